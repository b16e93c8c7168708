"""The picture between two states: blending by the short way, and never across a jump.

``alpha`` is 0 for the older state and goes towards 1 for the newer. All of it is for drawing only; no state
is ever made from blended values. Where the two states do not match (something was born or removed), the
newer one is shown.
"""

from __future__ import annotations

import math

import numpy as np

from game.physics.kernels import elementwise

_STRAIGHT = 1.0 - 1e-9  # cosine above which the arc between two unit quaternions is as good as its chord


def jumped(before: np.ndarray, now: np.ndarray, limit: float) -> np.ndarray:
    """Which rows of two (n, d) arrays lie further apart than ``limit``, (n,) bool: those were teleported."""
    apart = np.subtract(now, before)
    return np.sqrt(np.sum(apart * apart, axis=-1)) > limit


def blend(before: np.ndarray, now: np.ndarray, alpha: float, jumps: np.ndarray | None = None) -> np.ndarray:
    """Positions (n, ...) or plain numbers between two states, of their shape; rows in ``jumps`` (n,) are the
    newer ones.
    """
    if np.shape(before) != np.shape(now):
        return np.array(now, dtype=np.float64)
    result = before + alpha * np.subtract(now, before)
    return _with_jumps(result, now, jumps)


def blend_angles(
    before: np.ndarray, now: np.ndarray, alpha: float, jumps: np.ndarray | None = None
) -> np.ndarray:
    """Angles between two states, rad, turned by the short way; half a turn goes counterclockwise."""
    if np.shape(before) != np.shape(now):
        return np.array(now, dtype=np.float64)
    turn = np.subtract(now, before)
    turn = turn - 2.0 * math.pi * np.ceil(turn / (2.0 * math.pi) - 0.5)
    return _with_jumps(before + alpha * turn, now, jumps)


def blend_quaternions(
    before: np.ndarray, now: np.ndarray, alpha: float, jumps: np.ndarray | None = None
) -> np.ndarray:
    """Orientations (n, 4), scalar first, between two states, by the short way at an even rate.

    Shoemake 1985, "Animating rotation with quaternion curves" (slerp). The older one is negated where that
    is the shorter arc: q and -q are one orientation.
    """
    if np.shape(before) != np.shape(now):
        return np.array(now, dtype=np.float64)
    cosine = np.sum(np.multiply(before, now), axis=-1, keepdims=True)
    start = np.where(cosine < 0.0, np.negative(before), before)
    cosine = np.minimum(np.abs(cosine), 1.0)
    angle = elementwise.arccos(cosine)
    sine = elementwise.sin(angle)
    straight = cosine > _STRAIGHT
    divisor = np.where(straight, 1.0, sine)
    first = np.where(straight, 1.0 - alpha, elementwise.sin((1.0 - alpha) * angle) / divisor)
    second = np.where(straight, alpha, elementwise.sin(alpha * angle) / divisor)
    result = first * start + second * now
    length = np.sqrt(np.sum(result * result, axis=-1, keepdims=True))
    result = np.where(length > 0.0, result / np.where(length > 0.0, length, 1.0), now)
    return _with_jumps(result, now, jumps)


def _with_jumps(result: np.ndarray, now: np.ndarray, jumps: np.ndarray | None) -> np.ndarray:
    if jumps is not None and np.any(jumps):
        result[jumps] = np.asarray(now)[jumps]
    return result
