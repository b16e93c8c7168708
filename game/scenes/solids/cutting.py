"""Outlines of all shapes in the frames of their bodies; bodies cut in two along a line."""

from __future__ import annotations

import math
from typing import NamedTuple

import msgspec
import numpy as np

from game.arrays import Floats, Longs
from game.physics.kernels import elementary, elementwise, linear
from game.physics.solids.arrays.state import DISC, DYNAMIC, NONE, SEGMENT, Pool, Shapes
from game.scenes.solids.bodies import entry_of, joint_entry, whole_joints
from game.scenes.solids.level import BodyEntry, Point, ShapeEntry
from game.scenes.solids.model import ANCHOR, SolidModel
from game.worlds.hands.grab import body_at
from game.worlds.hands.hand import NOBODY

BEVEL = 0.09  # of the least width of a shape
MOST_BEVEL = 0.09  # m


class Outlines(NamedTuple):
    """corners (v, 2) m, of polygons; owners (v,) their bodies; starts (m + 1,) first corner of each polygon;
    bevels (v, 2) m the same corners moved inwards; ends (e, 2, 2) m of segments and their bodies (e,); discs:
    centres (d, 2) m, radii (d,) m, bodies (d,).
    """

    corners: Floats
    bevels: Floats
    normals: Floats
    owners: Longs
    starts: Longs
    ends: Floats
    end_owners: Longs
    centres: Floats
    radii: Floats
    disc_owners: Longs


def outlines_of(shapes: Shapes, pool: Pool) -> Outlines:
    """Of all shapes that there are."""
    polygons: list[Floats] = []
    owners: list[int] = []
    for slot in np.flatnonzero(
        (shapes.kinds != NONE) & (shapes.kinds != DISC) & (shapes.kinds != SEGMENT)
    ).tolist():
        start, count = int(shapes.starts[slot]), int(shapes.counts[slot])
        polygons.append(rounded_outline(pool.corners[start : start + count], float(shapes.radii[slot])))
        owners.append(int(shapes.bodies[slot]))
    counts = [len(polygon) for polygon in polygons]
    corners = np.concatenate(polygons) if polygons else np.zeros((0, 2))
    starts = np.concatenate([[0], np.cumsum(counts)]).astype(np.int64)
    inside = [_bevel(polygon) for polygon in polygons]
    empty = np.zeros((0, 2))
    chain = np.flatnonzero(shapes.kinds == SEGMENT)
    first = shapes.starts[chain].astype(np.int64)
    disc = np.flatnonzero(shapes.kinds == DISC)
    return Outlines(
        corners,
        np.concatenate([part[0] for part in inside]) if inside else empty,
        np.concatenate([part[1] for part in inside]) if inside else empty,
        np.repeat(np.array(owners, dtype=np.int64), counts),
        starts,
        np.stack([pool.corners[first + 1], pool.corners[first + 2]], axis=1)
        if len(chain)
        else np.zeros((0, 2, 2)),
        shapes.bodies[chain].astype(np.int64),
        pool.corners[shapes.starts[disc]],
        shapes.radii[disc],
        shapes.bodies[disc].astype(np.int64),
    )


def _bevel(corners: Floats) -> tuple[Floats, Floats]:
    """Corners moved inwards, and the outward normal of the edge that begins at each."""
    edges = np.roll(corners, -1, axis=0) - corners
    lengths = elementwise.hypot(edges[:, 0], edges[:, 1])[:, None]
    normals = np.stack([edges[:, 1], -edges[:, 0]], axis=1) / np.where(lengths > 0.0, lengths, 1.0)
    before = np.roll(normals, 1, axis=0)
    heights = linear.product(corners, normals.T)
    width = float((heights.max(axis=0) - heights.min(axis=0)).min())
    inset = min(BEVEL * width, MOST_BEVEL)
    share = np.maximum(1.0 + (normals * before).sum(axis=1), 0.3)[:, None]
    return corners - inset * (normals + before) / share, normals


ROUND = 28  # corners of a disc that is cut
LEAST = 1e-4  # m², of a piece


def cut_bodies(model: SolidModel, start: Point, end: Point) -> int:
    """Cut every dynamic body that the line goes right through; how many were cut."""
    world, cut = model.world, 0
    for body in model.movable().tolist():
        rows = world.bodies
        if not rows.flags[body] & DYNAMIC:
            continue
        x, y = rows.positions[body].tolist()
        if _distance((x, y), start, end) > float(rows.reaches[body]):
            continue
        if _passes_through(model, body, start, end):
            cut += _cut(model, body, start, end)
    return cut


def _distance(p: Point, a: Point, b: Point) -> float:
    dx, dy = b[0] - a[0], b[1] - a[1]
    length = elementary.hypot(dx, dy)
    return abs(dx * (p[1] - a[1]) - dy * (p[0] - a[0])) / length if length > 0.0 else math.inf


