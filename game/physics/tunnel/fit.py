"""Coefficients over the angle of attack, fitted by least squares: a Fourier series, or the plates' law.

The series is what spherical harmonics of the wind's direction (Martin, Umetani and Bickel 2015) are in a
plane: 1, cos k alpha, sin k alpha up to k = order, for drag, lift and moment each.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.physics.kernels import elementwise, linear

MOST_ORDER = 16


class SeriesFit(NamedTuple):
    """order; coefficients (3, 2 order + 1): of 1, cos, sin, cos 2, sin 2, ... for drag, lift and moment;
    residual (3,): root mean square at the angles that it was given.
    """

    order: int
    coefficients: Floats
    residual: Floats

    def at(self, angles: ArrayLike) -> Floats:
        """(n, 3) drag, lift and moment at angles (n,) rad."""
        return np.asarray(linear.product(basis(angles, self.order), self.coefficients.T))

    def error(self, angles: ArrayLike, values: ArrayLike) -> Floats:
        """(3,) root mean square of how far it is from values (n, 3) at angles (n,) rad; 0 for none."""
        given = np.asarray(values, dtype=np.float64).reshape(-1, 3)
        if not len(given):
            return np.zeros(3)
        away = self.at(angles) - given
        return np.asarray(np.sqrt(np.mean(away * away, axis=0)))


class PlateFit(NamedTuple):
    """What the law of Andersen, Pesavento and Wang (2005) makes of it: C_D = A - B cos 2 alpha, C_L = C_T sin
    2 alpha. residual (2,) of drag and lift.
    """

    drag: float
    drag_turn: float
    glide: float
    residual: Floats


def basis(angles: ArrayLike, order: int) -> Floats:
    """(n, 2 order + 1)."""
    given = np.atleast_1d(np.asarray(angles, dtype=np.float64))
    columns = [np.ones_like(given)]
    for k in range(1, order + 1):
        columns += [elementwise.cos(k * given), elementwise.sin(k * given)]
    return np.stack(columns, axis=1)


def _least_squares(matrix: Floats, values: Floats) -> Floats:
    """x of least |matrix x - values|, by the normal equations (bases here are nearly orthogonal)."""
    return linear.solve(linear.product(matrix.T, matrix), linear.product(matrix.T, values))


def fit_series(angles: ArrayLike, values: ArrayLike, order: int) -> SeriesFit:
    """A series of at most this order through values (n, 3) at angles (n,) rad that go round the whole turn.

    The order shrinks until it asks for no more than there are different angles. ValueError, naming it, for
    too few of them or an order below 0.
    """
    given, wanted = np.asarray(angles, dtype=np.float64), np.asarray(values, dtype=np.float64)
    if given.ndim != 1 or wanted.shape != (len(given), 3) or not np.isfinite(wanted).all() or len(given) < 3:
        raise ValueError("angles: expected at least three, and finite values (n, 3) for them")
    if isinstance(order, bool) or not isinstance(order, int) or not 0 <= order <= MOST_ORDER:
        raise ValueError(f"order = {order!r}: expected a whole number from 0 to {MOST_ORDER}")
    different = len({round(math.remainder(angle, 2.0 * math.pi) * 1e6) for angle in given.tolist()})
    used = min(order, (different - 1) // 2)
    found = SeriesFit(used, np.zeros((3, 2 * used + 1)), np.zeros(3))
    found.coefficients[:] = _least_squares(basis(given, used), wanted).T
    return found._replace(residual=found.error(given, wanted))


def fit_plate(angles: ArrayLike, values: ArrayLike) -> PlateFit:
    """A, B and C_T of the plates' law by values (n, 3) at angles (n,) rad, with A kept at |B| at least."""
    given, wanted = np.asarray(angles, dtype=np.float64), np.asarray(values, dtype=np.float64)
    if given.ndim != 1 or wanted.shape != (len(given), 3) or not np.isfinite(wanted).all() or len(given) < 3:
        raise ValueError("angles: expected at least three, and finite values (n, 3) for them")
    twice = 2.0 * given
    even, odd = np.stack([np.ones_like(given), -elementwise.cos(twice)], axis=1), elementwise.sin(twice)
    drag, turn = _least_squares(even, wanted[:, 0]).tolist()
    drag = max(drag, abs(turn))
    glide = float(np.sum(odd * wanted[:, 1])) / max(float(np.sum(odd * odd)), 1e-300)
    away = np.stack([drag * even[:, 0] + turn * even[:, 1], glide * odd], axis=1) - wanted[:, :2]
    return PlateFit(drag, turn, glide, np.asarray(np.sqrt(np.mean(away * away, axis=0))))
