"""Slopes at the knots that make a cubic spline twice continuously differentiable.

With h_i the distances of knots and d_i the slopes of chords, the condition at an inner knot is

    h_i m_(i-1) + 2 (h_(i-1) + h_i) m_i + h_(i-1) m_(i+1) = 3 (h_i d_(i-1) + h_(i-1) d_i)

(de Boor 1978, "A practical guide to splines", chapter IV). What happens at the ends closes the system:
natural ends have no second derivative there, which costs two orders of accuracy near them. Not-a-knot has the
same cubic in the first two pieces and in the last two. A closed curve goes on as it began.
"""

from __future__ import annotations

import numpy as np

from game.arrays import Floats


def solve_tridiagonal(below: Floats, middle: Floats, above: Floats, right: Floats) -> Floats:
    """Solution (n, m) of a tridiagonal system by elimination without pivots (Thomas 1949).

    below, middle, above: (n,), where below[0] and above[-1] do not count; right: (n, m).
    """
    n = len(middle)
    pivot, found = middle.copy(), right.copy()
    for i in range(1, n):
        part = below[i] / pivot[i - 1]
        pivot[i] -= part * above[i - 1]
        found[i] -= part * found[i - 1]
    found[-1] /= pivot[-1]
    for i in range(n - 2, -1, -1):
        found[i] = (found[i] - above[i] * found[i + 1]) / pivot[i]
    return found


def natural_slopes(lengths: Floats, chords: Floats) -> Floats:
    """Slopes (n, m) at the knots; lengths (n - 1,) of the pieces, chords (n - 1, m) their slopes."""
    below, middle, above, right = _inner_rows(lengths, chords)
    middle[0] = middle[-1] = 2.0
    above[0] = below[-1] = 1.0
    right[0], right[-1] = 3.0 * chords[0], 3.0 * chords[-1]
    return solve_tridiagonal(below, middle, above, right)


def not_a_knot_slopes(lengths: Floats, chords: Floats) -> Floats:
    """The same for the other ends. Three knots give the parabola through them, two the chord."""
    n = len(lengths) + 1
    if n == 2:
        return np.repeat(chords, 2, axis=0)
    if n == 3:
        whole = lengths[0] + lengths[1]
        bend = (chords[1] - chords[0]) / whole
        return np.stack(
            (chords[0] - lengths[0] * bend, chords[0] + lengths[0] * bend, chords[1] + lengths[1] * bend)
        )
    below, middle, above, right = _inner_rows(lengths, chords)
    for end, inner, h, k, d, e in (
        (0, above, lengths[0], lengths[1], chords[0], chords[1]),
        (-1, below, lengths[-1], lengths[-2], chords[-1], chords[-2]),
    ):
        middle[end], inner[end] = k, h + k
        right[end] = ((h + 2.0 * (h + k)) * k * d + h * h * e) / (h + k)
    return solve_tridiagonal(below, middle, above, right)


def closed_slopes(lengths: Floats, chords: Floats) -> Floats:
    """The same for a closed curve, whose last knot is its first: the last slope is the first.

    The two entries in the corners are taken out as an update of rank one (Sherman and Morrison 1950).
    """
    n = len(lengths)
    if n < 3:
        return np.zeros((n + 1, chords.shape[1]))  # there and back again: it turns at both knots
    before, after = np.roll(lengths, 1), lengths
    right = 3.0 * (after[:, None] * np.roll(chords, 1, axis=0) + before[:, None] * chords)
    middle = 2.0 * (before + after)
    gamma, low, high = -middle[0], after[0], before[-1]
    middle[0] -= gamma
    middle[-1] -= low * high / gamma
    u = np.zeros(n)
    u[0], u[-1] = gamma, high
    both = solve_tridiagonal(after, middle, before, np.column_stack((right, u)))
    y, z = both[:, :-1], both[:, -1]
    part = (y[0] + low / gamma * y[-1]) / (1.0 + z[0] + low / gamma * z[-1])
    slopes = y - z[:, None] * part
    return np.concatenate((slopes, slopes[:1]))


def _inner_rows(lengths: Floats, chords: Floats) -> tuple[Floats, Floats, Floats, Floats]:
    """Below, middle, above and right side, filled in at the inner knots."""
    n = len(lengths) + 1
    below, middle, above, right = np.zeros(n), np.zeros(n), np.zeros(n), np.zeros((n, chords.shape[1]))
    below[1:-1], above[1:-1] = lengths[1:], lengths[:-1]
    middle[1:-1] = 2.0 * (lengths[:-1] + lengths[1:])
    right[1:-1] = 3.0 * (lengths[1:, None] * chords[:-1] + lengths[:-1, None] * chords[1:])
    return below, middle, above, right
