"""A chain of links that is to reach a target: its points, the pull of the error on its joints, its limits.

Link i turns by angle i against the link before it; the first one against the frame that the chain hangs in.
With the error e = target - end, the gradient of |e|² / 2 by the angles is -Jᵀe, and in the plane

    (Jᵀe)_i = (end - p_i) × e        p_i: where joint i is

so no matrix is ever made. All methods share these kernels and are one file each.

Arrays: links (LINK_ROWS, n); points (n + 1, 2) m, joints and end; base (3,): x, y (m) and angle (rad) of the
frame; target (2,) m; numbers (NUMBERS,), what a method keeps between iterations.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.compiler.decorator import kernel
from game.physics.animation.skeleton import Skeleton, SkeletonError
from game.physics.kernels import elementary

FULL_TURN = 2.0 * math.pi

# rows of a chain's numbers for each link
LENGTH, ANGLE, LOWER, UPPER, BEST, PULL, TRIAL = range(7)
LINK_ROWS = 7

# the numbers that a method has, what it keeps from one iteration to the next, and when and where it ends
STEP, DAMPING, MEMORY, REACH_SQUARE, TOLERANCE, ITERATIONS, KEEP_BEST, AIM_X, AIM_Y = range(9)
NUMBERS = 9


@kernel(_nrt=False)
def place_points(base, links, row, points):
    """Write joints and end (n + 1, 2) of a chain with the angles in ``row``; base: x, y (m), angle (rad)."""
    x, y, angle = base[0], base[1], base[2]
    points[0, 0], points[0, 1] = x, y
    for i in range(links.shape[1]):
        angle += links[row, i]
        x += links[LENGTH, i] * elementary.cos(angle)
        y += links[LENGTH, i] * elementary.sin(angle)
        points[i + 1, 0], points[i + 1, 1] = x, y


@kernel(inline="always")
def error_of(points, target):
    """Distance (m) of the end of a chain from the target."""
    n = points.shape[0] - 1
    ex, ey = target[0] - points[n, 0], target[1] - points[n, 1]
    return math.sqrt(ex * ex + ey * ey)


@kernel(_nrt=False)
def pull_joints(points, target, links):
    """Write Jᵀe (m²) into the links' row PULL; gives its length."""
    n = links.shape[1]
    x, y = points[n, 0], points[n, 1]
    ex, ey = target[0] - x, target[1] - y
    square = 0.0
    for i in range(n):
        pull = (x - points[i, 0]) * ey - (y - points[i, 1]) * ex
        links[PULL, i] = pull
        square += pull * pull
    return math.sqrt(square)


@kernel(inline="always")
def follow_pull(links, points):
    """JJᵀe (m³): how the end moves if each joint turns by its row PULL."""
    n = links.shape[1]
    x, y = points[n, 0], points[n, 1]
    mx, my = 0.0, 0.0
    for i in range(n):
        mx -= (y - points[i, 1]) * links[PULL, i]
        my += (x - points[i, 0]) * links[PULL, i]
    return mx, my


@kernel(inline="always")
def turn_joints(links, step):
    """Turn each joint by ``step`` times its row PULL, within its limits."""
    for i in range(links.shape[1]):
        angle = links[ANGLE, i] + step * links[PULL, i]
        links[ANGLE, i] = min(max(angle, links[LOWER, i]), links[UPPER, i])


@kernel(inline="always")
def squared_reach(links):
    """Σ r_i² (m²) of the chain stretched out: the largest eigenvalue that J Jᵀ can have."""
    r, total = 0.0, 0.0
    for i in range(links.shape[1] - 1, -1, -1):
        r += links[LENGTH, i]
        total += r * r
    return total


@kernel(inline="always")
def copy_row(links, source, goal):
    """Copy one row of the links' numbers."""
    for i in range(links.shape[1]):
        links[goal, i] = links[source, i]


@kernel(inline="always")
def turn_between(ax, ay, bx, by):
    """Angle (rad) from one direction to another, the short way; 0 if one of them is none."""
    cross, dot = ax * by - ay * bx, ax * bx + ay * by
    return elementary.atan2(cross, dot) if cross != 0.0 or dot != 0.0 else 0.0


class Chain(NamedTuple):
    """A run of bones of a skeleton, each the parent of the next, and space to solve it in.

    bones (n,); links (LINK_ROWS, n); turns (n,) rad: what to add to a bone's angle for its link's; points
    (n + 1, 2); base (3,); numbers (NUMBERS,).
    """

    bones: NDArray[np.int64]
    links: Floats
    turns: Floats
    points: Floats
    base: Floats
    numbers: Floats

    @property
    def reach(self) -> float:
        """Length stretched out, m."""
        return float(self.links[LENGTH].sum())

    @property
    def hole(self) -> float:
        """Distance from its root below which nothing can be reached, m: 2 l_max - Σ l, or 0."""
        lengths = self.links[LENGTH]
        return max(0.0, 2.0 * float(lengths.max()) - float(lengths.sum()))


def chain_of(skeleton: Skeleton, start: int, end: int) -> Chain:
    """The chain from bone ``start`` to the end of ``end``; SkeletonError if they do not hang together."""
    bones = skeleton.path(start, end)
    vectors = [skeleton.offsets[i].tolist() for i in bones[1:]]
    vectors.append([float(skeleton.lengths[bones[-1]]), 0.0])
    links = np.zeros((LINK_ROWS, len(bones)))
    links[LENGTH] = [math.sqrt(x * x + y * y) for x, y in vectors]
    if not links[LENGTH].sum() > 0.0:
        raise SkeletonError("chain: has no length")
    directions = np.array([elementary.atan2(y, x) for x, y in vectors])
    turns = directions - np.concatenate([[0.0], directions[:-1]])
    return Chain(
        np.array(bones, dtype=np.int64), links, turns, np.zeros((len(bones) + 1, 2)), np.zeros(3),
        np.zeros(NUMBERS),
    )  # fmt: skip
