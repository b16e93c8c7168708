"""How steep a curve is at its keys: the rules that tell interpolations by cubics apart.

A rule looks at the chords between keys and gives a slope for each key. What it costs is always the same; what
it gives is an order of accuracy, smoothness, or no overshoot, not all at once. For a smooth motion of keys
that are not evenly spaced the errors fall with the power of the spacing that stands after each rule:

    flat             1   comes to rest at every key
    catmull-rom      1   uniform: the times of keys are ignored (3 if they are evenly spaced)
    chordal          1   knots as far apart as the points: moves at an even pace, overshoots most
    centripetal      1   knots by the root of that: no cusp and no loop within a piece
    secant           2   the slope from the key before to the key after
    monotone         2   never overshoots: harmonic means
    parabolic        3   the parabola through three keys
    natural-spline   2   continuous curvature; straight at its ends, 4 away from them
    spline           4   continuous curvature, ends free

Sources: Catmull and Rom 1974, "A class of local interpolating splines". Yuksel, Schaefer and Keyser 2011,
"Parameterization and applications of Catmull-Rom curves". Fritsch and Butland 1984, "A method for
constructing local monotone piecewise cubic interpolants"; de Boor 1978.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from game.arrays import Floats
from game.physics.animation.splines import closed_slopes, natural_slopes, not_a_knot_slopes
from game.physics.kernels import elementwise

KNOT_POWERS = {"catmull-rom": 0.0, "centripetal": 0.5, "chordal": 1.0}  # of the distance of points
RULES = (
    "flat", "catmull-rom", "centripetal", "chordal", "secant", "monotone", "parabolic", "natural-spline",
    "spline",
)  # fmt: skip
SHORTEST_PART = 1e-9  # of the longest piece: no slope is made across a piece that is shorter


def piece_slopes(
    rule: str, times: Floats, steps: Floats, closed: bool = False, geometry: tuple[int, ...] | None = None
) -> tuple[Floats, Floats]:
    """Slopes at the beginning and at the end of each piece, (n - 1, m) each, by the piece's own parameter.

    times: (n,) s, sorted; steps: (n - 1, m) from key to key. closed: the last key is the first, and slopes go
    round. geometry: columns whose distances make the knots of centripetal and chordal curves, None for all.
    Keys at the same time (a jump) end a smooth run. So do keys in the same place where that makes the knots.
    What lies between such keys is a straight line.
    """
    lengths = _knot_lengths(rule, times, steps, geometry)
    begins, ends = steps.copy(), steps.copy()
    long = lengths > SHORTEST_PART * np.max(lengths, initial=0.0)
    if not long.any():
        return begins, ends
    closed = closed and bool(long.all())
    edges = np.flatnonzero(np.diff(np.concatenate(([False], long, [False]))))
    for low, high in zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True):
        h = lengths[low:high] / np.max(lengths[low:high])
        slopes = _slopes(rule, h, steps[low:high] / h[:, None], closed)
        begins[low:high], ends[low:high] = h[:, None] * slopes[:-1], h[:, None] * slopes[1:]
    return begins, ends


def _knot_lengths(rule: str, times: Floats, steps: Floats, geometry: tuple[int, ...] | None) -> Floats:
    """Distances (n - 1,) of the knots that a rule works with."""
    if rule not in KNOT_POWERS:
        return np.asarray(np.diff(times))
    if rule == "catmull-rom":
        return np.where(np.diff(times) > 0.0, 1.0, 0.0)
    way = steps if geometry is None else steps[:, list(geometry)]
    squares = (way * way).sum(axis=1)
    return np.where(np.diff(times) > 0.0, elementwise.power(squares, 0.5 * KNOT_POWERS[rule]), 0.0)


def _slopes(rule: str, h: Floats, chords: Floats, closed: bool) -> Floats:
    """Slopes (n, m) at the knots of one run."""
    if rule == "flat":
        return np.zeros((len(h) + 1, chords.shape[1]))
    if rule == "natural-spline":
        return closed_slopes(h, chords) if closed else natural_slopes(h, chords)
    if rule == "spline":
        return closed_slopes(h, chords) if closed else not_a_knot_slopes(h, chords)
    inner, at_end = _LOCAL[rule]
    if closed:  # one piece more at either side, and no ends
        h = np.concatenate((h[-1:], h, h[:1]))
        chords = np.concatenate((chords[-1:], chords, chords[:1]))
        return inner(h[:-1, None], h[1:, None], chords[:-1], chords[1:])
    if len(h) == 1:
        return np.repeat(chords, 2, axis=0)
    middle = inner(h[:-1, None], h[1:, None], chords[:-1], chords[1:])
    first = at_end(h[0], h[1], chords[0], chords[1])
    last = at_end(h[-1], h[-2], chords[-1], chords[-2])
    return np.concatenate((first[None], middle, last[None]))


def _secant(h: Floats, k: Floats, d: Floats, e: Floats) -> Floats:
    """Slope over two pieces of lengths h and k with chords d and e."""
    return (h * d + k * e) / (h + k)


def _parabola(h: Floats, k: Floats, d: Floats, e: Floats) -> Floats:
    """Slope in the middle of the parabola through three keys."""
    return (k * d + h * e) / (h + k)


def _parabola_end(h: Floats, k: Floats, d: Floats, e: Floats) -> Floats:
    """Slope at the end of that parabola where the piece of length h is."""
    return ((2.0 * h + k) * d - h * e) / (h + k)


def _harmonic(h: Floats, k: Floats, d: Floats, e: Floats) -> Floats:
    """Weighted harmonic mean of two chords, 0 where they differ in sign (Fritsch and Butland 1984)."""
    agree = d * e > 0.0
    first, second = np.where(agree, d, 1.0), np.where(agree, e, 1.0)
    with np.errstate(over="ignore"):  # a chord below 1e-308 has no inverse: the mean is 0, as it should be
        mean = 3.0 * (h + k) / ((2.0 * k + h) / first + (k + 2.0 * h) / second)
    return np.where(agree, mean, 0.0)


def _harmonic_end(h: Floats, k: Floats, d: Floats, e: Floats) -> Floats:
    """The parabola's slope at an end, no steeper than keeps the shape (Moler 2004, section 3.6)."""
    slope = _parabola_end(h, k, d, e)
    slope = np.where(slope * d > 0.0, slope, 0.0)
    steep = (d * e <= 0.0) & (np.abs(slope) > 3.0 * np.abs(d))
    return np.where(steep, 3.0 * d, slope)


_Rule = Callable[[Floats, Floats, Floats, Floats], Floats]
_LOCAL: dict[str, tuple[_Rule, _Rule]] = {
    "secant": (_secant, _parabola_end),
    "monotone": (_harmonic, _harmonic_end),
    **dict.fromkeys(("parabolic", *KNOT_POWERS), (_parabola, _parabola_end)),
}
