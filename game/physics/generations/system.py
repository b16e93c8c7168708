"""Stars of many kinds that are born of one another: the pool, what comes in, and one step of all of it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.physics.effects import Effect, EffectSet
from game.physics.fields import DRAG, GRAVITY, GROUND, QUADRATIC_DRAG, WIND
from game.physics.generations import step as steps
from game.physics.generations.effects import BURNING, GENERATIONS, THRUST, TRAILS
from game.physics.generations.flight import METHODS, Air
from game.physics.generations.kinds import BURNS, LIFE, LIFE_SPREAD, Kind, make_table
from game.physics.generations.patterns import child_identity, life_of
from game.physics.generations.step import FIELDS, Pool, Rules, raise_children, step_stars

EVERYTHING = GRAVITY | DRAG | QUADRATIC_DRAG | WIND | GROUND | BURNING | THRUST | TRAILS
CALM = Air(9.81, 0.0, 0.0, 1000.0, 0.0)
LARGEST = 1e7  # m, m/s
MAX_ROW = 0x7FFFFFFF  # stands for the row of birth of what is put by hand
QUEUE = 16_384  # children of one star within one step, and theirs


class StarState(NamedTuple):
    """All that a later step depends on. The arrays are the system's own, not copies."""

    fields: NDArray[np.float64]
    identities: NDArray[np.int64]
    counts: NDArray[np.int64]
    tallies: NDArray[np.int64]
    clock: NDArray[np.float64]  # (4,): instant of origin, step (s), steps since the origin, stars put by hand


