"""A system of particles: emitters, a pool, forces, solids, and one step of all of it.

A step, in order: those too old die at their instant. All others fly. Those born in the step begin at their
instant; what comes near a solid is flown among the solids.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.physics.effects import Effect, EffectSet
from game.physics.fields import GRAVITY
from game.physics.particles import births, encounters
from game.physics.particles.advance import BLOCK, make_advance
from game.physics.particles.contacts import Rules
from game.physics.particles.effects import GROUND_BIT, OBSTACLES, OBSTACLES_BIT
from game.physics.particles.emitter import Emitter
from game.physics.particles.forces import FORCE_BITS, Forces
from game.physics.particles.pool import Pool
from game.physics.particles.runaway import FARTHEST, hold_runaways
from game.physics.particles.settings import CALM, Settings
from game.physics.particles.solids import Discs, checked_point

CHUNK = 65_536  # particles flown before their encounters are resolved: bounds the list of these


class ParticleState(NamedTuple):
    """All that a later step depends on. The arrays are the system's own, not copies."""

    fields: NDArray[np.float64]  # (5, n): x, y (m), vx, vy (m/s), instant of birth (s)
    tags: NDArray[np.int64]  # (2, n): identity, number of the step of the last touch
    tallies: NDArray[np.int64]  # (10,): see encounters
    clock: NDArray[np.float64]  # (3,): instant of origin, step (s), steps since the origin
    emitters: NDArray[np.float64]  # (m, 12): see births
    births: NDArray[np.int64]  # (m, 2)
    solids: NDArray[np.float64]  # (k, 6)
    impulses: NDArray[np.float64]  # (k, 2)


