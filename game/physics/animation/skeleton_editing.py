"""Skeletons made and changed by hand: which bone is at a point, a bone more, a bone less.

An edit gives a new skeleton; what it was made from stays as it was.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from game.physics.animation.skeleton import Indices, Skeleton, SkeletonError
from game.physics.animation.weights import distances_to_bones

NOWHERE = -1
SHORTEST = 1e-6  # m, of a bone that is made by hand
Point = Sequence[float]


class Removal(NamedTuple):
    """A skeleton without some bones, and where each old bone has gone (-1: away)."""

    skeleton: Skeleton
    place: Indices


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
    off = np.sqrt(((middles - at) ** 2).sum(axis=1))
    off[distances > nearest + 0.2 * reach] = math.inf
    return int(np.argmin(off))


def with_bone(skeleton: Skeleton, parent: int, end: Point) -> Skeleton:
    """One bone more, last in the list: from the end of ``parent`` to a point of the world.

    A parent of -1 lays a new root from the origin. SkeletonError if it would have no length.
    """
    frame = skeleton.world[skeleton.bone(parent)] if parent >= 0 else np.eye(3)
    start = skeleton.ends[parent] if parent >= 0 else np.zeros(2)
    dx, dy = float(end[0]) - float(start[0]), float(end[1]) - float(start[1])
    length = math.sqrt(dx * dx + dy * dy)
    if not length >= SHORTEST:
        raise SkeletonError(f"bone: its end must be at least {SHORTEST:g} m from its beginning")
    along = frame[0, 0] * dx + frame[1, 0] * dy
    across = frame[0, 0] * dy - frame[1, 0] * dx
    offset = (skeleton.lengths[parent], 0.0) if parent >= 0 else (0.0, 0.0)
    return Skeleton(
        np.append(skeleton.parents, parent),
        np.append(skeleton.lengths, length),
        np.append(skeleton.angles, math.atan2(across, along)),
        np.vstack([skeleton.offsets, offset]),
        np.append(skeleton.lower, -math.inf),
        np.append(skeleton.upper, math.inf),
    )


def without_bone(skeleton: Skeleton, bone: int) -> Removal:
    """A bone and all that hangs on it away. SkeletonError if nothing would be left."""
    bone = skeleton.bone(bone)
    stays = np.ones(skeleton.count, dtype=bool)
    for i in skeleton.order.tolist():
        parent = int(skeleton.parents[i])
        stays[i] = i != bone and (parent < 0 or bool(stays[parent]))
    if not np.any(stays):
        raise SkeletonError("bone: the last one cannot be taken away")
    place = np.where(stays, np.cumsum(stays) - 1, NOWHERE)
    parents = skeleton.parents[stays]
    left = Skeleton(
        np.where(parents >= 0, place[parents], NOWHERE),
        skeleton.lengths[stays],
        skeleton.angles[stays],
        skeleton.offsets[stays],
        skeleton.lower[stays],
        skeleton.upper[stays],
    )
    return Removal(left, place)