class StarSystem:
    """Stars of some kinds. See `Kind`; effects as `GENERATIONS` knows them; method: one of METHODS.

    seed: of the random numbers. ground: height (m) at which grounded kinds end. ValueError, naming the
    argument, for what makes no sense.
    """

    def __init__(
        self,
        kinds: Sequence[Kind],
        *,
        effects: EffectSet | Effect = EVERYTHING,
        method: str = "split-drag",
        air: Air = CALM,
        ground: float = 0.0,
        seed: int = 0,
        report_lines: int = 1024,
    ) -> None:
        self.kinds = tuple(kinds)
        self.table = make_table(self.kinds)
        self._numbers = {kind.name: number for number, kind in enumerate(self.kinds)}
        if isinstance(seed, bool) or not isinstance(seed, int) or not 0 <= seed < 2**31:
            raise ValueError(f"seed = {seed!r}: expected 0 to {2**31 - 1}")
        self.seed = seed
        self.ground = _finite("ground", ground)
        self.effects = GENERATIONS.checked(effects)
        self.method = method
        self.air = air
        capacity = int(self.table.begin[-1])
        self._clock = np.zeros(4)
        self._pool = Pool(
            fields=np.zeros((FIELDS, capacity)),
            identities=np.zeros(capacity, dtype=np.int64),
            counts=np.zeros(len(self.kinds), dtype=np.int64),
            tallies=np.zeros(steps.TALLIES, dtype=np.int64),
            before=np.zeros(len(self.kinds), dtype=np.int64),
            special=np.zeros(capacity, dtype=np.int64),
            kept=np.zeros((steps.MOVED, capacity)),
            queue=np.zeros((QUEUE, FIELDS)),
            queued=np.zeros((QUEUE, 2), dtype=np.int64),
            reports=np.zeros((report_lines, steps.REPORT_COLUMNS)),
        )

    def __len__(self) -> int:
        return int(self._pool.counts.sum())

    @property
    def method(self) -> str:
        """How stars fly: one of METHODS."""
        return METHODS[self._method]

    @method.setter
    def method(self, name: str) -> None:
        if name not in METHODS:
            raise ValueError(f"method = {name!r}: expected one of {', '.join(METHODS)}")
        self._method = METHODS.index(name)

    @property
    def air(self) -> Air:
        """Gravity and wind."""
        return self._air

    @air.setter
    def air(self, air: Air) -> None:
        for field, value in zip(Air._fields, air, strict=True):
            _finite(field, value)
        if air.ceiling < 0.0 or abs(air.wind) > 1000.0 or abs(air.gravity) > 1e4:
            raise ValueError(
                f"air = {air!r}: expected |wind| <= 1000 m/s, |gravity| <= 1e4 m/s², ceiling >= 0"
            )
        self._air = Air(*map(float, air))

    @property
    def time_s(self) -> float:
        """Simulated time: whole steps times their length since it was last changed."""
        origin, step, count, _ = self._clock.tolist()
        return float(origin + count * step)

    def tally(self, which: int) -> int:
        """One of the counters MADE, ENDED, DROPPED, LANDED, UNREPORTED of `step`."""
        return int(self._pool.tallies[which])

    @property
    def reports(self) -> NDArray[np.float64]:
        """(m, REPORT_COLUMNS) births, bursts and falls of the last step; a view, written over by the next."""
        return self._pool.reports[: self._pool.tallies[steps.REPORTED]]

    def stars(self, kind: str) -> NDArray[np.float64]:
        """(FIELDS, n) of the living stars of a kind: see `step`; a view. ValueError for no kind."""
        begin = int(self.table.begin[self._number(kind)])
        return self._pool.fields[:, begin : begin + int(self._pool.counts[self._number(kind)])]

    def identities(self, kind: str) -> NDArray[np.int64]:
        """(n,) identities of the living stars of a kind, in the order of `stars`; a view."""
        begin = int(self.table.begin[self._number(kind)])
        return self._pool.identities[begin : begin + int(self._pool.counts[self._number(kind)])]

    def _number(self, kind: str) -> int:
        if kind not in self._numbers:
            raise ValueError(f"kind = {kind!r}: expected one of {', '.join(self._numbers)}")
        return self._numbers[kind]

    def launch(self, kind: str, position: ArrayLike, velocity: ArrayLike, depth: float = 0.0) -> None:
        """Put one star that is born now: (2,) m, (2,) m/s, at a depth (m). What is born at its birth comes
        with it.

        ValueError for no such kind, or what is not finite. Without a place it is dropped and counted.
        """
        number = self._number(kind)
        place, speed, layer = (
            _pair("position", position),
            _pair("velocity", velocity),
            _finite("depth", depth),
        )
        pool, row = self._pool, self.table.kinds[number]
        by_hand = int(self._clock[3])
        identity = int(child_identity(self.seed, MAX_ROW, by_hand))
        self._clock[3] += 1.0
        life = float(life_of(row[LIFE], row[LIFE_SPREAD], self.seed, identity))
        pool.queue[1] = *place, layer, *speed, 0.0, self.time_s, self.time_s + life, row[BURNS] / life
        pool.queued[1] = identity, number
        raise_children(self._rules(), self.table, self._air, pool, 2, (self.time_s, self.time_s))

    def _rules(self) -> Rules:
        return Rules(self._method, GENERATIONS.mask(self.effects), self.seed, self.ground)

    def step(self, dt: float) -> None:
        """Go on by dt (s). ValueError unless it is finite and above 0."""
        if not 0.0 < dt < math.inf:
            raise ValueError(f"dt = {dt!r}: expected a finite number above 0 s")
        origin, step, count, by_hand = self._clock.tolist()
        if dt != step:
            origin, step, count = origin + count * step, dt, 0.0
        now = origin + count * step
        step_stars(self._rules(), self.table, self._air, self._pool, now, origin + (count + 1.0) * step - now)
        self._clock[:] = origin, step, count + 1.0, by_hand

    def state(self) -> StarState:
        """The state as arrays that the system goes on using."""
        pool = self._pool
        return StarState(pool.fields, pool.identities, pool.counts, pool.tallies, self._clock)

    def restore(self, state: StarState) -> None:
        """Take over a copy of a state of a system of the same kinds."""
        for mine, theirs in zip(self.state(), state, strict=True):
            np.copyto(mine, theirs)
        self._pool.tallies[steps.REPORTED] = 0

    def check(self) -> None:
        """Verify what must always hold; AssertionError names what does not."""
        capacity = np.diff(self.table.begin)
        assert np.all((self._pool.counts >= 0) & (self._pool.counts <= capacity)), "count"
        made, ended = self.tally(steps.MADE), self.tally(steps.ENDED)
        assert made == ended + len(self), "made = ended + alive"
        for kind in self.kinds:
            stars = self.stars(kind.name)
            assert np.all(np.isfinite(stars)), f"{kind.name}: finite"
            assert np.all(stars[steps.BORN] <= stars[steps.DIES]), f"{kind.name}: born before it dies"


def _finite(name: str, value: float) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float) or not abs(value) <= LARGEST:
        raise ValueError(f"{name} = {value!r}: expected a finite number up to {LARGEST:g}")
    return float(value)


def _pair(name: str, value: ArrayLike) -> NDArray[np.float64]:
    pair = np.asarray(value, dtype=np.float64)
    if pair.shape != (2,) or not np.all(np.abs(pair) <= LARGEST):
        raise ValueError(f"{name}: expected two finite numbers up to {LARGEST:g}")
    return pair