class ParticleSystem(Pool, Settings):
    """Particles of unit mass that meet solids but not one another.

    capacity: places in the pool; births beyond it are dropped and counted. emitters: of `Emitter`. solids:
    `Discs`. seed: of the random numbers, 0 or more. report_lines: space for the reports of a step. The rest:
    see `Settings`. ValueError, naming the argument, for what makes no sense.
    """

    def __init__(
        self,
        capacity: int = 100_000,
        *,
        emitters: Iterable[Emitter] = (),
        solids: Discs | None = None,
        effects: EffectSet | Effect = GRAVITY | OBSTACLES,
        method: str = "verlet",
        contact: str = "chord",
        life: float = 2.0,
        forces: Forces = CALM,
        floor: float = 0.0,
        floor_restitution: float = 0.5,
        seed: int = 0,
        substeps: int = 0,
        report_lines: int = 4096,
    ):
        Pool.__init__(self, capacity)
        solids = solids if solids is not None else Discs()
        Settings.__init__(
            self, solids, effects, method, contact, life, forces, floor, floor_restitution, substeps
        )
        if isinstance(seed, bool) or not isinstance(seed, int) or not 0 <= seed < 2**63:
            raise ValueError(f"seed = {seed!r}: expected a whole number, 0 or more")
        if isinstance(report_lines, bool) or not isinstance(report_lines, int) or report_lines < 0:
            raise ValueError(f"report_lines = {report_lines!r}: expected a whole number, 0 or more")
        self.seed = seed
        self.runaways = 0  # particles that the last step held back, see `runaway`
        self._fastest_added = 0.0
        self._clock = np.zeros(3)
        self._emitters = np.zeros((0, births.EMITTER_COLUMNS))
        self._births = np.zeros((0, 2), dtype=np.int64)
        self._due = np.zeros(0, dtype=np.int64)
        self._marks = np.zeros((2, BLOCK), dtype=np.int64)
        self._hits = np.zeros((encounters.LIST_ROWS, min(capacity, CHUNK)))
        self._who = np.zeros(min(capacity, CHUNK), dtype=np.int64)
        self._reports = np.zeros((report_lines, encounters.REPORT_COLUMNS))
        for emitter in emitters:
            self.add_emitter(emitter)

    @property
    def time_s(self) -> float:  # type: ignore[override]
        """Simulated time: whole steps times their length since it was last changed."""
        origin, step, steps = self._clock.tolist()
        return float(origin + steps * step)

    @property
    def reports(self) -> NDArray[np.float64]:
        """(m, 8) lines of the last step: kind, identity, instant, x, y, vx, vy, impulse (see encounters).

        A view: the next step writes over it.
        """
        return self._reports[: self.tallies[encounters.REPORTED]]

    # -- emitters -----------------------------------------------------------------------------------

    def add_emitter(self, emitter: Emitter) -> int:
        """Let one more emit from now on; returns its index."""
        self._emitters = np.vstack([self._emitters, emitter.row(self.time_s)])
        self._births = np.vstack([self._births, np.zeros((1, 2), dtype=np.int64)])
        self._due = np.zeros(len(self._births), dtype=np.int64)
        return len(self._births) - 1

    def change_emitter(self, index: int, emitter: Emitter) -> None:
        """Let an emitter be another from now on. It moves to its new position during the next step.

        With another rate, the fraction of a particle that is under way is kept: no burst, no gap. ValueError
        for a number that no emitter has.
        """
        self._known(index)
        old, now = self._emitters[index], self.time_s
        row = emitter.row(now)
        row[births.FROM_X], row[births.FROM_Y] = old[births.FROM_X], old[births.FROM_Y]
        if row[births.RATE] == old[births.RATE]:
            row[births.CARRY], row[births.SINCE] = old[births.CARRY], old[births.SINCE]
        else:
            phase = old[births.CARRY] + old[births.RATE] * (now - old[births.SINCE])
            carry = phase - self._births[index, births.MADE]
            row[births.CARRY] = min(max(carry, 0.0), 1.0 - 2.0**-53)
            self._births[index, births.MADE] = 0
        self._emitters[index] = row

    def place_emitter(self, index: int, position: ArrayLike) -> None:
        """Let an emitter move to a place (2,) m during the next step. ValueError as `change_emitter`."""
        self._known(index)
        self._emitters[index, : births.POSITION_Y + 1] = checked_point("position", position)

    @property
    def has_moving_emitters(self) -> bool:
        """Whether an emitter moves to another place during the next step."""
        return not np.array_equal(
            self._emitters[:, : births.POSITION_Y + 1], self._emitters[:, births.FROM_X : births.FROM_Y + 1]
        )

    def _known(self, index: int) -> None:
        if not 0 <= index < len(self._emitters):
            raise ValueError(f"emitter {index}: there are {len(self._emitters)}")

    def fastest_birth(self) -> float:
        """The greatest speed (m/s) at which an emitter sends a particle out."""
        speeds = self._emitters[:, births.SPEED] * (1.0 + self._emitters[:, births.SPEED_RANGE])
        return float(np.max(speeds, initial=0.0))

    def add(self, positions: ArrayLike, velocities: ArrayLike) -> None:
        """As `Pool.add`."""
        super().add(positions, velocities)
        speeds = np.asarray(velocities, dtype=np.float64).reshape(-1, 2)
        self._fastest_added = max(self._fastest_added, float(np.abs(speeds).sum(axis=1).max(initial=0.0)))

    def fastest_added(self) -> float:
        """A bound of the speed (m/s) of what was put in by itself."""
        return self._fastest_added

    # -- a step -------------------------------------------------------------------------------------

    def step(self, dt: float) -> None:
        """Go on by dt (s). ValueError unless it is finite and above 0."""
        if not 0.0 < dt < math.inf:
            raise ValueError(f"dt = {dt!r}: expected a finite number above 0 s")
        origin, step, steps = self._clock.tolist()
        if dt != step:
            origin, step, steps = origin + steps * step, dt, 0.0
        now = origin + steps * step
        self.tallies[encounters.REPORTED] = 0
        if len(self.solids):
            self.solids.impulses[:] = 0.0
        count = self.substeps_for(dt)
        h = dt / count
        guarded, self.runaways = self.may_run_away(h), 0
        for i in range(count):
            self._substep(now + i * h, h)
            if guarded:
                for low, high in self.segments():
                    self.runaways += int(hold_runaways(self.fields, low, high, FARTHEST))
        self._clock[:] = origin, step, steps + 1.0
        self.tallies[encounters.STEP] += 1

    def _substep(self, now: float, h: float) -> None:
        rules = Rules(self._contact, self._method, self.mask, self._floor, self._floor_restitution, h)
        pool, listed = self._pool(), (self._hits, self._who)
        full = found = len(self._who)
        while found == full and self._oldest_dies_by(now + h):
            found = births.retire(self.mask, pool, listed, 0, self._life, now, h)
            self._resolve(rules, found, now)
        self._fly_all(rules, now, h)
        sources = (self._emitters, self._births, self._due, self.seed)
        found = full if len(self._births) else 0
        while found == full:
            found = births.emit(self.mask, pool, sources, listed, 0, self._life, now, h)
            self._resolve(rules, found, now)
        if len(self._births):
            self._emitters[:, births.FROM_X : births.FROM_Y + 1] = self._emitters[:, : births.POSITION_Y + 1]
        if len(self.solids):
            self.solids.move(h)

    def _pool(self) -> tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.int64], int]:
        """As kernels take it."""
        return self.fields, self.tags, self.tallies, self.capacity

    def _oldest_dies_by(self, end: float) -> bool:
        """Whether there is a particle whose life may end until an instant (s)."""
        head, count = self.tallies[: encounters.COUNT + 1].tolist()
        if count == 0:
            return False
        return float(self.fields[4, head]) + self._life <= end * (1.0 + 1e-12) + 1e-12 * self._life

    def _fly_all(self, rules: Rules, now: float, h: float) -> None:
        """All particles of the pool, in portions whose encounters fit the list."""
        solids = self.solids.rows
        advance = make_advance(self._method, self.mask & (FORCE_BITS | GROUND_BIT | OBSTACLES_BIT))
        touches = self.mask & (GROUND_BIT | OBSTACLES_BIT)
        portion = CHUNK if touches else self.capacity
        world = (self._law, solids, self._floor, self.slack(h) if touches else 0.0)
        listed = (self._hits, self._who)
        for low, high in self.segments():
            for begin in range(low, high, portion):
                end = min(begin + portion, high)
                found = advance(self.fields, begin, end, world, h, self._marks, listed, 0)
                if found:
                    self._hits[encounters.START, :found] = 0.0
                    self._hits[encounters.DURATION, :found] = h
                    self._resolve(rules, found, now)

    def _resolve(self, rules: Rules, found: int, now: float) -> None:
        if found:
            solids = self.solids
            encounters.resolve_encounters(
                rules, self._pool(), (self._hits, self._who), found, self._law, solids.rows, now,
                solids.impulses, self._reports,
            )  # fmt: skip

    # -- remembering --------------------------------------------------------------------------------

    def state(self) -> ParticleState:
        """The state as arrays that the system goes on using."""
        return ParticleState(
            self.fields,
            self.tags,
            self.tallies,
            self._clock,
            self._emitters,
            self._births,
            self.solids.rows,
            self.solids.impulses,
        )

    def restore(self, state: ParticleState) -> None:
        """Take over a copy of a state of a system of the same capacity."""
        np.copyto(self.fields, state.fields)
        self._fastest_added = float(np.abs(self.fields[2:4]).sum(axis=0).max(initial=0.0))
        np.copyto(self.tags, state.tags)
        np.copyto(self.tallies, state.tallies)
        np.copyto(self._clock, state.clock)
        self._emitters = np.array(state.emitters)
        self._births = np.array(state.births)
        self._due = np.zeros(len(self._births), dtype=np.int64)
        self.solids.restore(state.solids, state.impulses)
