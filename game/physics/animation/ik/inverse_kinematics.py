"""Inverse kinematics: the end of a chain of bones is taken to a target, by one of several methods.

The methods are one file each (ik_gradient, ik_buss, ik_armijo, ik_damped, ik_ccd, ik_fabrik); here is what
hands them a skeleton's bones, and many targets at once.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Floats
from game.compiler.decorator import kernel
from game.physics.animation.ik import chain as c
from game.physics.animation.ik.chain import chain_of
from game.physics.animation.ik.solver import ENDINGS, METHODS, solve_links
from game.physics.animation.skeleton import LARGEST, Skeleton, SkeletonError
from game.physics.kernels import elementary

Point = Sequence[float] | Floats  # (2,)
CLOSE = 1e-6  # m, of the target
MOST_ITERATIONS = 1_000
ADAPTED = "damped"  # the best method but for chains without limits, where FABRIK is quicker


class Solution(NamedTuple):
    """What solving led to: error left (m), iterations, times the chain was placed, and why it ended."""

    error: float
    iterations: int
    placings: int
    ending: str


class Solutions(NamedTuple):
    """The same for many targets: angles (m, n) rad of the chain's bones, errors (m,) m, counts (m,)."""

    angles: Floats
    errors: Floats
    iterations: NDArray[np.int64]
    placings: NDArray[np.int64]


@kernel(_nrt=False)
def take_base(first, parents, bases, world, base):
    """Write where the bone ``first`` begins, and the angle of the frame that it hangs in."""
    p = parents[first]
    base[0], base[1], base[2] = bases[first, 0], bases[first, 1], 0.0
    if p >= 0:
        base[2] = elementary.atan2(world[p, 1, 0], world[p, 0, 0])


@kernel(_nrt=False)
def take_links(bones, angles, lower, upper, limited, turns, links):
    """Write angles and limits of a chain's links from those of its bones."""
    for i in range(bones.shape[0]):
        k = bones[i]
        low, high = -math.inf, math.inf
        if limited:
            low, high = lower[k], upper[k]
        links[c.ANGLE, i] = min(max(angles[k], low), high) + turns[i]
        links[c.LOWER, i], links[c.UPPER, i] = low + turns[i], high + turns[i]


@kernel(_nrt=False)
def give_links(bones, turns, links, angles):
    """Write the angles of a chain's links back to its bones."""
    for i in range(bones.shape[0]):
        angles[bones[i]] = links[c.ANGLE, i] - turns[i]


