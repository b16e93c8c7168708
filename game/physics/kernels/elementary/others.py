"""Lengths, the cube root, hyperbolic functions and the error function, each within 0.9 ulp."""

from __future__ import annotations

import math

from game.compiler.decorator import linked_kernel
from game.physics.kernels.elementary.constants import ln, pair, pi, square_root
from game.physics.kernels.elementary.extended import quick_two_sum, root, two_product, two_sum
from game.physics.kernels.elementary.powers import exp_parts, log_parts, scaled
from game.physics.kernels.elementary.words import from_bits

LN2_HIGH, LN2_LOW = pair(ln(2))
ERF_HIGH, ERF_LOW = pair(2 / square_root(pi()))


@linked_kernel
def hypot(x: float, y: float) -> float:
    """sqrt(x^2 + y^2), of which only the sum and the root are rounded."""
    a, b = math.fabs(x), math.fabs(y)
    if a < b:
        a, b = b, a
    if a == math.inf or b == math.inf:
        return math.inf
    if not b > a * 2.0**-60:  # nothing to add, or a nan
        return a + b
    scale = 1.0
    if a > 2.0**500:
        a, b, scale = a * 2.0**-600, b * 2.0**-600, 2.0**600
    elif b < 2.0**-450:
        a, b, scale = a * 2.0**600, b * 2.0**600, 2.0**-600
    square, rest = two_product(a, a)
    other, left = two_product(b, b)
    whole, lost = quick_two_sum(square, other)
    return scale * math.sqrt(whole + (lost + (rest + left)))


@linked_kernel
def cbrt(x: float) -> float:
    """The cube root: a first guess by logarithms, then one step of Newton's."""
    size = math.fabs(x)
    if not 0.0 < size < math.inf:
        return x
    scale = 1.0
    if size < 2.0**-900:
        size, scale = size * 2.0**300, 2.0**-100
    high, _ = log_parts(size, 0.0)
    high, rest, n = exp_parts(high / 3.0, 0.0)
    guess = scaled(high + rest, n)
    square, left = two_product(guess, guess)
    cube, rest = two_product(square, guess)
    guess -= ((cube - size) + (rest + left * guess)) / (3.0 * square)
    return math.copysign(scale * guess, x)


@linked_kernel
def tanh(x: float) -> float:
    """The hyperbolic tangent: Taylor's series below 1/4, 1 - 2 / (exp(2x) + 1) above."""
    size = math.fabs(x)
    if size < 2.0**-28 or x != x:
        return x
    if size < 0.25:
        z = x * x
        tail = 6404582.0 / 10854718875.0 - z * (
            443861162.0 / 1856156927625.0 - z * (18888466084.0 / 194896477400625.0)
        )
        tail = 21844.0 / 6081075.0 - z * (929569.0 / 638512875.0 - z * tail)
        tail = 17.0 / 315.0 - z * (62.0 / 2835.0 - z * (1382.0 / 155925.0 - z * tail))
        return x - x * (z * (1.0 / 3.0 - z * (2.0 / 15.0 - z * tail)))
    if size > 20.0:
        return math.copysign(1.0, x)
    high, rest, n = exp_parts(2.0 * size, 0.0)
    scale = from_bits((n + 1023) << 52)
    below, left = two_sum(high * scale, 1.0)
    below, left = quick_two_sum(below, left + rest * scale)
    gap = 2.0 / below
    back, back_rest = two_product(gap, below)
    gap_rest = (((2.0 - back) - back_rest) - gap * left) / below
    whole, left = two_sum(1.0, -gap)
    return math.copysign(whole + (left - gap_rest), x)


@linked_kernel
def asinh(x: float) -> float:
    """The inverse hyperbolic sine, log(|x| + sqrt(x^2 + 1)) with the sign of x."""
    size = math.fabs(x)
    if size < 2.0**-28 or not size < math.inf:
        return x
    if size > 2.0**30:
        high, rest = log_parts(size, 0.0)
        whole, left = two_sum(LN2_HIGH, high)
        return math.copysign(whole + (left + (rest + LN2_LOW)), x)
    square, rest = two_product(size, size)
    whole, left = two_sum(square, 1.0)
    slant, rest = root(whole, left + rest)
    whole, left = two_sum(slant, size)
    whole, left = quick_two_sum(whole, left + rest)
    high, rest = log_parts(whole, left)
    return math.copysign(high + rest, x)


@linked_kernel
def erf(x: float) -> float:
    """The error function: E. E. Kummer's series (1837), whose terms are positive, with a low part kept."""
    size = math.fabs(x)
    if x != x:
        return math.nan
    if size > 6.0:
        return math.copysign(1.0, x)
    if size < 2.0**-30:
        return x * ERF_HIGH + x * ERF_LOW
    square, square_rest = two_product(size, size)
    double, double_rest = 2.0 * square, 2.0 * square_rest
    term, term_rest, total, total_rest, k = 1.0, 0.0, 1.0, 0.0, 1.0
    while term > total * 2.0**-72:
        k += 2.0
        product, rest = two_product(term, double)
        rest += term * double_rest + term_rest * double
        term = product / k
        back, back_rest = two_product(term, k)
        term_rest = (((product - back) - back_rest) + rest) / k
        total, rest = two_sum(total, term)
        total, total_rest = quick_two_sum(total, total_rest + (rest + term_rest))
    high, rest, n = exp_parts(-square, -square_rest)
    scale = from_bits((n + 1023) << 52)
    high, rest = high * scale, rest * scale
    product, left = two_product(total, high)
    product, left = quick_two_sum(product, left + (total * rest + total_rest * high))
    side, side_rest = two_product(size, ERF_HIGH)
    side_rest += size * ERF_LOW
    whole, rest = two_product(product, side)
    return math.copysign(whole + (rest + (product * side_rest + left * side)), x)
