"""The elementary functions of all that decides a simulated number: the same bits on every machine.

A C library's differ from one platform and version to the next, by an ulp here and there. A chaotic run makes
that a different run. These use, in a fixed order, only what IEEE 754 rounds the same way everywhere: sums,
products, quotients, square roots. So they give the same bits compiled for any processor, and not compiled at
all. Every result is within 1 ulp of the exact value, for every argument; the modules say how near.

Kernels and Python call them as they would call ``math``'s, but none raises: what has no value is nan, what
is too large inf. `game.physics.kernels.elementwise` has them for arrays.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from numba.extending import overload

from game.compiler.decorator import kernel
from game.physics.kernels.elementary import angles, others, powers, turns
from game.physics.kernels.elementary.linking import linked

_sin = linked("sin", 1, turns.sin)
_cos = linked("cos", 1, turns.cos)
_tan = linked("tan", 1, turns.tan)
_atan = linked("atan", 1, angles.atan)
_asin = linked("asin", 1, angles.asin)
_acos = linked("acos", 1, angles.acos)
_exp = linked("exp", 1, powers.exp)
_expm1 = linked("expm1", 1, powers.expm1)
_log = linked("log", 1, powers.log)
_log1p = linked("log1p", 1, powers.log1p)
_log2 = linked("log2", 1, powers.log2)
_log10 = linked("log10", 1, powers.log10)
_cbrt = linked("cbrt", 1, others.cbrt)
_tanh = linked("tanh", 1, others.tanh)
_asinh = linked("asinh", 1, others.asinh)
_erf = linked("erf", 1, others.erf)
_atan2 = linked("atan2", 2, angles.atan2)
_pow = linked("pow", 2, powers.pow)
_hypot = linked("hypot", 2, others.hypot)


@kernel
def sin(x: float) -> float:
    """The sine of an angle in radians; nan of an infinity."""
    return _sin(x)


@kernel
def cos(x: float) -> float:
    """The cosine of an angle in radians; nan of an infinity."""
    return _cos(x)


@kernel
def tan(x: float) -> float:
    """The tangent of an angle in radians; nan of an infinity."""
    return _tan(x)


@kernel
def atan(x: float) -> float:
    """The arc tangent in [-pi/2, pi/2], in radians."""
    return _atan(x)


@kernel
def asin(x: float) -> float:
    """The arc sine in [-pi/2, pi/2], in radians; nan beyond 1."""
    return _asin(x)


@kernel
def acos(x: float) -> float:
    """The arc cosine in [0, pi], in radians; nan beyond 1."""
    return _acos(x)


@kernel
def exp(x: float) -> float:
    """e to the power x; inf where that is too large."""
    return _exp(x)


@kernel
def expm1(x: float) -> float:
    """exp(x) - 1, exact also where x is small."""
    return _expm1(x)


@kernel
def log(x: float) -> float:
    """The natural logarithm; -inf of zero, nan of a negative number."""
    return _log(x)


@kernel
def log1p(x: float) -> float:
    """log(1 + x), exact also where x is small; -inf of -1, nan below."""
    return _log1p(x)


@kernel
def log2(x: float) -> float:
    """The logarithm to the base 2, exact for its powers; else as `log`."""
    return _log2(x)


@kernel
def log10(x: float) -> float:
    """The logarithm to the base 10, exact for its powers; else as `log`."""
    return _log10(x)


@kernel
def cbrt(x: float) -> float:
    """The cube root, with the sign of x."""
    return _cbrt(x)


@kernel
def tanh(x: float) -> float:
    """The hyperbolic tangent."""
    return _tanh(x)


@kernel
def asinh(x: float) -> float:
    """The inverse hyperbolic sine."""
    return _asinh(x)


@kernel
def erf(x: float) -> float:
    """The error function."""
    return _erf(x)


@kernel
def atan2(y: float, x: float) -> float:
    """The angle of the point (x, y) in [-pi, pi], in radians."""
    return _atan2(y, x)


@kernel
def pow(x: float, y: float) -> float:
    """x to the power y; nan for a negative x and a y that is no integer."""
    return _pow(x, y)


@kernel
def hypot(x: float, y: float) -> float:
    """The length of (x, y), without overflow on the way."""
    return _hypot(x, y)


def dist(p: Sequence[float], q: Sequence[float]) -> float:
    """The distance of two points of as many coordinates each."""
    away = [a - b for a, b in zip(p, q, strict=True)]
    if len(away) == 2:
        return hypot(away[0], away[1])
    return math.sqrt(math.fsum(d * d for d in away))


def length(*coordinates: float) -> float:
    """The length of a vector of any number of coordinates."""
    return dist(coordinates, (0.0,) * len(coordinates))


def square(x: Any) -> Any:
    """x times x, of a number or an array."""
    return x * x


def cube(x: Any) -> Any:
    """x times x times x, of a number or an array."""
    return x * x * x


@overload(square)
def _square_in_kernels(x: Any) -> Any:
    return square


@overload(cube)
def _cube_in_kernels(x: Any) -> Any:
    return cube
