"""Rows of the tables of a model: a ball, a gate, a gauge; and what is heard."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

# of a ball: its body while it is loose (RIDES: it rolls on a track, or flies), gate that holds it (NONE),
# delay s after that, time at which it was let go (NOT_YET), rod that it hangs on (NONE), where it was let go
# (m), highest place since (m), friction of its own (NONE: the parameter's)
BODY, GATE, DELAY, FREED, ROD, FROM_X, FROM_Y, HIGHEST, GRIP = range(9)
BALL_WIDTH = 9
RIDES, NONE, NOT_YET = -1.0, -1.0, -1.0
STEEL = 7.8  # kg/m² of a slice, water being 1


def none_of(width: int) -> Floats:
    """An empty table."""
    return np.zeros((0, width))
