"""Structures of a level, as the bodies and joints that they are made of."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from game.physics.kernels import elementary, elementwise, linear
from game.scenes.solids.level import (
    GROUND,
    ArchEntry,
    BodyEntry,
    CardEntry,
    CradleEntry,
    DominoEntry,
    HeapEntry,
    JointEntry,
    LinksEntry,
    MaterialEntry,
    PegEntry,
    Point,
    ShapeEntry,
    SolidContent,
    StackEntry,
)
from game.scenes.solids.machines import Made, add_beam, add_escapement, add_truss, material_of


def make(content: SolidContent, seed: int) -> Made:
    """All that a level says, one by one."""
    made = Made(list(content.bodies), [])
    for stack in content.stacks:
        made.bodies.extend(_stack(stack))
    for beam in content.beams:
        add_beam(beam, made)
    for truss in content.trusses:
        add_truss(truss, made)
    for clock in content.escapements:
        add_escapement(clock, made)
    for arch in content.arches:
        made.bodies.extend(_arch(arch))
    for row in content.dominoes:
        made.bodies.extend(_dominoes(row))
    for house in content.cards:
        made.bodies.extend(_cards(house))
    for cradle in content.cradles:
        _cradle(cradle, made)
    for links in content.links:
        _links(links, made)
    for pegs in content.pegs:
        made.bodies.extend(_pegs(pegs))
    chance = np.random.default_rng(seed)
    for heap in content.heaps:
        made.bodies.extend(_heap(heap, chance))
    made.joints.extend(content.joints)
    return made


def _box(entry: MaterialEntry, size: Point, place: Point, angle: float = 0.0, **more: Any) -> BodyEntry:
    return BodyEntry(
        shapes=(ShapeEntry(box=size),), position=place, angle=angle, **{**material_of(entry), **more}
    )


def _stack(entry: StackEntry) -> Iterator[BodyEntry]:
    (x, y), half = entry.at, 0.5 * entry.size[1]
    width, height = (side * (1.0 - entry.overlap) for side in entry.size)
    for row in range(entry.count):
        across = entry.count - row if entry.form == "pyramid" else entry.across
        shift = 0.25 * width if entry.form == "wall" and row % 2 else 0.0
        for k in range(across):
            place = x + shift + width * (k - 0.5 * (across - 1)), y + half + height * row
            yield _box(entry, entry.size, place)


def _arch(entry: ArchEntry) -> Iterator[BodyEntry]:
    """Straight voussoirs between radial joints."""
    (x, y), half = entry.at, 0.5 * math.pi / entry.blocks
    for k in range(entry.blocks):
        angle = math.pi - (2 * k + 1) * half
        inner = entry.radius - 0.5 * entry.thickness
        outer = entry.radius + 0.5 * entry.thickness
        corners = []
        for radius, turn in ((inner, half), (inner, -half), (outer, -half), (outer, half)):
            corners.append((radius * elementary.cos(angle + turn), radius * elementary.sin(angle + turn)))
        middle = np.mean(corners, axis=0)
        own = tuple((float(cx - middle[0]), float(cy - middle[1])) for cx, cy in reversed(corners))
        place = (x + float(middle[0]), y + float(middle[1]))
        yield BodyEntry(shapes=(ShapeEntry(polygon=own),), position=place, **material_of(entry))


def _dominoes(entry: DominoEntry) -> Iterator[BodyEntry]:
    (x, y), (width, height) = entry.at, entry.size
    for k in range(entry.count):
        spin = -entry.push if k == 0 else 0.0
        place = (x + k * (width + entry.gap), y + 0.5 * height)
        # turning about the lower right corner
        moves = (-spin * 0.5 * height, -spin * 0.5 * width) if k == 0 else (0.0, 0.0)
        yield _box(entry, entry.size, place, spin=spin, velocity=moves)


def _cards(entry: CardEntry) -> Iterator[BodyEntry]:
    """Leaning pairs meet at their tops; flat cards lie from top to top."""
    x, y = entry.at
    lean = math.radians(entry.lean)
    size = (entry.thickness, entry.length)
    foot = 0.5 * (entry.length * elementary.sin(lean) + entry.thickness * elementary.cos(lean))
    high = 0.5 * (entry.length * elementary.cos(lean) + entry.thickness * elementary.sin(lean))
    pitch = 4.0 * foot
    for storey in range(entry.storeys):
        pairs = entry.storeys - storey
        base = y + storey * (2.0 * high + entry.thickness)
        for k in range(pairs):
            middle = x + pitch * (k - 0.5 * (pairs - 1))
            yield _box(entry, size, (middle - foot, base + high), -entry.lean)
            yield _box(entry, size, (middle + foot, base + high), entry.lean)
        for k in range(pairs - 1):
            middle = x + pitch * (k - 0.5 * (pairs - 2))
            lying = (pitch * 0.98, entry.thickness)
            yield _box(entry, lying, (middle, base + 2.0 * high + 0.5 * entry.thickness))


def _cradle(entry: CradleEntry, made: Made) -> None:
    x, y = entry.at
    for k in range(entry.balls):
        top = (x + (2.0 * entry.ball + entry.gap) * (k - 0.5 * (entry.balls - 1)), y)
        turn = math.radians(-entry.swing if k < entry.lifted else 0.0)
        place = (top[0] + entry.length * elementary.sin(turn), top[1] - entry.length * elementary.cos(turn))
        made.joints.append(
            JointEntry(kind="distance", bodies=(GROUND, len(made.bodies)), at=top, other=place)
        )
        made.bodies.append(
            BodyEntry(shapes=(ShapeEntry(disc=entry.ball),), position=place, **material_of(entry))
        )


def _links(entry: LinksEntry, made: Made) -> None:
    start, end = np.array(entry.start), np.array(entry.end)
    step = (end - start) / entry.links
    half, angle = 0.5 * float(elementwise.hypot(*step)), math.degrees(elementary.atan2(step[1], step[0]))
    before = GROUND
    for k in range(entry.links):
        number = len(made.bodies)
        first = start + k * step
        middle = first + 0.5 * step
        shape = ShapeEntry(capsule=((-half, 0.0), (half, 0.0)), radius=entry.radius)
        made.bodies.append(
            BodyEntry(shapes=(shape,), position=_pair(middle), angle=angle, **material_of(entry))
        )
        if k or entry.held != "none":
            made.joints.append(JointEntry(kind="pin", bodies=(before, number), at=_pair(first)))
        before = number
    if entry.load:
        radius = entry.load_radius
        density = entry.load / (math.pi * radius * radius)
        place = end + radius * step / (2.0 * half)
        made.joints.append(JointEntry(kind="pin", bodies=(before, len(made.bodies)), at=_pair(end)))
        made.bodies.append(
            BodyEntry(
                shapes=(ShapeEntry(disc=radius),), position=_pair(place), density=density, colour="steel"
            )
        )
    elif entry.held == "both":
        made.joints.append(JointEntry(kind="pin", bodies=(before, GROUND), at=_pair(end)))


def _pegs(entry: PegEntry) -> Iterator[BodyEntry]:
    x, y = entry.at
    for row in range(entry.rows):
        across = entry.columns - row % 2
        for k in range(across):
            place = (x + entry.spacing * (k - 0.5 * (across - 1)), y - entry.spacing * math.sqrt(0.75) * row)
            shape = ShapeEntry(disc=entry.radius)
            yield BodyEntry(shapes=(shape,), position=place, kind="fixed", **material_of(entry))


def _heap(entry: HeapEntry, chance: np.random.Generator) -> Iterator[BodyEntry]:
    (x0, y0), (x1, y1) = entry.low, entry.high
    for k in range(entry.count):
        place = (float(linear.uniform(chance, x0, x1)), float(linear.uniform(chance, y0, y1)))
        size, turn = float(linear.uniform(chance, *entry.size)), float(linear.uniform(chance, -180.0, 180.0))
        disc = entry.form == "disc" or (entry.form == "mixed" and k % 2 == 0)
        shape = ShapeEntry(disc=size) if disc else ShapeEntry(box=(2.0 * size, 2.0 * size))
        yield BodyEntry(shapes=(shape,), position=place, angle=turn, **material_of(entry))


def _pair(point: Any) -> Point:
    return float(point[0]), float(point[1])
