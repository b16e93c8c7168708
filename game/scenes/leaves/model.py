"""Leaves on a lawn: what they are, the wind that takes them, the basket, what they do."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Flags, Floats, Longs, Point
from game.physics.effects import EffectSet
from game.physics.kernels import elementary, elementwise, linear
from game.physics.plates import Gust, GustyWind, Plate, Plates, PlateSettings, PlateState
from game.physics.plates.law import X, Y
from game.physics.plates.watch import NOTHING
from game.scenes.leaves.basket import Basket
from game.scenes.leaves.level import LeavesContent
from game.scenes.leaves.parameters import OF_LEAVES, LeavesParameters
from game.scenes.leaves.sounds import blowing, landings, rubbing
from game.scenes.leaves.species import SPECIES
from game.scenes.leaves.ways import WAY, follow_ways, seen_of
from game.worlds.hearing import Heard
from game.worlds.world import Kept, Member, Whole, World

LAYER = 0.4  # m of the lawn's slow air
HOLLOW = 0.35  # m below the lawn where gusts are mirrored: air also flows in from before and behind the plane
IN_THE_AIR = 0.12  # m
ALOFT_S = 0.25  # without a touch for so long a leaf has taken off
MOST_LEAVES = 400
FOLLOWS_S = 1.5  # s in which the camera comes after the middle of those that fly
NAMES = tuple(SPECIES)


class LeavesState(NamedTuple):
    """plates; ways (n, WAY): see `ways`; gusts (MOST_GUSTS, GUST); own (n, 6): see `LeavesModel.own`;
    airborne (n,): s since it was last touched; heard (k, HEARD_WIDTH): see `sounds`; tally (4,):
    how often leaves took off, the highest so far (m), and where the camera has the middle of those that fly
    (m).
    """

    plates: PlateState
    ways: Floats
    gusts: Floats
    own: Floats
    airborne: Floats
    heard: Floats
    tally: Floats


KIND, YAW, SHADE, DEPTH, FLIP, GROWN = range(6)


class Gusts(Member):
    """What blows now."""

    def __init__(self, wind: GustyWind):
        self.wind = wind

    def state(self) -> tuple[Any, ...]:
        return (self.wind.gusts[: self.wind.count],)

    def restore(self, fields: Iterator[Any]) -> None:
        self.take(next(fields))

    def take(self, gusts: Floats) -> None:
        """These (n, GUST), and no others."""
        self.wind.gusts[:] = 0.0
        self.wind.count = len(gusts)
        self.wind.gusts[: self.wind.count] = gusts


class LeavesModel(World):
    """own (n, 6): kind, turn of its outline within its plane (rad), shade 0 to 1, depth -1 to 1, whether its
    outline is mirrored, and its size beside its kind's. airborne, ways, tally: see `LeavesState`.
    """

    state_type = LeavesState
    content: LeavesContent
    parameters: LeavesParameters

    def __init__(self, content: LeavesContent, parameters: LeavesParameters, active: EffectSet, seed: int):
        super().__init__(content, parameters, active)
        self.added = 0
        self.basket = Basket.of(content.basket)
        self.wind = GustyWind(parameters.wind, LAYER, -HOLLOW, [self.basket.shelter()])
        for gust in content.gusts:
            self.wind.add(gust.gust())
        self.plates = Plates(
            effects=active, wind=self.wind, walls=self.basket.walls(), method=parameters.method,
            settings=self._settings(),
        )  # fmt: skip
        self.ways: Floats = np.zeros((0, WAY))
        self.own: Floats = np.zeros((0, 6))
        self.airborne: Floats = np.zeros(0)
        self.heard, self.gusts = Heard(), Gusts(self.wind)
        self.tally: Floats = np.array((0.0, 0.0, -0.6, 0.6))
        self.chance = seed
        self._lay()
        self.members = (
            Whole(self.plates), Kept(self, "ways"), self.gusts, Kept(self, "own", "airborne"), self.heard,
            Kept(self, "tally"),
        )  # fmt: skip

    def _settings(self) -> PlateSettings:
        return PlateSettings(self.parameters.gravity, 0.0, self.parameters.friction)

    def _lay(self) -> None:
        """The leaves of the level's beds."""
        random = np.random.default_rng(self.chance)
        for bed in self.content.beds:
            for k in range(bed.count):
                kind = bed.kinds[k % len(bed.kinds)]
                x = bed.left + (bed.right - bed.left) * (k + 0.5) / bed.count
                jitter = 0.0 if bed.alike else 1.0
                x += jitter * linear.uniform(random, -0.02, 0.02)
                y = bed.height + 0.02 + 0.02 * (k % 2) + bed.spread * random.random()
                # at rest with the rims up or down; let go from above at any angle
                angle = linear.uniform(random, -0.1, 0.1) + (math.pi if random.random() < 0.5 else 0.0)
                if bed.height > 0.1:
                    angle = 0.2 if bed.alike else linear.uniform(random, -math.pi, math.pi)
                self.add(kind, (x, y), angle, random, jitter)

    # -- changes --------------------------------------------------------------------------------------

    def add(
        self, kind: str, place: Point, angle: float, random: np.random.Generator,
        jitter: float = 1.0,
    ) -> None:  # fmt: skip
        """One more leaf; ValueError if there are too many."""
        if len(self.plates) >= MOST_LEAVES:
            raise ValueError(f"leaves: at most {MOST_LEAVES}")
        grown = 1.0 + jitter * linear.uniform(random, -0.15, 0.15)
        own = (
            float(NAMES.index(kind)),
            linear.uniform(random, -0.5, 0.5) + (math.pi if random.random() < 0.5 else 0.0),
            random.random(), linear.uniform(random, -1.0, 1.0), float(random.integers(2)), grown,
        )  # fmt: skip
        self.own = np.concatenate([self.own, np.array([own])])
        self.plates.add(self._plate(len(self.own) - 1), place, angle)
        self.ways = np.concatenate([self.ways, np.zeros((1, WAY))])
        self.airborne = np.append(self.airborne, 0.0)

    def drop(self, kind: str, place: Point) -> None:
        """A leaf by hand."""
        self.added += 1
        random = np.random.default_rng((self.chance, self.added))
        self.add(kind, place, linear.uniform(random, -math.pi, math.pi), random)

    def _plate(self, number: int) -> Plate:
        """The law of a leaf: its kind, its own shade of it, and what is chosen for all."""
        row, chosen = self.own[number], self.parameters
        species = SPECIES[NAMES[int(row[KIND])]]
        kind = species.plate
        unlike = (row[SHADE] - 0.4) * (row[GROWN] != 1.0)
        curl = kind.curl + species.curls * unlike + chosen.curl
        return kind._replace(
            half_chord=kind.half_chord * row[GROWN],
            inertia=kind.inertia * chosen.weight * (1.0 + species.varies * unlike),
            curl=min(max(curl, -1.1), 1.1), bend_hz=kind.bend_hz * chosen.stiffness,
            balance=min(max(kind.balance + chosen.balance, -0.8), 0.8),
        )  # fmt: skip

    def change_effects(self, active: EffectSet) -> None:
        super().change_effects(active)
        self.plates.effects = active

    def change_parameter(self, name: str) -> None:
        """Take over a parameter's new value."""
        chosen = self.parameters
        if name == "wind":
            self.wind.set_wind(chosen.wind, LAYER)
        elif name == "method":
            self.plates.set_method(chosen.method)
        elif name in ("gravity", "friction"):
            self.plates.settings = self._settings()
        elif name in OF_LEAVES:
            for number in range(len(self.plates)):
                self.plates.change(number, self._plate(number))

    def blow(self, place: Point, way: Point) -> None:
        """A gust as it was drawn: from a place (m) on, by the length and direction of the way (m)."""
        length = elementary.length(*way)
        if length < 0.05:
            return
        speed = min(3.0 * length, 6.0) * self.parameters.gusts
        along = (way[0] / length, way[1] / length)
        blows = (speed * along[0], speed * along[1] + 0.3 * speed)
        goes = (0.45 * speed * along[0], 0.45 * speed * along[1])
        self.wind.add(Gust(place, self.plates.time, 2.5, goes, self.parameters.size, blows))

    # -- a step ---------------------------------------------------------------------------------------

    def advance(self, dt: float) -> str:
        """Leaves in the wind, then what they were seen and heard to do."""
        plates = self.plates
        before = plates.rows.copy()
        self.wind.forget(plates.time)
        plates.step(dt)
        plates.check()
        free = plates.touched <= 0.0
        follow_ways(self.ways, plates.rows, plates.air, free, dt)
        landed = np.flatnonzero(~free & (self.airborne > ALOFT_S))
        took_off = free & (self.airborne <= ALOFT_S) & (self.airborne + dt > ALOFT_S)
        rows, now = plates.rows, plates.time
        sounds = (
            landings(landed, before, rows, now),
            rubbing(~free, rows, now, dt),
            blowing(plates.air, now, dt),
        )
        self.heard.forget(now)
        self.heard.append(np.concatenate(sounds))
        self.airborne = np.where(free, self.airborne + dt, 0.0)
        self.tally[0] += np.count_nonzero(took_off)
        if len(plates):
            self.tally[1] = max(self.tally[1], float(np.max(plates.rows[Y])))
            x, y = self.cloud()
            share = dt / (FOLLOWS_S + dt)
            self.tally[2] += share * (x - self.tally[2])
            self.tally[3] += share * (max(y, 0.7) - self.tally[3])
        return ""

    # -- what is there --------------------------------------------------------------------------------

    def inside(self) -> Flags:
        """(n,) whether a leaf's middle is in the basket."""
        return self.basket.holds(self.plates.rows[X], self.plates.rows[Y])

    def flying(self) -> Flags:
        """(n,) whether a leaf is in the air."""
        return np.asarray((self.airborne > 0.1) & (self.plates.rows[Y] > IN_THE_AIR))

    def seen(self) -> Longs:
        """(n,) what each leaf is seen to do in the air: of `plates.watch`, NOTHING for one that lies."""
        return np.where(self.flying(), seen_of(self.ways, self.plates.laws), NOTHING)

    def gusts_now(self) -> float:
        """The strongest wind at a leaf, m/s."""
        return float(np.max(elementwise.hypot(*self.plates.air[:2]), initial=0.0))

    def cloud(self) -> Point:
        """The middle of the leaves that fly; of all, without any."""
        flying = self.flying()
        rows = self.plates.rows
        if not len(self.plates):
            return 0.0, 0.5
        part = flying if flying.any() else np.ones(len(flying), dtype=bool)
        return float(np.mean(rows[X, part])), float(np.mean(rows[Y, part]))
