"""A kernel of a function, with its place on the disk."""

from __future__ import annotations

import contextlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numba
from numba import config

from game.compiler.cache import code_folder
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
    return dispatcher


def _closes_over_integers(function: Callable[..., Any]) -> bool:
    """True if a function's closure, if any, holds plain integers only, whose values have lasting names."""
    try:
        return all(type(cell.cell_contents) in (int, bool) for cell in function.__closure__ or ())
    except ValueError:  # a cell not filled yet: the function refers to itself
        return False
