"""Rows of the tables of a model: a domino, a ball, a sliding block; and what is heard."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

# of a domino: body (GONE: taken away), row, direction of its row, way from the one before it (m, 0: none),
# where its foot stood and how it leant, size, time at which it was struck (NOT_YET), and whether it stands
# on the level at the height of the one before it
BODY, ROW, TO, PITCH, FOOT_X, FOOT_Y, LEAN, THICK, TALL, STRUCK, LEVEL = range(11)
DOMINO_WIDTH = 11
# of a sliding block: body, friction with its lane, speed and place (m) at which it was measured, distance
SLIDER_BODY, SLIDER_MU, SLIDER_SPEED, SLIDER_X, SLIDER_Y, SLIDER_WAY = range(6)
SLIDER_WIDTH = 6
GONE, NOT_YET = -1.0, -1.0
MATERIALS = ("steel", "glass", "wood", "cork")
DENSITIES = {"steel": 7.8, "glass": 2.5, "wood": 0.7, "cork": 0.24}  # kg/m² of a slice, water being 1
BALL_KINDS = tuple(MATERIALS)


def none_of(width: int) -> Floats:
    """An empty table."""
    return np.zeros((0, width))
