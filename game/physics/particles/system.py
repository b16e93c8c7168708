"""A system of particles: emitters, a pool, forces, solids, and one step of all of it.

A step, in order: those too old die at their instant; all others fly; those born in the step begin at their
instant; whoever comes near a solid is flown among the solids.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.physics.effects import EffectSet
from game.physics.fields import DRAG, GRAVITY, GROUND, QUADRATIC_DRAG, WHIRL, WIND
from game.physics.particles import births, encounters
from game.physics.particles.advance import BLOCK, make_advance
from game.physics.particles.contacts import CONTACTS
from game.physics.particles.effects import GROUND_BIT, OBSTACLES, OBSTACLES_BIT, REPORTS
from game.physics.particles.emitter import Emitter
from game.physics.particles.flight import METHODS, STABILITY_LIMITS
from game.physics.particles.forces import FORCE_BITS, Forces
from game.physics.particles.solids import LARGEST, Discs, checked_point

KNOWN = EffectSet.from_mask(FORCE_BITS | GROUND_BIT | OBSTACLES_BIT | REPORTS.mask)
CALM = Forces(9.81, 0.1, 0.02, 0.0, 0.0, 0.0, 2.0, 0.0, 0.5, 0.0, 0.0, 0.0)
CHUNK = 65_536  # particles flown before their encounters are resolved: bounds the list
PADDING = 72  # numbers between the rows of fields, so that equal indices do not fall on one cache set
MAX_CAPACITY = 4_000_000
SMOOTH = 0.25  # drag times substep at which an explicit method is within 1 % of the exact decay
MAX_SUBSTEPS = 64


class ParticleState(NamedTuple):
    """All that a later step depends on. The arrays are the system's own, not copies."""

    fields: NDArray[np.float64]  # (5, n): x, y (m), vx, vy (m/s), instant of birth (s)
    tags: NDArray[np.int64]  # (2, n): identity, step of the last impact + 1
    tallies: NDArray[np.int64]  # (10,): see encounters
    clock: NDArray[np.float64]  # (3,): instant of origin, step (s), steps since the origin
    emitters: NDArray[np.float64]  # (m, 12)
    births: NDArray[np.int64]  # (m, 2)
    solids: NDArray[np.float64]  # (k, 6)
    impulses: NDArray[np.float64]  # (k, 2)


