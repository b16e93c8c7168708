"""Skeletons changed by hand: which bone is at a point."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from game.physics.animation.skeleton import Skeleton
from game.physics.animation.weights import distances_to_bones
from game.physics.kernels import elementary

NOWHERE = -1
SHORTEST = 1e-6  # m, of a bone that is made by hand
Point = Sequence[float]


def bone_at(skeleton: Skeleton, point: Point, reach: float) -> int:
    """The bone nearest to a point, NOWHERE if none is within ``reach`` m.

    Of bones about equally near, as at a joint, the one whose own middle is nearest.
    """
    at = np.array([point], dtype=np.float64)
    distances = distances_to_bones(at, skeleton.bases, skeleton.ends)[0]
    nearest = float(distances.min())
    if not nearest <= reach:
        return NOWHERE
    middles = 0.5 * (skeleton.bases + skeleton.ends)
    off = np.sqrt((elementary.square(middles - at)).sum(axis=1))
    off[distances > nearest + 0.2 * reach] = math.inf
    return int(np.argmin(off))
