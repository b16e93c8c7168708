"""Layouts of balls: balls by number, their places, and how balls are put on the table by hand."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.billiards.game.rules import CUE_BALL, Hand, ShotSummary
from game.billiards.laws.layout import layout_of
from game.billiards.shot.cue import strike
from game.billiards.shot.physics import Physics
from game.billiards.shot.shot import Shot, make_shot
from game.billiards.table import rack as r
from game.billiards.table.rack import eight_ball_rack, nine_ball_rack, ten_ball_rack
from game.billiards.table.table import Table
from game.physics.kernels import elementary

Places = tuple[tuple[int, float, float], ...]  # ball, x, y m; ascending

BALLS = 16  # the cue ball and fifteen numbered ones
SPOT_GAP = 1e-9  # m; between a ball that is put back and the one it would touch


class Stroke(NamedTuple):
    """A stroke of the cue: speed m/s, azimuth and elevation rad, tip in ball radii, as in `cue.strike`."""

    cue_speed: float
    azimuth: float
    elevation: float = 0.0
    tip_left: float = 0.0
    tip_up: float = 0.0


class BallSet(NamedTuple):
    """Radii (16,) m and masses (16,) kg of the balls, by number."""

    radii: Floats
    masses: Floats


def equal_balls(radius: float = r.BALL_RADIUS, mass: float = r.BALL_MASS) -> BallSet:
    """A set of like balls."""
    return BallSet(np.full(BALLS, radius), np.full(BALLS, mass))


class Arrangement(NamedTuple):
    """Balls on a table: numbers (n,), ascending, positions (n, 2) m in its frame, and the set they are of."""

    numbers: tuple[int, ...]
    positions: Floats
    balls: BallSet

    @property
    def radii(self) -> Floats:
        """Radii (n,) m."""
        return self.balls.radii[list(self.numbers)]

    @property
    def places(self) -> Places:
        """Ball, x, y m of each, as plain values."""
        rows = zip(self.numbers, self.positions.tolist(), strict=True)
        return tuple((number, x, y) for number, (x, y) in rows)

    def place_of(self, number: int) -> tuple[float, float] | None:
        """Where a ball lies, m; None if it is not on the table."""
        if number not in self.numbers:
            return None
        x, y = self.positions[self.numbers.index(number)].tolist()
        return x, y

    def without(self, *numbers: int) -> Arrangement:
        """The same without some balls."""
        kept = [k for k, number in enumerate(self.numbers) if number not in numbers]
        return Arrangement(tuple(self.numbers[k] for k in kept), self.positions[kept], self.balls)

    def with_ball(self, number: int, place: ArrayLike) -> Arrangement:
        """The same with a ball put down, or moved, to (x, y) m; nothing is checked."""
        rest = self.without(number)
        at = sum(1 for other in rest.numbers if other < number)
        numbers = (*rest.numbers[:at], number, *rest.numbers[at:])
        return Arrangement(
            numbers, np.insert(rest.positions, at, np.asarray(place, float), axis=0), self.balls
        )

    def shot(self, table: Table, physics: Physics, stroke: Stroke | None = None) -> Shot:
        """The shot that a stroke makes; without one, all balls at rest. ShotError if balls overlap."""
        numbers = list(self.numbers)
        shot = make_shot(
            table,
            self.positions,
            radii=self.balls.radii[numbers],
            masses=self.balls.masses[numbers],
            physics=physics,
            ids=tuple(str(number) for number in numbers),
        )
        if stroke is None:
            return shot
        made = strike(
            *stroke,
            ball_mass=float(self.balls.masses[CUE_BALL]),
            ball_radius=float(self.balls.radii[CUE_BALL]),
        )
        return shot.struck(self.numbers.index(CUE_BALL), made.pressed(stroke.elevation), made.spin)


def arrange(places: dict[int, tuple[float, float]], balls: BallSet | None = None) -> Arrangement:
    """An arrangement from places (m) by ball number. ValueError for a number that no ball has."""
    numbers = tuple(sorted(places))
    for number in numbers:
        if not 0 <= number < BALLS:
            raise ValueError(f"balls: {number!r} is not a number from 0 to {BALLS - 1}")
    positions = np.array([places[number] for number in numbers], dtype=np.float64).reshape(-1, 2)
    return Arrangement(numbers, positions, equal_balls() if balls is None else balls)


def after_shot(before: Arrangement, summary: ShotSummary) -> Arrangement:
    """The balls where they came to rest."""
    numbers = tuple(number for number, _, _ in summary.rest)
    positions = np.array([(x, y) for _, x, y in summary.rest]).reshape(-1, 2)
    return Arrangement(numbers, positions, before.balls)


def racked(
    table: Table, game: str = "eight-ball", balls: BallSet | None = None, seed: int | None = None
) -> Arrangement:
    """The rack of a game ("nine-ball", "ten-ball" or any other), the cue ball on the head spot.

    Balls of different radii lie on the lattice of the largest, those of one radius touch: apart by a tenth of
    a millimetre only they would be struck one after the other, and half of them would hardly leave their
    place. With a seed the order is drawn.
    """
    balls = equal_balls() if balls is None else balls
    radius = float(balls.radii.max())
    rack = {"nine-ball": nine_ball_rack, "ten-ball": ten_ball_rack}.get(game, eight_ball_rack)
    positions = rack(table, radius, seed=seed)
    return Arrangement(tuple(range(len(positions))), positions, balls)


def is_free(
    layout: Arrangement, table: Table, number: int, x: float, y: float, hand: Hand = "anywhere"
) -> bool:
    """True if a ball may be put at (x, y) m: on the bed, clear of the others, behind the line if said."""
    radius = float(layout.balls.radii[number])
    left, right, lower, upper = bed_for(table, radius)
    if not (left <= x <= right and lower <= y <= upper):
        return False
    if hand == "behind the line" and y > r.HEAD_SPOT * table.length:
        return False
    for other, place in zip(layout.numbers, layout.positions.tolist(), strict=True):
        if other == number:
            continue
        reach = 2.0 * math.sqrt(radius * float(layout.balls.radii[other]))
        dx, dy = place[0] - x, place[1] - y
        if dx * dx + dy * dy < reach * reach:
            return False
    return True


def bed_for(table: Table, radius: float) -> tuple[float, float, float, float]:
    """Where the centre of a ball can lie within the straight rails: left, right, lower, upper, m."""
    edges = layout_of(table)
    left, right, lower, upper = edges.free
    x, y = edges.middle
    return (
        max(left + x, 0.0) + radius, min(right + x, table.width) - radius,
        max(lower + y, 0.0) + radius, min(upper + y, table.length) - radius,
    )  # fmt: skip


def nearest_free(
    layout: Arrangement, table: Table, number: int, x: float, y: float, hand: Hand = "anywhere"
) -> tuple[float, float]:
    """The free place for a ball nearest to (x, y) m, sought on rings about it; ValueError if none is."""
    radius = float(layout.balls.radii[number])
    left, right, lower, upper = bed_for(table, radius)
    if hand == "behind the line":
        upper = min(upper, r.HEAD_SPOT * table.length)
    x, y = min(max(x, left), right), min(max(y, lower), upper)
    for ring in range(400):
        distance = 0.1 * radius * ring
        spokes = max(1, 4 * ring)
        for spoke in range(spokes):
            angle = 2.0 * math.pi * spoke / spokes
            px = min(max(x + distance * elementary.cos(angle), left), right)
            py = min(max(y + distance * elementary.sin(angle), lower), upper)
            if is_free(layout, table, number, px, py, hand):
                return px, py
    raise ValueError(f"ball {number}: there is no free place near ({x:.3f}, {y:.3f}) m")


def spotted(layout: Arrangement, table: Table, numbers: tuple[int, ...]) -> Arrangement:
    """Balls put back (WPA 1.4): on the foot spot, else behind it as near as can be, else before it."""
    x, y = 0.5 * table.width, r.FOOT_SPOT * table.length
    for number in sorted(numbers):
        layout = layout.without(number)
        radius = float(layout.balls.radii[number])
        behind, before = [y], []
        for other, (px, py) in zip(layout.numbers, layout.positions.tolist(), strict=True):
            reach = 2.0 * math.sqrt(radius * float(layout.balls.radii[other])) + SPOT_GAP
            under = reach * reach - (px - x) * (px - x)
            if under > 0.0:
                behind.append(py + math.sqrt(under))
                before.append(py - math.sqrt(under))
        order = sorted(v for v in behind if v >= y) + sorted((v for v in before if v < y), reverse=True)
        free = next((v for v in order if is_free(layout, table, number, x, v)), None)
        place = (x, free) if free is not None else nearest_free(layout, table, number, x, y)
        layout = layout.with_ball(number, place)
    return layout
