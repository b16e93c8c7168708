"""Blocks that slide in lanes of their own: how far each has come, beside what Coulomb's law says."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats, Longs
from game.physics.dominoes import stopping_distance
from game.physics.kernels import elementary, elementwise
from game.physics.solids import Material, SolidWorld, box
from game.scenes.domino.course import Standing, height_at
from game.scenes.domino.dominoes import NOT_YET, centre_of
from game.scenes.domino.level import DominoContent, SliderEntry
from game.worlds.tables import NO_FLOATS, NO_LONGS, extended
from game.worlds.world import Member

ALL = 2**62 - 1  # bits of all that a block may meet
QUIET = 1e-3  # m/s, of a block that has come to rest


class Table(NamedTuple):
    """Of each block: body, friction with its lane, speed (m/s; NOT_YET) and place (m) at which it was
    measured, distance since then (m).
    """

    body: Longs = NO_LONGS
    mu: Floats = NO_FLOATS
    speed: Floats = NO_FLOATS
    x: Floats = NO_FLOATS
    y: Floats = NO_FLOATS
    distance: Floats = NO_FLOATS


class Blocks(Member):
    """``table`` of all, each upright or flat at its place of the lane."""

    kept = ("table",)

    def __init__(self, world: SolidWorld, content: DominoContent, floors: list[Floats], grips: list[float]):
        """grips: friction of each lane, so that the block and it come to what is wanted."""
        self.world, self.content, self.floors = world, content, floors
        bodies = [
            self._add(one, k, grip) for k, (one, grip) in enumerate(zip(content.sliders, grips, strict=True))
        ]
        rows = zip(bodies, content.sliders, strict=True)
        self.table = extended(Table(), [(body, one.friction, NOT_YET, 0.0, 0.0, 0.0) for body, one in rows])

    def _add(self, entry: SliderEntry, number: int, lane: float) -> int:
        """A block in its lane; its body."""
        y, slope = height_at(self.floors[entry.floor], entry.x)
        others = sum(2 << k for k in range(12) if k != number)
        material = Material(entry.density, block_grip(entry.friction, lane), 0.0, 2 << number, ALL & ~others)
        thick, tall = entry.size
        if entry.speed > 0.0:  # it lies flat
            place = centre_of(Standing(entry.x, y, slope, 1.0), thick)
            velocity = entry.speed * elementary.cos(slope), entry.speed * elementary.sin(slope)
            return self.world.add_body(box(tall, thick, material=material), place, slope, velocity)
        place = centre_of(Standing(entry.x, y, slope, 1.0), tall)
        return self.world.add_body(box(thick, tall, material=material), place, slope)

    def step(self, dt: float) -> None:
        """Measure from the line on how far they have slid."""
        line, table, rows = self.content.x_measured, self.table, self.world.bodies
        if line is None:
            return
        for k, body in enumerate(table.body.tolist()):
            x, y = rows.positions[body].tolist()
            if table.speed[k] < 0.0 and x >= line and self._lies(body):
                table.speed[k] = elementary.length(*rows.velocities[body].tolist())
                table.x[k], table.y[k] = x, y
            elif table.speed[k] >= 0.0:
                table.distance[k] = elementary.hypot(x - float(table.x[k]), y - float(table.y[k]))

    def _lies(self, body: int) -> bool:
        """Whether a block lies on a long side and slides without turning."""
        c, _ = self.world.bodies.rotations[body].tolist()
        return abs(c) < 0.3 or self.content.pushed_at is None

    def speeds(self) -> Floats:
        """(m,) m/s, now."""
        return elementwise.hypot(*self.world.bodies.velocities[self.table.body].T)

    def at_rest(self) -> int:
        """How many have slid and come to rest."""
        return int(np.count_nonzero(self.speeds()[self.table.speed >= 0.0] < QUIET))

    def slope(self, number: int) -> float:
        """Of a block's lane where it was measured, rad."""
        entry = self.content.sliders[number]
        return height_at(self.floors[entry.floor], float(self.table.x[number]) + 0.01)[1]

    def distance_by_law(self, number: int, gravity: float) -> float:
        """How far (m) a block slides from where it was measured, by the formula; NaN before."""
        speed, mu = float(self.table.speed[number]), float(self.table.mu[number])
        return stopping_distance(speed, mu, -self.slope(number), gravity) if speed >= 0.0 else math.nan

    def stop_by_law(self, number: int, gravity: float) -> float:
        """Where (x, m) the formula has it stop; NaN before it is measured, and if it never does."""
        far = self.distance_by_law(number, gravity)
        if not math.isfinite(far):
            return math.nan
        return float(self.table.x[number]) + far * elementary.cos(self.slope(number))


def block_grip(wanted: float, lane: float) -> float:
    """Friction of a block so that with a lane of friction ``lane`` it comes to ``wanted``."""
    return wanted * wanted / lane if lane > 0.0 else 0.0
