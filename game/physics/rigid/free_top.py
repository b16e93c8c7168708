"""The free rigid body, exactly: how a body turns that nothing pushes, by Jacobi's elliptic functions.

In the frame of the principal axes, I1 <= I2 <= I3, with 2 E = Σ I w² and L² = Σ I² w² kept (Jacobi 1849;
Landau and Lifshitz, Mechanics, 37), while L² > 2 E I2:

    w1 = A1 cn(u),  w2 = ± A2 sn(u),  w3 = ± A3 dn(u),  u = p t + u0
    A1² = (2 E I3 - L²) / (I1 (I3 - I1)),  A2² = (2 E I3 - L²) / (I2 (I3 - I2)),
    A3² = (L² - 2 E I1) / (I3 (I3 - I1)),  p² = (I3 - I2) (L² - 2 E I1) / (I1 I2 I3),
    m = (I2 - I1) (2 E I3 - L²) / ((I3 - I2) (L² - 2 E I1))

and else the same with axes 1 and 3 in each other's place. Differences are written out as sums of squares,
which cancel nothing, and the phase u0 comes in by the addition theorem.

The turn itself: the direction l of L in the body's frame is known. About L the body has turned by an angle ψ
with ψ' = |L| (l2²/I2 + l3²/I3) / (l2² + l3²), the azimuth of axis 1, which here never points along L. That is
smooth and periodic, and summed by Gauss's rule to the last digits (Celledoni, Fassò, Säfström, Zanna 2008).
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.compiler.decorator import kernel
from game.physics.kernels import elementary
from game.physics.rigid.quaternion import multiply, normalize, quaternion_of, rotate_back

CLOSE = 1e-8  # relative gap of the two means, whose square is below rounding
LEVELS = 40  # of the arithmetic-geometric mean; six do unless the motion is next to the separatrix
NODES, WEIGHTS = np.polynomial.legendre.leggauss(10)
MOST_PANELS = 100_000  # of Gauss's rule: beyond, a single step is absurdly long


@kernel
def mean_level(m1, level):
    """(a, b) after so many steps of the arithmetic-geometric mean from 1 and √m1."""
    a = 1.0
    b = math.sqrt(m1)
    for _ in range(level):
        product = a * b
        a = 0.5 * (a + b)
        b = math.sqrt(product)
    return a, b


@kernel
def elliptic_functions(u, m1):
    """Jacobi's sn, cn, dn of u with the complementary parameter m1 = 1 - m.

    Bulirsch 1965, by Gauss's transformation of cn/sn and dn, which keeps their digits next to m = 1.
    """
    if m1 <= 0.0:
        w = elementary.exp(-abs(u))
        sech = 2.0 * w / (1.0 + w * w)
        return elementary.tanh(u), sech, sech
    level = 0
    a, b = mean_level(m1, level)
    while a - b > CLOSE * a and level < LEVELS:
        level += 1
        a, b = mean_level(m1, level)
    mean = 0.5 * (a + b)
    phase = mean * u
    sn = elementary.sin(phase)
    if abs(sn) < 1e-100:
        return sn, elementary.cos(phase), 1.0
    ratio = elementary.cos(phase) / sn
    c, dn = mean * ratio, 1.0
    while level >= 0:
        # the levels once more from above: six short loops, and no array to keep them in
        a, b = mean_level(m1, level)
        ratio *= c
        c *= dn
        dn = (b + ratio) / (a + ratio)
        ratio = c / a
        level -= 1
    sn = math.copysign(1.0 / math.sqrt(c * c + 1.0), sn)
    return sn, c * sn, dn


@kernel
def polhode(w, i):
    """The curve that the spin w (3 numbers, rad/s) runs through; i: ascending moments (3 numbers, kg m²).

    Gives (about3, A1, A2, A3, sign, p, m1, sn0, cn0, dn0, w); about3: whether axis 3 is the one it runs
    about, or axis 1. A spin about a principal axis has p = 0 and stays.
    """
    d21, d31, d32 = i[1] - i[0], i[2] - i[0], i[2] - i[1]
    high = i[0] * d31 * w[0] * w[0] + i[1] * d32 * w[1] * w[1]  # 2 E I3 - L²
    low = i[1] * d21 * w[1] * w[1] + i[2] * d31 * w[2] * w[2]  # L² - 2 E I1
    middle = i[2] * d32 * w[2] * w[2] - i[0] * d21 * w[0] * w[0]  # L² - 2 E I2
    about3 = middle > 0.0
    # with axes 1 and 3 in each other's place all three differences change their signs
    far, near, gap = (high, low, d32) if about3 else (low, high, d21)
    a1 = math.sqrt(high / (i[0] * d31)) if d31 > 0.0 else abs(w[0])
    a3 = math.sqrt(low / (i[2] * d31)) if d31 > 0.0 else abs(w[2])
    a2 = math.sqrt(far / (i[1] * gap)) if gap > 0.0 else abs(w[1])
    p = math.sqrt(gap * near / (i[0] * i[1] * i[2]))
    m1 = 1.0
    if gap * near > 0.0:
        m1 = min(max(d31 * abs(middle) / (gap * near), 0.0), 1.0)
    turning, across = (w[2], w[0]) if about3 else (w[0], w[2])
    sign = -1.0 if turning < 0.0 else 1.0
    size = a1 if about3 else a3
    sn, cn = 0.0, 1.0
    if size > 0.0 and a2 > 0.0:
        sn = sign * w[1] / a2
        cn = across / size
        length = math.sqrt(sn * sn + cn * cn)
        if length > 0.0:
            sn /= length
            cn /= length
    if cn < 0.0:  # half a period on; so that the separatrix, where cn is never negative, needs no case
        sn, cn, a2 = -sn, -cn, -a2
        if about3:
            a1 = -a1
        else:
            a3 = -a3
    return about3, a1, a2, a3, sign, p, m1, sn, cn, math.sqrt(m1 + (1.0 - m1) * cn * cn), w


@kernel
def spin_on(curve, t):
    """Spin (3 numbers, rad/s, in the body's frame) after t s on a polhode."""
    about3, a1, a2, a3, sign, p, m1, sn0, cn0, dn0, start = curve
    if p == 0.0:
        return start
    s, c, d = elliptic_functions(p * t, m1)
    m = 1.0 - m1
    divisor = cn0 * cn0 + sn0 * sn0 * d * d  # 1 - m sn0² s², which would cancel near the separatrix
    if not divisor > 0.0:
        return (sign * a1 * dn0, sign * a2 * sn0, a3 * cn0)
    sn = (sn0 * c * d + s * cn0 * dn0) / divisor
    cn = (cn0 * c - sn0 * dn0 * s * d) / divisor
    dn = (dn0 * d - m * sn0 * cn0 * s * c) / divisor
    if about3:
        return (a1 * cn, sign * a2 * sn, sign * a3 * dn)
    return (sign * a1 * dn, sign * a2 * sn, a3 * cn)


@kernel
def turned_about_momentum(curve, i, t):
    """Angle ψ (rad) by which the body turns about L in t s, seen by the axis that is far from L."""
    far = 0 if curve[0] else 2
    other = 2 - far
    widest = i[far] * (curve[1] if curve[0] else curve[3])  # the most of L that axis ever sees
    start = spin_on(curve, 0.0)
    squared = 0.0
    for k in range(3):
        squared += i[k] * start[k] * i[k] * start[k]
    momentum = math.sqrt(squared)
    reach = 0.5 * math.pi  # distance of the integrand's poles from real u, at least
    if widest != 0.0:
        reach = min(reach, elementary.atan(math.sqrt(max(squared / (widest * widest) - 1.0, 1e-12))))
    panels = min(int(abs(curve[5] * t) * 1.5 / reach) + 1, MOST_PANELS)
    h = t / panels
    total = 0.0
    for panel in range(panels):
        for k in range(NODES.shape[0]):
            w = spin_on(curve, (panel + 0.5 + 0.5 * NODES[k]) * h)
            l2 = i[1] * w[1]
            l3 = i[other] * w[other]
            across = l2 * l2 + l3 * l3
            if across > 0.0:
                total += WEIGHTS[k] * (l2 * w[1] + l3 * w[other]) / across
    return 0.5 * h * momentum * total


@kernel
def momentum_frame(angular, far):
    """Rotation matrix, row by row: an axis across L near the axis ``far``, one across both, and L."""
    length = math.sqrt(angular[0] * angular[0] + angular[1] * angular[1] + angular[2] * angular[2])
    x, y, z = angular[0] / length, angular[1] / length, angular[2] / length
    across = max(math.sqrt(y * y + z * z) if far == 0 else math.sqrt(x * x + y * y), 1e-300)
    towards = (across, -x * y / across, -x * z / across)
    a = towards if far == 0 else (-x * z / across, -y * z / across, across)
    b = (y * a[2] - z * a[1], z * a[0] - x * a[2], x * a[1] - y * a[0])
    return (a[0], a[1], a[2], b[0], b[1], b[2], x, y, z)


@kernel
def turn_freely(q, angular, i, t):
    """Orientation after t s without torque: q of the principal frame, angular momentum in the world's.

    i: ascending moments, all above 0. Gives a unit quaternion.
    """
    body = rotate_back(q, angular)
    squared = body[0] * body[0] + body[1] * body[1] + body[2] * body[2]
    if not squared > 1e-300:
        return q
    curve = polhode((body[0] / i[0], body[1] / i[1], body[2] / i[2]), i)
    far = 0 if curve[0] else 2
    angle = turned_about_momentum(curve, i, t)
    w = spin_on(curve, t)
    f = momentum_frame(body, far)
    g = momentum_frame((i[0] * w[0], i[1] * w[1], i[2] * w[2]), far)
    c, s = elementary.cos(angle), elementary.sin(angle)
    # F0ᵀ Rz(ψ) G, with the rows of F0 and G as above
    top = (c * g[0] - s * g[3], c * g[1] - s * g[4], c * g[2] - s * g[5])
    side = (s * g[0] + c * g[3], s * g[1] + c * g[4], s * g[2] + c * g[5])
    last = (g[6], g[7], g[8])
    turn = (
        f[0] * top[0] + f[3] * side[0] + f[6] * last[0],
        f[0] * top[1] + f[3] * side[1] + f[6] * last[1],
        f[0] * top[2] + f[3] * side[2] + f[6] * last[2],
        f[1] * top[0] + f[4] * side[0] + f[7] * last[0],
        f[1] * top[1] + f[4] * side[1] + f[7] * last[1],
        f[1] * top[2] + f[4] * side[2] + f[7] * last[2],
        f[2] * top[0] + f[5] * side[0] + f[8] * last[0],
        f[2] * top[1] + f[5] * side[1] + f[8] * last[1],
        f[2] * top[2] + f[5] * side[2] + f[8] * last[2],
    )
    return normalize(multiply(q, quaternion_of(turn)))


class FreeTop:
    """A free body: ascending principal moments (3,) kg m², and its spin (3,) rad/s about those axes.

    ValueError unless all are finite and the moments above 0 and ascending.
    """

    def __init__(self, moments: ArrayLike, spin: ArrayLike):
        values = np.array(moments, dtype=np.float64), np.array(spin, dtype=np.float64)
        for name, array in zip(("moments", "spin"), values, strict=True):
            if array.shape != (3,) or not np.isfinite(array).all():
                raise ValueError(f"{name}: expected three finite numbers")
        if not (values[0][0] > 0.0 and np.all(np.diff(values[0]) >= 0.0)):
            raise ValueError("moments: must be above 0 and ascending")
        self._moments = tuple(values[0].tolist())
        self._curve = polhode(tuple(values[1].tolist()), self._moments)

    def spin(self, t: float) -> Floats:
        """Spin (3,) rad/s about the principal axes after t s."""
        return np.array(spin_on(self._curve, float(t)))

    def orientation(self, q: ArrayLike, t: float) -> Floats:
        """Where the orientation q (4,), unit, of the principal frame has come to after t s."""
        start = normalize(tuple(np.array(q, dtype=np.float64).tolist()))
        back = (start[0], -start[1], -start[2], -start[3])
        body = tuple(i * w for i, w in zip(self._moments, self.spin(0.0).tolist(), strict=True))
        return np.array(turn_freely(start, rotate_back(back, body), self._moments, float(t)))

    @property
    def period(self) -> float:
        """Time (s) after which the spin is in the body as it was: 4 K(m) / p; infinite if it never is."""
        p, m1 = float(self._curve[5]), float(self._curve[6])
        if not (p > 0.0 and m1 > 0.0):
            return math.inf
        a, _ = mean_level(m1, LEVELS)
        return 2.0 * math.pi / (a * p)

    def flips(self, seconds: float) -> list[float]:
        """Times (s) up to ``seconds`` at which the spin about the middle axis changes its sign."""
        p, m1, sn = (float(self._curve[k]) for k in (5, 6, 7))
        if p == 0.0 or self._curve[2] == 0.0:
            return []
        if m1 == 0.0:  # on the separatrix, from one end of the middle axis to the other: sn = tanh
            at = -elementary.asinh(sn / float(self._curve[8])) / p if sn < 0.0 else math.inf
            return [at] if at <= seconds else []
        half = 0.5 * self.period
        first = _first_zero(lambda t: float(self.spin(t)[1]), half)
        return [first + k * half for k in range(max(0, math.floor((seconds - first) / half) + 1))]


def _first_zero(function: Callable[[float], float], half: float) -> float:
    """First time above 0 at which a function of period 2 half, with one zero in each half, changes sign."""
    low, high = 1e-12 * half, half
    sign = function(low) > 0.0
    for _ in range(200):
        middle = 0.5 * (low + high)
        if (function(middle) > 0.0) == sign:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)
