"""The tower: what is cut, what gives way, what breaks, how fast it comes down, and the dust of it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY
from game.physics.kernels import linear
from game.physics.solids import SolidSettings, SolidState, SolidWorld
from game.physics.solids.arrays.state import ASLEEP, DYNAMIC
from game.physics.solids.effects import SOLIDS
from game.scenes.tower import tables
from game.scenes.tower.air import AirState, TowerAir, loose_of, solids_of
from game.scenes.tower.breaking import (
    apart,
    break_up,
    cuts_of,
    grind,
    halves_of,
    middle_of,
    shocks_of,
    speed_of_stop,
)
from game.scenes.tower.building import (
    build,
    floor_height,
    frame_stuff,
    half_width,
    rubble_stuff,
)
from game.scenes.tower.dust import advance_dust, puffs
from game.scenes.tower.effects import AIR
from game.scenes.tower.level import TowerContent
from game.scenes.tower.parameters import TowerParameters
from game.scenes.tower.sounds import air_heard, charges, impacts, remembered
from game.scenes.tower.tables import none_of
from game.stage import ParameterError, Part
from game.worlds.hearing import HEARD_WIDTH
from game.worlds.stopwatch import Stopwatch

MOST_BODIES = 1_500
PIECES_OF_COLUMN = 3
LEAST_LONG = 1.0  # m: shorter shards do not break any more
NOT_FIRED = -1.0
SKIN, SLOWEST = 0.02, 0.1  # m; m/s
LASTING = 1.5  # of what a strike may take from a body that bears it: what a stop of `STOP_S` may
MOST_GROUND = 0.2  # of what it comes from may become dust at once
OF_COLUMN, OF_STRIKE, ON_FLOOR = 4.0, 0.8, 3.0  # kg of dust of a column, of a hard strike; kg/m² on a floor


class ModelState(NamedTuple):
    """world; parts (n, PART_WIDTH), storeys (s, STOREY_WIDTH), dust (d, DUST_WIDTH), heard (k, HEARD_WIDTH):
    see `tables`; clock (3,): time of the firing s (NOT_FIRED), steps, kg that have become dust; freed (3,):
    see `tables`; air.
    """

    world: SolidState
    parts: Floats
    storeys: Floats
    dust: Floats
    heard: Floats
    clock: Floats
    freed: Floats
    air: AirState


class TowerModel(Part):
    """A tower of a level. time: s; fired: s at which it was fired (NOT_FIRED)."""

    def __init__(self, content: TowerContent, parameters: TowerParameters, active: EffectSet):
        if content.first > content.storeys:
            raise ValueError(f"first = {content.first}: there are {content.storeys} storeys")
        self.content, self.parameters, self.active = content, parameters, active
        self.watch = Stopwatch()
        self.time = 0.0
        self.build()

    def build(self) -> None:
        """Build it, whatever is left of one before: nothing is fired, and there is no dust."""
        content, parameters = self.content, self.parameters
        self.steps, self.fired = 0, NOT_FIRED
        self.world = SolidWorld(self._settings())
        self.ground, self.parts = build(self.world, content, parameters.friction, parameters.joints)
        self.storeys = np.full((content.storeys, tables.STOREY_WIDTH), tables.NOT_YET)
        self.dust, self.heard = none_of(tables.DUST_WIDTH), none_of(HEARD_WIDTH)
        self.world.check_solver()
        self.built_mass = float(self.parts[:, tables.MASS].sum())
        self.dusted, self.freed = 0.0, np.full(3, tables.NOT_YET)
        self.air = TowerAir(content)

    # -- changes --------------------------------------------------------------------------------------

    def _settings(self) -> SolidSettings:
        parameters = self.parameters
        try:
            return SolidSettings(
                effects=self.active & SOLIDS.known,
                solver=parameters.solver,
                substeps=parameters.substeps_now(),
                gravity=(0.0, -parameters.gravity),
            )
        except ValueError as error:
            raise ParameterError(str(error)) from None

    def change_parameter(self, name: str) -> None:
        """Take over a parameter's new value."""
        self.watch.clear()
        if name == "friction":
            bodies = self.parts[self.parts[:, tables.BODY] >= 0.0, tables.BODY].astype(np.int64)
            shapes = self.world.shapes
            shapes.frictions[np.isin(shapes.bodies, bodies)] = self.parameters.friction
        self.world.settings = self._settings()

    def change_effects(self, active: EffectSet) -> None:
        """Compute these effects from now on."""
        if AIR in active and AIR not in self.active:
            self.air = TowerAir(self.content)
        self.active = active
        self.world.settings = self._settings()
        self.watch.clear()

    def fire(self) -> None:
        """Begin the schedule now."""
        if self.fired == NOT_FIRED:
            self.fired = self.time
            self.steps = 0  # so things break as they would whenever it is fired

    def first_storey(self) -> int:
        """Whose columns are cut first."""
        chosen = int(self.parameters.first) or self.content.first
        return min(chosen, self.content.storeys)

    # -- cutting and breaking -------------------------------------------------------------------------

    def _random(self, number: int) -> np.random.Generator:
        return np.random.default_rng((self.content.seed, self.steps, number))

    def cut(self, row: int) -> None:
        """A charge turns a column into rubble that flies off to both sides, and some of it into dust."""
        part = self.parts[row]
        storey, random = int(part[tables.STOREY]), self._random(row)
        body = int(part[tables.BODY])
        x, y = self.world.bodies.positions[body].tolist()
        pieces = cuts_of(float(part[tables.WIDE]), float(part[tables.TALL]), PIECES_OF_COLUMN, random)
        side = np.where(np.arange(len(pieces)) % 2 == 0, 1.0, -1.0) * (1.0 if random.random() < 0.5 else -1.0)
        thrown = np.stack(
            [side * linear.uniform(random, 0.6, 1.4, len(pieces)), np.zeros(len(pieces))], axis=1
        )
        made = self._replace(row, pieces, tables.RUBBLE, self.parameters.blast * thrown)
        if self.storeys[storey - 1, tables.CUT] == tables.NOT_YET:
            self.storeys[storey - 1, tables.CUT] = self.time
        spread = linear.uniform(random, -0.5, 0.5, (10, 2)) * (1.0, 2.0)
        self._raise_dust(
            spread + np.array((x, y)), linear.uniform(random, -3.0, 3.0, (10, 2)), 0.8, 3.5, random,
            (made, OF_COLUMN),
        )  # fmt: skip

    def break_floor(self, row: int, stopped: float = 0.0) -> None:
        """A floor's bay, a column or a shard of one breaks in two or three, which still meet the floors.

        stopped: m/s that it has lost; some of it throws the pieces apart.
        """
        part, random = self.parts[row], self._random(row)
        long = max(float(part[tables.WIDE]), float(part[tables.TALL]))
        count = 3 if long > 3.0 else 2
        if part[tables.KIND] != tables.SHARD:
            pieces = cuts_of(float(part[tables.WIDE]), float(part[tables.TALL]), count, random)
        else:
            pieces = halves_of(self._corners(int(part[tables.BODY])), random)
        self._replace(row, pieces, tables.SHARD, apart(pieces, stopped, random))

    def _corners(self, body: int) -> Floats:
        """Corners (k, 2) m of a body's first shape in its own frame."""
        shape = int(self.world.shapes_of(body)[0])
        start, count = int(self.world.shapes.starts[shape]), int(self.world.shapes.counts[shape])
        return self.world.pool.corners[start : start + count].copy()

    def _replace(
        self, row: int, pieces: list[Floats], kind: int, thrown: Floats | None = None
    ) -> list[int]:  # fmt: skip
        """Pieces in the place of a part: their rows, or its own where there are too many bodies."""
        part, stuff = self.parts[row], rubble_stuff if kind == tables.RUBBLE else frame_stuff
        if len(self.world.ids()) + len(pieces) > MOST_BODIES:
            return [row]
        density = float(part[tables.MASS]) / sum(middle_of(corners)[2] for corners in pieces)
        material = stuff(self.parameters.friction, density)
        made = break_up(self.world, int(part[tables.BODY]), pieces, material, thrown)
        rows = [
            (new, kind, part[tables.STOREY], part[tables.PLACE], w, h, mass, 0.0) for new, mass, w, h in made
        ]
        self.parts[row, tables.BODY], self.parts[row, tables.MASS] = tables.GONE, 0.0
        self.parts = np.concatenate([self.parts, np.array(rows)])
        return list(range(len(self.parts) - len(rows), len(self.parts)))

    def _raise_dust(
        self, places: Floats, speeds: Floats, size: float, life: float, random: np.random.Generator,
        source: tuple[Sequence[int] | NDArray[np.int64], float],
    ) -> None:  # fmt: skip
        """Puffs that show it, and dust for the air to carry. source: rows of parts, kg taken from them."""
        self.dust = np.concatenate([self.dust, puffs(places, speeds, size, life, random)])
        rows = np.asarray(source[0], dtype=np.int64)
        if not len(rows):
            return
        kilograms = min(source[1], MOST_GROUND * float(self.parts[rows, tables.MASS].sum()))
        self.parts[rows, tables.MASS] = grind(
            self.world, self.parts[rows, tables.BODY].astype(np.int64), kilograms
        )
        self.dusted += kilograms
        if AIR in self.active:
            self.air.raise_dust(places, kilograms)

    # -- a step ---------------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        """One step."""
        at = self.content.fired_at
        if at is not None and self.time >= at - 0.5 * dt:
            self.fire()
        charged = self._cut_on_schedule(dt)
        if self.parameters.gives_way:
            self._give_way(dt)
        before = self.world.bodies.velocities.copy()
        with self.watch.time("step"):
            self.world.step(dt)
        self.time += dt
        self.steps += 1
        began = self.time - dt
        sounds = [charges(charged, began), impacts(self.world, began)]
        if AIR in self.active:
            sounds.append(air_heard(self.air.fastest(), self.time, dt))
        self.heard = remembered(self.heard, sounds, began)
        self._break_by_impact()
        self._break_by_stops(before, dt)
        self._blow(dt)

    def _blow(self, dt: float) -> None:
        """Air and dust, once something moves."""
        if AIR not in self.active:
            self.dust = advance_dust(self.dust, dt)
            return
        if self.awake() or not self.air.is_still():
            with self.watch.time("air"):
                solids = solids_of(self.parts, self.world.bodies, self.air.thickness(0.0))
                self.air.advance(solids, loose_of(self.parts, self.world.bodies), self.gravity(), dt)
        self.dust = advance_dust(self.dust, dt, self.air.gas.sample)

    def _cut_on_schedule(self, dt: float) -> Floats:
        """Cut the columns whose time it is; the places (k,) m of these charges."""
        if self.fired == NOT_FIRED:
            return np.zeros(0)
        first = self.first_storey()
        parts = self.parts
        due = (self.time - self.fired + 0.5 * dt) / max(self.parameters.delay, 1e-9)
        mine = (
            (parts[:, tables.KIND] == tables.COLUMN)
            & (parts[:, tables.STOREY] == first)
            & (parts[:, tables.BODY] >= 0.0)
        )
        now = np.flatnonzero(mine & (parts[:, tables.PLACE] <= due))
        places = self.world.bodies.positions[parts[now, tables.BODY].astype(np.int64), 0].copy()
        for row in now.tolist():
            self.cut(row)
        if mine.any() and (parts[mine, tables.PLACE] <= due).all():
            self._set_free(first)
        return places

    def _set_free(self, storey: int) -> None:
        """Nothing carries what is above a storey any more: note when, how fast it is, how far it has come."""
        parts, bodies = self.parts, self.world.bodies
        slabs = (
            (parts[:, tables.KIND] == tables.SLAB)
            & (parts[:, tables.STOREY] == storey)
            & (parts[:, tables.BODY] >= 0.0)
        )
        own = parts[slabs, tables.BODY].astype(np.int64)
        if len(own):
            way = floor_height(self.content, storey) - 0.5 * self.content.slab - bodies.positions[own, 1]
            speed = -float(bodies.velocities[own, 1].mean())
            self.freed[:] = self.time, max(speed, 0.0), max(float(way.mean()), 0.0)

    def _give_way(self, dt: float) -> None:
        """Columns of a storey break where the floor above has come down upon its own floor."""
        content, parts = self.content, self.parts
        places, speeds = self.world.bodies.positions, self.world.bodies.velocities
        for storey in range(content.storeys - 1, 0, -1):
            if (
                self.storeys[storey - 1, tables.STRUCK] != tables.NOT_YET
                or self.storeys[storey, tables.CUT] == tables.NOT_YET
            ):
                continue
            above = (parts[:, tables.STOREY] == storey + 1) & (parts[:, tables.BODY] >= 0.0)
            above &= (parts[:, tables.KIND] == tables.SLAB) | (parts[:, tables.KIND] == tables.SHARD)
            bodies = parts[above, tables.BODY].astype(np.int64)
            if not len(bodies):
                continue
            speed = -float(np.median(speeds[bodies, 1]))
            gap = float(np.median(places[bodies, 1])) - floor_height(content, storey) - 0.5 * content.slab
            if gap > 1.5 * dt * max(speed, 0.0) + SKIN:
                continue
            self.storeys[storey - 1, tables.STRUCK] = self.time + max(gap, 0.0) / max(speed, SLOWEST)
            self._blow_out(storey, speed)
            own = (self.parts[:, tables.KIND] == tables.COLUMN) & (self.parts[:, tables.STOREY] == storey)
            for row in np.flatnonzero(own & (self.parts[:, tables.BODY] >= 0.0)).tolist():
                self.cut(row)

    def _blow_out(self, storey: int, speed: float) -> None:
        """The air between two floors leaves at both sides, by continuity."""
        half, random = half_width(self.content), self._random(100_000 + storey)
        side = np.where(np.arange(36) % 2 == 0, 1.0, -1.0)
        y = floor_height(self.content, storey) + linear.uniform(random, 0.1, 0.9, 36)
        floors = np.isin(self.parts[:, tables.KIND], (tables.SLAB, tables.SHARD)) & (
            self.parts[:, tables.BODY] >= 0.0
        )
        floors &= (self.parts[:, tables.STOREY] == storey) | (self.parts[:, tables.STOREY] == storey + 1)
        source = np.flatnonzero(floors), ON_FLOOR * 2.0 * half
        if AIR in self.active:  # the air knows how fast, and takes it along from all over the floor
            x = linear.uniform(random, -half, half, 36)
            self._raise_dust(np.stack([x, y], axis=1), np.zeros((36, 2)), 1.3, 9.0, random, source)
            return
        fast = min(max(speed, 0.0) * half / self.content.storey, 18.0)
        speeds = np.stack([side * fast, linear.uniform(random, -1.0, 2.0, 36)], axis=1)
        self._raise_dust(np.stack([side * half, y], axis=1), speeds, 1.3, 9.0, random, source)

    def _break_by_stops(self, before: Floats, dt: float) -> None:
        """Floors and columns that ride on what falls break where they are stopped faster than they bear."""
        there = np.flatnonzero(
            (self.parts[:, tables.BODY] >= 0.0) & (self.parts[:, tables.KIND] != tables.RUBBLE)
        )
        parts, own = self.parts, self.parts[there, tables.BODY].astype(np.int64)
        known = own < len(before)
        there, own = there[known], own[known]
        now = self.world.bodies.velocities[own]
        parts[there, tables.SHOCK] = shocks_of(parts[there, tables.SHOCK], before[own], now, dt)
        long = np.maximum(parts[there, tables.WIDE], parts[there, tables.TALL])
        breaks = (parts[there, tables.SHOCK] > LASTING * self.parameters.strength) & (long > 2.0 * LEAST_LONG)
        for row in there[breaks].tolist():
            self.break_floor(row, float(parts[row, tables.SHOCK]))

    def _break_by_impact(self) -> None:
        """Floors that were stopped faster than they bear break; what strikes raises dust."""
        shapes, begun = self.world.contacts_begun()
        if not len(begun):
            return
        pairs = self.world.shapes.bodies[shapes]
        row_of = np.full(len(self.world.bodies.flags), -1)
        there = np.flatnonzero(self.parts[:, tables.BODY] >= 0.0)
        row_of[self.parts[there, tables.BODY].astype(np.int64)] = there
        rows = row_of[pairs]
        hard = np.flatnonzero(begun[:, 3] > 2.0)[:24]
        if len(hard):
            source = np.unique(rows[hard][rows[hard] >= 0])
            self._raise_dust(
                begun[hard, :2], np.tile((0.0, 0.8), (len(hard), 1)), 1.0, 6.0, self._random(200_000),
                (source, OF_STRIKE * len(hard)),
            )  # fmt: skip
        breaking: set[int] = set()
        for pair, impulse in zip(rows.tolist(), begun[:, 2].tolist(), strict=True):
            for row in pair:
                if row < 0 or self.parts[row, tables.KIND] not in (tables.SLAB, tables.SHARD):
                    continue
                long = max(self.parts[row, tables.WIDE], self.parts[row, tables.TALL])
                stopped = speed_of_stop(impulse, float(self.parts[row, tables.MASS]))
                if stopped > self.parameters.strength and long > 2.0 * LEAST_LONG:
                    breaking.add(row)
        for row in sorted(breaking):
            self.break_floor(row)

    # -- how it stands --------------------------------------------------------------------------------

    def awake(self) -> int:
        """How many bodies are computed."""
        return int(np.count_nonzero(self.world.bodies.flags & (DYNAMIC | ASLEEP) == DYNAMIC))

    def gravity(self) -> float:
        """m/s², as it acts now."""
        return self.parameters.gravity if GRAVITY in self.active else 0.0

    def state(self) -> ModelState:
        """All that later steps depend on."""
        clock = np.array([self.fired, float(self.steps), self.dusted])
        return ModelState(
            self.world.state(), self.parts, self.storeys, self.dust, self.heard, clock, self.freed,
            self.air.state(),
        )  # fmt: skip

    def restore(self, state: Any) -> None:
        """Take over a copy of a state."""
        self.world.restore(state.world)
        self.parts, self.storeys = state.parts.copy(), state.storeys.copy()
        self.dust, self.heard = state.dust.copy(), state.heard.copy()
        fired, steps, self.dusted = state.clock.tolist()
        self.fired, self.steps = fired, int(steps)
        self.freed = state.freed.copy()
        self.air.restore(state.air)
