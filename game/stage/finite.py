"""Is a state finite? Asked after every step, so it is asked cheaply: on the bits of the numbers.

A float64 is infinite or NaN exactly if all its exponent bits are set. Testing that on integers lets the
compiler take several numbers at once, which it may not do with a sum of floats.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numba import config

from game.physics.jit import kernel

EXPONENT = np.uint64(0x7FF0_0000_0000_0000)
EXPONENT_SINGLE = np.uint32(0x7F80_0000)


@kernel
def _finite_doubles(words: np.ndarray) -> bool:
    """True if no word (n,) uint64 has all exponent bits of a float64 set."""
    found = np.uint64(0)
    for i in range(words.size):
        found |= np.uint64((words[i] & EXPONENT) == EXPONENT)
    return found == np.uint64(0)


@kernel
def _finite_singles(words: np.ndarray) -> bool:
    """True if no word (n,) uint32 has all exponent bits of a float32 set."""
    found = np.uint32(0)
    for i in range(words.size):
        found |= np.uint32((words[i] & EXPONENT_SINGLE) == EXPONENT_SINGLE)
    return found == np.uint32(0)


def _by_numpy(array: np.ndarray) -> bool:
    return bool(np.isfinite(array).all())


def _test_for(array: np.ndarray) -> tuple[Callable[[np.ndarray], bool], np.ndarray] | None:
    """How to test an array, and the view of it to test; None if it holds no floats."""
    if array.dtype.kind not in "fc":
        return None
    plain = array.flags.c_contiguous and array.dtype.isnative and not config.DISABLE_JIT
    if plain and array.dtype == np.float64:
        return _finite_doubles, array.reshape(-1).view(np.uint64)
    if plain and array.dtype == np.float32:
        return _finite_singles, array.reshape(-1).view(np.uint32)
    return _by_numpy, array


def leaves(state: Any, prefix: str = "") -> Iterator[tuple[str, Any]]:
    """Every array and number of a (nested) NamedTuple, with its dotted name."""
    names = getattr(state, "_fields", None) or [str(index) for index in range(len(state))]
    for name, value in zip(names, state, strict=True):
        if isinstance(value, tuple):
            yield from leaves(value, f"{prefix}{name}.")
        else:
            yield prefix + name, value


class FiniteWatch:
    """Names the first quantity of a state that is not finite; keeps views of arrays it has seen before."""

    def __init__(self, exempt: frozenset[str] = frozenset()) -> None:
        self._exempt = exempt
        self._seen: dict[str, tuple[np.ndarray, Any]] = {}

    def first_bad(self, state: Any) -> str | None:
        """Dotted name of the first field of the state that holds inf or NaN, or None."""
        seen = self._seen
        for name, value in zip(state._fields, state, strict=True):
            entry = seen.get(name)
            if entry is not None and entry[0] is value:
                test = entry[1]
                if test is None or test[0](test[1]):
                    continue
                return name
            bad = self._look(name, value)
            if bad is not None:
                return bad
        return None

    def _look(self, name: str, value: Any) -> str | None:
        """The slow way, for what is not an array already known."""
        if name in self._exempt:
            return None
        if isinstance(value, np.ndarray):
            test = _test_for(value)
            self._seen[name] = (value, test)
            return name if test is not None and not test[0](test[1]) else None
        if isinstance(value, (float, np.floating)):
            return None if math.isfinite(value) else name
        if isinstance(value, tuple):
            inner = (self._look(f"{name}.{key}", item) for key, item in _named(value))
            return next((found for found in inner if found is not None), None)
        return None


def _named(value: tuple[Any, ...]) -> Iterator[tuple[str, Any]]:
    return zip(getattr(value, "_fields", None) or map(str, range(len(value))), value, strict=True)
