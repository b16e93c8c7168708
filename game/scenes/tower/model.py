"""The tower: what is cut, what gives way, what breaks, how fast it comes down, and the dust of it."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY
from game.physics.kernels import elementwise, linear
from game.physics.solids import SolidSettings, SolidState, SolidWorld
from game.physics.solids.effects import SOLIDS
from game.physics.solids.state import ASLEEP, DYNAMIC
from game.scenes.tower.air import AirState, TowerAir
from game.scenes.tower.breaking import break_up, cuts_of, halves_of, speed_of_stop
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
from game.scenes.tower.sounds import heard_now
from game.scenes.tower.tables import (
    BODY,
    COLUMN,
    CUT,
    DUST_WIDTH,
    GONE,
    KIND,
    MASS,
    NOT_YET,
    PLACE,
    RUBBLE,
    SHARD,
    SLAB,
    STOREY,
    STOREY_WIDTH,
    STRUCK,
    TALL,
    WIDE,
    Floats,
    none_of,
)
from game.stage import ParameterError, Part
from game.worlds.hearing import HEARD_WIDTH
from game.worlds.stopwatch import Stopwatch

MOST_BODIES = 1_500
PIECES_OF_COLUMN = 3
LEAST_LONG = 1.0  # m: shorter shards do not break any more
NOT_FIRED = -1.0
SKIN, SLOWEST = 0.02, 0.1  # m; m/s
OF_COLUMN, OF_STRIKE, ON_FLOOR = 4.0, 0.8, 3.0  # kg of dust of a column, of a hard strike; kg/m² on a floor


class ModelState(NamedTuple):
    """world; parts (n, PART_WIDTH), storeys (s, STOREY_WIDTH), dust (d, DUST_WIDTH), heard (k, HEARD_WIDTH):
    see `tables`; clock (2,): time of the firing s (NOT_FIRED), steps; air.
    """

    world: SolidState
    parts: Floats
    storeys: Floats
    dust: Floats
    heard: Floats
    clock: Floats
    air: AirState


class TowerModel(Part):
    """A tower of a level. time: s; fired: s at which it was fired (NOT_FIRED)."""

    def __init__(self, content: TowerContent, parameters: TowerParameters, active: EffectSet):
        if content.first > content.storeys:
            raise ValueError(f"first = {content.first}: there are {content.storeys} storeys")
        self.content, self.parameters, self.active = content, parameters, active
        self.watch = Stopwatch()
        self.time, self.steps, self.fired = 0.0, 0, NOT_FIRED
        self.world = SolidWorld(self._settings())
        self.ground, self.parts = build(self.world, content, parameters.friction, parameters.joints)
        self.storeys = np.full((content.storeys, STOREY_WIDTH), NOT_YET)
        self.dust, self.heard = none_of(DUST_WIDTH), none_of(HEARD_WIDTH)
        self.world.check_solver()
        self.built_mass = float(self.parts[:, MASS].sum())
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
            bodies = self.parts[self.parts[:, BODY] >= 0.0, BODY].astype(np.int64)
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

    def first_storey(self) -> int:
        """Whose columns are cut first."""
        chosen = int(self.parameters.first) or self.content.first
        return min(chosen, self.content.storeys)

    # -- cutting and breaking -------------------------------------------------------------------------

    def _random(self, number: int) -> np.random.Generator:
        return np.random.default_rng((self.content.seed, self.steps, number))

    def cut(self, row: int) -> None:
        """A charge turns a column into rubble that flies off to both sides."""
        part = self.parts[row]
        storey, random = int(part[STOREY]), self._random(row)
        body = int(part[BODY])
        x, y = self.world.bodies.positions[body].tolist()
        pieces = cuts_of(float(part[WIDE]), float(part[TALL]), PIECES_OF_COLUMN, random)
        side = np.where(np.arange(len(pieces)) % 2 == 0, 1.0, -1.0) * (1.0 if random.random() < 0.5 else -1.0)
        thrown = np.stack(
            [side * linear.uniform(random, 0.6, 1.4, len(pieces)), np.zeros(len(pieces))], axis=1
        )
        self._replace(row, pieces, RUBBLE, self.parameters.blast * thrown)
        if self.storeys[storey - 1, CUT] == NOT_YET:
            self.storeys[storey - 1, CUT] = self.time
        spread = linear.uniform(random, -0.5, 0.5, (10, 2)) * (1.0, 2.0)
        self._raise_dust(
            spread + np.array((x, y)), linear.uniform(random, -3.0, 3.0, (10, 2)), 0.8, 3.5, random,
            OF_COLUMN,
        )  # fmt: skip

    def break_floor(self, row: int) -> None:
        """A floor's bay, or a shard of one, breaks in two or three."""
        part, random = self.parts[row], self._random(row)
        long = max(float(part[WIDE]), float(part[TALL]))
        count = 3 if long > 3.0 else 2
        if part[KIND] == SLAB:
            pieces = cuts_of(float(part[WIDE]), float(part[TALL]), count, random)
        else:
            pieces = halves_of(self._corners(int(part[BODY])), random)
        self._replace(row, pieces, SHARD)

    def _corners(self, body: int) -> Floats:
        """Corners (k, 2) m of a body's first shape in its own frame."""
        shape = int(self.world.shapes_of(body)[0])
        start, count = int(self.world.shapes.starts[shape]), int(self.world.shapes.counts[shape])
        return self.world.pool.corners[start : start + count].copy()

    def _replace(self, row: int, pieces: list[Floats], kind: int, thrown: Floats | None = None) -> None:
        part, stuff = self.parts[row], rubble_stuff if kind == RUBBLE else frame_stuff
        if len(self.world.ids()) + len(pieces) > MOST_BODIES:
            return
        made = break_up(self.world, int(part[BODY]), pieces, stuff(self.parameters.friction), thrown)
        rows = [(new, kind, part[STOREY], part[PLACE], wide, tall, mass) for new, mass, wide, tall in made]
        self.parts[row, BODY], self.parts[row, MASS] = GONE, 0.0
        self.parts = np.concatenate([self.parts, np.array(rows)])

    def _raise_dust(
        self, places: Floats, speeds: Floats, size: float, life: float, random: np.random.Generator,
        kilograms: float,
    ) -> None:  # fmt: skip
        """Puffs that show it, and so much dust for the air to carry."""
        self.dust = np.concatenate([self.dust, puffs(places, speeds, size, life, random)])
        if AIR in self.active:
            self.air.raise_dust(places, kilograms)

    # -- a step ---------------------------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        """One step."""
        at = self.content.fired_at
        if at is not None and self.time >= at - 0.5 * dt:
            self.fire()
        self._cut_on_schedule(dt)
        if self.parameters.gives_way:
            self._give_way(dt)
        before = self.world.bodies.velocities.copy()
        with self.watch.time("step"):
            self.world.step(dt)
        self._break_columns(before)
        self.time += dt
        self.steps += 1
        self.heard = heard_now(self.world, self.heard, self.time - dt)
        self._break_by_impact()
        self._blow(dt)

    def _blow(self, dt: float) -> None:
        """Air and dust, once something moves."""
        if AIR not in self.active:
            self.dust = advance_dust(self.dust, dt)
            return
        if self.awake() or not self.air.is_still():
            with self.watch.time("air"):
                self.air.advance(self.floors(), self.loose_pieces(), self.gravity(), dt)
        self.dust = advance_dust(self.dust, dt, self.air.gas.sample)

    def floors(self) -> Floats:
        """(k, FLOOR_WIDTH): bays of floors that are whole, as solids of the air."""
        parts, rows = self.parts, self.world.bodies
        whole = parts[(parts[:, KIND] == SLAB) & (parts[:, BODY] >= 0.0)]
        own = whole[:, BODY].astype(np.int64)
        long = 0.5 * whole[:, WIDE]
        thick = 0.5 * np.maximum(whole[:, TALL], self.air.thickness(0.0))
        c, s = np.abs(rows.rotations[own]).T
        return np.column_stack([
            rows.positions[own], rows.rotations[own], long, thick, rows.velocities[own], rows.spins[own],
            c * long + s * thick, s * long + c * thick,
        ])  # fmt: skip

    def loose_pieces(self) -> Floats:
        """(n, 5): place m, velocity m/s, breadth m of what is broken and moves."""
        parts, rows = self.parts, self.world.bodies
        loose = parts[(parts[:, BODY] >= 0.0) & ((parts[:, KIND] == SHARD) | (parts[:, KIND] == RUBBLE))]
        own = loose[:, BODY].astype(np.int64)
        breadth = 0.5 * (loose[:, WIDE] + loose[:, TALL])
        found = np.column_stack([rows.positions[own], rows.velocities[own], breadth])
        return np.ascontiguousarray(found[np.abs(found[:, 2:4]).max(axis=1, initial=0.0) > SLOWEST])

    def _cut_on_schedule(self, dt: float) -> None:
        if self.fired == NOT_FIRED:
            return
        first = self.first_storey()
        parts = self.parts
        due = (self.time - self.fired + 0.5 * dt) / max(self.parameters.delay, 1e-9)
        mine = (parts[:, KIND] == COLUMN) & (parts[:, STOREY] == first) & (parts[:, BODY] >= 0.0)
        for row in np.flatnonzero(mine & (parts[:, PLACE] <= due)).tolist():
            self.cut(row)

    def _give_way(self, dt: float) -> None:
        """Columns of a storey break where the floor above has come down upon its own floor."""
        content, parts = self.content, self.parts
        places, speeds = self.world.bodies.positions, self.world.bodies.velocities
        for storey in range(content.storeys - 1, 0, -1):
            if self.storeys[storey - 1, STRUCK] != NOT_YET or self.storeys[storey, CUT] == NOT_YET:
                continue
            above = (parts[:, STOREY] == storey + 1) & (parts[:, BODY] >= 0.0)
            above &= (parts[:, KIND] == SLAB) | (parts[:, KIND] == SHARD)
            bodies = parts[above, BODY].astype(np.int64)
            if not len(bodies):
                continue
            speed = -float(np.median(speeds[bodies, 1]))
            gap = float(np.median(places[bodies, 1])) - floor_height(content, storey) - 0.5 * content.slab
            if gap > 1.5 * dt * max(speed, 0.0) + SKIN:
                continue
            self.storeys[storey - 1, STRUCK] = self.time + max(gap, 0.0) / max(speed, SLOWEST)
            self._blow_out(storey, speed)
            own = (self.parts[:, KIND] == COLUMN) & (self.parts[:, STOREY] == storey)
            for row in np.flatnonzero(own & (self.parts[:, BODY] >= 0.0)).tolist():
                self.cut(row)

    def _blow_out(self, storey: int, speed: float) -> None:
        """The air between two floors leaves at both sides, by continuity."""
        half, random = half_width(self.content), self._random(100_000 + storey)
        side = np.where(np.arange(36) % 2 == 0, 1.0, -1.0)
        y = floor_height(self.content, storey) + linear.uniform(random, 0.1, 0.9, 36)
        kilograms = ON_FLOOR * 2.0 * half
        if AIR in self.active:  # the air knows how fast, and takes it along from all over the floor
            x = linear.uniform(random, -half, half, 36)
            self._raise_dust(np.stack([x, y], axis=1), np.zeros((36, 2)), 1.3, 9.0, random, kilograms)
            return
        fast = min(max(speed, 0.0) * half / self.content.storey, 18.0)
        speeds = np.stack([side * fast, linear.uniform(random, -1.0, 2.0, 36)], axis=1)
        self._raise_dust(np.stack([side * half, y], axis=1), speeds, 1.3, 9.0, random, kilograms)

    def _break_columns(self, before: Floats) -> None:
        """Columns that ride on what falls break where it is stopped."""
        columns = np.flatnonzero((self.parts[:, KIND] == COLUMN) & (self.parts[:, BODY] >= 0.0))
        bodies = self.parts[columns, BODY].astype(np.int64)
        lost = elementwise.hypot(*(self.world.bodies.velocities[bodies] - before[bodies]).T)
        for row in columns[lost > self.parameters.strength].tolist():
            self.cut(row)

    def _break_by_impact(self) -> None:
        """Floors that were stopped faster than they bear break; what strikes raises dust."""
        shapes, begun = self.world.contacts_begun()
        if not len(begun):
            return
        pairs = self.world.shapes.bodies[shapes]
        order = np.argsort(self.parts[:, BODY], kind="stable")
        random = self._random(200_000)
        hard = np.flatnonzero(begun[:, 3] > 2.0)[:24]
        if len(hard):
            self._raise_dust(begun[hard, :2], np.tile((0.0, 0.8), (len(hard), 1)), 1.0, 6.0, random,
                             OF_STRIKE * len(hard))  # fmt: skip
        known = self.parts[order, BODY]
        breaking: set[int] = set()
        for (a, b), (_, _, impulse, _, _) in zip(pairs.tolist(), begun.tolist(), strict=True):
            for body in (a, b):
                row = int(order[min(int(np.searchsorted(known, body)), len(order) - 1)])
                if self.parts[row, BODY] != body or self.parts[row, KIND] not in (SLAB, SHARD):
                    continue
                long = max(self.parts[row, WIDE], self.parts[row, TALL])
                stopped = speed_of_stop(impulse, float(self.parts[row, MASS]))
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
        clock = np.array([self.fired, float(self.steps)])
        return ModelState(
            self.world.state(), self.parts, self.storeys, self.dust, self.heard, clock, self.air.state()
        )

    def restore(self, state: Any) -> None:
        """Take over a copy of a state."""
        self.world.restore(state.world)
        self.parts, self.storeys = state.parts.copy(), state.storeys.copy()
        self.dust, self.heard = state.dust.copy(), state.heard.copy()
        self.fired, self.steps = float(state.clock[0]), int(state.clock[1])
        self.air.restore(state.air)
