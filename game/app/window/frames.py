"""Real time: the one wall clock of the program, and how long frames take."""

from __future__ import annotations

import math
import time
from collections import deque
from statistics import median
from typing import Protocol

KEPT_FRAMES = 120


class Clock(Protocol):
    """What the main loop needs of time; tests give one that they set themselves."""

    def now(self) -> float:
        """Seconds since some beginning, never going back."""
        ...

    def wait(self, seconds: float) -> None:
        """Let so many seconds pass."""
        ...


class SystemClock:
    """The machine's own monotonic clock."""

    def now(self) -> float:
        return time.perf_counter()

    def wait(self, seconds: float) -> None:
        if seconds > 0.0:
            time.sleep(seconds)


class FrameMeter:
    """Work of the last two seconds' frames: without the waiting, s."""

    def __init__(self) -> None:
        self._spent: deque[float] = deque(maxlen=KEPT_FRAMES)

    def add(self, seconds: float) -> None:
        """One more frame."""
        self._spent.append(seconds)

    @property
    def median_s(self) -> float:
        """Half of the frames took less; nan if there is none yet."""
        return median(self._spent) if self._spent else math.nan

    @property
    def worst_s(self) -> float:
        """The longest of them."""
        return max(self._spent, default=0.0)

    def clear(self) -> None:
        """Begin again, after something that has nothing to do with what is drawn now."""
        self._spent.clear()
