"""Values between grid points: linear, and cubic Catmull-Rom (1974), of padded fields.

Places count in grid points from the first value of the unpadded field. A padded field answers places from -1
to its count (one beyond the last value); what comes from outside is clamped there by the caller.
"""

from __future__ import annotations

import math

from game.physics.grid.layout import PAD
from game.physics.kernels.lean import inner_kernel


@inner_kernel
def wrapped(x, count):
    """x brought into [0, count) of a periodic side."""
    return x - count * math.floor(x / count)


@inner_kernel
def clamped(x, low, high):
    """x, at least low and at most high; low for what is no number."""
    x = x if x > low else low
    return x if x < high else high


@inner_kernel
def cubic_weights(f):
    """Of the four points around a place, f behind the second."""
    g = 1.0 - f
    return -0.5 * f * g * g, 1.0 + f * f * (1.5 * f - 2.5), 1.0 + g * g * (1.5 * g - 2.5), -0.5 * g * f * f


@inner_kernel
def linear_at(padded, x, y):
    """Bilinear value of a padded field at (x, y)."""
    i, j = int(math.floor(x)), int(math.floor(y))
    f, g = x - i, y - j
    low, high = padded[j + PAD], padded[j + PAD + 1]
    i += PAD
    return (1.0 - g) * ((1.0 - f) * low[i] + f * low[i + 1]) + g * ((1.0 - f) * high[i] + f * high[i + 1])


@inner_kernel
def cubic_at(padded, x, y):
    """Bicubic Catmull-Rom value of a padded field at (x, y), not limited."""
    i, j = int(math.floor(x)), int(math.floor(y))
    a, b, c, d = cubic_weights(x - i)
    p, q, r, s = cubic_weights(y - j)
    i += PAD - 1
    j += PAD - 1
    r0, r1, r2, r3 = padded[j], padded[j + 1], padded[j + 2], padded[j + 3]
    outer = p * ((a * r0[i] + d * r0[i + 3]) + (b * r0[i + 1] + c * r0[i + 2]))
    inner = q * ((a * r1[i] + d * r1[i + 3]) + (b * r1[i + 1] + c * r1[i + 2]))
    inner += r * ((a * r2[i] + d * r2[i + 3]) + (b * r2[i + 1] + c * r2[i + 2]))
    outer += s * ((a * r3[i] + d * r3[i + 3]) + (b * r3[i + 1] + c * r3[i + 2]))
    return outer + inner


@inner_kernel
def bounds_at(padded, x, y):
    """Least and largest of the four values around a place."""
    i, j = int(math.floor(x)) + PAD, int(math.floor(y)) + PAD
    a, b, c, d = padded[j, i], padded[j, i + 1], padded[j + 1, i], padded[j + 1, i + 1]
    return min(min(a, b), min(c, d)), max(max(a, b), max(c, d))
