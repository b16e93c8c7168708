"""A convex core and its rounding: what kernels of collision are given of one shape."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray


class Hull(NamedTuple):
    """Corners start to start + size, anticlockwise, grown by a radius; a capsule has two, a disc one.

    start and size are int64 wherever a hull is made, so that each kernel is compiled once.
    """

    corners: NDArray[np.float64]  # (v, 2) m
    normals: NDArray[np.float64]  # (v, 2) outward normal of the edge that begins at the corner
    start: np.int64
    size: np.int64
    radius: float  # m