class Solver:
    """A chain of a skeleton, ready to be solved again and again without allocating anything large.

    start, end: bones. `history` (h,) holds the errors (m) before each iteration of the last solution, and
    after the last; `count` says how many. SkeletonError if the bones do not hang together.
    """

    def __init__(self, skeleton: Skeleton, start: int, end: int, remembered: int = 0) -> None:
        self.skeleton = skeleton
        self.chain = chain_of(skeleton, start, end)
        self.history = np.zeros(remembered)
        self.count = 0
        self._reach = self.chain.reach
        self._first = int(self.chain.bones[0])
        self._start, self._found = np.zeros((1, self.length)), np.zeros((1, 4))
        self._targets = np.zeros((1, 2))

    @property
    def length(self) -> int:
        """Number of bones in the chain."""
        return len(self.chain.bones)

    @property
    def root(self) -> tuple[float, float]:
        """Where the chain begins, m."""
        x, y = self.skeleton.bases[self.chain.bones[0]].tolist()
        return x, y

    def solve(
        self,
        target: Point,
        method: str = ADAPTED,
        tolerance: float = CLOSE,
        iterations: int = MOST_ITERATIONS,
        *,
        step: float = 1.0,
        damping: float = 0.1,
        limited: bool = True,
        keep_best: bool = True,
    ) -> Solution:
        """Take the end of the chain as near to a target (2,) m as it goes; the skeleton is posed so.

        step: of the fixed-step gradient, over the safe one. damping: λ of ``damped-fixed`` over the reach.
        SkeletonError for a target that is not finite, an unknown method, or numbers that make no sense.
        """
        self._targets[0, 0], self._targets[0, 1] = _target(target)
        if not (0.0 < step <= 1e6 and 0.0 < damping <= 1e6):
            raise SkeletonError(f"step, damping: expected more than 0, got {step!r} and {damping!r}")
        chain, skeleton = self.chain, self.skeleton
        self._take(limited)
        self._start[0] = chain.links[c.ANGLE]
        chain.numbers[c.STEP], chain.numbers[c.DAMPING] = step, damping * self._reach
        found = self._run(
            method, tolerance, iterations, keep_best, self._start, self._targets, self.history, self._found
        )
        give_links(chain.bones, chain.turns, chain.links, skeleton.angles)
        skeleton.update()
        error, count, placings, ending = found[0].tolist()
        self.count = min(int(count) + 1, len(self.history))
        return Solution(error, int(count), int(placings), ENDINGS[int(ending)])

    def solve_each(
        self,
        targets: ArrayLike,
        method: str = ADAPTED,
        tolerance: float = CLOSE,
        iterations: int = MOST_ITERATIONS,
        limited: bool = True,
        keep_best: bool = True,
    ) -> Solutions:
        """Solve for many targets (m, 2) m, each from the present pose, which stays.

        SkeletonError unless all are finite numbers within the world.
        """
        targets = np.array(targets, dtype=np.float64, order="C")
        if targets.ndim != 2 or targets.shape[1] != 2 or not np.all(np.abs(targets) <= LARGEST):
            raise SkeletonError("targets: expected finite numbers (m, 2)")
        chain = self.chain
        self._take(limited)
        chain.numbers[c.STEP], chain.numbers[c.DAMPING] = 1.0, 0.1 * self._reach
        angles = np.repeat(chain.links[c.ANGLE : c.ANGLE + 1], len(targets), axis=0)
        found = np.empty((len(targets), 4))
        self._run(method, tolerance, iterations, keep_best, angles, targets, self.history[:0], found)
        counts = found.astype(np.int64)
        return Solutions(angles - chain.turns, found[:, 0].copy(), counts[:, 1], counts[:, 2])

    def _take(self, limited: bool) -> None:
        """Base, angles and limits of the links as the skeleton has them now."""
        skeleton, chain = self.skeleton, self.chain
        take_base(self._first, skeleton.parents, skeleton.bases, skeleton.world, chain.base)
        take_links(
            chain.bones, skeleton.angles, skeleton.lower, skeleton.upper, limited, chain.turns, chain.links
        )

    def _run(
        self, method: str, tolerance: float, iterations: int, keep_best: bool, start: Floats, targets: Floats,
        history: Floats, found: Floats,
    ) -> Floats:  # fmt: skip
        number, chain = _method(method, tolerance, iterations), self.chain
        numbers = chain.numbers
        numbers[c.TOLERANCE], numbers[c.ITERATIONS], numbers[c.KEEP_BEST] = tolerance, iterations, keep_best
        solve_links(number, chain.base, chain.links, start, targets, chain.points, numbers, history, found)
        return found


def solve_ik(
    skeleton: Skeleton,
    chain: tuple[int, int] | Solver,
    target: Point,
    method: str = ADAPTED,
    tolerance: float = CLOSE,
    iterations: int = MOST_ITERATIONS,
    *,
    step: float = 1.0,
    damping: float = 0.1,
    limited: bool = True,
    keep_best: bool = True,
) -> Solution:
    """Take the end of a chain of bones to a target (2,) m; see `Solver.solve`.

    chain: first and last bone, or a Solver made of them, which saves its making.
    """
    solver = chain if isinstance(chain, Solver) else Solver(skeleton, *chain)
    return solver.solve(
        target, method, tolerance, iterations,
        step=step, damping=damping, limited=limited, keep_best=keep_best,
    )  # fmt: skip


def _target(target: Point) -> tuple[float, float]:
    x, y = float(target[0]), float(target[1])
    if not (abs(x) <= LARGEST and abs(y) <= LARGEST):
        raise SkeletonError(f"target: expected two finite numbers, got {target!r}")
    return x, y


def _method(method: str, tolerance: float, iterations: int) -> int:
    if method not in METHODS:
        raise SkeletonError(f"method {method!r}: expected one of {', '.join(METHODS)}")
    if not 0.0 < tolerance < math.inf:
        raise SkeletonError(f"tolerance: expected more than 0 m, got {tolerance!r}")
    if isinstance(iterations, bool) or int(iterations) != iterations or iterations < 1:
        raise SkeletonError(f"iterations: expected a whole number above 0, got {iterations!r}")
    return METHODS.index(method)
