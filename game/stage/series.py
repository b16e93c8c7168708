"""Readouts of the last seconds, for strip charts: rings whose contents are one piece of memory."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from game.stage.declarations import Readout

WINDOW_S = 10.0
RATE_HZ = 60.0


class StripSeries:
    """Samples of readouts by name, with the step and simulated time they were taken at.

    ``window_s``: s of simulated time that are kept. ``rate_hz``: the most samples for each of them.
    """

    def __init__(self, window_s: float = WINDOW_S, rate_hz: float = RATE_HZ):
        self.window_s = window_s
        self.rate_hz = rate_hz
        self.changes = 0  # how often samples were added or forgotten
        self._room = int(window_s * rate_hz * 1.25) + 8
        self.clear()

    def clear(self) -> None:
        """Forget all samples and names."""
        self.changes += 1
        self._first = 0
        self._end = 0
        self._times = np.empty(2 * self._room)
        self._steps = np.empty(2 * self._room, dtype=np.int64)
        self._values: dict[str, np.ndarray] = {}

    @property
    def names(self) -> tuple[str, ...]:
        """Names of all readouts that were ever sampled, in the order of appearance."""
        return tuple(self._values)

    @property
    def times(self) -> np.ndarray:
        """Simulated times of the samples, (n,) s, ascending; a view, good until the next sample."""
        return self._times[self._first : self._end]

    @property
    def steps(self) -> np.ndarray:
        """Steps at which they were taken, (n,) int64; a view like `times`."""
        return self._steps[self._first : self._end]

    def values(self, name: str) -> np.ndarray:
        """Values of one readout, (n,), NaN where it was not there; a view like `times`. KeyError."""
        return self._values[name][self._first : self._end]

    def __len__(self) -> int:
        return self._end - self._first

    def sample(self, step: int, time_s: float, readouts: Iterable[Readout]) -> None:
        """Add a sample; one of the same step is written over."""
        if len(self) and self._steps[self._end - 1] >= step:
            self.cut(step - 1)
        if self._end == 2 * self._room:
            self._compact()
        self.changes += 1
        index = self._end
        self._end += 1
        self._steps[index] = step
        self._times[index] = time_s
        for column in self._values.values():
            column[index] = np.nan
        for readout in readouts:
            if readout.name not in self._values:
                self._values[readout.name] = np.full(2 * self._room, np.nan)
            self._values[readout.name][index] = readout.value
        while self._times[self._first] < time_s - self.window_s or len(self) > self._room:
            self._first += 1

    def cut(self, step: int) -> None:
        """Forget samples of later steps."""
        self.changes += 1
        while self._end > self._first and self._steps[self._end - 1] > step:
            self._end -= 1

    def _compact(self) -> None:
        count = len(self)
        for column in (self._times, self._steps, *self._values.values()):
            column[:count] = column[self._first : self._end]
        self._first, self._end = 0, count
