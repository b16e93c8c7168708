"""A kernel of a function, with its place on the disk."""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import numba
from numba import config

from game.compiler.cache import code_folder
from game.compiler.progress import kernels
from game.compiler.target.dispatchers import KernelDispatcher
from game.compiler.target.kept import KernelCache


def make_kernel(function: Callable[..., Any], options: dict[str, Any]) -> KernelDispatcher:
    """The dispatcher of a function, by numba's options."""
    dispatcher = KernelDispatcher(function, targetoptions={"nopython": True, "boundscheck": None, **options})
    if _closes_over_integers(function):
        folder = code_folder(Path(function.__code__.co_filename).resolve())
        if folder is not None:
            said = f"{sorted(options.items())}|{numba.__version__}|{config.OPT}|{config.BOUNDSCHECK}"
            with contextlib.suppress(ValueError):
                dispatcher._cache = KernelCache(function, folder, said)
    if _may_be_inner(options):
        dispatcher.make_inner = partial(_make_inner, function, options)
    return dispatcher


def _make_inner(function: Callable[..., Any], options: dict[str, Any]) -> KernelDispatcher:
    """The inner kernel of a function, for the kernels that call it."""
    made = make_kernel(function, {**options, "no_cpython_wrapper": True, "no_cfunc_wrapper": True})
    kernels.add(made)
    return made


def _may_be_inner(options: dict[str, Any]) -> bool:
    """Whether a kernel may be called as an inner one: it counts no references and is not inlined by numba."""
    has_entries = not (options.get("no_cpython_wrapper") or options.get("no_cfunc_wrapper"))
    return has_entries and options.get("_nrt") is False and options.get("inline", "never") == "never"


def _closes_over_integers(function: Callable[..., Any]) -> bool:
    """True if a function's closure, if any, holds plain integers only, whose values have lasting names."""
    try:
        return all(type(cell.cell_contents) in (int, bool) for cell in function.__closure__ or ())
    except ValueError:  # a cell not filled yet: the function refers to itself
        return False
