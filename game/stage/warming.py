"""Compiling kernels behind a loading bar: a list of warm-ups, called one by one in a thread."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from time import perf_counter
from typing import NamedTuple

from game.stage.declarations import WarmUp


class WarmingProgress(NamedTuple):
    """How far it is: warm-ups ended, of how many, the one under way (or ""), s since the start."""

    done: int
    total: int
    name: str
    seconds: float


class Warming:
    """Calls warm-ups in a thread of its own; the main thread only looks.

    One that fails is noted in `errors` as (name, reason) and the next is called. `cancel` stops between
    two; what is being compiled is finished, as a compiler cannot be interrupted.
    """

    def __init__(self, warm_ups: Sequence[WarmUp], clock: Callable[[], float] = perf_counter):
        self._warm_ups = tuple(warm_ups)
        self._clock = clock
        self._began = clock()
        self._ended: float | None = None
        self._done = 0
        self._name = ""
        self._errors: list[tuple[str, str]] = []
        self._cancelled = threading.Event()
        self._finished = threading.Event()
        self._thread = threading.Thread(target=self._work, name="warming", daemon=True)
        self._thread.start()

    @property
    def progress(self) -> WarmingProgress:
        """How far it is now."""
        end = self._clock() if self._ended is None else self._ended
        return WarmingProgress(self._done, len(self._warm_ups), self._name, end - self._began)

    @property
    def finished(self) -> bool:
        """True when nothing more will be called."""
        return self._finished.is_set()

    @property
    def errors(self) -> list[tuple[str, str]]:
        """Names of the warm-ups that failed, and why, in one line each."""
        return list(self._errors)

    def cancel(self) -> None:
        """Call no further warm-up."""
        self._cancelled.set()

    def wait(self, timeout_s: float | None = None) -> bool:
        """Wait until it has finished, for tests and headless runs; False if that takes longer."""
        return self._finished.wait(timeout_s)

    def _work(self) -> None:
        for name, call in self._warm_ups:
            if self._cancelled.is_set():
                break
            self._name = name
            try:
                call()
            except Exception as error:
                self._errors.append((name, " ".join(str(error).split()) or type(error).__name__))
            self._done += 1
        self._name = ""
        self._ended = self._clock()
        self._finished.set()
