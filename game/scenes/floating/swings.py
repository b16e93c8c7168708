"""Periods of heave and roll, found from how often a body passes the middle of its swings."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from game.arrays import Floats
from game.worlds.world import Member

FADES = 0.35  # 1/s: how fast an earlier swing is forgotten
ARMED, STILL = 0.3, 1e-3  # of the fastest of late: so far back it has to be before it turns; m/s, rad/s
UNKNOWN = -1.0
SOFT = 0.05  # s: over which a rate is taken in the mean, so that splashes do not count
AGO, FAST, BEFORE, READY, SPAN = range(5)  # columns of a watched rate


class Swings(Member):
    """Watches rates, one a row of ``rows`` (n, 5): s since it last turned from falling to rising, how fast it
    was of late, what it was before, 1 while it falls, the last period s. Times may be `UNKNOWN`.
    """

    kept = ("rows",)

    def __init__(self, read: Callable[[], Floats]):
        """read() gives the rates (n,) as they are."""
        self.read = read
        self.rows: Floats = np.zeros((len(read()), 5))
        self.begin()

    def begin(self) -> None:
        """Forget what was."""
        self.rows[:] = 0.0
        self.rows[:, AGO] = self.rows[:, SPAN] = UNKNOWN

    def step(self, dt: float) -> None:
        share = min(dt / SOFT, 1.0)
        for row, rate in zip(self.rows, self.read(), strict=True):
            now = row[BEFORE] + share * (rate - row[BEFORE])
            row[FAST] = max(abs(now), row[FAST] * (1.0 - min(FADES * dt, 1.0)))
            known = row[AGO] >= 0.0
            if known:
                row[AGO] += dt
            if now < -ARMED * row[FAST] and row[FAST] > STILL:
                row[READY] = 1.0
            if row[READY] > 0.0 and now >= 0.0:
                late = dt * now / (now - row[BEFORE])  # it turned so long before the end of this step
                if known:
                    row[SPAN] = row[AGO] - late
                row[AGO], row[READY] = late, 0.0
            row[BEFORE] = now

    def period(self, k: int) -> float:
        """s; NaN while it is not known."""
        found = float(self.rows[k, SPAN])
        return found if found > 0.0 else float("nan")
