"""Least value of a rough function of several numbers, from values only.

The covariance matrix adaptation of Hansen and Ostermeier 2001 (Completely derandomized self-adaptation in
evolution strategies), with the constants of Hansen's tutorial (2016) for a population of LAMBDA.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementary, elementwise, linear

LAMBDA = 10
MU = LAMBDA // 2
WEIGHTS = elementwise.log(MU + 0.5) - elementwise.log(np.arange(1, MU + 1))
WEIGHTS /= WEIGHTS.sum()
MU_EFF = 1.0 / float((WEIGHTS * WEIGHTS).sum())


class Evolution:
    """Where the search is: mean (n,), in the function's own units; and the shape of its steps."""

    def __init__(self, start: Floats, steps: Floats, seed: int) -> None:
        """steps (n,): how far to look at first in each number. ValueError if one is not positive."""
        if not (steps > 0.0).all():
            raise ValueError("evolution: every first step must be positive")
        n = len(start)
        self.mean = start.astype(np.float64)
        self._units = steps.astype(np.float64)
        self._chance = np.random.default_rng(seed)
        self._size = 1.0
        self._covariance = np.eye(n)
        self._path = np.zeros(n)
        self._size_path = np.zeros(n)
        self._turns = 0

    def turn(self, value: Callable[[Floats], float]) -> float:
        """One generation: asks for LAMBDA values, moves the mean. Returns the least of them."""
        lengths, axes = linear.eigenvectors(self._covariance)
        lengths = np.sqrt(np.maximum(lengths, 1e-20))
        steps = linear.product(self._chance.standard_normal((LAMBDA, len(self.mean))) * lengths, axes.T)
        values = [value(self.mean + self._units * self._size * step) for step in steps]
        order = np.argsort(values, kind="stable")[:MU]
        self._turns += 1
        self._move(steps[order], axes, lengths)
        return float(values[order[0]])

    def _move(self, steps: Floats, axes: Floats, lengths: Floats) -> None:
        """Move the mean to the weighted best steps (MU, n), and adapt shape and size to them."""
        n = len(self.mean)
        for_path = (4.0 + MU_EFF / n) / (n + 4.0 + 2.0 * MU_EFF / n)
        for_size = (MU_EFF + 2.0) / (n + MU_EFF + 5.0)
        rank_one = 2.0 / (elementary.square(n + 1.3) + MU_EFF)
        rank_mu = min(
            1.0 - rank_one, 2.0 * (MU_EFF - 2.0 + 1.0 / MU_EFF) / (elementary.square(n + 2.0) + MU_EFF)
        )
        damping = 1.0 + 2.0 * max(0.0, math.sqrt((MU_EFF - 1.0) / (n + 1.0)) - 1.0) + for_size
        expected = math.sqrt(n) * (1.0 - 1.0 / (4.0 * n) + 1.0 / (21.0 * n * n))
        step = linear.product(WEIGHTS, steps)
        self.mean = self.mean + self._units * self._size * step
        white = linear.product(axes, (linear.product(axes.T, step)) / lengths)
        self._size_path *= 1.0 - for_size
        self._size_path += math.sqrt(for_size * (2.0 - for_size) * MU_EFF) * white
        length = float(np.sqrt((self._size_path * self._size_path).sum()))
        settled = math.sqrt(1.0 - elementary.pow(1.0 - for_size, 2 * self._turns))
        goes_on = 1.0 if length / settled < (1.4 + 2.0 / (n + 1.0)) * expected else 0.0
        self._path *= 1.0 - for_path
        self._path += goes_on * math.sqrt(for_path * (2.0 - for_path) * MU_EFF) * step
        self._covariance *= 1.0 - rank_one - rank_mu
        self._covariance += rank_one * np.outer(self._path, self._path)
        self._covariance += linear.product(rank_mu * (steps.T * WEIGHTS), steps)
        self._size *= elementary.exp(for_size / damping * (length / expected - 1.0))