def _passes_through(model: SolidModel, body: int, start: Point, end: Point) -> bool:
    """Both ends are outside, and the line meets it between them."""
    only = np.array([body])
    if (
        NOBODY not in (body_at(model.world, only, start, 0.0),)
        or body_at(model.world, only, end, 0.0) != NOBODY
    ):
        return False
    way = np.linspace(0.0, 1.0, 65)[1:-1, None]
    between = np.array(start) + way * (np.array(end) - np.array(start))
    return any(body_at(model.world, only, (float(x), float(y)), 0.0) == body for x, y in between)


def _cut(model: SolidModel, body: int, start: Point, end: Point) -> int:
    """Two bodies for one; joints go to the piece that has their point. 0 if a piece would be too small."""
    world = model.world
    entry = entry_of(world, body, int(model.tints.rows[body]))
    a, b = np.array(world.local(body, start)), np.array(world.local(body, end))
    pieces: list[BodyEntry] = []
    for side in (1.0, -1.0):
        kept = [half for shape in entry.shapes for half in _half(shape, a, b, side)]
        if not kept:
            return 0
        pieces.append(msgspec.structs.replace(entry, shapes=tuple(kept)))
    names = {int(i): int(i) for i in world.ids()}
    joints = [
        (joint_entry(world, joint, names), world.joints.bodies[joint].tolist())
        for joint in whole_joints(world) if body in world.joints.bodies[joint]
    ]  # fmt: skip
    velocity, spin = world.bodies.velocities[body].copy(), float(world.bodies.spins[body])
    centre = world.bodies.positions[body].copy()
    model.remove(body)
    made = [model.add(piece) for piece in pieces]
    for piece in made:  # each goes on as its part of the whole went
        arm = world.bodies.positions[piece] - centre
        world.set_velocity(piece, velocity + spin * np.array([-arm[1], arm[0]]), spin)
    for joint, ends in joints:
        places = (joint.at, joint.other or joint.at)
        own = [
            body_at(world, np.array(made), places[k], 0.5) if name == body else name
            for k, name in enumerate(ends)
        ]
        if NOBODY not in own and own[0] != own[1]:
            ids = [ANCHOR if name == ANCHOR else name for name in own]
            model.join(msgspec.structs.replace(joint, bodies=(0, 1)), ids)
    return 1


def _half(shape: ShapeEntry, a: Floats, b: Floats, side: float) -> list[ShapeEntry]:
    """What of a shape is on one side of a line; [] for next to nothing."""
    corners = _outline(shape)
    if corners is None:
        return []
    dx, dy = b - a
    heights = side * (dx * (corners[:, 1] - a[1]) - dy * (corners[:, 0] - a[0]))
    if (heights >= 0.0).all():
        return [shape]
    kept: list[Point] = []
    for k in range(len(corners)):
        j = (k + 1) % len(corners)
        if heights[k] >= 0.0:
            kept.append((float(corners[k, 0]), float(corners[k, 1])))
        if heights[k] * heights[j] < 0.0:
            at = heights[k] / (heights[k] - heights[j])
            x, y = corners[k] + at * (corners[j] - corners[k])
            kept.append((float(x), float(y)))
    if len(kept) < 3 or _area(np.array(kept)) < LEAST:
        return []
    return [ShapeEntry(polygon=tuple(kept))]


def _area(corners: Floats) -> float:
    after = np.roll(corners, -1, axis=0)
    return 0.5 * abs(float((corners[:, 0] * after[:, 1] - corners[:, 1] * after[:, 0]).sum()))


def _outline(shape: ShapeEntry) -> Floats | None:
    """Corners of a convex shape, roundings included as chords; None for chains."""
    if shape.disc is not None:
        return rounded_outline(np.array([shape.at]), shape.disc)
    if shape.capsule is not None:
        return rounded_outline(np.array(shape.capsule), shape.radius)
    if shape.polygon is not None:
        return rounded_outline(np.array(shape.polygon), shape.radius)
    return None


def rounded_outline(corners: Floats, radius: float, pieces: int = ROUND) -> Floats:
    """A convex outline (k, 2), anticlockwise, grown by a radius: arcs as ``pieces`` chords to a full turn."""
    if radius <= 0.0:
        return corners
    if len(corners) == 1:
        turns = np.linspace(0.0, 2.0 * math.pi, pieces, endpoint=False)
        return corners + radius * np.stack([elementwise.cos(turns), elementwise.sin(turns)], axis=1)
    edges = np.roll(corners, -1, axis=0) - corners
    facing = elementwise.arctan2(
        -edges[:, 0], edges[:, 1]
    )  # of the outward normal of the edge after each corner
    found = []
    for k in range(len(corners)):
        first = facing[k - 1]
        turn = (facing[k] - first) % (2.0 * math.pi)
        count = max(1, math.ceil(turn / (2.0 * math.pi) * pieces))
        turns = first + turn * np.linspace(0.0, 1.0, count + 1)
        found.append(corners[k] + radius * np.stack([elementwise.cos(turns), elementwise.sin(turns)], axis=1))
    return np.concatenate(found)
