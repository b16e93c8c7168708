"""Many strokes at one arrangement of balls: struck, played and summed up in three kernel calls a chunk.

`Board` is the arrangement made ready. What comes of a stroke depends neither on the others nor on the number
of threads; buffers belong to the thread that uses them.
"""

from __future__ import annotations

import math
import threading
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.game.arrangement import Arrangement
from game.billiards.game.rules import CUE_BALL
from game.billiards.laws import state as col
from game.billiards.laws.batch import Batch, Log
from game.billiards.laws.lean import inner_kernel, lean_kernel
from game.billiards.search.outcomes import NO_LINE, Outcomes, sum_up
from game.billiards.shot.cue import CUE_END_MASS, CUE_MASS
from game.billiards.shot.physics import Physics
from game.billiards.simulation import log_for, play_into
from game.billiards.table.table import Table
from game.physics.kernels import elementary, elementwise

CHUNK = 128  # strokes that a thread takes at a time
EVENTS_A_STROKE = 64  # first guess of the capacity of a log
MAX_EVENTS = 3000  # of a stroke; the few that need more are given up

# columns of strokes (m, 5), the fields of `arrangement.Stroke`
SPEED, AZIMUTH, ELEVATION, TIP_LEFT, TIP_UP = range(5)
LARGEST_TIP = 0.7  # ball radii; noise does not carry the tip farther out
LEAST_SPEED = 0.02  # m/s
SLATE_PUSH = 2.0  # a ball never gets more than twice the speed of the cue
STEEPEST = 1.5  # rad

_local = threading.local()


class Noise(NamedTuple):
    """Standard deviations of what a hand does: tip m, elevation rad, azimuth rad, speed m/s."""

    tip: float = 0.5e-3
    elevation: float = math.radians(0.1)
    azimuth: float = math.radians(0.125)
    speed: float = 0.075

    def scaled(self, factor: float) -> Noise:
        """A hand that is so many times as unsteady."""
        return Noise(*(factor * sigma for sigma in self))


STEADY = Noise(0.0, 0.0, 0.0, 0.0)


@inner_kernel(inline="always")
def strike_ball(stroke, ball, end_mass, cue_mass):
    """Velocity and spin of a struck ball to its row (11,): `cue.strike`, on arrays; in a row of 13 also its
    speed into the slate."""
    a = stroke[TIP_LEFT]
    b = stroke[TIP_UP]
    radius = ball[col.IN_RADIUS]
    mass = ball[col.IN_MASS]
    cosine = elementary.cos(stroke[ELEVATION])
    sine = elementary.sin(stroke[ELEVATION])
    c = math.sqrt(1.0 - a * a - b * b)
    k = 0.4 * radius * radius
    side = radius * a
    lever = radius * (sine * c + cosine * b) * cosine - radius * (cosine * c - sine * b) * sine
    speed = 2.0 * stroke[SPEED] / (1.0 + mass / cue_mass + (side * side + lever * lever) / k)
    turn = stroke[AZIMUTH] + 0.5 * math.pi
    rest = 1.0 - a * a
    aside = turn - elementary.atan2(2.5 * a * math.sqrt(rest), 1.0 + mass / end_mass + 2.5 * rest)
    ball[col.IN_VX] = elementary.sin(aside) * speed * cosine
    ball[col.IN_VY] = -elementary.cos(aside) * speed * cosine
    roll = speed / k * lever
    swerve = speed / k * side * sine
    ball[col.IN_WX] = elementary.cos(turn) * roll - elementary.sin(turn) * swerve
    ball[col.IN_WY] = elementary.sin(turn) * roll + elementary.cos(turn) * swerve
    ball[col.IN_WZ] = -speed / k * side * cosine
    ball[col.IN_MOTION] = col.SLIDING
    if ball.shape[0] > col.IN_VZ:
        ball[col.IN_Z] = 0.0
        ball[col.IN_VZ] = -speed * sine


