"""The world of the trebuchet: ground, wall and machine; how the stone flies, and what it strikes."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats, Longs, Point
from game.physics.effects import EffectSet
from game.physics.fields import QUADRATIC_DRAG
from game.physics.kernels import elementwise
from game.physics.solids import Chain, Material, SolidState
from game.physics.solids.arrays.state import SEGMENT
from game.scenes.trebuchet.machine import LOOSE, THROWING, Machine, stone_radius
from game.scenes.trebuchet.parameters import TrebuchetContent, TrebuchetParameters
from game.worlds.hands.hand import NOBODY
from game.worlds.hearing import Heard, impacts
from game.worlds.members.dust import Dust, Dusty, advance_dust
from game.worlds.members.solids import Solids, drag_sphere, momentum, resist_rolling
from game.worlds.world import World

WIDE, TALL, DENSITY = 0.8, 0.55, 690.0  # m; kg/m² of a block, 0.3 m deep
MOVED = 0.3  # m: a block that is farther from its place than that is out of place
EVERY, MOST = 0.15, 200  # s between two points of the trail, and how many there are
EARTH, STONES, LANDING = range(3)  # sounds
LEAST_HEARD, USUAL = 0.3, 60.0  # m/s of approach; kg that sounds as it is
DUSTY = Dusty(each=240.0, most=14, quick=6.0, size=0.36, life=2.2)
ROLLS = (
    0.3  # rolling resistance on turf: that of wheels in sand (0.2 to 0.4), so that no stone rolls to the wall
)


class TrebuchetState(NamedTuple):
    """heard (k, HEARD_WIDTH); dust (n, DUST_WIDTH)."""

    world: SolidState
    heard: Floats
    dust: Floats


class TrebuchetWorld(World):
    """``blocks`` (n,) bodies of the wall, ``sizes`` (n, 2) m, ``homes`` (n, 2) m where they were built.

    flying: a stone, since ``thrown`` (s), until it touches something, or NOBODY; landing: where it did, m.
    before, after: kg m/s along x of stone and wall before and after the step in which they met.
    """

    state_type = TrebuchetState
    content: TrebuchetContent
    parameters: TrebuchetParameters

    def __init__(
        self, content: TrebuchetContent, parameters: TrebuchetParameters, active: EffectSet, seed: int
    ):
        super().__init__(content, parameters, active)
        self.solids, self.heard, self.dust, self.seed = Solids(parameters, active), Heard(), Dust(), seed
        self.world, self.anchor = self.solids.world, self.solids.anchor()
        ground = Chain([(-400.0, 0.0), (2000.0, 0.0)], material=Material(1.0, 0.6))
        self.world.add_body(ground, kind="fixed")
        made_of, counts = Material(DENSITY, parameters.friction), (int(parameters.rows), content.columns)
        self.blocks, self.sizes = self.solids.lay_courses(content.wall, counts, (WIDE, TALL), made_of)
        self.homes = self.world.bodies.positions[self.blocks].copy()
        self.machine = Machine(self.solids, parameters, self.anchor)
        self.flying, self.thrown, self.trail = NOBODY, 0.0, list[Point]()
        self.landing: Point | None = None
        self.before = self.after = math.nan
        self.members = (self.solids, self.machine, self.heard, self.dust)

    def loose(self) -> Longs:
        """Bodies that a hand may take: blocks, and stones that no sling holds."""
        return np.concatenate([self.blocks, np.array(self.machine.free(), dtype=np.int64)])

    def advance(self, dt: float) -> str:
        left, said = dt, ""
        while left > 0.0:  # in parts where the hook lets go within the step
            part = self.machine.part_of(left)
            said, left = self.go_on(part) or said, left - part
        self.dust.rows = advance_dust(self.dust.rows, dt)
        return said

    def go_on(self, dt: float) -> str:
        """A step, or a part of one, of dt (s)."""
        phase, rows = self.machine.phase, self.world.bodies
        stone = self.machine.stones[-1] if self.flying == NOBODY else self.flying
        if self.flying != NOBODY and QUADRATIC_DRAG in self.active:
            drag_sphere(self.world, stone, stone_radius(1.0 / float(rows.inverse_masses[stone])))
        for ball in self.machine.free():
            radius = stone_radius(1.0 / float(rows.inverse_masses[ball]))
            if float(rows.positions[ball, 1]) < 1.1 * radius:
                resist_rolling(self.world, ball, radius, ROLLS, dt)
        place, velocity = rows.positions[stone].copy(), rows.velocities[stone].copy()
        both = np.append(self.blocks, stone)
        pushed = momentum(self.world, both)
        said = super().advance(dt)
        shot, found = self.machine.shot, impacts(self.world, 0.0)
        if phase == THROWING and self.machine.phase == LOOSE and shot is not None:
            self.flying, self.thrown, self.landing, self.trail = stone, self.time, None, [(shot.x, shot.y)]
            self.before = self.after = math.nan
        elif self.flying != NOBODY:
            touched = np.flatnonzero((found.bodies == stone).any(axis=1))
            if len(touched):
                first = touched[int(np.argmin(found.rows[touched, 4]))]
                x, y = (place + float(found.rows[first, 4]) * velocity).tolist()
                self.flying, self.landing = NOBODY, (x, y)
                if np.isin(found.bodies[first], self.blocks).any():
                    self.before, self.after = pushed, momentum(self.world, both)
            elif len(self.trail) < MOST and self.time > self.thrown + EVERY * len(self.trail):
                self.trail.append((float(rows.positions[stone, 0]), float(rows.positions[stone, 1])))
        loud = found.take(found.rows[:, 3] > LEAST_HEARD)
        kinds = np.where((loud.shapes == SEGMENT).any(axis=1), EARTH, STONES)
        random = np.random.default_rng((self.seed, round(1e4 * self.time)))
        self.dust.rise(loud.rows, kinds == EARTH, DUSTY, random)
        kinds[(kinds == EARTH) & np.isin(loud.bodies, self.machine.stones).any(axis=1)] = LANDING
        self.heard.remember(loud.heard(self.time - dt, kinds, loud.by_impulse(USUAL, 3.0)), self.time - dt)
        return said

    def range_by_law(self) -> float:
        """m from where the sling let go to the height of landing, by the parabola without air; NaN before."""
        shot, gravity = self.machine.shot, self.gravity()
        if shot is None or self.landing is None or gravity <= 0.0:
            return math.nan
        under = shot.vy * shot.vy + 2.0 * gravity * (shot.y - self.landing[1])
        return shot.vx * (shot.vy + math.sqrt(under)) / gravity if under >= 0.0 else math.nan

    def out_of_place(self) -> int:
        """How many blocks are not where they were built."""
        away = self.world.bodies.positions[self.blocks] - self.homes
        return int(np.count_nonzero(elementwise.hypot(away[:, 0], away[:, 1]) > MOVED))
