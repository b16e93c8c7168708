"""Angles between key-frames: the shortest way round, and what happens to matrices that are mixed instead."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.physics.kernels import elementwise

TURN = 2.0 * math.pi


def shortest_turn(difference: ArrayLike, turn: float = TURN) -> Floats:
    """Differences of angles by the shortest way, in (-turn/2, turn/2]: half a turn goes counterclockwise.

    ``turn``: a whole turn in the unit of the angles, 2 pi rad. Shapes are kept.
    """
    plain = np.asarray(difference, dtype=np.float64)
    return np.asarray(plain - turn * np.ceil(plain / turn - 0.5))


def rotation(angle: ArrayLike) -> Floats:
    """Rotation matrices (..., 2, 2) of angles (...,) rad."""
    plain = np.asarray(angle, dtype=np.float64)
    cos, sin = elementwise.cos(plain), elementwise.sin(plain)
    return np.stack((np.stack((cos, -sin), axis=-1), np.stack((sin, cos), axis=-1)), axis=-2)


def mix_rotations(first: float, second: float, share: ArrayLike) -> Floats:
    """Rotation matrices (..., 2, 2) of two angles (rad), entries mixed by shares (...,): what not to do.

    The mix is a rotation only at its ends. Between, all lengths shrink by the cosine of the half angle or
    more, and for angles half a turn apart the matrix halfway is singular: the thing collapses to a point.
    """
    part = np.asarray(share, dtype=np.float64)[..., None, None]
    return np.asarray((1.0 - part) * rotation(first) + part * rotation(second))
