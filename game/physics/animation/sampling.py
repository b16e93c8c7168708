"""Many samples of a piecewise cubic at once: which piece a time is in, and the value there.

A piece from key i to i + 1 is c0 + u (c1 + u (c2 + u c3)) with u = (t - t_i) / (t_(i+1) - t_i), so it is
exactly the key's value at u = 0, which is where every key lies: the piece of a time is the one that begins
at the last key not after it. Pieces are found in constant time by a guide table, cells of equal width with
the last key not after each cell's beginning (Chen and Asau 1974, "On generating random variates from an
empirical distribution"). It is only a hint: a binary search or a walk cannot give another piece.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.compiler.decorator import kernel

NEAREST, LINEAR, CUBIC = 0, 1, 2  # degree of the pieces that a kernel is made for
RATE_BIT = 4  # with a degree: its derivative by time
UNROLLED = 4  # columns up to which a kernel is made for their very number
CELLS_PER_KEY = 8
WALK = 8  # keys beyond the hint that are looked at one by one before a binary search begins
LONGEST_RATE = 1e150  # 1/s; the rate within a piece shorter than 1e-150 s is that of one as long as this


class Track(NamedTuple):
    """Keys as the kernels take them: sorted times (n,) s, 1 / piece length (n,), coefficients and guide.

    coefficients: (n * 4 * m,), [key, power of u, column] in this order; the last key has its value alone.
    guide: (c,) last key not after a cell's beginning; density: cells to a second.
    """

    times: Floats
    inverse: Floats
    coefficients: Floats
    guide: NDArray[np.int64]
    density: float


def make_track(times: Floats, coefficients: Floats) -> Track:
    """The track of sorted times (n,) s and coefficients (n, 4, m)."""
    span = float(times[-1] - times[0])
    count = CELLS_PER_KEY * len(times)
    with np.errstate(over="ignore", divide="ignore"):
        density = float(np.float64(count) / span)
        lengths = np.diff(times)
        inverse = np.minimum(1.0 / lengths, 1e300)
    # so that u, rounded, is never above 1
    inverse = np.append(np.where(lengths * inverse > 1.0, np.nextafter(inverse, 0.0), inverse), 0.0)
    if not density < 1e300:
        density = 0.0
    begins = times[0] + span * (np.arange(count + 2) / count)
    guide = np.maximum(np.searchsorted(times, begins, side="right") - 1, 0)
    return Track(times, inverse, np.ascontiguousarray(coefficients).reshape(-1), guide, density)


@kernel(_nrt=False)
def find_piece(times, guide, density, t):
    """The last key not after t, which lies between the first key and before the last one."""
    i = np.uintp(guide[np.uintp(np.int64((t - times[0]) * density))])
    one = np.uintp(1)
    while times[i] > t:
        i -= one
    walked = 0
    while times[i + one] <= t:
        i += one
        walked += 1
        if walked == WALK:
            high = np.uintp(times.shape[0] - 1)
            while high - i > one:
                middle = (i + high) >> one
                if times[middle] <= t:
                    i = middle
                else:
                    high = middle
            break
    return i


@cache
def sampler(variant: int, width: int) -> Callable[..., Any]:
    """The kernel for pieces of a degree (NEAREST, LINEAR, CUBIC; with RATE_BIT their derivative by time).

    width: how many columns it is for, 0 for any number. It takes the arrays of a `Track`, m, loop (0 or 1),
    at (k,) s, and writes out (k * m,). Before the first key and after the last it holds their values; with
    ``loop`` the time from first to last key is repeated. It returns how many of ``at`` are not finite.
    """
    degree = variant & ~RATE_BIT
    rate = variant & RATE_BIT

    @kernel(_nrt=False)
    def sample(times, inverse, coefficients, guide, density, m, loop, at, out):
        columns = np.uintp(width if width else m)
        last = times.shape[0] - 1
        begin, end = times[0], times[last]
        bad = 0
        for k in range(at.shape[0]):
            t = at[k]
            to = np.uintp(k) * columns
            if not begin <= t < end:
                if not math.isfinite(t):
                    bad += 1
                    continue
                if loop and end > begin:
                    t -= np.floor((t - begin) / (end - begin)) * (end - begin)
                    t = t if begin <= t < end else begin  # rounding
                else:
                    first = np.uintp(0 if t < begin else last) * columns * np.uintp(4)
                    for j in range(columns):
                        out[to + np.uintp(j)] = 0.0 if rate else coefficients[first + np.uintp(j)]
                    continue
            i = find_piece(times, guide, density, t)
            u = (t - times[i]) * inverse[i]
            pace = min(inverse[i], LONGEST_RATE) if rate else 0.0
            first = i * columns * np.uintp(4)
            for j in range(columns):
                c = first + np.uintp(j)
                c1 = c + columns
                c2 = c1 + columns
                c3 = c2 + columns
                if degree == NEAREST:
                    value = 0.0 if rate else coefficients[c + np.uintp(4) * columns if u >= 0.5 else c]
                elif degree == LINEAR:
                    slope = coefficients[c1]
                    value = pace * slope if rate else coefficients[c] + u * slope
                elif rate:
                    slope = 2.0 * coefficients[c2] + u * (3.0 * coefficients[c3])
                    value = pace * (coefficients[c1] + u * slope)
                else:
                    slope = coefficients[c1] + u * (coefficients[c2] + u * coefficients[c3])
                    value = coefficients[c] + u * slope
                out[to + np.uintp(j)] = value
        return bad

    return sample
