"""The elementary functions of whole arrays, under numpy's names: the same bits as one number at a time.

They take what numpy's take, a number too, and return float64: an array of the arguments' (broadcast) shape,
or a numpy float for plain numbers. There is no ``out``, ``where`` or ``dtype``.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.compiler.decorator import kernel
from game.physics.kernels import elementary

SIN, COS, TAN, ARCSIN, ARCCOS, ARCTAN, EXP, EXPM1, LOG, LOG1P, LOG2, LOG10, CBRT, TANH, ARCSINH = range(15)
ARCTAN2, HYPOT, POWER = range(3)


@kernel
def fill_one(which: int, x: np.ndarray, values: np.ndarray) -> None:
    """values (n,) = a function of x (n,)."""
    if which == SIN:
        for i in range(x.size):
            values[i] = elementary.sin(x[i])
    elif which == COS:
        for i in range(x.size):
            values[i] = elementary.cos(x[i])
    elif which == TAN:
        for i in range(x.size):
            values[i] = elementary.tan(x[i])
    elif which == ARCSIN:
        for i in range(x.size):
            values[i] = elementary.asin(x[i])
    elif which == ARCCOS:
        for i in range(x.size):
            values[i] = elementary.acos(x[i])
    elif which == ARCTAN:
        for i in range(x.size):
            values[i] = elementary.atan(x[i])
    elif which == EXP:
        for i in range(x.size):
            values[i] = elementary.exp(x[i])
    elif which == EXPM1:
        for i in range(x.size):
            values[i] = elementary.expm1(x[i])
    elif which == LOG:
        for i in range(x.size):
            values[i] = elementary.log(x[i])
    elif which == LOG1P:
        for i in range(x.size):
            values[i] = elementary.log1p(x[i])
    elif which == LOG2:
        for i in range(x.size):
            values[i] = elementary.log2(x[i])
    elif which == LOG10:
        for i in range(x.size):
            values[i] = elementary.log10(x[i])
    elif which == CBRT:
        for i in range(x.size):
            values[i] = elementary.cbrt(x[i])
    elif which == TANH:
        for i in range(x.size):
            values[i] = elementary.tanh(x[i])
    elif which == ARCSINH:
        for i in range(x.size):
            values[i] = elementary.asinh(x[i])


@kernel
def fill_two(which: int, a: np.ndarray, b: np.ndarray, values: np.ndarray) -> None:
    """values (n,) = a function of a and b, (n,) each."""
    if which == ARCTAN2:
        for i in range(a.size):
            values[i] = elementary.atan2(a[i], b[i])
    elif which == HYPOT:
        for i in range(a.size):
            values[i] = elementary.hypot(a[i], b[i])
    elif which == POWER:
        for i in range(a.size):
            values[i] = elementary.pow(a[i], b[i])


def _of_one(which: int, x: ArrayLike) -> Any:
    given = np.asarray(x, dtype=np.float64)
    values = np.empty(given.size)
    fill_one(which, np.ascontiguousarray(given).reshape(-1), values)
    return values.reshape(given.shape)[()]


def _of_two(which: int, a: ArrayLike, b: ArrayLike) -> Any:
    one, other = np.broadcast_arrays(np.asarray(a, dtype=np.float64), np.asarray(b, dtype=np.float64))
    values = np.empty(one.size)
    flat = [np.array(given, order="C").reshape(-1) for given in (one, other)]
    fill_two(which, flat[0], flat[1], values)
    return values.reshape(one.shape)[()]


def turned(angle: ArrayLike) -> NDArray[np.complex128]:
    """exp(i angle), the point of the unit circle at an angle."""
    return np.asarray(cos(angle) + 1j * sin(angle))


def sin(x: ArrayLike) -> Any:
    """`elementary.sin` of each number."""
    return _of_one(SIN, x)


def cos(x: ArrayLike) -> Any:
    """`elementary.cos` of each number."""
    return _of_one(COS, x)


def tan(x: ArrayLike) -> Any:
    """`elementary.tan` of each number."""
    return _of_one(TAN, x)


def arcsin(x: ArrayLike) -> Any:
    """`elementary.asin` of each number."""
    return _of_one(ARCSIN, x)


def arccos(x: ArrayLike) -> Any:
    """`elementary.acos` of each number."""
    return _of_one(ARCCOS, x)


def arctan(x: ArrayLike) -> Any:
    """`elementary.atan` of each number."""
    return _of_one(ARCTAN, x)


def exp(x: ArrayLike) -> Any:
    """`elementary.exp` of each number."""
    return _of_one(EXP, x)


def expm1(x: ArrayLike) -> Any:
    """`elementary.expm1` of each number."""
    return _of_one(EXPM1, x)


def log(x: ArrayLike) -> Any:
    """`elementary.log` of each number."""
    return _of_one(LOG, x)


def log1p(x: ArrayLike) -> Any:
    """`elementary.log1p` of each number."""
    return _of_one(LOG1P, x)


def log2(x: ArrayLike) -> Any:
    """`elementary.log2` of each number."""
    return _of_one(LOG2, x)


def log10(x: ArrayLike) -> Any:
    """`elementary.log10` of each number."""
    return _of_one(LOG10, x)


def cbrt(x: ArrayLike) -> Any:
    """`elementary.cbrt` of each number."""
    return _of_one(CBRT, x)


def tanh(x: ArrayLike) -> Any:
    """`elementary.tanh` of each number."""
    return _of_one(TANH, x)


def arcsinh(x: ArrayLike) -> Any:
    """`elementary.asinh` of each number."""
    return _of_one(ARCSINH, x)


def arctan2(y: ArrayLike, x: ArrayLike) -> Any:
    """`elementary.atan2` of each pair of numbers."""
    return _of_two(ARCTAN2, y, x)


def hypot(x: ArrayLike, y: ArrayLike) -> Any:
    """`elementary.hypot` of each pair of numbers."""
    return _of_two(HYPOT, x, y)


def power(x: ArrayLike, y: ArrayLike) -> Any:
    """`elementary.pow` of each pair of numbers."""
    return _of_two(POWER, x, y)
