"""Arc functions, each within 0.6 ulp.

The tangent t of an angle up to pi/4 is compared with the nearest i/64: arctan t = arctan i/64 + arctan of
(t - i/64) / (1 + t i/64), which is so small that five terms of Gregory's series do. All else is led back to
that.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, linked_kernel
from game.physics.kernels.elementary.constants import arc_tangents, pair, pi
from game.physics.kernels.elementary.extended import quick_two_sum, root, two_product, two_sum

SECTIONS = 64
ARC_HIGH, ARC_LOW = arc_tangents(SECTIONS)
PI_HIGH, PI_LOW = pair(pi())
HALF_HIGH, HALF_LOW = pair(pi() / 2)


@inner_kernel
def arc(y: float, y_rest: float, x: float, x_rest: float) -> tuple[float, float]:
    """The angle of the point (x + x_rest, y + y_rest), both >= 0 and of common size, as high + low."""
    steep = y > x
    if steep:
        x, x_rest, y, y_rest = y, y_rest, x, x_rest
    i = int(y / x * SECTIONS + 0.5)
    over, over_rest, under, under_rest = y, y_rest, x, x_rest
    if i > 0:
        t = i / SECTIONS
        down, down_rest = two_product(t, x)
        over, left = two_sum(y, -down)
        over_rest = left - down_rest + (y_rest - t * x_rest)
        along, along_rest = two_product(t, y)
        under, left = two_sum(x, along)
        under_rest = left + along_rest + (x_rest + t * y_rest)
    t = over / under
    back, back_rest = two_product(t, under)
    rest = (((over - back) - back_rest) + over_rest - t * under_rest) / under
    square = t * t
    rest -= t * square * (1.0 / 3.0 + square * (-0.2 + square * (1.0 / 7.0 - square * (1.0 / 9.0))))
    high, left = two_sum(float(ARC_HIGH[i]), t)
    low = left + (float(ARC_LOW[i]) + rest)
    if steep:
        high, left = two_sum(HALF_HIGH, -high)
        low = left + (HALF_LOW - low)
    return high, low


@linked_kernel
def atan2(y: float, x: float) -> float:
    """The angle of the point (x, y) in [-pi, pi], with the signs of zeros as C has them."""
    if x != x or y != y:
        return math.nan
    across, along = math.fabs(y), math.fabs(x)
    left = x < 0.0 or (x == 0.0 and math.copysign(1.0, x) < 0.0)
    if along == math.inf and across == math.inf:
        across = along = 1.0
    if across == 0.0 or along == math.inf:
        angle = PI_HIGH if left else 0.0
    elif along == 0.0 or across == math.inf:
        angle = HALF_HIGH
    else:
        angle = finite_angle(across, along, left)
    return math.copysign(angle, y)


@inner_kernel
def finite_angle(across: float, along: float, left: bool) -> float:
    """The angle of (along, across), both positive and finite, or of (-along, across) if ``left``."""
    largest = across if across > along else along
    if largest > 2.0**900:
        across, along = across * 2.0**-200, along * 2.0**-200
    elif largest < 2.0**-800:
        across, along = across * 2.0**200, along * 2.0**200
    if across < along * 2.0**-60:
        small = across / along
        return PI_HIGH + (PI_LOW - small) if left else small
    if along < across * 2.0**-60:
        small = along / across
        return HALF_HIGH + (HALF_LOW + small if left else HALF_LOW - small)
    high, low = arc(across, 0.0, along, 0.0)
    if left:
        high, rest = two_sum(PI_HIGH, -high)
        low = rest + (PI_LOW - low)
    return high + low


@linked_kernel
def atan(x: float) -> float:
    """The arc tangent in [-pi/2, pi/2]."""
    size = math.fabs(x)
    if size < 2.0**-28:
        return x
    if not size < 2.0**60:
        return math.nan if x != x else math.copysign(HALF_HIGH, x)
    high, low = arc(size, 0.0, 1.0, 0.0)
    return math.copysign(high + low, x)


@inner_kernel
def leg(x: float) -> tuple[float, float]:
    """sqrt(1 - x^2) for |x| <= 1 as high + low."""
    square, rest = two_product(x, x)
    whole, left = two_sum(1.0, -square)
    high, low = quick_two_sum(whole, left - rest)
    return root(high, low)


@linked_kernel
def asin(x: float) -> float:
    """The arc sine in [-pi/2, pi/2]; nan beyond 1."""
    size = math.fabs(x)
    if size < 2.0**-28:
        return x
    if not size <= 1.0:
        return math.nan
    along, rest = leg(size)
    high, low = arc(size, 0.0, along, rest)
    return math.copysign(high + low, x)


@linked_kernel
def acos(x: float) -> float:
    """The arc cosine in [0, pi]; nan beyond 1."""
    size = math.fabs(x)
    if not size <= 1.0:
        return math.nan
    across, rest = leg(x)
    high, low = arc(across, rest, size, 0.0)
    if x < 0.0:
        high, left = two_sum(PI_HIGH, -high)
        low = left + (PI_LOW - low)
    return high + low
