"""Outlines to choose from, in m, each in a frame of its own."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.physics.kernels import elementary
from game.physics.solids.outlines import clean_outline

ROUND = 48  # corners of a disc


def _box(width: float, height: float) -> list[tuple[float, float]]:
    w, h = 0.5 * width, 0.5 * height
    return [(-w, -h), (w, -h), (w, h), (-w, h)]


def _disc(radius: float) -> list[tuple[float, float]]:
    turns = [math.tau * k / ROUND for k in range(ROUND)]
    return [(radius * elementary.cos(one), radius * elementary.sin(one)) for one in turns]


SHAPES = {
    "beam": _box(0.6, 0.24),
    "square": _box(0.36, 0.36),
    "triangle": [(0.0, -0.3), (0.26, 0.15), (-0.26, 0.15)],
    "hull": [
        (-0.36, 0.14), (-0.29, -0.04), (-0.17, -0.14), (0.0, -0.18), (0.17, -0.14), (0.29, -0.04),
        (0.36, 0.14),
    ],
    "disc": _disc(0.18),
    "plank": [(-0.03, 0.0), (0.03, 0.0), (0.03, 0.7), (-0.03, 0.7)],
}  # fmt: skip
PLANK = 0.7  # m, its length; it hangs on a hinge at its lower end
LEAST_AREA = 0.002  # m², of what is drawn


def outline_of(points: ArrayLike) -> Floats:
    """(n, 2) m of a drawn line, closed. ValueError, with the reason, for what is none."""
    corners = clean_outline("outline", points)
    x, y = corners.T
    area = 0.5 * float((x * np.roll(y, -1) - np.roll(x, -1) * y).sum())
    if area < LEAST_AREA:
        raise ValueError("outline: it is too small")
    return corners
