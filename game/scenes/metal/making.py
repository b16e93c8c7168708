"""Puts what a level says into a world of solids."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from game.arrays import Point
from game.physics.kernels import elementary
from game.physics.solids import Capsule, Chain, Disc, Material, Polygon, SolidWorld, box
from game.physics.solids.tracks import Curve
from game.scenes.metal.level import (
    BallEntry,
    Box,
    CradleEntry,
    FloorEntry,
    HeapEntry,
    PlugEntry,
    SeesawEntry,
    TowerEntry,
)

STEEL = 7.8  # kg/m² of a slice, water being 1
WOOD_GRIP = 0.6
BEYOND = 0.5  # m: so far beyond a yard its balls may still reach
LEDGE = 0.08  # m, thickness of what keeps a ball on a seesaw


def balls_of(heap: HeapEntry) -> Iterator[BallEntry]:
    """Row by row; every other one is shifted, so that none stands on top of another."""
    pitch = 2.02 * (heap.radius + 2.0 * max(heap.grows, 0.0))
    for row in range(heap.counts[1]):
        for column in range(heap.counts[0]):
            radius = heap.radius + heap.grows * ((row * heap.counts[0] + column) % 3)
            at = heap.at[0] + pitch * (column + 0.25 * (row % 2)), heap.at[1] + pitch * row
            yield BallEntry(at=at, radius=radius)


def add_floor(world: SolidWorld, entry: FloorEntry) -> int:
    """Something solid; its body."""
    material = Material(1.0, entry.friction, entry.restitution)
    return world.add_body(Chain(np.array(entry.points), material=material), kind="fixed")


def add_track(world: SolidWorld, curve: Curve, yards: tuple[Box, ...], friction: float) -> list[int]:
    """The parts of a track that reach into yards, as balls there meet them, from both sides; their bodies."""
    points = curve.checked()
    if curve.closed:
        points = np.concatenate([points, points[:1]])
    inside = np.zeros(len(points), dtype=bool)
    for one in yards:
        inside |= (
            (points[:, 0] > one.left - BEYOND) & (points[:, 0] < one.right + BEYOND)
            & (points[:, 1] > one.bottom - BEYOND) & (points[:, 1] < one.top + BEYOND)
        )  # fmt: skip
    steps = inside[1:] | inside[:-1]
    edges = np.flatnonzero(np.diff(np.concatenate([[False], steps, [False]]).astype(np.int8)))
    material = Material(1.0, friction)
    return [
        world.add_body(Chain(side, material=material), kind="fixed")
        for first, last in edges.reshape(-1, 2).tolist()
        for side in (points[first : last + 1].copy(), points[first : last + 1][::-1].copy())
    ]


def add_plug(world: SolidWorld, entry: PlugEntry) -> int:
    """A bar in the way; its body."""
    shape = Capsule(entry.start, entry.end, 0.5 * entry.thick, Material(1.0, 0.3))
    return world.add_body(shape, kind="fixed")


def add_tower(world: SolidWorld, entry: TowerEntry) -> list[int]:
    """Blocks in columns, layer by layer; their bodies."""
    (columns, layers), (wide, tall), (x, y) = entry.counts, entry.size, entry.at
    shape = box(wide, tall, material=Material(entry.density, WOOD_GRIP))
    return [
        world.add_body(shape, (x + (column - 0.5 * (columns - 1)) * wide, y + (layer + 0.5) * tall))
        for layer in range(layers)
        for column in range(columns)
    ]


def add_seesaw(world: SolidWorld, anchor: int, entry: SeesawEntry) -> int:
    """A plank with a ledge at each end, on a pin; its body."""
    material = Material(entry.density, WOOD_GRIP)
    half, up = 0.5 * entry.length, 0.5 * entry.thickness
    shapes = [_plank(-half, half, -up, up, material)]
    if entry.ledge > 0.0:
        top = up + entry.ledge
        shapes += [
            _plank(-half, LEDGE - half, up, top, material), _plank(half - LEDGE, half, up, top, material)
        ]  # fmt: skip
    body = world.add_body(shapes, entry.at, math.radians(entry.lean))
    world.add_joint("pin", anchor, body, entry.at)
    return body


def _plank(left: float, right: float, bottom: float, top: float, material: Material) -> Polygon:
    return Polygon([(left, bottom), (right, bottom), (right, top), (left, top)], material=material)


def cradle_places(entry: CradleEntry) -> list[tuple[Point, Point]]:
    """Where each rod hangs and where its ball is, m."""
    found = []
    for k in range(entry.count):
        hung = entry.at[0] + k * (2.0 * entry.radius + entry.gap), entry.at[1]
        turn = math.radians(entry.lift) if k < entry.lifted else 0.0
        ball = hung[0] - entry.length * elementary.sin(turn), hung[1] - entry.length * elementary.cos(turn)
        found.append((hung, ball))
    return found


def add_hanging(world: SolidWorld, anchor: int, hung: Point, ball: Point, radius: float) -> tuple[int, int]:
    """A ball of a cradle: its body and its rod."""
    body = world.add_body(Disc(radius, material=Material(STEEL, 0.0, 1.0)), ball, restless=True)
    return body, world.add_joint("distance", anchor, body, hung, ball)
