"""What the compiler is at, for those that wait for it."""

from __future__ import annotations

import gc
import threading
from typing import Any, NamedTuple
from weakref import WeakSet

from numba.core import event


class Compiling(NamedTuple):
    """What the compiler is at: names of the kernels it is in, outermost first, and how many it has done."""

    names: tuple[str, ...]
    done: int


class _Progress(event.Listener):
    """Hears from numba when a function begins and ends to be compiled, in any thread; heeds kernels only.

    Meanwhile Python does not look for objects that only hold each other: the compiler makes a million
    objects, nearly all of which are needed until it ends, and a seventh of its time would go into that.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._names: list[str] = []
        self._done = 0
        self._collects = False  # whether Python did so before

    def on_start(self, event: Any) -> None:
        """A function begins."""
        if event.data["dispatcher"] not in kernels:
            return
        with self._lock:
            if not self._names:
                self._collects = gc.isenabled()
                gc.disable()
            self._names.append(event.data["dispatcher"].py_func.__qualname__)

    def on_end(self, event: Any) -> None:
        """A function ends, and all that began after it."""
        if event.data["dispatcher"] not in kernels:
            return
        name = event.data["dispatcher"].py_func.__qualname__
        with self._lock:
            if name in self._names:
                del self._names[len(self._names) - 1 - self._names[::-1].index(name) :]
            self._done += 1
            if self._collects and not self._names:
                gc.enable()

    def look(self) -> Compiling:
        """What it is at now."""
        with self._lock:
            return Compiling(tuple(self._names), self._done)


kernels: WeakSet[Any] = WeakSet()  # whose progress it is
_progress = _Progress()
event.register("numba:compile", _progress)


def compiling() -> Compiling:
    """What is being compiled now, in any thread, and how many kernels this process has compiled.

    Kernels that were taken from the disk do not count, nor do functions of other packages.
    """
    return _progress.look()
