"""Linear complementarity by pivoting: w = A z + q with w, z >= 0 and w . z = 0 (Lemke 1965).

Lexicographic choice of the row that leaves, so that ties, which symmetric piles are full of, do not cycle.
For the matrices of contacts with friction (copositive) it ends in a solution (Anitescu and Potra 1997).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.kernels import linear

TINY = 1e-11
PROXIMAL = 3  # points: each leaves the shift's share of what was left
ON_RAY, TOO_LONG = -1, -2


@inner_kernel
def pivot(tableau, row, column):
    """Gauss-Jordan: the column becomes a unit vector."""
    width = tableau.shape[1]
    over = 1.0 / tableau[row, column]
    for n in range(width):
        tableau[row, n] *= over
    for m in range(tableau.shape[0]):
        factor = tableau[m, column]
        if m != row and factor != 0.0:
            for n in range(width):
                tableau[m, n] -= factor * tableau[row, n]


@inner_kernel
def comes_before(tableau, i, j, column):
    """Row i before row j in the lexicographic order of (right side, inverse of the basis) / pivot."""
    size, last = tableau.shape[0], tableau.shape[1] - 1
    over_i, over_j = 1.0 / tableau[i, column], 1.0 / tableau[j, column]
    difference = tableau[i, last] * over_i - tableau[j, last] * over_j
    if abs(difference) > TINY:
        return difference < 0.0
    for n in range(size):
        difference = tableau[i, n] * over_i - tableau[j, n] * over_j
        if abs(difference) > TINY:
            return difference < 0.0
    return False


@inner_kernel
def leaving_row(tableau, basis, column, cover):
    """Which row leaves; -1 for a ray. The covering variable goes as soon as it may."""
    best = -1
    for m in range(tableau.shape[0]):
        if tableau[m, column] > 1e-9 and (best < 0 or comes_before(tableau, m, best, column)):
            best = m
    if best >= 0:
        last = tableau.shape[1] - 1
        for m in range(tableau.shape[0]):
            if basis[m] == cover and tableau[m, column] > 1e-9:
                gain = tableau[m, last] / tableau[m, column] - tableau[best, last] / tableau[best, column]
                if gain <= TINY:
                    best = m
    return best


@lean_kernel
def run_lemke(tableau, basis, most):
    """Pivots on (I, -A, -1 | q), columns w, z, cover; how many there were, or ON_RAY or TOO_LONG."""
    size = tableau.shape[0]
    last, cover = tableau.shape[1] - 1, 2 * size
    row = 0
    for m in range(1, size):
        if tableau[m, last] < tableau[row, last]:
            row = m
    if size == 0 or tableau[row, last] >= 0.0:
        return 0
    leaving = basis[row]
    pivot(tableau, row, cover)
    basis[row] = cover
    result = TOO_LONG
    for turn in range(most):
        column = leaving + size if leaving < size else leaving - size
        row = leaving_row(tableau, basis, column, cover)
        if row < 0:
            result = ON_RAY
            break
        leaving = basis[row]
        pivot(tableau, row, column)
        basis[row] = column
        if leaving == cover:
            result = turn + 1
            break
    return result


def solve_complementarity(a: Floats, q: Floats) -> Floats | None:
    """z (m,) for A (m, m) and q (m,); None if pivots end on a ray."""
    size = len(q)
    for shift in (0.0, 1e-10, 1e-7):
        tableau = np.concatenate(
            [np.eye(size), -a - shift * np.eye(size), -np.ones((size, 1)), q[:, None]], axis=1
        )
        basis = np.arange(size, dtype=np.int64)
        if run_lemke(np.ascontiguousarray(tableau), basis, 50 * size + 50) >= 0:
            values = _values(a, q, basis, shift)
            if values is not None:
                return values
    return None


def _values(a: Floats, q: Floats, basis: NDArray[np.int64], shift: float) -> Floats | None:
    """z of a basis, solved afresh: pivots have gathered rounding; None if it is no solution.

    ``shift``: what was added to the diagonal for the pivots. Its share is taken out again by proximal points
    (Martinet 1970), which also go where A itself is singular, as where contacts share a load.
    """
    size = len(q)
    z: Floats = np.zeros(size)
    active = np.sort(basis[(basis >= size) & (basis < 2 * size)] - size)
    if len(active):
        try:
            kept, wanted = a[np.ix_(active, active)], -q[active]
            shifted = kept + shift * np.eye(len(active))
            z[active] = linear.solve(shifted, wanted)
            for _ in range(PROXIMAL if shift else 0):
                z[active] += linear.solve(shifted, wanted - linear.product(kept, z[active]))
        except np.linalg.LinAlgError:
            return None
    scale = 1.0 + float(np.abs(z).max(initial=0.0))
    if not np.isfinite(z).all() or z.min(initial=0.0) < -1e-6 * scale:
        return None
    w = linear.product(a, z) + q
    w[active] = 0.0
    if w.min(initial=0.0) < -1e-9 * (1.0 + float(np.abs(q).max(initial=0.0))):
        return None  # rounding has led the pivots to a basis that is no solution
    return np.maximum(z, 0.0)
