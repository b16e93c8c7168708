"""Is an array finite? Asked after every step, so it is asked cheaply: on the bits of the numbers.

A float64 is infinite or NaN exactly if all its exponent bits are set. Testing that on integers lets the
compiler take several numbers at once, which it may not do with a sum of floats.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numba import config

from game.compiler.decorator import kernel

EXPONENT = np.uint64(0x7FF0_0000_0000_0000)
EXPONENT_SINGLE = np.uint32(0x7F80_0000)


@kernel
def finite_doubles(words: np.ndarray) -> bool:
    """True if no word (n,) uint64 has all exponent bits of a float64 set."""
    found = np.uint64(0)
    for i in range(words.size):
        found |= np.uint64((words[i] & EXPONENT) == EXPONENT)
    return found == np.uint64(0)


@kernel
def finite_singles(words: np.ndarray) -> bool:
    """True if no word (n,) uint32 has all exponent bits of a float32 set."""
    found = np.uint32(0)
    for i in range(words.size):
        found |= np.uint32((words[i] & EXPONENT_SINGLE) == EXPONENT_SINGLE)
    return found == np.uint32(0)


@kernel
def finite_together(arrays: tuple[np.ndarray, ...]) -> bool:
    """The same for several arrays of words at once, (n,) uint64 each: one call instead of one for each."""
    for words in arrays:  # noqa: SIM110  a kernel has no generators
        if not finite_doubles(words):
            return False
    return True


def finite_test(array: np.ndarray) -> tuple[Callable[[np.ndarray], bool], np.ndarray] | None:
    """A test for an array and the view of it to call it with; None if the array holds no floats.

    The view shares the array's memory, so it may be kept and asked again.
    """
    if array.dtype.kind not in "fc":
        return None
    plain = array.flags.c_contiguous and array.dtype.isnative and not config.DISABLE_JIT
    if plain and array.dtype == np.float64:
        return finite_doubles, array.reshape(-1).view(np.uint64)
    if plain and array.dtype == np.float32:
        return finite_singles, array.reshape(-1).view(np.uint32)
    return _finite_by_numpy, array


def _finite_by_numpy(array: np.ndarray) -> bool:
    return bool(np.isfinite(array).all())
