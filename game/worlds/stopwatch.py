"""Times of the parts of a step, for the picture alone: nothing that is computed may depend on them."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from contextlib import contextmanager
from time import perf_counter

FIRST = 3  # measurements of every step that find no space yet, cold caches and unread machine code
SAMPLES = 31  # odd, so that the median is a sample


class Stopwatch:
    """Running medians of measured times, by name. ``first``: how many of each are not counted."""

    def __init__(self, first: int = FIRST) -> None:
        self._first = first
        self._samples: dict[str, deque[float]] = {}
        self._seen: dict[str, int] = {}

    @contextmanager
    def time(self, name: str) -> Iterator[None]:
        """Measure what is done inside."""
        began = perf_counter()
        yield
        self.add(name, perf_counter() - began)

    def add(self, name: str, seconds: float) -> None:
        """Take a measured time, s."""
        seen = self._seen[name] = self._seen.get(name, 0) + 1
        if seen <= self._first:
            return
        self._samples.setdefault(name, deque(maxlen=SAMPLES)).append(seconds)

    def clear(self) -> None:
        """Forget all: what is measured has become something else."""
        self._samples.clear()
        self._seen.clear()

    def forget(self, name: str) -> None:
        """Forget a part that is no longer done."""
        self._samples.pop(name, None)
        self._seen.pop(name, None)

    def median(self, name: str) -> float:
        """Median of the last times, s; NaN if there are none."""
        samples = sorted(self._samples.get(name, ()))
        return samples[len(samples) // 2] if samples else float("nan")
