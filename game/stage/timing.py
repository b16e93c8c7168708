"""What a step costs: the running median of measured times, which one slow step does not move."""

from __future__ import annotations

import math

import numpy as np

KEPT = 128  # measurements; at 120 steps a second about one second


class StepTimer:
    """A ring of measured seconds per step. Measured times never reach a scene."""

    def __init__(self) -> None:
        self._times = [0.0] * KEPT
        self._count = 0

    def add(self, seconds: float) -> None:
        """Take in one measurement, s."""
        self._times[self._count % KEPT] = seconds
        self._count += 1

    def clear(self) -> None:
        """Forget all measurements."""
        self._count = 0

    @property
    def median_s(self) -> float:
        """Median of the last measurements, s; NaN before the first."""
        count = min(self._count, KEPT)
        return float(np.median(self._times[:count])) if count else math.nan

    @property
    def last_s(self) -> float:
        """The lesser of the last two measurements, as one alone may be a hitch, s; 0 before the first."""
        if self._count < 2:
            return self._times[0] if self._count else 0.0
        return min(self._times[(self._count - 1) % KEPT], self._times[(self._count - 2) % KEPT])

    @property
    def worst_s(self) -> float:
        """Largest of the last measurements, s; NaN before the first."""
        count = min(self._count, KEPT)
        return max(self._times[:count]) if count else math.nan
