"""Types of arrays, as annotations say them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Singles = NDArray[np.float32]
Longs = NDArray[np.int64]
Samples = NDArray[np.int16]  # of sound, (n, 2)
Ints = NDArray[np.int32]
Flags = NDArray[np.bool_]
Inks = NDArray[np.uint32]  # colours as pixels have them
Point = tuple[float, float]
