"""Which bones a point of the skin follows, and by how much: weights from its distance to all bones.

    w_i = (d_min / d_i)^p - (d_min / r)^p   for d_i < r,  else 0,     then divided by their sum

with the falloff p and the threshold r. It goes to 0 at the threshold without a jump. A point on a bone (d =
0) follows that bone alone, on a joint the bones that meet there by equal parts. A point beyond the threshold
of every bone follows the nearest one. Weights belong to the pose in which the skin is bound and are never
computed again while bones move, so nothing pops.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats, Ints
from game.compiler.decorator import kernel
from game.physics.animation.skeleton import Skeleton
from game.physics.kernels import elementary

FALLOFF = 3.0
INFLUENCES = 4  # bones that one point may follow


class WeightError(ValueError):
    """Weights, or points to be bound, that make no sense."""


@kernel
def measure_distances(points, bases, ends, distances):
    """Write the distances (v, n) m of points (v, 2) to bones as segments; without length: to a point."""
    for v in range(points.shape[0]):
        for i in range(bases.shape[0]):
            dx, dy = ends[i, 0] - bases[i, 0], ends[i, 1] - bases[i, 1]
            px, py = points[v, 0] - bases[i, 0], points[v, 1] - bases[i, 1]
            square = dx * dx + dy * dy
            part = (px * dx + py * dy) / square if square > 0.0 else 0.0
            part = min(max(part, 0.0), 1.0)
            px -= part * dx
            py -= part * dy
            distances[v, i] = math.sqrt(px * px + py * py)


@kernel
def weigh(distances, threshold, falloff, all_weights):
    """Write weights (v, n) that sum up to 1 for distances (v, n) m."""
    n = distances.shape[1]
    for v in range(distances.shape[0]):
        nearest = 0
        for i in range(n):
            if distances[v, i] < distances[v, nearest]:
                nearest = i
        least = distances[v, nearest]
        total = 0.0
        if least < threshold:
            at_threshold = elementary.pow(least / threshold, falloff)
            for i in range(n):
                d = distances[v, i]
                weight = 0.0
                if d == least:
                    weight = 1.0 - at_threshold
                elif d < threshold:
                    weight = max(elementary.pow(least / d, falloff) - at_threshold, 0.0)
                all_weights[v, i] = weight
                total += weight
        if total > 0.0:
            for i in range(n):
                all_weights[v, i] /= total
        else:
            for i in range(n):
                all_weights[v, i] = 1.0 if i == nearest else 0.0


@kernel
def keep_largest(all_weights, bones, weights):
    """Write the largest weights (v, k) of each point, falling, dividing by their sum, and whose they are."""
    n, most = all_weights.shape[1], weights.shape[1]
    for v in range(all_weights.shape[0]):
        for j in range(most):
            bones[v, j] = 0
            weights[v, j] = 0.0
        for i in range(n):
            weight = all_weights[v, i]
            j = most
            while j > 0 and weight > weights[v, j - 1]:
                j -= 1
            if j < most:
                for m in range(most - 1, j, -1):
                    weights[v, m] = weights[v, m - 1]
                    bones[v, m] = bones[v, m - 1]
                weights[v, j] = weight
                bones[v, j] = i
        total = 0.0
        for j in range(most):
            total += weights[v, j]
        for j in range(most):
            weights[v, j] /= total


def distances_to_bones(points: Floats, bases: Floats, ends: Floats) -> Floats:
    """Distances (v, n) m of points (v, 2) to bones from ``bases`` to ``ends`` (n, 2)."""
    distances = np.empty((len(points), len(bases)))
    measure_distances(points, bases, ends, distances)
    return distances


class Binding:
    """A skin bound to a skeleton: points (v, 2) m, and for each up to k bones with their weights (v, k).

    `inverse` (n, 3, 3): the bones' frames at the time of binding, inverted. Weights fall along a row and sum
    up to 1. WeightError if a frame cannot be inverted, or if what is given is no set of weights.
    """

    def __init__(self, points: Floats, bones: Ints, weights: Floats, frames: Floats) -> None:
        self.points, self.bones, self.weights = points, bones, weights
        self.inverse = invert_frames(frames)
        self.check()

    def dense(self) -> Floats:
        """Weights (v, n) of all bones."""
        dense = np.zeros((len(self.points), len(self.inverse)))
        np.add.at(dense, (np.arange(len(self.points))[:, None], self.bones), self.weights)
        return dense

    def check(self) -> None:
        """Raise WeightError unless all weights are in order."""
        if self.weights.shape != self.bones.shape or len(self.weights) != len(self.points):
            raise WeightError("weights: expected as many rows as points, and as many columns as bones")
        if not np.all((self.weights >= 0.0) & (self.weights <= 1.0)):
            raise WeightError("weights: expected finite numbers from 0 to 1")
        if np.any((self.bones < 0) | (self.bones >= len(self.inverse))):
            raise WeightError("weights: a bone that is not there")
        if len(self.weights) and np.abs(self.weights.sum(axis=1) - 1.0).max() > 1e-14:
            raise WeightError("weights: must sum up to 1")


def bind_weights(
    skeleton: Skeleton,
    points: ArrayLike,
    threshold: float = math.inf,
    falloff: float = FALLOFF,
    influences: int = INFLUENCES,
) -> Binding:
    """Bind points (v, 2) m to a skeleton in its present pose, by their distances to all bones.

    threshold: m, bones farther off do not count. falloff: how fast a weight falls with distance. influences:
    the most bones for a point; the largest weights are kept and made to sum up to 1. WeightError for what is
    not finite or not positive.
    """
    points = checked_points(points)
    if not threshold > 0.0:
        raise WeightError(f"threshold: expected more than 0 m, got {threshold!r}")
    if not 0.0 < falloff <= 64.0:
        raise WeightError(f"falloff: expected more than 0, at most 64, got {falloff!r}")
    distances = distances_to_bones(points, skeleton.bases, skeleton.ends)
    weigh(distances, float(threshold), float(falloff), distances)
    return _kept(skeleton, points, distances, influences)


def bind_given(
    skeleton: Skeleton, points: ArrayLike, weights: ArrayLike, influences: int = INFLUENCES
) -> Binding:
    """Bind points (v, 2) m with weights (v, n) given for all bones; they are made to sum up to 1.

    WeightError for a weight that is negative or not finite, and for a point without any.
    """
    points = checked_points(points)
    given = np.array(weights, dtype=np.float64, order="C")
    if given.shape != (len(points), skeleton.count):
        raise WeightError(f"weights: expected shape {(len(points), skeleton.count)}, got {given.shape}")
    if not np.all((given >= 0.0) & (given < math.inf)):
        raise WeightError("weights: expected finite numbers, 0 or more")
    largest = given.max(axis=1, initial=0.0)
    if np.any(largest == 0.0):
        raise WeightError(f"weights: point {int(np.argmax(largest == 0.0))} has none")
    return _kept(skeleton, points, given / largest[:, None], influences)


def checked_points(points: ArrayLike) -> Floats:
    """Points as (v, 2) m; WeightError unless they are finite and there is at least one."""
    array = np.array(points, dtype=np.float64, order="C")
    if array.ndim != 2 or array.shape[1] != 2 or len(array) == 0:
        raise WeightError(f"points: expected shape (v, 2) with v > 0, got {array.shape}")
    if not np.all(np.abs(array) <= 1e9):
        raise WeightError("points: expected finite numbers up to 1e9 m")
    return array


def invert_frames(frames: ArrayLike) -> Floats:
    """Inverses (n, 3, 3) of affine frames; WeightError naming a bone whose frame cannot be inverted."""
    frames = np.asarray(frames, dtype=np.float64)
    if frames.ndim != 3 or frames.shape[1:] != (3, 3) or not np.all(np.isfinite(frames)):
        raise WeightError("frames: expected finite 3 x 3 matrices")
    a, b, c, d = frames[:, 0, 0], frames[:, 0, 1], frames[:, 1, 0], frames[:, 1, 1]
    determinant = a * d - b * c
    size = np.maximum(a * a + c * c, b * b + d * d)
    flat = ~(np.abs(determinant) > 1e-12 * size)
    if np.any(flat):
        raise WeightError(f"frames: bone {int(np.argmax(flat))} has no area (scale 0) and cannot be bound")
    inverse = np.zeros(frames.shape)
    inverse[:, 0, 0], inverse[:, 0, 1] = d / determinant, -b / determinant
    inverse[:, 1, 0], inverse[:, 1, 1] = -c / determinant, a / determinant
    inverse[:, :2, 2] = -(inverse[:, :2, :2] * frames[:, None, :2, 2]).sum(axis=2)
    inverse[:, 2, 2] = 1.0
    return inverse


def _kept(skeleton: Skeleton, points: Floats, all_weights: Floats, influences: int) -> Binding:
    if isinstance(influences, bool) or not int(influences) >= 1 or int(influences) != influences:
        raise WeightError(f"influences: expected a whole number above 0, got {influences!r}")
    columns = min(int(influences), skeleton.count)
    bones = np.empty((len(points), columns), dtype=np.int32)
    weights = np.empty((len(points), columns))
    keep_largest(all_weights, bones, weights)
    return Binding(points, bones, weights, skeleton.world)
