"""Constants of the elementary functions, worked out in decimal arithmetic and rounded to pairs of floats."""

from __future__ import annotations

import decimal
from decimal import Decimal
from fractions import Fraction
from functools import cache

import numpy as np
from numpy.typing import NDArray

DIGITS = 45


def exact_context() -> decimal.Context:
    """Decimal arithmetic of enough digits, whatever the process has set for its own."""
    return decimal.Context(prec=DIGITS, Emin=-999_999, Emax=999_999, rounding=decimal.ROUND_HALF_EVEN)


def pair(value: Fraction, grid: int | None = None) -> tuple[float, float]:
    """A number as high + low; high a multiple of 2^grid if that is given, else the nearest float."""
    unit = Fraction(2) ** grid if grid is not None else None
    high = float(value) if unit is None else float(round(value / unit) * unit)
    return high, float(value - Fraction(high))


def pi_word(bits: int) -> int:
    """Pi times 2^bits, rounded down: J. Machin's formula (1706) in integers."""
    guard = 32
    one = 1 << (bits + guard)

    def arccot(n: int) -> int:
        power, total, k, sign = one // n, 0, 1, 1
        while power:
            total += sign * (power // k)
            power, k, sign = power // (n * n), k + 2, -sign
        return total

    return (4 * (4 * arccot(5) - arccot(239))) >> guard


@cache
def pi() -> Fraction:
    """Pi, to 220 bits after the point."""
    return Fraction(pi_word(220), 1 << 220)


def two_over_pi(count: int) -> NDArray[np.int64]:
    """The first digits of 2 / pi after the point, base 2^24 (count,)."""
    bits = 24 * count
    word = (1 << (2 * bits + 65)) // pi_word(bits + 64)
    return np.array([(word >> (bits - 24 * (i + 1))) & 0xFFFFFF for i in range(count)], dtype=np.int64)


@cache
def ln(n: int) -> Fraction:
    """The natural logarithm of a number, to `DIGITS` digits."""
    return Fraction(exact_context().ln(Decimal(n)))


def square_root(value: Fraction) -> Fraction:
    """A square root, to `DIGITS` digits."""
    context = exact_context()
    return Fraction(context.sqrt(context.divide(Decimal(value.numerator), Decimal(value.denominator))))


def exp_table(count: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """2^(i / count), and the relative rest of each after rounding (count,) each."""
    context = exact_context()
    ratio = context.power(Decimal(2), context.divide(Decimal(1), Decimal(count)))
    whole = [Decimal(1)]
    for _ in range(count - 1):
        whole.append(context.multiply(whole[-1], ratio))
    rounded = [float(value) for value in whole]
    rests = [
        float(context.divide(context.subtract(a, Decimal(b)), Decimal(b)))
        for a, b in zip(whole, rounded, strict=True)
    ]
    return np.array(rounded), np.array(rests)


def log_table(middles: list[float], grid: int) -> tuple[NDArray[np.float64], ...]:
    """1 / c to nine bits after the point, and -ln of that as high + low; high a multiple of 2^grid."""
    context = exact_context()
    inverses = [round(512.0 / c) / 512.0 for c in middles]
    pairs = [pair(-Fraction(context.ln(Decimal(inverse))), grid) for inverse in inverses]
    return np.array(inverses), np.array([a for a, _ in pairs]), np.array([b for _, b in pairs])


def arc_tangent(x: Decimal) -> Decimal:
    """The arc tangent of 0 <= x <= 1, by halving the angle and Gregory's series."""
    context = exact_context()
    for _ in range(6):
        x = context.divide(x, context.add(1, context.sqrt(context.add(1, context.multiply(x, x)))))
    square, power, total, k = context.multiply(x, x), x, x, 1
    while abs(power) > Decimal(10) ** -DIGITS:
        power, k = context.minus(context.multiply(power, square)), k + 2
        total = context.add(total, context.divide(power, Decimal(k)))
    return context.multiply(total, 64)


def arc_tangents(count: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """The arc tangents of i / count for i = 0 ... count, as high + low (count + 1,) each."""
    pairs = [pair(Fraction(arc_tangent(Decimal(i) / Decimal(count)))) for i in range(count + 1)]
    return np.array([a for a, _ in pairs]), np.array([b for _, b in pairs])


def parts(value: Fraction, grids: tuple[int, ...]) -> list[tuple[float, float]]:
    """A number cut at each grid 2^g in turn: (part, nearest float to all that follows it) for each."""
    left, found = value, []
    for grid in grids:
        unit = Fraction(2) ** grid
        part = (left // unit) * unit
        left -= part
        found.append((float(part), float(left)))
    return found
