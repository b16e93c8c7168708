"""How long a curve is, and where on it one is after a given way.

The length of a cubic has no closed form. The speed is integrated by Gauss-Legendre with eight points, whole
and in halves, and halved again where the two disagree. At a cusp the speed has a kink, which lies unseen
between two of the points as easily as not: so a piece is divided where its speed is least. From length to
parameter leads Newton's method on the integral, whose derivative is the speed itself. Bisection keeps it in a
bracket where the speed vanishes (Guenter and Parent 1990, "Computing the arc length of parametric curves").

Arrays: controls (n, 4, d) m, the pieces of a curve; breaks (n, 3), where each is divided; table
(n PARTS + 1,) m, the way up to each part.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.compiler.decorator import kernel

NODES = (0.1834346424956498, 0.525532409916329, 0.7966664774136267, 0.9602898564975363)
WEIGHTS = (0.362683783378362, 0.3137066458778873, 0.22238103445337448, 0.10122853629037626)
PARTS = 16  # of a piece, whose lengths are kept
AGREED = 1e-15  # of the piece's control polygon: whole and halves may differ by so much
CLOSE = 1e-15  # of the whole length: Newton's method may stop so far off
DEEPEST = 40  # halvings
MOST_ROUNDS = 80  # of Newton's method


@kernel(_nrt=False)
def speed_at(controls, i, u):
    """Length of the derivative of piece i of controls (n, 4, d) at u in [0, 1]."""
    v = 1.0 - u
    total = 0.0
    for j in range(controls.shape[2]):
        a = controls[i, 1, j] - controls[i, 0, j]
        b = controls[i, 2, j] - controls[i, 1, j]
        c = controls[i, 3, j] - controls[i, 2, j]
        slope = 3.0 * (v * v * a + 2.0 * u * v * b + u * u * c)
        total += slope * slope
    return math.sqrt(total)


@kernel(_nrt=False)
def gauss_length(controls, i, low, high):
    """Length from u = low to high by eight points."""
    half, middle = 0.5 * (high - low), 0.5 * (high + low)
    total = 0.0
    for k in range(4):
        off = half * NODES[k]
        total += WEIGHTS[k] * (speed_at(controls, i, middle - off) + speed_at(controls, i, middle + off))
    return half * total


@kernel(_nrt=False)
def polygon_length(controls, i):
    """Length of the control polygon of piece i, not less than that of the curve."""
    total = 0.0
    for k in range(3):
        square = 0.0
        for j in range(controls.shape[2]):
            way = controls[i, k + 1, j] - controls[i, k, j]
            square += way * way
        total += math.sqrt(square)
    return total


@kernel(_nrt=False)
def cubic_at(g, u):
    """Value of the cubic with coefficients g (4,), the constant first."""
    return g[0] + u * (g[1] + u * (g[2] + u * g[3]))


@kernel(_nrt=False)
def root_between(g, low, high):
    """Root of the cubic between two places at which its sign differs, by bisection to the last bit."""
    rising = cubic_at(g, high) > 0.0
    while True:
        middle = 0.5 * (low + high)
        if not low < middle < high:
            return middle
        if (cubic_at(g, middle) > 0.0) == rising:
            high = middle
        else:
            low = middle


@kernel(_nrt=False)
def find_breaks(controls, i, g, breaks):
    """Write where the speed of piece i has its extremes: breaks[i, :3], rising, 2 where there are fewer.

    They are the roots of B' . B'', a cubic, between the extremes of that. g: (4,) to work in.
    """
    for k in range(4):
        g[k] = 0.0
    for k in range(3):
        breaks[i, k] = 2.0
    for j in range(controls.shape[2]):
        a = controls[i, 1, j] - controls[i, 0, j]
        b = controls[i, 2, j] - controls[i, 1, j]
        c = controls[i, 3, j] - controls[i, 2, j]
        p, q = 2.0 * (b - a), a - 2.0 * b + c  # B' / 3 = a + p u + q u^2
        g[0] += a * p
        g[1] += p * p + 2.0 * a * q
        g[2] += 3.0 * p * q
        g[3] += 2.0 * q * q
    # extremes of g: roots of g1 + 2 g2 u + 3 g3 u^2
    first = second = 2.0
    inside = g[2] * g[2] - 3.0 * g[3] * g[1]
    if g[3] > 0.0 and inside > 0.0:
        root = math.sqrt(inside)
        first, second = (-g[2] - root) / (3.0 * g[3]), (-g[2] + root) / (3.0 * g[3])
    count = 0
    low = 0.0
    for edge in (first, second, 1.0):
        high = min(max(edge, low), 1.0)
        at_low, at_high = cubic_at(g, low), cubic_at(g, high)
        if high > low and ((at_low < 0.0 < at_high) or (at_high < 0.0 < at_low)):
            breaks[i, count] = root_between(g, low, high)
            count += 1
        low = high


@kernel(_nrt=False)
def smooth_length(controls, i, low, high, scale):
    """Length of piece i from u = low to high, halved where needed; scale: length of its control polygon.

    The intervals are those of a binary tree, gone through from the left: ``place`` counts on ``level``.
    """
    total = 0.0
    place, level = 0, 0
    width = high - low
    while True:
        part = width / (1 << level)
        begin = low + place * part
        middle, end = begin + 0.5 * part, begin + part
        whole = gauss_length(controls, i, begin, end)
        halves = gauss_length(controls, i, begin, middle) + gauss_length(controls, i, middle, end)
        if abs(whole - halves) > AGREED * scale and level < DEEPEST:
            place *= 2
            level += 1
            continue
        total += halves
        place += 1
        while level > 0 and place % 2 == 0:
            place //= 2
            level -= 1
        if level == 0:
            return total


@kernel(_nrt=False)
def piece_length(controls, breaks, i, low, high, scale):
    """Length of piece i from u = low to high, in parts between the extremes of its speed."""
    total = 0.0
    begin = low
    for k in range(3):
        if begin < breaks[i, k] < high:
            total += smooth_length(controls, i, begin, breaks[i, k], scale)
            begin = breaks[i, k]
    return total + smooth_length(controls, i, begin, high, scale)


@kernel(_nrt=False)
def measure(controls, g, breaks, table):
    """Write breaks (n, 3) and the lengths up to each part of each piece: table (n * PARTS + 1,)."""
    table[0] = 0.0
    for i in range(controls.shape[0]):
        find_breaks(controls, i, g, breaks)
        scale = polygon_length(controls, i)
        for k in range(PARTS):
            way = piece_length(controls, breaks, i, k / PARTS, (k + 1) / PARTS, scale)
            table[i * PARTS + k + 1] = table[i * PARTS + k] + way


@kernel(_nrt=False)
def length_to(controls, breaks, table, u):
    """Length from the beginning to the parameter u in [0, n]."""
    last = controls.shape[0]
    if u >= last:
        return table[last * PARTS]
    i = int(u)
    k = int((u - i) * PARTS)
    low = k / PARTS
    scale = polygon_length(controls, i)
    return table[i * PARTS + k] + piece_length(controls, breaks, i, low, u - i, scale)


@kernel(_nrt=False)
def parameter_at(controls, breaks, table, way):
    """The parameter in [0, n] that lies ``way`` from the beginning, within [0, whole length]."""
    last = table.shape[0] - 1
    if way >= table[last]:
        return float(controls.shape[0])
    if way <= 0.0:
        return 0.0
    low_place, high_place = 0, last
    while high_place - low_place > 1:
        middle = (low_place + high_place) >> 1
        if table[middle] <= way:
            low_place = middle
        else:
            high_place = middle
    i, k = low_place // PARTS, low_place % PARTS
    begin, low, high = k / PARTS, k / PARTS, (k + 1) / PARTS
    length = way - table[low_place]
    scale = polygon_length(controls, i)
    u = low + (high - low) * length / (table[high_place] - table[low_place])
    for _ in range(MOST_ROUNDS):
        off = piece_length(controls, breaks, i, begin, u, scale) - length
        if off > 0.0:
            high = u
        else:
            low = u
        if abs(off) <= CLOSE * table[last] or not low < 0.5 * (low + high) < high:
            break
        speed = speed_at(controls, i, u)
        u = u - off / speed if speed > 0.0 else low
        if not low < u < high:
            u = 0.5 * (low + high)
    return i + u


@kernel(_nrt=False)
def lengths_to(controls, breaks, table, at, out):
    """Lengths (k,) up to the parameters ``at`` (k,)."""
    for k in range(at.shape[0]):
        out[k] = length_to(controls, breaks, table, min(max(at[k], 0.0), float(controls.shape[0])))


@kernel(_nrt=False)
def parameters_at(controls, breaks, table, ways, out):
    """Parameters (k,) at the lengths ``ways`` (k,)."""
    for k in range(ways.shape[0]):
        out[k] = parameter_at(controls, breaks, table, ways[k])


class ArcLength:
    """Lengths along controls (n, 4, d) of n cubic Bezier pieces; the parameter of piece i is i + u."""

    def __init__(self, controls: Floats) -> None:
        self.controls = controls
        self.breaks = np.empty((len(controls), 3))
        self.table = np.empty(len(controls) * PARTS + 1)
        measure(controls, np.empty(4), self.breaks, self.table)

    @property
    def total(self) -> float:
        """Length of the whole curve."""
        return float(self.table[-1])

    def to(self, parameters: ArrayLike) -> Floats:
        """Length (...,) from the beginning up to parameters (...,); beyond the ends that of the end.

        In the unit of the controls. ValueError for what is not finite.
        """
        at = _finite("parameters", parameters)
        out = np.empty(at.size)
        lengths_to(self.controls, self.breaks, self.table, at.reshape(-1), out)
        return out.reshape(at.shape)

    def parameter(self, ways: ArrayLike) -> Floats:
        """Parameters (...,) at lengths (...,) from the beginning; beyond the ends that of the end.

        ValueError for what is not finite.
        """
        at = _finite("lengths", ways)
        out = np.empty(at.size)
        parameters_at(self.controls, self.breaks, self.table, at.reshape(-1), out)
        return out.reshape(at.shape)


def _finite(name: str, numbers: ArrayLike) -> Floats:
    array = np.ascontiguousarray(numbers, dtype=np.float64).reshape(np.shape(numbers))
    if not np.isfinite(array).all():
        raise ValueError(f"{name}: expected finite numbers")
    return array
