"""Sums and products with what rounding took from them: (high, low) with high + low exact.

T. J. Dekker (1971), "A floating-point technique for extending the available precision"; D. E. Knuth, The Art
of Computer Programming 2, 4.2.2. Nothing here may be contracted to a fused multiply-add: numba does not.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel

SPLITTER = 2.0**27 + 1.0


@inner_kernel
def two_sum(a: float, b: float) -> tuple[float, float]:
    """a + b exactly."""
    high = a + b
    other = high - a
    return high, (a - (high - other)) + (b - other)


@inner_kernel
def quick_two_sum(a: float, b: float) -> tuple[float, float]:
    """a + b exactly, for |a| >= |b| or a = 0."""
    high = a + b
    return high, b - (high - a)


@inner_kernel
def two_product(a: float, b: float) -> tuple[float, float]:
    """a * b exactly, for |a|, |b| < 2^996 and a product that is zero or above 2^-960."""
    high = a * b
    t = SPLITTER * a
    a_high = t - (t - a)
    a_low = a - a_high
    t = SPLITTER * b
    b_high = t - (t - b)
    b_low = b - b_high
    return high, ((a_high * b_high - high) + a_high * b_low + a_low * b_high) + a_low * b_low


@inner_kernel
def root(high: float, low: float) -> tuple[float, float]:
    """The square root of high + low > 0, with twice the precision; (0, 0) of zero."""
    r = math.sqrt(high)
    if r == 0.0:
        return 0.0, 0.0
    square, rest = two_product(r, r)
    return r, (((high - square) - rest) + low) / (2.0 * r)
