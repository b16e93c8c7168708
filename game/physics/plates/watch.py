"""What plates are doing, found while they fall: when each stops turning one way, and each whole turn."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.plates import law

KEPT = 9  # events of each kind that are remembered of a plate
TIME, AT_X, AT_Y, ANGLE = range(4)
EVENT = 4
STOPS, TURNS = range(2)
UNSTEADY = 0.1  # spread of swings beside their mean from which on they are irregular
NAMES = ("", "flutter", "tumble", "chaos", "glide")
NOTHING, FLUTTER, TUMBLE, CHAOS, GLIDE = range(5)
GLIDING = 0.6  # m across for each m down


class Course(NamedTuple):
    """What a plate does now, SI: which of NAMES, period s, half amplitude rad, spin rad/s, descent m/s."""

    regime: int
    period: float
    amplitude: float
    spin: float
    descent: float


NO_COURSE = Course(NOTHING, math.nan, math.nan, math.nan, math.nan)


class Watch:
    """Of n plates the last events (2, n, KEPT, EVENT), and how many of each there were (2, n)."""

    def __init__(self, count: int):
        self.events: Floats = np.zeros((2, count, KEPT, EVENT))
        self.counts = np.zeros((2, count), dtype=np.int64)

    def grow(self) -> None:
        """A plate more."""
        self.events = np.concatenate([self.events, np.zeros((2, 1, KEPT, EVENT))], axis=1)
        self.counts = np.concatenate([self.counts, np.zeros((2, 1), dtype=np.int64)], axis=1)

    def remove(self, number: int) -> None:
        """One less."""
        self.events = np.delete(self.events, number, axis=1)
        self.counts = np.delete(self.counts, number, axis=1)

    def forget(self, number: int) -> None:
        """It is another plate from now on."""
        self.counts[:, number] = 0

    def look(self, before: Floats, now: Floats, time: float, dt: float) -> None:
        """Between two states (STATE, n), the later at ``time``: note stops and whole turns."""
        stopped = before[law.SPIN] * now[law.SPIN] < 0.0
        for i in np.flatnonzero(stopped).tolist():
            self._note(
                STOPS,
                i,
                before,
                now,
                (time, dt, before[law.SPIN, i] / (before[law.SPIN, i] - now[law.SPIN, i])),
            )
        turn = np.floor(before[law.THETA] / math.tau), np.floor(now[law.THETA] / math.tau)
        for i in np.flatnonzero(turn[0] != turn[1]).tolist():
            edge = max(turn[0][i], turn[1][i]) * math.tau
            self._note(
                TURNS,
                i,
                before,
                now,
                (time, dt, (edge - before[law.THETA, i]) / (now[law.THETA, i] - before[law.THETA, i])),
            )

    def _note(self, kind: int, i: int, before: Floats, now: Floats, when: tuple[float, float, float]) -> None:
        time, dt, share = when
        at = before[:, i] + share * (now[:, i] - before[:, i])
        row = self.counts[kind, i] % KEPT
        self.events[kind, i, row] = time - dt * (1.0 - share), at[law.X], at[law.Y], at[law.THETA]
        self.counts[kind, i] += 1

    def _last(self, kind: int, i: int) -> Floats:
        """Events (k, EVENT), the oldest first."""
        count = int(self.counts[kind, i])
        return self.events[kind, i, np.arange(max(count - KEPT, 0), count) % KEPT]

    def course(self, i: int, now: Floats, time: float) -> Course:
        """What plate i does: by the last events, or steadily nothing."""
        stops, turns = self._last(STOPS, i), self._last(TURNS, i)
        since = stops[-1, TIME] if len(stops) else -1.0
        if len(turns) >= 3 and turns[-3, TIME] > since:
            steady = turns[turns[:, TIME] > since]
            took, fell = steady[-1, TIME] - steady[0, TIME], steady[0, AT_Y] - steady[-1, AT_Y]
            spin = (steady[-1, ANGLE] - steady[0, ANGLE]) / took
            return Course(TUMBLE, math.tau / abs(spin), math.pi, spin, fell / took)
        if len(stops) < 5:
            return NO_COURSE
        stops = stops[(len(stops) - 1) % 2 :]  # whole swings
        took, fell = stops[-1, TIME] - stops[0, TIME], stops[0, AT_Y] - stops[-1, AT_Y]
        gaps, spans = np.diff(stops[:, TIME]), np.abs(np.diff(stops[:, ANGLE]))
        if time - stops[-1, TIME] > 6.0 * float(np.mean(gaps)):
            return NO_COURSE
        periods, ways = np.diff(stops[::2, TIME]), spans[::2]
        spread = max(np.std(periods) / np.mean(periods), np.std(ways) / max(float(np.mean(ways)), 1e-12))
        period, amplitude = float(np.mean(periods)), 0.5 * float(np.mean(spans))
        far = abs(stops[-1, AT_X] - stops[0, AT_X]) > GLIDING * fell
        regime = CHAOS if spread > UNSTEADY else GLIDE if far else FLUTTER
        if regime == CHAOS and len(stops) < KEPT - 1:
            regime = NOTHING  # still on its way
        spin = (stops[-1, ANGLE] - stops[0, ANGLE]) / took
        return Course(regime, period, amplitude, spin, fell / took)
