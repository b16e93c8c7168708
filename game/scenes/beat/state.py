"""The state of the scene, as arrays."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

TAPPING, SEARCHING, PLAYING, SILENT = range(4)  # phases; silent: nothing is tapped, or nothing was found
COUNT, SIZE, PHASE, CLOCK = range(4)  # places of `numbers`


class BeatState(NamedTuple):
    """What later steps depend on."""

    taps: NDArray[np.float64]  # (16,) s since the first
    layout: NDArray[np.float64]  # (36,) see `level`
    numbers: NDArray[
        np.float64
    ]  # (4,) taps; numbers of the layout; phase; s since the first tap or the stroke
