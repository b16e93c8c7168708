"""Rows of ultrasonic transducers that face each other, and the phases that make a trap."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.physics.acoustics.field import COLUMNS, PHASE, STRENGTH, aim
from game.physics.kernels import elementwise

PATTERNS = ("focus", "plane")
MOST_TRANSDUCERS = 400


class PhasedArray:
    """Transducers with a phase each. sources: (n, 6), see `field`; rows: (n,) which row each stands in."""

    def __init__(self, places: ArrayLike, axes: ArrayLike, rows: ArrayLike, strength: float):
        """places: (n, 2) m; axes: (n, 2) unit vectors; strength: Pa m. ValueError for nonsense."""
        where, facing = np.array(places, dtype=np.float64), np.array(axes, dtype=np.float64)
        self.rows = np.array(rows, dtype=np.int64)
        if where.ndim != 2 or where.shape[1] != 2 or not 1 <= len(where) <= MOST_TRANSDUCERS:
            raise ValueError(f"places: expected 1 to {MOST_TRANSDUCERS} points, not {where.shape}")
        if facing.shape != where.shape or self.rows.shape != (len(where),):
            raise ValueError("axes and rows: expected one for each place")
        if not (np.isfinite(where).all() and np.allclose(elementwise.hypot(*facing.T), 1.0)):
            raise ValueError("places: expected finite numbers; axes: of length 1")
        self.sources: Floats = np.zeros((len(where), COLUMNS))
        self.sources[:, :2], self.sources[:, 2:4] = where, facing
        self.set_strength(strength)

    def set_strength(self, strength: float) -> None:
        """Pressure times distance on the axis of each, Pa m; ValueError unless finite and at least 0."""
        if not 0.0 <= strength < math.inf:
            raise ValueError(f"strength = {strength!r}: expected a finite number, at least 0 Pa m")
        self.sources[:, STRENGTH] = strength

    def offsets(self) -> Floats:
        """Phases (n,) rad that are added so that the pressure vanishes where the sound is aimed at.

        Of two rows that face each other one is turned by half a wave: a node of the pressure. A second pair
        is a quarter ahead, so that the two pairs add as squares and the trap is as stiff both ways.
        """
        return np.asarray(np.choose(self.rows, (0.0, math.pi, 0.5 * math.pi, 1.5 * math.pi)))

    def focus(self, number: float, place: tuple[float, float], offsets: Floats) -> None:
        """Aim all at a place (m); number: of the wave, 1/m."""
        aim(self.sources, number, float(place[0]), float(place[1]), offsets)

    def level(self, number: float, place: tuple[float, float], offsets: Floats) -> None:
        """Plane waves from each row, with a node through a place (m)."""
        axes, away = self.sources[:, 2:4], np.asarray(place) - self.sources[:, :2]
        self.sources[:, PHASE] = offsets - number * np.sum(axes * away, axis=1)


def facing_rows(rows: int, count: int, pitch: float, distance: float, strength: float) -> PhasedArray:
    """Two rows (below and above) or four (left and right too) about the origin, ``distance`` (m) apart.

    count: transducers of a row; pitch: m from one to the next; strength: Pa m. ValueError for nonsense.
    """
    if rows not in (2, 4):
        raise ValueError(f"rows = {rows!r}: expected 2 or 4")
    if not (1 <= count <= MOST_TRANSDUCERS // rows and 0.0 < pitch < 1.0 and 0.0 < distance < 10.0):
        raise ValueError(f"count, pitch, distance = {count}, {pitch}, {distance}: out of range")
    along = pitch * (np.arange(count) - 0.5 * (count - 1))
    half = np.full(count, 0.5 * distance)
    ones, zeros = np.ones(count), np.zeros(count)
    places = [np.stack([along, -half], 1), np.stack([along, half], 1)]
    axes = [np.stack([zeros, ones], 1), np.stack([zeros, -ones], 1)]
    if rows == 4:
        places += [np.stack([-half, along], 1), np.stack([half, along], 1)]
        axes += [np.stack([ones, zeros], 1), np.stack([-ones, zeros], 1)]
    numbers = np.repeat(np.arange(rows), count)
    return PhasedArray(np.concatenate(places), np.concatenate(axes), numbers, strength)
