"""Kernels that neither allocate nor count references, and inner kernels that only other kernels call.

numba counts the references to every array that a compiled function gets, by an atomic addition when it
enters and another when it leaves: 100 to 200 clock cycles for each call with ten arrays. The exact billiard
table makes about ten calls an event, so that this cost a fifth of its time, and code that counts takes longer
to compile. A lean kernel must not create arrays; views of given ones are fine.

numba also makes, of each function, two more that unpack its arguments for a call from Python or C. They take
as long to compile as a small kernel itself, and are compiled once more with every caller. An inner kernel
goes without.
"""

from __future__ import annotations

from functools import partial
from typing import Any

from numba import config

from game.physics.kernels.jit import kernel


def lean_kernel(function: Any = None, **options: Any) -> Any:
    """`kernel`, without numba's run-time for memory. Use bare, or with numba's options."""
    if function is None:
        return partial(lean_kernel, **options)
    return kernel(_nrt=False, **options)(function)


def inner_kernel(function: Any = None, **options: Any) -> Any:
    """`lean_kernel` for other kernels only: a call from Python is a TypeError (unless compilation is off)."""
    if function is None:
        return partial(inner_kernel, **options)
    dispatcher = lean_kernel(function, no_cpython_wrapper=True, no_cfunc_wrapper=True, **options)
    if not config.DISABLE_JIT:
        _shut_door(dispatcher)
    return dispatcher


def linked_kernel(function: Any) -> Any:
    """`lean_kernel` that machine code calls by its address, and Python not at all."""
    dispatcher = lean_kernel(function, no_cpython_wrapper=True)
    if not config.DISABLE_JIT:
        _shut_door(dispatcher)
    return dispatcher


def _shut_door(dispatcher: Any) -> None:
    """Let no call from Python reach the machine code, which has no entrance for it."""

    def add_overload(result: Any) -> None:
        dispatcher.overloads[tuple(result.signature.args)] = result

    def refuse(*_arguments: Any, **_options: Any) -> None:
        raise TypeError(f"{dispatcher.py_func.__name__}: an inner kernel, which only other kernels can call")

    dispatcher.add_overload = add_overload
    dispatcher._compile_for_args = refuse
