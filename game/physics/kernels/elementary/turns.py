"""Sine, cosine and tangent of every float, each within 1 ulp.

An angle is first taken to [-pi/4, pi/4] as high + low: by three parts of pi/2 (W. J. Cody and W. Waite 1980)
up to 2^20 quarter turns, and from there by as many digits of 2/pi as the angle needs (M. H. Payne and
R. N. Hanek 1983). The polynomials there are those of fdlibm (Sun Microsystems 1993).
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, linked_kernel
from game.physics.kernels.elementary.constants import pair, parts, pi, two_over_pi
from game.physics.kernels.elementary.extended import quick_two_sum, two_product, two_sum
from game.physics.kernels.elementary.words import bits_of

QUARTER = float(pi()) / 4.0
HALF_HIGH, HALF_LOW = pair(pi() / 2)
INVERSE = float(2 / pi())
# pi/2 in parts of 33 bits, whose products with a count below 2^20 are exact, and what follows each part
(FIRST, AFTER_FIRST), (SECOND, AFTER_SECOND), (THIRD, AFTER_THIRD) = parts(pi() / 2, (-32, -65, -98))
ROUNDER = 1.5 * 2.0**52  # added and taken away again, it rounds to the nearest integer
MEDIUM = 1_647_099.0  # rad, 2^20 quarter turns
TWO_OVER_PI = two_over_pi(52)
DIGIT = 0xFFFFFF

SIN_3, SIN_5, SIN_7 = -1.66666666666666324348e-01, 8.33333333332248946124e-03, -1.98412698298579493134e-04
SIN_9, SIN_11, SIN_13 = 2.75573137070700676789e-06, -2.50507602534068634195e-08, 1.58969099521155010221e-10
COS_4, COS_6, COS_8 = 4.16666666666666019037e-02, -1.38888888888741095749e-03, 2.48015872894767294178e-05
COS_10, COS_12, COS_14 = -2.75573143513906633035e-07, 2.08757232129817482790e-09, -1.13596475577881948265e-11
TAN_3, TAN_5, TAN_7 = 3.33333333333334091986e-01, 1.33333333333201242699e-01, 5.39682539762260521377e-02
TAN_9, TAN_11, TAN_13 = 2.18694882948595424599e-02, 8.86323982359930005737e-03, 3.59207910759131235356e-03
TAN_15, TAN_17, TAN_19 = 1.45620945432529025516e-03, 5.88041240820264096874e-04, 2.46463134818469906812e-04
TAN_21, TAN_23, TAN_25 = 7.81794442939557092300e-05, 7.14072491382608190305e-05, -1.85586374855275456654e-05
TAN_27 = 2.59073051863633712884e-05
NEAR_QUARTER = 0.67434


@inner_kernel
def sine_near(x: float, low: float) -> float:
    """The sine of x + low, |x| <= pi/4."""
    z = x * x
    cube = z * x
    tail = SIN_5 + z * (SIN_7 + z * SIN_9) + z * (z * z) * (SIN_11 + z * SIN_13)
    return x - ((z * (0.5 * low - cube * tail) - low) - cube * SIN_3)


@inner_kernel
def cosine_near(x: float, low: float) -> float:
    """The cosine of x + low, |x| <= pi/4."""
    z = x * x
    square = z * z
    tail = z * (COS_4 + z * (COS_6 + z * COS_8)) + square * square * (COS_10 + z * (COS_12 + z * COS_14))
    half = 0.5 * z
    high = 1.0 - half
    return high + (((1.0 - high) - half) + (z * tail - x * low))


@inner_kernel
def tangent_near(x: float, low: float) -> tuple[float, float]:
    """The tangent of x + low, |x| <= `NEAR_QUARTER`, as high + low."""
    z = x * x
    w = z * z
    odd = TAN_5 + w * (TAN_9 + w * (TAN_13 + w * (TAN_17 + w * (TAN_21 + w * TAN_25))))
    even = z * (TAN_7 + w * (TAN_11 + w * (TAN_15 + w * (TAN_19 + w * (TAN_23 + w * TAN_27)))))
    cube = z * x
    return quick_two_sum(x, (low + z * (cube * (odd + even) + low)) + TAN_3 * cube)


@inner_kernel
def reduced(x: float) -> tuple[int, float, float]:
    """Quarter turns n (its last two bits count) and high + low in [-pi/4, pi/4]: x = n pi/2 + high + low."""
    size = math.fabs(x)
    if size >= MEDIUM:
        return reduced_far(x)
    turns = (x * INVERSE + ROUNDER) - ROUNDER
    rest = x - turns * FIRST
    after = turns * AFTER_FIRST
    high = rest - after
    if math.fabs(high) < size * 2.0**-15:  # so much is gone that the parts after the first count
        whole = rest
        after = turns * SECOND
        rest = whole - after
        after = turns * AFTER_SECOND - ((whole - rest) - after)
        high = rest - after
        if math.fabs(high) < size * 2.0**-47:
            whole = rest
            after = turns * THIRD
            rest = whole - after
            after = turns * AFTER_THIRD - ((whole - rest) - after)
            high = rest - after
    return int(turns), high, (rest - high) - after


@inner_kernel
def digit_sum(low: int, middle: int, top: int, first: int) -> int:
    """One digit of the product of a number of three digits with 2/pi, nothing carried (all base 2^24)."""
    total = 0
    if first >= 0:
        total += low * int(TWO_OVER_PI[first])
    if first >= -1:
        total += middle * int(TWO_OVER_PI[first + 1])
    if first >= -2:
        total += top * int(TWO_OVER_PI[first + 2])
    return total


@inner_kernel
def reduced_far(x: float) -> tuple[int, float, float]:
    """`reduced` for 2^20 quarter turns and more, finite: only the digits of x 2/pi that matter are made."""
    word = bits_of(math.fabs(x))
    exponent = (word >> 52) - 1075
    mantissa = (word & ((1 << 52) - 1)) | (1 << 52)
    by = exponent // 24
    shift = exponent - 24 * by
    low, middle, top = mantissa & DIGIT, (mantissa >> 24) & DIGIT, mantissa >> 48
    by -= 1
    d8 = digit_sum(low, middle, top, by + 8)
    d7 = digit_sum(low, middle, top, by + 7) + (d8 >> 24)
    d6 = digit_sum(low, middle, top, by + 6) + (d7 >> 24)
    d5 = digit_sum(low, middle, top, by + 5) + (d6 >> 24)
    d4 = digit_sum(low, middle, top, by + 4) + (d5 >> 24)
    d3 = digit_sum(low, middle, top, by + 3) + (d4 >> 24)
    d2 = digit_sum(low, middle, top, by + 2) + (d3 >> 24)
    d1 = digit_sum(low, middle, top, by + 1) + (d2 >> 24)
    d0 = digit_sum(low, middle, top, by) + (d1 >> 24)
    turns = shifted(d0, d1, shift)
    first = (shifted(d1, d2, shift) << 24) | shifted(d2, d3, shift)
    second = (shifted(d3, d4, shift) << 24) | shifted(d4, d5, shift)
    third = (shifted(d5, d6, shift) << 24) | shifted(d6, d7, shift)
    sign = 1.0
    if first >= 1 << 47:  # the nearest quarter turn is the next one
        turns += 1
        sign = -1.0
        first, second, third = (1 << 48) - 1 - first, (1 << 48) - 1 - second, (1 << 48) - 1 - third
    if x < 0.0:
        turns, sign = -turns, -sign
    high, rest = two_sum(first * 2.0**-48, second * 2.0**-96)
    high, rest = quick_two_sum(high, rest + third * 2.0**-144)
    angle, left = two_product(high, HALF_HIGH)
    angle, left = quick_two_sum(angle, left + (high * HALF_LOW + rest * HALF_HIGH))
    return turns, sign * angle, sign * left


@inner_kernel
def shifted(digit: int, after: int, shift: int) -> int:
    """A digit base 2^24 of a number shifted left by so many bits, fewer than 24."""
    return ((digit << shift) & DIGIT) | ((after & DIGIT) >> (24 - shift))


@linked_kernel
def sin(x: float) -> float:
    """The sine; nan of an infinity."""
    if math.fabs(x) <= QUARTER:
        return sine_near(x, 0.0)
    if not math.fabs(x) < math.inf:
        return math.nan
    turns, high, low = reduced(x)
    size = cosine_near(high, low) if turns & 1 else sine_near(high, low)
    return -size if turns & 2 else size


@linked_kernel
def cos(x: float) -> float:
    """The cosine; nan of an infinity."""
    if math.fabs(x) <= QUARTER:
        return cosine_near(x, 0.0)
    if not math.fabs(x) < math.inf:
        return math.nan
    turns, high, low = reduced(x)
    size = sine_near(high, low) if turns & 1 else cosine_near(high, low)
    return -size if (turns + 1) & 2 else size


@linked_kernel
def tan(x: float) -> float:
    """The tangent; nan of an infinity."""
    turns, high, low = 0, x, 0.0
    if math.fabs(x) > QUARTER:
        if not math.fabs(x) < math.inf:
            return math.nan
        turns, high, low = reduced(x)
    elif math.fabs(x) < 2.0**-28:
        return x
    elif x != x:
        return math.nan
    sign = 1.0
    if high < 0.0:
        high, low, sign = -high, -low, -1.0
    over = turns & 1 == 1
    if (
        high >= NEAR_QUARTER
    ):  # tan(pi/4 - y) = (1 - t) / (1 + t), and its inverse for the quarter turns between
        y, rest = two_sum(QUARTER, -high)
        t, left = tangent_near(y, rest + (0.5 * HALF_LOW - low))
        above, above_rest = two_sum(1.0, -t)
        below, below_rest = two_sum(1.0, t)
        above_rest, below_rest = above_rest - left, below_rest + left
    else:
        above, above_rest = tangent_near(high, low)
        if not over:
            return sign * (above + above_rest)
        below, below_rest = 1.0, 0.0
    if over:
        above, above_rest, below, below_rest = below, below_rest, above, above_rest
        sign = -sign
    return sign * quotient(above, above_rest, below, below_rest)


@inner_kernel
def quotient(above: float, above_rest: float, below: float, below_rest: float) -> float:
    """(above + above_rest) / (below + below_rest), rounded once and a little."""
    q = above / below
    back, rest = two_product(q, below)
    return q + (((above - back) - rest) + above_rest - q * below_rest) / below