class ParticleSystem:
    """Particles of unit mass, struck by nothing but solids.

    capacity: places in the pool; births beyond it are dropped and counted. emitters: of `Emitter`. solids:
    `Discs`. effects: what is computed, of KNOWN. method: of METHODS. contact: of CONTACTS. life: s.
    forces: `Forces`. floor: m. floor_restitution: 0 to 1. seed: of the random numbers.
    substeps: of a step; 0 for as many as drag needs to be stable and smooth.

    ValueError, naming the argument, for what makes no sense.
    """

    def __init__(
        self,
        capacity: int = 100_000,
        *,
        emitters: Iterable[Emitter] = (),
        solids: Discs | None = None,
        effects: EffectSet = GRAVITY | OBSTACLES,
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
        if isinstance(capacity, bool) or not isinstance(capacity, int) or not 1 <= capacity <= MAX_CAPACITY:
            raise ValueError(f"capacity = {capacity!r}: 1 to {MAX_CAPACITY} is wanted")
        self.capacity = capacity
        self.solids = solids if solids is not None else Discs()
        self.seed = seed
        self._block = np.zeros((5, capacity + PADDING))
        self._tags = np.full((2, capacity), -1, dtype=np.int64)
        self._tallies = np.zeros(encounters.TALLIES, dtype=np.int64)
        self._clock = np.zeros(3)
        self._emitters = np.zeros((0, births.EMITTER_COLUMNS))
        self._births = np.zeros((0, 2), dtype=np.int64)
        self._due = np.zeros(0, dtype=np.int64)
        self._marks = np.zeros(BLOCK, dtype=np.int64)
        self._hits = np.zeros((encounters.LIST_ROWS, min(capacity, CHUNK)))
        self._who = np.zeros(min(capacity, CHUNK), dtype=np.int64)
        self._reports = np.zeros((report_lines, encounters.REPORT_COLUMNS))
        self.effects = effects
        self.method = method
        self.contact = contact
        self.life = life
        self.forces = forces
        self.set_ground(floor, floor_restitution)
        self.substeps = substeps
        for emitter in emitters:
            self.add_emitter(emitter)

    # -- what it is made of -------------------------------------------------------------------------

    @property
    def effects(self) -> EffectSet:
        """What a step computes."""
        return self._effects

    @effects.setter
    def effects(self, effects: EffectSet) -> None:
        unknown = [effect.name for effect in effects if effect not in KNOWN]
        if unknown:
            raise ValueError(f"effects: particles know nothing of {', '.join(unknown)}")
        self._effects = effects
        self._mask = effects.mask

    @property
    def method(self) -> str:
        """The integrator, of METHODS."""
        return METHODS[self._method]

    @method.setter
    def method(self, name: str) -> None:
        if name not in METHODS:
            raise ValueError(f"method = {name!r}: one of {', '.join(METHODS)} is wanted")
        self._method = METHODS.index(name)

    @property
    def contact(self) -> str:
        """How impacts are found, of CONTACTS."""
        return CONTACTS[self._contact]

    @contact.setter
    def contact(self, name: str) -> None:
        if name not in CONTACTS:
            raise ValueError(f"contact = {name!r}: one of {', '.join(CONTACTS)} is wanted")
        self._contact = CONTACTS.index(name)

    @property
    def life(self) -> float:
        """How long each particle lives, s; a change holds for those alive too."""
        return self._life

    @life.setter
    def life(self, value: float) -> None:
        if not 0.0 < value < math.inf:
            raise ValueError(f"life = {value!r}: a finite number above 0 s is wanted")
        self._life = float(value)

    @property
    def forces(self) -> Forces:
        """The numbers of the force law; change them by `forces._replace(...)`."""
        return self._forces

    @forces.setter
    def forces(self, forces: Forces) -> None:
        for name, value in forces._asdict().items():
            if not abs(value) <= LARGEST:
                raise ValueError(f"{name} = {value!r}: a finite number up to {LARGEST:g} is wanted")
            if name in ("drag", "quadratic_drag", "pull") and value < 0.0:
                raise ValueError(f"{name} = {value!r}: 0 or more is wanted")
        if forces.whirl_core <= 0.0:
            raise ValueError(f"whirl_core = {forces.whirl_core!r}: more than 0 m is wanted")
        self._forces = Forces(*map(float, forces))
        self._law = np.array(self._forces)

    @property
    def substeps(self) -> int:
        """Substeps of a step; 0: as many as drag needs."""
        return self._substeps

    @substeps.setter
    def substeps(self, value: int) -> None:
        if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value <= MAX_SUBSTEPS:
            raise ValueError(f"substeps = {value!r}: 0 to {MAX_SUBSTEPS} is wanted")
        self._substeps = value

    def set_ground(self, floor: float, restitution: float) -> None:
        """Height of the floor (m) and its restitution, 0 to 1."""
        if not abs(floor) <= LARGEST:
            raise ValueError(f"floor = {floor!r}: a finite number up to {LARGEST:g} is wanted")
        if not 0.0 <= restitution <= 1.0:
            raise ValueError(f"floor_restitution = {restitution!r}: 0 to 1 is wanted")
        self._ground = (float(floor), float(restitution))

    @property
    def floor(self) -> float:
        """Height of the floor, m."""
        return self._ground[0]

    # -- emitters -----------------------------------------------------------------------------------

    def add_emitter(self, emitter: Emitter) -> int:
        """Let one more emit from now on; returns its index."""
        self._emitters = np.vstack([self._emitters, emitter.row(self.time_s)])
        self._births = np.vstack([self._births, np.zeros((1, 2), dtype=np.int64)])
        self._due = np.zeros(len(self._births), dtype=np.int64)
        return len(self._births) - 1

    def change_emitter(self, index: int, emitter: Emitter) -> None:
        """Let an emitter be another from now on. It moves to its new position during the next step.

        With another rate, the fraction of a particle that is under way is kept: no burst, no gap.
        """
        old, now = self._emitters[index], self.time_s
        row = emitter.row(now)
        row[births.FROM_X], row[births.FROM_Y] = old[births.POSITION_X], old[births.POSITION_Y]
        if row[births.RATE] == old[births.RATE]:
            row[births.CARRY], row[births.SINCE] = old[births.CARRY], old[births.SINCE]
        else:
            phase = old[births.CARRY] + old[births.RATE] * (now - old[births.SINCE])
            row[births.CARRY] = min(max(phase - self._births[index, births.MADE], 0.0), 1.0 - 2.0**-53)
            self._births[index, births.MADE] = 0
        self._emitters[index] = row

    def place_emitter(self, index: int, position: ArrayLike) -> None:
        """Let an emitter move to a place (m) during the next step."""
        self._emitters[index, : births.POSITION_Y + 1] = checked_point("position", position)

    # -- what there is ------------------------------------------------------------------------------

    def __len__(self) -> int:
        return int(self._tallies[encounters.COUNT])

    def _tally(self, index: int) -> int:
        return int(self._tallies[index])

    @property
    def time_s(self) -> float:
        """Simulated time: whole steps times their length since it was last changed."""
        origin, step, steps = self._clock.tolist()
        return float(origin + steps * step)

    @property
    def born(self) -> int:
        """Particles ever born."""
        return self._tally(encounters.BORN)

    @property
    def died(self) -> int:
        """Particles ever dead of age."""
        return self._tally(encounters.DIED)

    @property
    def dropped(self) -> int:
        """Births for which the pool had no place."""
        return self._tally(encounters.DROPPED)

    @property
    def impacts(self) -> int:
        """Impacts ever."""
        return self._tally(encounters.IMPACTS)

    @property
    def cut_short(self) -> int:
        """Flights in which a step's greatest number of contacts was reached, and the time left dropped."""
        return self._tally(encounters.CUT_SHORT)

    def segments(self) -> tuple[tuple[int, int], ...]:
        """Places in the pool that are taken, as one or two ranges, the oldest particle first."""
        head, count = self._tally(encounters.HEAD), len(self)
        end = head + count
        if end <= self.capacity:
            return ((head, end),)
        return ((head, self.capacity), (0, end - self.capacity))

    def _living(self, row: NDArray) -> NDArray:
        parts = [row[..., low:high] for low, high in self.segments()]
        return parts[0] if len(parts) == 1 else np.concatenate(parts, axis=-1)

    @property
    def positions(self) -> NDArray[np.float64]:
        """(n, 2) m, a copy; the oldest particle first."""
        return np.ascontiguousarray(self._living(self._block[:2]).T)

    @property
    def velocities(self) -> NDArray[np.float64]:
        """(n, 2) m/s, a copy."""
        return np.ascontiguousarray(self._living(self._block[2:4]).T)

    @property
    def ages(self) -> NDArray[np.float64]:
        """(n,) s."""
        return self.time_s - self._living(self._block[4])

    @property
    def identities(self) -> NDArray[np.int64]:
        """(n,): emitter * 2**40 + serial number; particles put by hand count as of the last emitter + 1."""
        return self._living(self._tags[0]).copy()

    @property
    def reports(self) -> NDArray[np.float64]:
        """(m, 8) lines of the last step: kind, identity, instant, x, y, vx, vy, impulse (see encounters)."""
        return self._reports[: self._tally(encounters.REPORTED)]

    def add(self, positions: ArrayLike, velocities: ArrayLike) -> None:
        """Put particles (n, 2) m, (n, 2) m/s that are born now; what has no place is dropped and counted."""
        places = np.array(positions, dtype=np.float64).reshape(-1, 2)
        speeds = np.array(velocities, dtype=np.float64).reshape(-1, 2)
        if places.shape != speeds.shape:
            raise ValueError(f"velocities: {len(places)} pairs are wanted, got {len(speeds)}")
        for name, values, most in (("positions", places, LARGEST), ("velocities", speeds, LARGEST)):
            if not np.all(np.abs(values) <= most):
                raise ValueError(f"{name}: finite numbers up to {most:g} are wanted")
        room = self.capacity - len(self)
        count = min(len(places), room)
        slots = (self._tally(encounters.HEAD) + len(self) + np.arange(count)) % self.capacity
        self._block[0:2, slots] = places[:count].T
        self._block[2:4, slots] = speeds[:count].T
        self._block[4, slots] = self.time_s
        first = len(self._births) * births.IDENTITY_STEP + self.born
        self._tags[0, slots] = first + np.arange(count)
        self._tags[1, slots] = -1
        self._tallies[encounters.COUNT] += count
        self._tallies[encounters.BORN] += count
        self._tallies[encounters.DROPPED] += len(places) - count

    # -- a step -------------------------------------------------------------------------------------

    def stiffness(self) -> float:
        """The fastest rate (1/s) at which drag slows anything that the emitters send out."""
        forces, rate = self._forces, 0.0
        if DRAG in self._effects:
            rate = forces.drag
        if QUADRATIC_DRAG in self._effects:
            fastest = np.max(
                self._emitters[:, births.SPEED] * (1 + self._emitters[:, births.SPEED_RANGE]), initial=0
            )
            rate += 2.0 * forces.quadratic_drag * (float(fastest) + self._air_speed())
        return rate

    def _air_speed(self) -> float:
        """The greatest speed (m/s) of the air anywhere."""
        forces, speed = self._forces, 0.0
        if WIND in self._effects:
            speed = math.hypot(forces.wind_x, forces.wind_y)
        if WHIRL in self._effects:
            speed += abs(forces.whirl_strength) / (2.0 * forces.whirl_core)
        return speed

    def substeps_for(self, dt: float) -> int:
        """Substeps that a step of dt (s) is divided into."""
        if self._substeps:
            return self._substeps
        if math.isinf(STABILITY_LIMITS[self._method]):
            return 1
        return min(max(math.ceil(self.stiffness() * dt / SMOOTH), 1), MAX_SUBSTEPS)

    def step(self, dt: float) -> None:
        """Go on by dt (s). ValueError unless it is finite and above 0."""
        if not 0.0 < dt < math.inf:
            raise ValueError(f"dt = {dt!r}: a finite number above 0 s is wanted")
        if dt != self._clock[1]:
            self._clock[:] = self.time_s, dt, 0.0
        now = self.time_s
        self._tallies[encounters.REPORTED] = 0
        self.solids.impulses[:] = 0.0
        count = self.substeps_for(dt)
        h = dt / count
        for i in range(count):
            self._substep(now + i * h, h, (i + 1) / count)
        self._emitters[:, births.FROM_X : births.FROM_Y + 1] = self._emitters[:, : births.POSITION_Y + 1]
        self._clock[2] += 1.0
        self._tallies[encounters.STEP] += 1

    def _substep(self, now: float, h: float, part: float) -> None:
        life, mask, tallies = self._life, self._mask, self._tallies
        pool = (self._block, self._tags, tallies, self.capacity)
        found = limit = len(self._who)
        while found == limit:
            found = births.retire(mask, *pool, life, now, h, self._hits, self._who, 0)
            self._resolve(found, now, h)
        self._fly_all(now, h)
        found = limit
        while found == limit:
            found = births.emit(
                mask, *pool, self._emitters, self._births, self._due, self.seed, life, now, h, self._hits, self._who, 0
            )
            self._resolve(found, now, h)
        self.solids.move(h)

    def _fly_all(self, now: float, h: float) -> None:
        """All particles of the pool, in portions whose encounters fit the list."""
        mask, solids = self._mask, self.solids.rows
        advance = make_advance(self._method, mask & (FORCE_BITS | GROUND_BIT | OBSTACLES_BIT))
        portion = CHUNK if mask & (GROUND_BIT | OBSTACLES_BIT) else self.capacity
        slack = self._slack(h)
        for low, high in self.segments():
            for begin in range(low, high, portion):
                end = min(begin + portion, high)
                found = advance(
                    self._block, begin, end, self._law, solids, self._ground[0], slack, h,
                    self._marks, self._hits, self._who, 0,
                )  # fmt: skip
                if found:
                    self._hits[encounters.START, :found] = 0.0
                    self._hits[encounters.DURATION, :found] = h
                    self._resolve(found, now, h)

    def _resolve(self, found: int, now: float, h: float) -> None:
        if found:
            encounters.resolve_encounters(
                self._contact, self._method, self._mask, self._block, self._tags, self._tallies, self._hits, self._who,
                found, self._law, self.solids.rows, self._ground, h, now, self.solids.impulses, self._reports,
            )  # fmt: skip

    def _slack(self, h: float) -> float:
        """How much farther than h |v| (m) a particle near a solid may get in h (s)."""
        forces = self._forces
        push = abs(forces.gravity) if GRAVITY in self._effects else 0.0
        if forces.pull:
            solids = self.solids
            arms = np.abs(solids.centres - (forces.pull_x, forces.pull_y)).sum(axis=1) + solids.radii
            push += forces.pull * (1.0 + max(float(np.max(arms, initial=0.0)), abs(self.floor - forces.pull_y)))
        return h * (h * push + self._air_speed())

    # -- remembering --------------------------------------------------------------------------------

    def state(self) -> ParticleState:
        """The state as arrays that the system goes on using."""
        return ParticleState(
            self._block,
            self._tags,
            self._tallies,
            self._clock,
            self._emitters,
            self._births,
            self.solids.rows,
            self.solids.impulses,
        )

    def restore(self, state: ParticleState) -> None:
        """Take over a copy of a state of a system of the same capacity."""
        np.copyto(self._block, state.fields)
        np.copyto(self._tags, state.tags)
        np.copyto(self._tallies, state.tallies)
        np.copyto(self._clock, state.clock)
        self._emitters = np.array(state.emitters)
        self._births = np.array(state.births)
        self._due = np.zeros(len(self._births), dtype=np.int64)
        self.solids.restore(state.solids, state.impulses)

    def check(self) -> None:
        """Verify what must always hold; AssertionError names what does not."""
        count, head = len(self), self._tally(encounters.HEAD)
        assert 0 <= count <= self.capacity, "count"
        assert 0 <= head < self.capacity, "head"
        assert self.born == self.died + count, "born = died + alive"
        instants = self._living(self._block[4])
        assert np.all(np.diff(instants) >= 0.0), "the pool is in the order of birth"
        assert np.all(np.isfinite(self._living(self._block))), "finite"
        assert GROUND not in self._effects or np.all(self._living(self._block[1]) >= self.floor - 1e-9), "floor"
