"""The one ``@kernel`` decorator: numba's nopython compiler with a disk cache that cannot go stale.

numba's own cache looks only at the file a function stands in, and hands back old code after an edit of a
helper in another file. Here machine code lies in a folder named by all sources that it depends on (see
jit_sources.py), in the user's cache folder or ``CAROM_CACHE_DIR`` (see jit_cache.py). If that cannot be
written, kernels compile again in each process: that costs time and nothing else.

Kept on disk are kernels of this package, at module level or closures over plain integers (a closure over
another kernel is a new function in every process). So variants by effect are specialised by integer masks.
A kernel elsewhere, in a test say, is compiled in each process. A module must not make a constant that its
kernels use depend on anything but sources: environment, files and clock are not in the folder's name.

``NUMBA_DISABLE_JIT=1`` leaves every kernel the Python function that it is.
"""

from __future__ import annotations

import contextlib
import gc
import itertools
import os
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numba
from numba import config, types
from numba.core import event
from numba.core.bytecode import FunctionIdentity

from game.folders import cache_folder
from game.physics.kernels.jit_cache import KernelCache
from game.physics.kernels.jit_sources import module_name, source_digest
from game.physics.kernels.linking import InnerCompiler, OuterCompiler
from game.physics.kernels.quick_typing import answer_at_once

__all__ = ["Compiling", "code_folder", "compiling", "kernel", "source_digest"]


class Compiling(NamedTuple):
    """What the compiler is at: names of the kernels it is in, outermost first, and how many it has done."""

    names: tuple[str, ...]
    done: int


class _Watch(event.Listener):
    """Hears from numba when a kernel begins and ends to be compiled, in any thread.

    Meanwhile Python does not look for objects that only hold each other: the compiler makes a million
    objects, nearly all of which are needed until it ends, and a seventh of its time would go into that.
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._names: list[str] = []
        self._done = 0
        self._collects = False  # whether Python did so before

    def on_start(self, event: Any) -> None:
        with self._lock:
            if not self._names:
                self._collects = gc.isenabled()
                gc.disable()
            self._names.append(event.data["dispatcher"].py_func.__qualname__)

    def on_end(self, event: Any) -> None:
        name = event.data["dispatcher"].py_func.__qualname__
        with self._lock:
            if name in self._names:
                del self._names[len(self._names) - 1 - self._names[::-1].index(name) :]
            self._done += 1
            if self._collects and not self._names:
                gc.enable()

    def look(self) -> Compiling:
        with self._lock:
            return Compiling(tuple(self._names), self._done)


_watch = _Watch()
event.register("numba:compile", _watch)
answer_at_once()

# numba tells two functions of one name apart, as two closures over different integers, by a number that it
# counts up from 1 in each process. Kept code of two processes then has one name for different functions, and
# a kernel that calls both would call one of them twice. So each process counts from a place of its own.
FunctionIdentity._unique_ids = itertools.count(int.from_bytes(os.urandom(6), "little") << 14)


def compiling() -> Compiling:
    """What is being compiled now, in any thread, and how many kernels this process has compiled.

    Kernels that were taken from the disk do not count.
    """
    return _watch.look()


def code_folder(file: Path) -> Path | None:
    """Folder of the machine code of the kernels that stand in ``file``; None if theirs cannot be kept."""
    try:
        return cache_folder() / "kernels" / f"{module_name(file)}-{source_digest(file)}"
    except (OSError, ValueError):  # not of this package, no readable sources (in a zip file), or just edited
        return None


def kernel(function: Callable[..., Any] | None = None, **options: Any) -> Any:
    """Compile a function to machine code (nopython, no GIL, no fastmath), kept on disk.

    Use bare (``@kernel``) or with numba options (``@kernel(inline="always")``). Division by zero gives
    inf or nan as in numpy. ValueError for fastmath, which removes NaN tests and fuses sums so that equal
    input would no longer give equal bits, and for parallel and cache, which are not the caller's to say.
    """
    for refused in ("fastmath", "parallel", "cache", "error_model", "nogil"):
        if refused in options:
            raise ValueError(f"kernel: the option {refused} is not to be had here")

    def compile_lazily(py_function: Callable[..., Any]) -> Any:
        compiler = InnerCompiler if options.get("no_cfunc_wrapper") else OuterCompiler
        dispatcher = numba.njit(nogil=True, error_model="numpy", pipeline_class=compiler, **options)(
            py_function
        )
        if not config.DISABLE_JIT:
            _forget_literals(dispatcher)
        if config.DISABLE_JIT or not _closes_over_integers(py_function):
            return dispatcher
        folder = code_folder(Path(py_function.__code__.co_filename).resolve())
        if folder is not None:
            said = f"{sorted(options.items())}|{numba.__version__}|{config.OPT}|{config.BOUNDSCHECK}"
            with contextlib.suppress(ValueError):
                dispatcher._cache = KernelCache(py_function, folder, said)
        return dispatcher

    return compile_lazily if function is None else compile_lazily(function)


def _forget_literals(dispatcher: Any) -> None:
    """Let calls with a constant share the machine code of calls with a variable.

    For numba ``f(a, 0)`` is another signature than ``f(a, i)``, and all that f calls is compiled once more
    for it. The optimiser puts the constant in anyway where that is worth something.
    """
    ask = dispatcher.get_call_template

    def get_call_template(args: Any, kws: Any) -> Any:
        plain = {name: types.unliteral(kind) for name, kind in dict(kws).items()}
        return ask(tuple(types.unliteral(kind) for kind in args), plain)

    dispatcher.get_call_template = get_call_template


def _closes_over_integers(function: Callable[..., Any]) -> bool:
    """True if a function's closure, if any, holds plain integers only, whose values have lasting names."""
    try:
        return all(type(cell.cell_contents) in (int, bool) for cell in function.__closure__ or ())
    except ValueError:  # a cell not filled yet: the function refers to itself
        return False
