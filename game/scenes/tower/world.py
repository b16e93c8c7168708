"""The tower: what is cut, what gives way, what breaks, how fast it comes down, and the dust of it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats, Longs
from game.physics.effects import EffectSet
from game.physics.kernels import linear
from game.physics.solids import SolidState
from game.scenes.tower.air import AirState, TowerAir, loose_of, solids_of
from game.scenes.tower.breaking import apart, cuts_of, halves_of
from game.scenes.tower.building import COLUMN, NOT_YET, RUBBLE, SHARD, SLAB, floor_height, half_width
from game.scenes.tower.frame import FLOORS, Frame
from game.scenes.tower.level import TowerContent
from game.scenes.tower.parameters import TowerParameters
from game.scenes.tower.sounds import MOST, air_heard, charges, impacts_heard
from game.worlds.hearing import Heard
from game.worlds.members.dust import Dust, advance_dust
from game.worlds.members.solids import Solids
from game.worlds.stopwatch import Stopwatch
from game.worlds.world import Member, World

PIECES_OF_COLUMN = 3
SKIN, SLOWEST = 0.02, 0.1  # m; m/s
HARD, MOST_HARD = 2.0, 24  # m/s of a strike that raises dust; of so many in a step
OF_COLUMN, OF_STRIKE, ON_FLOOR = 4.0, 0.8, 3.0  # kg of dust of a column, of a hard strike; kg/m² on a floor
PUFFS = 36  # at both ends of a floor that comes down


class TowerState(NamedTuple):
    """world; parts, storeys: see `tables`; dust (d, DUST_WIDTH), heard (k, HEARD_WIDTH); clock (3,), freed
    (3,): see `Course`; air.
    """

    world: SolidState
    parts: Floats
    storeys: Floats
    dust: Floats
    heard: Floats
    clock: Floats
    freed: Floats
    air: AirState


class Freed(NamedTuple):
    """When nothing carried what falls any more (s), how fast it was then (m/s), how far it had come (m)."""

    time: float = NOT_YET
    speed: float = NOT_YET
    way: float = NOT_YET


class Course(Member):
    """How far the fall has come. fired: s at which it was fired, NOT_YET; steps: since then; dusted: kg that
    have become dust.
    """

    def __init__(self) -> None:
        self.fired, self.steps, self.dusted, self.freed = NOT_YET, 0, 0.0, Freed()

    def step(self, dt: float) -> None:
        self.steps += 1

    def state(self) -> tuple[Any, ...]:
        return np.array([self.fired, float(self.steps), self.dusted]), np.array(self.freed)

    def restore(self, fields: Iterator[Any]) -> None:
        self.fired, steps, self.dusted = next(fields).tolist()
        self.steps, self.freed = int(steps), Freed(*next(fields).tolist())


class TowerWorld(World):
    """A tower of a level. ValueError for a storey to begin at that there is not."""

    state_type = TowerState
    content: TowerContent
    parameters: TowerParameters

    def __init__(self, content: TowerContent, parameters: TowerParameters, active: EffectSet, seed: int):
        super().__init__(content, parameters, active)
        if content.first > content.storeys:
            raise ValueError(f"first = {content.first}: there are {content.storeys} storeys")
        self.watch = Stopwatch()
        self.build()

    def build(self) -> None:
        """Build it, whatever is left of one before: nothing is fired, and there is no dust."""
        self.solids = Solids(self.parameters, self.active)
        self.solids.watch = self.watch
        self.world = self.solids.world
        self.frame = Frame(self.solids, self.content, self.parameters)
        self.dust, self.heard, self.course = Dust(), Heard(MOST), Course()
        self.air = TowerAir(self.content, self.active)
        self.members = self.solids, self.frame, self.dust, self.heard, self.course, self.air

    def fire(self) -> None:
        """Begin the schedule now."""
        if self.course.fired == NOT_YET:
            self.course.fired = self.time
            self.course.steps = 0  # so things break as they would whenever it is fired

    def first_storey(self) -> int:
        """Whose columns are cut first."""
        chosen = int(self.parameters.first) or self.content.first
        return min(chosen, self.content.storeys)

    # -- cutting and breaking -------------------------------------------------------------------------

    def _random(self, number: int) -> np.random.Generator:
        return np.random.default_rng((self.content.seed, self.course.steps, number))

    def cut(self, row: int) -> None:
        """A charge turns a column into rubble that flies off to both sides, and some of it into dust."""
        parts, random = self.frame.parts, self._random(row)
        storey, place = int(parts.storey[row]), self.world.bodies.positions[int(parts.body[row])].copy()
        pieces = cuts_of(float(parts.wide[row]), float(parts.tall[row]), PIECES_OF_COLUMN, random)
        side = np.where(np.arange(len(pieces)) % 2 == 0, 1.0, -1.0) * (1.0 if random.random() < 0.5 else -1.0)
        thrown = np.stack(
            [side * linear.uniform(random, 0.6, 1.4, len(pieces)), np.zeros(len(pieces))], axis=1
        )
        made = self.frame.replace(row, pieces, RUBBLE, self.parameters.blast * thrown)
        if self.frame.storeys.cut[storey - 1] == NOT_YET:
            self.frame.storeys.cut[storey - 1] = self.time
        places = linear.uniform(random, -0.5, 0.5, (10, 2)) * (1.0, 2.0) + place
        self._grind(made, OF_COLUMN, places)
        self.dust.add(places, linear.uniform(random, -3.0, 3.0, (10, 2)), 0.8, 3.5, random)

    def break_floor(self, row: int, stopped: float = 0.0) -> None:
        """A floor's bay, a column or a shard of one breaks in two or three, which still meet the floors.

        stopped: m/s that it has lost; some of it throws the pieces apart.
        """
        parts, random = self.frame.parts, self._random(row)
        wide, tall = float(parts.wide[row]), float(parts.tall[row])
        if parts.kind[row] != SHARD:
            pieces = cuts_of(wide, tall, 3 if max(wide, tall) > 3.0 else 2, random)
        else:
            pieces = halves_of(self.frame.corners(row), random)
        self.frame.replace(row, pieces, SHARD, apart(pieces, stopped, random))

    def _grind(self, rows: Longs, most: float, places: Floats) -> None:
        """At most so many kg of parts become dust, which the air takes up at places (n, 2) m."""
        if not len(rows):
            return
        kilograms = self.frame.ground_to_dust(rows, most)
        self.course.dusted += kilograms
        if self.air.on:
            self.air.raise_dust(places, kilograms)

    # -- a step ---------------------------------------------------------------------------------------

    def advance(self, dt: float) -> str:
        """Charges first, then the solids; then what these have broken, the air, and the dust in it."""
        at = self.content.fired_at
        if at is not None and self.time >= at - 0.5 * dt:
            self.fire()
        charged = self._cut_on_schedule(dt)
        if self.parameters.gives_way:
            self._give_way(dt)
        before = self.world.bodies.velocities.copy()
        said = super().advance(dt)
        began = self.time - dt
        blown = air_heard(self.air.fastest() if self.air.on else 0.0, self.time, dt)
        self.heard.remember(np.concatenate([impacts_heard(self.world, began), blown]), began)
        self.heard.remember(charges(charged, began), began)  # last: none of them is lost among the stones
        self._break_by_impact()
        for row, lost in self.frame.stopped(before, dt):
            self.break_floor(row, lost)
        self._blow(dt)
        return said

    def _blow(self, dt: float) -> None:
        """Air and dust, once something moves."""
        if not self.air.on:
            self.dust.rows = advance_dust(self.dust.rows, dt)
            return
        if self.solids.awake() or not self.air.is_still():
            with self.watch.time("air"):
                solids = solids_of(self.frame, self.air.thickness(0.0))
                self.air.advance(solids, loose_of(self.frame), self.gravity(), dt)
        self.dust.rows = advance_dust(self.dust.rows, dt, self.air.gas.sample)

    def _cut_on_schedule(self, dt: float) -> Floats:
        """Cut the columns whose time it is; the places (k,) m of these charges."""
        if self.course.fired == NOT_YET:
            return np.zeros(0)
        first, parts = self.first_storey(), self.frame.parts
        due = (self.time - self.course.fired + 0.5 * dt) / max(self.parameters.delay, 1e-9)
        mine = self.frame.rows((COLUMN,), (first,))
        now = mine[parts.place[mine] <= due]
        places = self.world.bodies.positions[parts.body[now], 0].copy()
        for row in now.tolist():
            self.cut(row)
        if len(mine) and len(now) == len(mine):
            self._set_free(first)
        return places

    def _set_free(self, storey: int) -> None:
        """Nothing carries what is above a storey any more: note when, how fast it is, how far it has come."""
        bodies, own = self.world.bodies, self.frame.bodies((SLAB,), (storey,))
        if len(own):
            way = floor_height(self.content, storey) - 0.5 * self.content.slab - bodies.positions[own, 1]
            speed = -float(bodies.velocities[own, 1].mean())
            self.course.freed = Freed(self.time, max(speed, 0.0), max(float(way.mean()), 0.0))

    def _give_way(self, dt: float) -> None:
        """Columns of a storey break where the floor above has come down upon its own floor."""
        content, rows, storeys = self.content, self.world.bodies, self.frame.storeys
        for storey in range(content.storeys - 1, 0, -1):
            if storeys.struck[storey - 1] != NOT_YET or storeys.cut[storey] == NOT_YET:
                continue
            bodies = self.frame.bodies(FLOORS, (storey + 1,))
            if not len(bodies):
                continue
            speed = -float(np.median(rows.velocities[bodies, 1]))
            gap = float(np.median(rows.positions[bodies, 1])) - floor_height(content, storey)
            gap -= 0.5 * content.slab
            if gap > 1.5 * dt * max(speed, 0.0) + SKIN:
                continue
            storeys.struck[storey - 1] = self.time + max(gap, 0.0) / max(speed, SLOWEST)
            self._blow_out(storey, speed)
            for row in self.frame.rows((COLUMN,), (storey,)).tolist():
                self.cut(row)

    def _blow_out(self, storey: int, speed: float) -> None:
        """The air between two floors leaves at both sides, by continuity."""
        half, random = half_width(self.content), self._random(100_000 + storey)
        y = floor_height(self.content, storey) + linear.uniform(random, 0.1, 0.9, PUFFS)
        if self.air.on:  # the air knows how fast, and takes it along from all over the floor
            x, speeds = linear.uniform(random, -half, half, PUFFS), np.zeros((PUFFS, 2))
        else:
            side = np.where(np.arange(PUFFS) % 2 == 0, 1.0, -1.0)
            fast = min(max(speed, 0.0) * half / self.content.storey, 18.0)
            x = side * half
            speeds = np.stack([side * fast, linear.uniform(random, -1.0, 2.0, PUFFS)], axis=1)
        places = np.stack([x, y], axis=1)
        self._grind(self.frame.rows(FLOORS, (storey, storey + 1)), ON_FLOOR * 2.0 * half, places)
        self.dust.add(places, speeds, 1.3, 9.0, random)

    def _break_by_impact(self) -> None:
        """Floors that were stopped faster than they bear break; what strikes raises dust."""
        shapes, begun = self.world.contacts_begun()
        if not len(begun):
            return
        bodies: Any = self.world.shapes.bodies[shapes]
        hard = np.flatnonzero(begun[:, 3] > HARD)[:MOST_HARD]
        if len(hard):
            rows, places = self.frame.rows_of(bodies[hard]), begun[hard, :2]
            self._grind(np.unique(rows[rows >= 0]), OF_STRIKE * len(hard), places)
            up = np.tile((0.0, 0.8), (len(hard), 1))
            self.dust.add(places, up, 1.0, 6.0, self._random(200_000))
        for row in self.frame.struck(bodies, begun[:, 2]):
            self.break_floor(row)