@lean_kernel
def strike_all(strokes, base, cue, end_mass, cue_mass, balls):
    """The balls of each stroke (m, n, 11 or 13): those of `base` (n, 11) with ball `cue` struck."""
    for s in range(strokes.shape[0]):
        for i in range(base.shape[0]):
            for column in range(base.shape[1]):
                balls[s, i, column] = base[i, column]
        strike_ball(strokes[s], balls[s, cue], end_mass, cue_mass)


@lean_kernel
def add_noise(strokes, draws, sigmas, noisy):
    """Each stroke (m, 5) with each of k draws (k, 5) of normal numbers, to noisy (m k, 5).

    sigmas (4,): a `Noise`, the tip's in ball radii. A tip is kept on the ball, a butt above the cloth.
    """
    k = draws.shape[0]
    for s in range(strokes.shape[0]):
        for d in range(k):
            row = noisy[s * k + d]
            row[SPEED] = max(strokes[s, SPEED] + sigmas[3] * draws[d, SPEED], LEAST_SPEED)
            row[AZIMUTH] = strokes[s, AZIMUTH] + sigmas[2] * draws[d, AZIMUTH]
            raised = abs(strokes[s, ELEVATION] + sigmas[1] * draws[d, ELEVATION])
            row[ELEVATION] = min(raised, STEEPEST)
            a = strokes[s, TIP_LEFT] + sigmas[0] * draws[d, TIP_LEFT]
            b = strokes[s, TIP_UP] + sigmas[0] * draws[d, TIP_UP]
            shrink = LARGEST_TIP / max(math.sqrt(a * a + b * b), LARGEST_TIP)
            row[TIP_LEFT] = a * shrink
            row[TIP_UP] = b * shrink


class _Buffers(NamedTuple):
    """Buffers of one thread for n balls."""

    balls: Floats
    constants: Floats
    ranges: NDArray[np.int64]
    log: Log


def _buffers_for(n: int, flies: bool, paths: bool) -> _Buffers:
    kept: dict[tuple[int, bool, bool], _Buffers] = _local.__dict__.setdefault("buffers", {})
    if (n, flies, paths) not in kept:
        kept[n, flies, paths] = _Buffers(
            np.zeros((CHUNK, n, col.FLIGHT_IN_COLUMNS if flies else col.IN_COLUMNS)),
            np.empty((CHUNK, col.PHYSICS_COLUMNS)),
            np.empty((CHUNK, 4), np.int64),
            log_for(CHUNK, n, max(EVENTS_A_STROKE * CHUNK, 4 * n * n + 2 * MAX_EVENTS), paths, flies),
        )
    return kept[n, flies, paths]


