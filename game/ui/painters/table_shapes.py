"""Outlines of a table's cushions from its rails, jaws and facings: metres, in the table's frame."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.billiards.table.table import Table

Array = np.ndarray
TOLERANCE = 1e-6  # m; ends of rails, jaws and facings that are closer are the same point
ARC_STEPS = 8
NOSE_SHARE = 0.30  # of the cushion's depth is the slope under the nose
FACING_SHARE = 0.16  # and under the facings


class CushionShape(NamedTuple):
    """One cushion as seen from above."""

    outline: Array  # (n, 2) m, closed by itself
    top: Array  # (m, 2) m, the flat part; the rest falls away to nose and facings
    ridge: Array  # (2, 2) m, its edge along the nose
    nose: Array  # (k, 2) m, open: what a ball can touch
    back: Array  # (2, 2) m, where it meets the wood
    normal: tuple[float, float]  # into the table


def cushion_shapes(table: Table, depth: float) -> list[CushionShape]:
    """The cushions of a table, ``depth`` m from nose to wood, in the order of its rails."""
    shapes = []
    for row in table.cushions:
        start, end, normal = row[0:2], row[2:4], row[4:6]
        if min(abs(normal[0]), abs(normal[1])) > TOLERANCE:
            continue  # a facing, which belongs to a rail
        along = (end - start) / math.sqrt(float((end - start) @ (end - start)))
        first = _end(table, start, -along, normal, depth)
        last = _end(table, end, along, normal, depth)
        outline = np.array([*first[::-1], *last])
        edge = start - NOSE_SHARE * depth * normal
        top = _beyond(outline, edge, -normal)
        for near, far, across in _facing_lines(outline, start, normal, depth):
            top = _beyond(top, 0.5 * (near + far) + FACING_SHARE * depth * across, across)
        level = (start - outline) @ normal
        shapes.append(
            CushionShape(
                outline,
                top,
                _extremes(top[(edge - top) @ normal < TOLERANCE], along),
                outline[level < depth - TOLERANCE],
                _extremes(outline[level > depth - 2.0 * TOLERANCE], along),
                (float(normal[0]), float(normal[1])),
            )
        )
    return shapes


def _extremes(points: Array, along: Array) -> Array:
    """First and last of some points in a direction."""
    order = np.argsort(points @ along, kind="stable")
    return points[order[[0, -1]]]


def _end(table: Table, tip: Array, along: Array, normal: Array, depth: float) -> list[Array]:
    """Points from the end of a nose to the wood: round the jaw, along the facing."""
    jaw = next((j for j in table.jaws if _apart(tip - j[2] * normal, j[:2]) < TOLERANCE), None)
    facing = _facing(table, tip, jaw)
    if facing is None:
        neighbour = any(
            min(_apart(tip, r[0:2]), _apart(tip, r[2:4])) < TOLERANCE and abs(float(r[4:6] @ normal)) < 0.5
            for r in table.cushions
        )
        return [tip, tip + (along - normal) * depth if neighbour else tip - normal * depth]
    near, far = facing
    points = [tip] if jaw is None else _arc(jaw[:2], float(jaw[2]), tip, near)
    points.append(far)
    missing = depth - float((tip - far) @ normal)
    if missing > TOLERANCE:
        points.append(far - normal * missing)
    return points


def _facing(table: Table, tip: Array, jaw: Array | None) -> tuple[Array, Array] | None:
    """Near and far end of the facing that begins at a nose's end or on its jaw."""
    reach = TOLERANCE if jaw is None else 2.0 * float(jaw[2])
    best = None
    for row in table.cushions:
        if min(abs(row[4]), abs(row[5])) <= TOLERANCE:
            continue
        for near, far in ((row[0:2], row[2:4]), (row[2:4], row[0:2])):
            gap = _apart(near, tip)
            touches = jaw is None or abs(_apart(near, jaw[:2]) - float(jaw[2])) < TOLERANCE
            if touches and gap <= reach:
                best, reach = (near, far), gap
    return best


def _arc(center: Array, radius: float, start: Array, end: Array) -> list[Array]:
    """Points on the shorter arc round a centre, both ends included."""
    a = math.atan2(start[1] - center[1], start[0] - center[0])
    b = math.atan2(end[1] - center[1], end[0] - center[0])
    turn = (b - a + math.pi) % (2.0 * math.pi) - math.pi
    angles = a + turn * np.arange(ARC_STEPS + 1) / ARC_STEPS
    return [center + radius * np.array((math.cos(t), math.sin(t))) for t in angles]


def _facing_lines(
    outline: Array, nose: Array, normal: Array, depth: float
) -> list[tuple[Array, Array, Array]]:
    """Oblique sides of an outline that reach the wood: both ends, and the unit normal into the cushion."""
    level = (nose - outline) @ normal
    middle = outline.mean(axis=0)
    lines = []
    for i in range(len(outline)):
        j = (i + 1) % len(outline)
        reaches_wood = max(level[i], level[j]) > depth - 2.0 * TOLERANCE
        if reaches_wood and min(level[i], level[j]) < depth - 2.0 * TOLERANCE:
            side = outline[j] - outline[i]
            across = np.array((-side[1], side[0])) / math.sqrt(float(side @ side))
            lines.append(
                (outline[i], outline[j], across if across @ (middle - outline[i]) > 0.0 else -across)
            )
    return lines


def _beyond(outline: Array, point: Array, normal: Array) -> Array:
    """The part of a convex polygon on one side of a line (Sutherland and Hodgman 1974)."""
    level = (outline - point) @ normal  # positive on the side that stays
    kept = []
    for i in range(len(outline)):
        j = (i + 1) % len(outline)
        if level[i] >= 0.0:
            kept.append(outline[i])
        if (level[i] >= 0.0) != (level[j] >= 0.0):
            kept.append(outline[i] + (outline[j] - outline[i]) * level[i] / (level[i] - level[j]))
    return np.array(kept).reshape(-1, 2)


def _apart(a: Array, b: Array) -> float:
    """Distance of two points."""
    return math.sqrt(float((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2))
