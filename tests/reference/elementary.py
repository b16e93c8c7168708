"""The elementary functions by decimal arithmetic, to some 60 digits: what floats are measured against."""

from __future__ import annotations

import decimal
import math
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from functools import cache

DIGITS = 60
CONTEXT = decimal.Context(prec=DIGITS + 20, Emin=-999_999, Emax=999_999)


def in_context(function: Callable[..., Decimal]) -> Callable[..., Decimal]:
    def with_context(*arguments: float) -> Decimal:
        with decimal.localcontext(CONTEXT):
            return function(*(Decimal(value) for value in arguments))

    return with_context


@cache
def pi(digits: int = DIGITS + 20) -> Decimal:
    """Pi by the recipe of the decimal module's documentation."""
    with decimal.localcontext(decimal.Context(prec=digits + 5, Emin=-999_999, Emax=999_999)):
        three = Decimal(3)
        lasts, t, s, n, na, d, da = Decimal(0), three, three, 1, 0, 0, 24
        while s != lasts:
            lasts = s
            n, na = n + na, na + 8
            d, da = d + da, da + 32
            t = (t * n) / d
            s += t
        return s


def _series(first: Decimal, ratio: Callable[[int], Decimal]) -> Decimal:
    total, term, k = first, first, 1
    while term and abs(term) > abs(total) * Decimal(10) ** -(DIGITS + 10):
        term *= ratio(k)
        total += term
        k += 1
    return total


def _reduced(x: Decimal) -> tuple[int, Decimal]:
    """Quarter turns and what is left in [-pi/4, pi/4], with as many digits of pi as that takes."""
    digits = max(x.adjusted(), 0) + DIGITS + 40
    with decimal.localcontext(decimal.Context(prec=2 * digits, Emin=-999_999, Emax=999_999)):
        half = pi(2 * digits) / 2
        turns = (x / half).to_integral_value()
        return int(turns) % 4, x - turns * half


@in_context
def sin(x: Decimal) -> Decimal:
    turns, rest = _reduced(x)
    return (_sine(rest), _cosine(rest), -_sine(rest), -_cosine(rest))[turns]


@in_context
def cos(x: Decimal) -> Decimal:
    turns, rest = _reduced(x)
    return (_cosine(rest), -_sine(rest), -_cosine(rest), _sine(rest))[turns]


@in_context
def tan(x: Decimal) -> Decimal:
    turns, rest = _reduced(x)
    return -_cosine(rest) / _sine(rest) if turns % 2 else _sine(rest) / _cosine(rest)


def _sine(x: Decimal) -> Decimal:
    return _series(x, lambda k: -x * x / ((2 * k) * (2 * k + 1)))


def _cosine(x: Decimal) -> Decimal:
    return _series(Decimal(1), lambda k: -x * x / ((2 * k - 1) * (2 * k)))


@in_context
def exp(x: Decimal) -> Decimal:
    return x.exp()


@in_context
def expm1(x: Decimal) -> Decimal:
    return x.exp() - 1 if abs(x) > 1 else _series(x, lambda k: x / (k + 1))


@in_context
def log(x: Decimal) -> Decimal:
    return x.ln()


@in_context
def log2(x: Decimal) -> Decimal:
    return x.ln() / Decimal(2).ln()


@in_context
def log10(x: Decimal) -> Decimal:
    return x.log10()


@in_context
def log1p(x: Decimal) -> Decimal:
    return (1 + x).ln() if abs(x) > Decimal("1e-12") else x * (1 - x / 2 + x * x / 3 - x**3 / 4 + x**4 / 5)


@in_context
def pow(x: Decimal, y: Decimal) -> Decimal:
    if x < 0:
        return (abs(x).ln() * y).exp() * (-1 if int(y) % 2 else 1)
    return (x.ln() * y).exp()


@in_context
def hypot(x: Decimal, y: Decimal) -> Decimal:
    return (x * x + y * y).sqrt()


@in_context
def cbrt(x: Decimal) -> Decimal:
    return (abs(x).ln() / 3).exp().copy_sign(x) if x else x


@in_context
def tanh(x: Decimal) -> Decimal:
    if abs(x) < Decimal("1e-12"):
        return x - x**3 / 3
    double = (2 * x).exp()
    return (double - 1) / (double + 1)


@in_context
def asinh(x: Decimal) -> Decimal:
    if abs(x) < Decimal("1e-12"):
        return x - x**3 / 6
    return (abs(x) + (x * x + 1).sqrt()).ln().copy_sign(x)


@in_context
def erf(x: Decimal) -> Decimal:
    return 2 / pi().sqrt() * (-x * x).exp() * _series(x, lambda k: 2 * x * x / (2 * k + 1))


def _arc_tangent(x: Decimal) -> Decimal:
    for _ in range(5):
        x = x / (1 + (1 + x * x).sqrt())
    total, power, k = x, x, 1
    while power and abs(power) > abs(total) * Decimal(10) ** -(DIGITS + 10):
        power *= -x * x
        k += 2
        total += power / k
    return 32 * total


@in_context
def atan(x: Decimal) -> Decimal:
    return _arc_tangent(x)


@in_context
def atan2(y: Decimal, x: Decimal) -> Decimal:
    if x > abs(y):
        return _arc_tangent(y / x)
    if abs(y) >= abs(x):
        return (pi() / 2).copy_sign(y) - _arc_tangent(x / y)
    return pi().copy_sign(y) + _arc_tangent(y / x)


@in_context
def asin(x: Decimal) -> Decimal:
    return _arc_tangent(x / (1 - x * x).sqrt()) if abs(x) < 1 else pi() / 2 * x


@in_context
def acos(x: Decimal) -> Decimal:
    return 2 * _arc_tangent((1 - x).sqrt() / (1 + x).sqrt()) if x > -1 else pi()


def ulps(value: float, exact: Decimal) -> float:
    """How far a float is from an exact value, in units of the last place of the float nearest to that."""
    nearest = float(exact)
    unit = math.ulp(nearest) if math.isfinite(nearest) else math.ulp(1.7e308)
    return float(abs(Fraction(value) - Fraction(exact)) / Fraction(unit))