class Board:
    """An arrangement with its cue ball, ready for many strokes.

    layout, table, physics: what was given. line: y, m, from behind which the cue ball is played, so that no
    ball there may be met first; NO_LINE without one. cue: row of the cue ball. ValueError without one.
    """

    def __init__(
        self,
        layout: Arrangement,
        table: Table,
        physics: Physics = Physics(),  # noqa: B008  (immutable)
        line: float = NO_LINE,
    ) -> None:
        if CUE_BALL not in layout.numbers:
            raise ValueError("search: there is no cue ball on the table")
        self.layout = layout
        self.table = table
        self.physics = physics
        self.line = line
        self.cue = layout.numbers.index(CUE_BALL)
        shot = layout.shot(table, physics)
        self.base = shot.balls.copy()
        self.radii = shot.balls[:, col.IN_RADIUS].copy()
        self.radius = float(self.radii[self.cue])
        self.middle = shot.layout.middle
        self._constants = shot.constants
        self._elements = shot.batch.elements
        self._ranges = shot.batch.ranges[0]

    @property
    def places(self) -> Floats:
        """Where the balls lie (n, 2), m in the table's frame."""
        return self.base[:, :2] + self.middle

    def moved(self, places: Floats, kept: NDArray[np.intp]) -> Board:
        """The board with some of its rows, at rest at other places (n, 2) m; nothing is checked."""
        board = Board.__new__(Board)
        board.__dict__.update(self.__dict__)
        board.line = NO_LINE  # the next stroke is played from where the cue ball lies
        board.base = self.base[kept]
        board.base[:, :2] = places[kept] - self.middle
        board.cue = int(np.flatnonzero(kept == self.cue)[0])
        board.radii = self.radii[kept]
        return board

    @property
    def count(self) -> int:
        """How many balls there are, the cue ball among them."""
        return len(self.base)

    def play(self, strokes: Floats, pool: ThreadPoolExecutor | None = None) -> Outcomes:
        """What comes of strokes (m, 5). pool: threads to share them among."""
        outcomes = Outcomes.empty(len(strokes), self.count)
        starts = range(0, len(strokes), CHUNK)
        in_threads(pool, lambda start: self._play_chunk(strokes, outcomes, start), starts)
        return outcomes

    def _play_chunk(self, strokes: Floats, outcomes: Outcomes, start: int) -> None:
        """Play one chunk into its rows of the outcomes."""
        chunk = strokes[start : start + CHUNK]
        for log, first, played in self.played(chunk):
            rows = outcomes.rows(slice(start, start + len(chunk)))
            sum_up(log, self.cue, self.line, first, played, rows)

    def _flies(self, strokes: Floats) -> bool:
        """True if one of strokes (m, 5) may take a ball off the slate."""
        physics = self.physics
        if not physics.airborne:
            return False
        down = SLATE_PUSH * strokes[:, SPEED] * elementwise.sin(strokes[:, ELEVATION])
        return physics.cushion_hop > 0.0 or bool((physics.slate_restitution * down > col.LANDING_SPEED).any())

    def played(self, strokes: Floats) -> Iterator[tuple[Log, int, int]]:
        """Play at most CHUNK strokes (m, 5): a log, and from which to which row it holds them, part by part.

        The log is this thread's own, and is written over by the next part.
        """
        m = len(strokes)
        flies = self._flies(strokes)
        buffers = _buffers_for(self.count, flies, self.line > NO_LINE)
        balls, constants, ranges = buffers.balls[:m], buffers.constants[:m], buffers.ranges[:m]
        constants[:] = self._constants
        ranges[:] = self._ranges
        strike_all(strokes, self.base, self.cue, CUE_END_MASS, CUE_MASS, balls)
        log = buffers.log
        rows = Log(log.events, log.segments, log.ends[:m], log.final[:m])
        if flies:
            rise = -self.physics.slate_restitution * balls[:, self.cue, col.IN_VZ]
            balls[rise <= col.LANDING_SPEED, self.cue, col.IN_VZ] = 0.0
        batch = Batch(balls, constants, self._elements, ranges)
        first = 0
        while first < m:
            end = play_into(rows, batch, first, math.inf, MAX_EVENTS)
            yield rows, first, end
            first = end


def in_threads(
    pool: ThreadPoolExecutor | None, task: Callable[[int], Any], items: Sequence[int]
) -> list[Any]:
    """Do a task for each item, in threads if there is a pool; results in the order of items."""
    if pool is None or len(items) < 2:
        return [task(item) for item in items]
    return list(pool.map(task, items))


def draw_noise(seed: int, count: int) -> Floats:
    """Normal numbers (count, 5) for `add_noise`, each column of mean 0: half of them mirror the others."""
    half = np.random.default_rng(seed).standard_normal(((count + 1) // 2, 5))
    return np.ascontiguousarray(np.concatenate([half, -half])[:count])


def with_noise(strokes: Floats, draws: Floats, noise: Noise, radius: float) -> Floats:
    """Each stroke (m, 5) as an unsteady hand does it, k times: (m k, 5). draws (k, 5): normal numbers."""
    noisy = np.empty((len(strokes) * len(draws), 5))
    sigmas = np.array([noise.tip / radius, noise.elevation, noise.azimuth, noise.speed])
    add_noise(np.ascontiguousarray(strokes), draws, sigmas, noisy)
    return noisy
