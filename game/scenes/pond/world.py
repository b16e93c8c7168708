"""A pond of wave particles, its floats and its boat, and what a hand does to them."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY
from game.physics.kernels import elementary
from game.physics.waves.effects import BOAT, FADING, FLOATS, SPLITTING
from game.physics.waves.floats import FX, FY, FZ, RADIUS, FloatingBodies, FloatSettings, FloatState
from game.physics.waves.hull import HX, HY, Hull, HullState
from game.physics.waves.wave_particles import WaveParticles, WaveParticleState, WaveSettings
from game.scenes.pond.level import MOST_FLOATS, PondContent
from game.scenes.pond.parameters import RADII, SIZES, PondParameters
from game.settings import taken
from game.worlds.world import Kept, Whole, World

BOAT_SIZE = (1.4, 0.46, 0.14)  # m: length, width, draft
TOUCHED = 0.12  # m about a small float, in which a hand has it
FOLLOWS, FASTEST = 2.5, 4.0  # 1/s and m/s: how the boat comes after the hand
SHARE_OF_RADIUS = 0.4  # that a wave goes between two that leave one face
NO_SPLIT = 1e9  # radii
CLOCK, RAINED, OWED = range(3)


class PondState(NamedTuple):
    """water, floats, boat; clock: (3,) s, drops of rain that fell, share of the next; course: of the boat."""

    water: WaveParticleState
    floats: FloatState
    boat: HullState
    clock: Floats
    course: Floats


class PondWorld(World):
    """A pond. course: (5,) velocity (m/s) that the boat keeps by itself; 1 while a hand leads it; to where.

    touched: a hand has put something there, so that nothing is known by theory any more.
    """

    state_type = PondState

    def __init__(self, content: PondContent, parameters: PondParameters, active: EffectSet, seed: int):
        self.parameters, self.active, self.seed = parameters, active, seed
        size = content.width, content.height
        cell = min(max(float(parameters.cell), max(size) / 500.0), 0.25 * min(size))
        radii = tuple(min(max(radius, cell), 0.25 * min(size)) for radius in RADII)
        self.water = WaveParticles(size, radii, cell, self._waves(), int(parameters.most))
        self.floats = FloatingBodies(self.water, taken(FloatSettings, parameters.values))
        boat = content.boat
        self.has_boat = boat is not None
        where = (boat.x, boat.y) if boat is not None else (0.0, 0.0)
        self.boat = Hull(self.water, where, *BOAT_SIZE)
        self.course: Floats = np.zeros(5)
        if boat is not None:
            self.course[:2] = boat.along, boat.up
            speed = float(elementary.hypot(boat.along, boat.up))
            if speed > 0.0:
                self.boat.pose[4:] = boat.along / speed, boat.up / speed
        for entry in content.floats:
            self.floats.add((entry.x, entry.y), entry.radius, entry.tall, entry.density)
            self.floats.rows[-1, FZ] += entry.lifted
        self._strew(content.strewn, size)
        for drop in content.drops:
            if drop.ring:
                self.water.add_ring((drop.x, drop.y), drop.height, self.reach, self.kind)
            else:
                self.water.drop((drop.x, drop.y), drop.height, self.kind)
        self.water.find_heights()
        self.clock: Floats = np.zeros(3)
        self.touched = False
        super().__init__(
            content, parameters, active,
            Whole(self.water), Whole(self.floats), Whole(self.boat), Kept(self, "clock", "course"),
        )  # fmt: skip

    def _strew(self, count: int, size: tuple[float, float]) -> None:
        """Floats in rows all over the pond."""
        if not count:
            return
        columns = max(1, round(math.sqrt(count * size[0] / size[1])))
        rows = -(-count // columns)
        for k in range(count):
            at = (k % columns + 0.5) / columns * size[0], (k // columns + 0.5) / rows * size[1]
            self.floats.add(at, 0.1 + 0.05 * ((7 * k) % 3), 0.16, 0.5)

    @property
    def kind(self) -> int:
        """Number of the radius of waves that come now."""
        return SIZES.index(self.parameters.waves)

    @property
    def reach(self) -> float:
        """How far from its middle (m) a ring begins."""
        return 2.0 * float(self.water.radii[self.kind])

    def _waves(self) -> WaveSettings:
        """What is chosen, without the effects that are off."""
        found = taken(WaveSettings, self.parameters.values)
        return found._replace(
            gravity=found.gravity if GRAVITY in self.active else 0.0,
            fading=found.fading if FADING in self.active else 0.0,
            spacing=found.spacing if SPLITTING in self.active else NO_SPLIT,
        )

    def change_parameter(self, name: str) -> None:
        self.water.settings = self._waves()
        self.floats.settings = taken(FloatSettings, self.parameters.values)

    def change_effects(self, active: EffectSet) -> None:
        super().change_effects(active)
        self.water.settings = self._waves()

    def restore(self, state: PondState) -> None:
        super().restore(state)
        self.water.find_heights()

    # -- a step ---------------------------------------------------------------------------------------

    def advance(self, dt: float) -> str:
        water, before = self.water, self.clock[CLOCK]
        water.step(dt)
        self._rain(dt)
        if self.has_boat and BOAT in self.active:
            self.boat.step(self._boat_speed(), dt)
            if FLOATS in self.active:
                self.boat.push_aside(self.floats.rows)
        if FLOATS in self.active and len(self.floats):
            self.floats.step(dt)
        self.clock[CLOCK] = before + dt
        between = SHARE_OF_RADIUS * float(water.radii[self.kind]) / self._fastest()
        if math.floor((before + dt) / between) > math.floor(before / between):
            if BOAT in self.active:
                self.boat.send_waves(self.kind)
            if FLOATS in self.active:
                self.floats.send_waves(0)
        water.find_heights()
        self.time += dt
        return ""

    def _fastest(self) -> float:
        """m/s, of waves and boat."""
        return max(float(self.water.speeds[self.kind]), self.boat.speed, 1e-3)

    def _rain(self, dt: float) -> None:
        self.clock[OWED] += float(self.parameters.rain) * dt
        while self.clock[OWED] >= 1.0:
            self.clock[OWED] -= 1.0
            self.clock[RAINED] += 1.0
            rng = np.random.default_rng((self.seed, int(self.clock[RAINED])))
            x, y = (rng.random(2) * self.water.size).tolist()
            self.water.drop((x, y), 0.25 * float(self.parameters.stone), 0)

    def _boat_speed(self) -> tuple[float, float]:
        """m/s: after the hand, or on its own course; it turns round at a bank."""
        pose = self.boat.pose
        if self.course[2]:
            to = FOLLOWS * (self.course[3:] - pose[[HX, HY]])
            speed = float(elementary.hypot(*to.tolist()))
            vx, vy = (to * min(1.0, FASTEST / max(speed, 1e-9))).tolist()
            return vx, vy
        for axis in range(2):
            near = 0.5 * BOAT_SIZE[0]
            if pose[axis] < near:
                self.course[axis] = abs(self.course[axis])
            elif pose[axis] > self.water.size[axis] - near:
                self.course[axis] = -abs(self.course[axis])
        return float(self.course[0]), float(self.course[1])

    # -- the hand -------------------------------------------------------------------------------------

    def drop(self, place: tuple[float, float]) -> None:
        """A stone falls in."""
        self.water.drop(place, float(self.parameters.stone), self.kind)
        self.touched = True

    def lead(self, place: tuple[float, float] | None) -> None:
        """Let the boat come to a place from now on; None: let it lie."""
        self.touched = True
        self.course[:2] = 0.0
        self.course[2] = 0.0 if place is None else 1.0
        if place is not None:
            self.course[3:] = place

    def put_float(self, place: tuple[float, float]) -> str:
        """Another float; why it cannot be, or ""."""
        if len(self.floats) >= MOST_FLOATS:
            return f"There are {MOST_FLOATS} floats already."
        self.floats.add(place, float(self.parameters.radius), 0.2, float(self.parameters.density))
        self.touched = True
        return ""

    def float_at(self, place: tuple[float, float]) -> int | None:
        """Number of the float at a place."""
        rows = self.floats.rows
        off = rows[:, [FX, FY]] - place
        reach = elementary.square(np.maximum(rows[:, RADIUS], TOUCHED))
        near = np.nonzero((off * off).sum(axis=1) < reach)[0]
        return int(near[-1]) if len(near) else None
