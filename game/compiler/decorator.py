"""The decorator of kernels: numba's nopython compiler with a disk cache that cannot go stale.

numba's own cache looks only at the file a function stands in. It hands back old code after an edit of a
helper in another file. Here machine code lies in a folder named by all sources that it depends on (see
sources.py), in the user's cache folder or ``CAROM_CACHE_DIR`` (see cache.py). If that cannot be written,
kernels compile again in each process: that costs time and nothing else.

Kept on disk are kernels of this package, at module level or closures over plain integers. A closure over
another kernel is a new function in every process. So variants by effect are specialised by integer masks. A
kernel elsewhere, in a test say, is compiled in each process. A module must not make a constant that its
kernels use depend on anything but sources: environment, files and clock are not in the folder's name.

Kernels take Carom's own compilation target (see target/), or are plain ones of numba's (see tried.py).
``NUMBA_DISABLE_JIT=1`` leaves every kernel the Python function that it is.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numba
from numba import config

from game.compiler.progress import kernels
from game.compiler.tried import is_plain

if not is_plain():
    from game.compiler.target.making import make_kernel

__all__ = ["inner_kernel", "kernel", "lean_kernel", "linked_kernel"]

_ALWAYS = {"nogil": True, "error_model": "numpy"}
_OF_THE_TARGET = ("_nrt", "no_cpython_wrapper", "no_cfunc_wrapper")  # options that plain kernels go without


def kernel(function: Callable[..., Any] | None = None, **options: Any) -> Any:
    """Compile a function to machine code (nopython, no GIL, no fastmath), kept on disk.

    Use bare (``@kernel``) or with numba options (``@kernel(inline="always")``). Division by zero gives inf or
    nan as in numpy. ValueError for fastmath, which removes NaN tests and fuses sums so that equal input would
    no longer give equal bits. Also for parallel and cache, which are not the caller's to say.
    """
    for refused in ("fastmath", "parallel", "cache", "error_model", "nogil"):
        if refused in options:
            raise ValueError(f"kernel: the option {refused} is not to be had here")
    if function is None:
        return partial(kernel, **options)
    if config.DISABLE_JIT:
        return function
    if is_plain():
        known = {name: value for name, value in options.items() if name not in _OF_THE_TARGET}
        made = numba.njit(**_ALWAYS, **known)(function)
    else:
        made = make_kernel(function, {**_ALWAYS, **options})
    kernels.add(made)
    return made


def lean_kernel(function: Any = None, **options: Any) -> Any:
    """`kernel`, without numba's run-time for memory. Use bare, or with numba's options.

    numba counts the references to every array that a compiled function gets, by an atomic addition when it
    enters and another when it leaves: 100 to 200 clock cycles for each call with ten arrays. The exact
    billiard table makes about ten calls an event, so this cost a fifth of its time. Code that counts takes
    longer to compile. A lean kernel must not create arrays; views of given ones are fine.
    """
    return partial(lean_kernel, **options) if function is None else kernel(_nrt=False, **options)(function)


def inner_kernel(function: Any = None, **options: Any) -> Any:
    """`lean_kernel` for other kernels only. A call from Python is a TypeError, unless kernels are plain.

    numba makes, of each function, two more that unpack its arguments for a call from Python or C. They take
    as long to compile as a small kernel itself, and are compiled once more with every caller. An inner kernel
    goes without.
    """
    if function is None:
        return partial(inner_kernel, **options)
    return lean_kernel(function, no_cpython_wrapper=True, no_cfunc_wrapper=True, **options)


def linked_kernel(function: Any) -> Any:
    """`lean_kernel` that machine code calls by its address, and Python not at all."""
    return lean_kernel(function, no_cpython_wrapper=True)
