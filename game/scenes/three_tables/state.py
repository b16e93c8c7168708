"""The state of the three tables."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats


class ThreeTablesState(NamedTuple):
    """What is played, and where the balls are.

    start (n, 2) m and in_play (n,) of the shot; shot (8,): playing, time s, speed m/s, aim, offsets of the
    tip, elevation, strokes; cue (7,); places (3, n, 2) m on the three tables.
    """

    start: Floats
    in_play: NDArray[np.bool_]
    shot: Floats
    cue: Floats
    places: Floats


PLAYING, TIME, SPEED, AIM, LEFT, UP, ELEVATION, STROKES = range(8)
