"""Exponentials, logarithms and powers: each within 0.6 ulp but expm1, which is within 0.8.

Both are read from tables and led on by short series (P. T. P. Tang 1989 and 1990), with a low part kept. So
powers, logarithms to other bases and the like are rounded once and a little.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, linked_kernel
from game.physics.kernels.elementary.constants import exp_table, ln, log_table, pair
from game.physics.kernels.elementary.extended import quick_two_sum, two_product, two_sum
from game.physics.kernels.elementary.words import bits_of, from_bits

TABLE = 128  # entries of each table, a power of two
PLACES = 7  # its logarithm
EXP_TABLE, EXP_RESTS = exp_table(TABLE)
STEPS_OF_ONE = float(TABLE / ln(2))
STEP_HIGH, STEP_LOW = pair(ln(2) / TABLE, -41)  # 34 bits: exact times a count below 2^18
ROUNDER = 1.5 * 2.0**52
LARGEST_EXP = float.fromhex("0x1.62e42fefa39efp+9")  # of greater numbers it is infinite
LEAST_EXP = -745.2  # of smaller ones it is zero

# Sections of the mantissa, 2^-7 wide above one and half as wide below; one is the middle of a section, so
# that near it the logarithm is the short series alone.
SECTION = 1 << (52 - PLACES)
LEAST_WORD = bits_of(1.0) - TABLE // 2 * SECTION - SECTION // 2
MIDDLES = [from_bits(LEAST_WORD + i * SECTION + SECTION // 2) for i in range(TABLE)]
INVERSES, LOG_HIGH, LOG_LOW = log_table(MIDDLES, -42)
LN2_HIGH, LN2_LOW = pair(ln(2), -42)
LN2_FULL_HIGH, LN2_FULL_LOW = pair(ln(2))
BITS_HIGH, BITS_LOW = pair(1 / ln(2))
TENS_HIGH, TENS_LOW = pair(1 / ln(10))


@inner_kernel
def exp_parts(x: float, low: float) -> tuple[float, float, int]:
    """exp(x + low) = (high + rest) 2^n for -746 < x < 711 and low below an ulp or so of x."""
    steps = (x * STEPS_OF_ONE + ROUNDER) - ROUNDER
    r = (x - steps * STEP_HIGH) - steps * STEP_LOW + low
    count = int(steps)
    i = count & (TABLE - 1)
    square = r * r
    series = square * (0.5 + r * (1.0 / 6.0)) + square * square * (1.0 / 24.0 + r * (1.0 / 120.0))
    high = float(EXP_TABLE[i])
    return high, high * (float(EXP_RESTS[i]) + series + r), count >> PLACES


@inner_kernel
def scaled(x: float, n: int) -> float:
    """x 2^n for 0.5 < x < 4 and -1100 < n <= 1024; rounded once."""
    if -1021 < n < 1023:
        return x * from_bits((n + 1023) << 52)
    part = n >> 1
    return (x * from_bits((part + 1023) << 52)) * from_bits((n - part + 1023) << 52)


@linked_kernel
def exp(x: float) -> float:
    """The exponential."""
    if not x <= LARGEST_EXP:
        return math.nan if x != x else math.inf
    if x < LEAST_EXP:
        return 0.0
    high, rest, n = exp_parts(x, 0.0)
    return scaled(high + rest, n)


@linked_kernel
def expm1(x: float) -> float:
    """exp(x) - 1, exact also where x is small."""
    if math.fabs(x) < 0.25:
        if math.fabs(x) < 2.0**-54:
            return x
        tail = 1.0 / 5040.0 + x * (1.0 / 40320.0 + x * (1.0 / 362880.0 + x * (1.0 / 3628800.0)))
        rest = x * x * x * x * (1.0 / 39916800.0 + x * (1.0 / 479001600.0 + x * (1.0 / 6227020800.0)))
        tail = 1.0 / 6.0 + x * (1.0 / 24.0 + x * (1.0 / 120.0 + x * (1.0 / 720.0 + x * (tail + rest))))
        return x + (0.5 * (x * x) + (x * x * x) * tail)
    if not x <= 60.0:
        return exp(x)
    if x < -60.0:
        return -1.0
    high, rest, n = exp_parts(x, 0.0)
    scale = from_bits((n + 1023) << 52)
    whole, left = two_sum(high * scale, -1.0)
    return whole + (left + rest * scale)


@inner_kernel
def log_parts(x: float, low: float) -> tuple[float, float]:
    """The natural logarithm of x + low as high + rest, for a finite x > 0 and low below an ulp of x."""
    word, n = bits_of(x), 0
    if x < 2.0**-1022:
        word, n = bits_of(x * 2.0**54), -54
    offset = word - LEAST_WORD
    section = (offset >> (52 - PLACES)) & (TABLE - 1)
    power = offset >> 52
    z = from_bits(word - (power << 52))
    inverse = float(INVERSES[section])
    top = from_bits(bits_of(z) & ~0xFFFFFFFF)
    r, rest = two_sum(top * inverse - 1.0, (z - top) * inverse)
    if low != 0.0:
        rest += low * inverse * from_bits((1023 - power) << 52)
    square, square_rest = two_product(r, r)
    high, left = quick_two_sum(r, -0.5 * square)
    tail = 1.0 / 3.0 + r * (
        -0.25 + r * (0.2 + r * (-1.0 / 6.0 + r * (1.0 / 7.0 + r * (-0.125 + r * (1.0 / 9.0)))))
    )
    left += (rest - r * rest) - 0.5 * square_rest + (r * square) * tail
    count = float(power + n)
    high, added = two_sum(count * LN2_HIGH + float(LOG_HIGH[section]), high)
    return quick_two_sum(high, added + (left + (count * LN2_LOW + float(LOG_LOW[section]))))


@linked_kernel
def log(x: float) -> float:
    """The natural logarithm; -inf of zero, nan of a negative number."""
    if not 0.0 < x < math.inf:
        return log_edge(x)
    return log_parts(x, 0.0)[0]


@inner_kernel
def log_edge(x: float) -> float:
    """The logarithm of what is no positive finite number, to any base."""
    if x == 0.0:
        return -math.inf
    return math.inf if x > 0.0 else math.nan


@linked_kernel
def log2(x: float) -> float:
    """The logarithm to the base 2, exact for its powers."""
    if not 0.0 < x < math.inf:
        return log_edge(x)
    high, rest = log_parts(x, 0.0)
    whole, left = two_product(high, BITS_HIGH)
    return whole + (left + (high * BITS_LOW + rest * BITS_HIGH))


@linked_kernel
def log10(x: float) -> float:
    """The logarithm to the base 10, exact for its powers."""
    if not 0.0 < x < math.inf:
        return log_edge(x)
    high, rest = log_parts(x, 0.0)
    whole, left = two_product(high, TENS_HIGH)
    return whole + (left + (high * TENS_LOW + rest * TENS_HIGH))


@linked_kernel
def log1p(x: float) -> float:
    """log(1 + x), exact also where x is small."""
    if not -1.0 < x < math.inf:
        return -math.inf if x == -1.0 else log_edge(x)
    if math.fabs(x) < 2.0**-54:
        return x
    whole, rest = two_sum(1.0, x)
    return log_parts(whole, rest)[0]


@linked_kernel
def pow(x: float, y: float) -> float:
    """x to the power y, as C has it (ISO C, F.10.4.4), but nan where that raises an error."""
    if y == 0.0 or x == 1.0:
        return 1.0
    if x != x or y != y:
        return math.nan
    size, sign = math.fabs(x), 1.0
    if x < 0.0 or (x == 0.0 and math.copysign(1.0, x) < 0.0):
        if (
            math.fabs(y) >= 2.0**53
        ):  # even; a kernel's floor is an integer, which has no space for all of these
            sign = 1.0
        elif math.floor(y) == y:
            sign = 1.0 if math.floor(0.5 * y) == 0.5 * y else -1.0
        elif 0.0 < size < math.inf:
            return math.nan
    if size == 1.0:
        return sign
    if size == 0.0 or size == math.inf or math.fabs(y) >= 2.0**65:
        return sign * (math.inf if (size > 1.0) == (y > 0.0) else 0.0)
    if math.fabs(y) < 2.0**-70:
        return sign
    high, rest = log_parts(size, 0.0)
    high_y, left = two_product(high, y)
    high_y, left = quick_two_sum(high_y, left + rest * y)
    if high_y > 711.0:
        return sign * math.inf
    if high_y < -746.0:
        return sign * 0.0
    high, rest, n = exp_parts(high_y, left)
    return sign * scaled(high + rest, n)
