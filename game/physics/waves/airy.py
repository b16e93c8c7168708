"""Low waves of any length in a tank of one depth, exactly: what shallow water leaves out.

A wave of wave number k on water of depth h swings at the rate (Airy 1845)

    w² = g k tanh(k h)

so long ones run ahead of short ones. In a tank with walls a level that is let go at rest is a sum of
cosines, and each swings by itself. It is added up anew for each time (Cauchy 1827, Poisson 1818).
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats
from game.compiler.decorator import kernel
from game.physics.kernels import elementary, elementwise

NOTHING = 1e-12  # of the highest: shares of modes that are left out at the end of the sum


def wave_rate(number: float, depth: float, gravity: float = 9.81) -> float:
    """rad/s of waves of a wave number (1/m) on water of a depth (m)."""
    return math.sqrt(gravity * number * elementary.tanh(number * depth))


@kernel
def add_cosines(shares, out):
    """out (n,) = the sum of shares (m,) times cos(k pi (i + 1/2) / n), by Clenshaw (1955)."""
    count = out.shape[0]
    for i in range(count):
        turn = 2.0 * elementary.cos(math.pi * (i + 0.5) / count)
        here, before = 0.0, 0.0
        for k in range(shares.shape[0] - 1, 0, -1):
            here, before = shares[k] + turn * here - before, here
        out[i] = shares[0] + 0.5 * turn * here - before


@kernel
def find_shares(level, shares):
    """The shares (n,) of cosines of which the level (n,) is the sum."""
    count = level.shape[0]
    for k in range(count):
        turn = 2.0 * elementary.cos(math.pi * k / count)
        here, before = 0.0, 0.0
        for i in range(count - 1, -1, -1):
            here, before = level[i] + turn * here - before, here
        # the sum of level[i] cos(k pi i / n), then the half cell's turn
        cosine = elementary.cos(0.5 * math.pi * k / count)
        shares[k] = (here - before) * cosine * (2.0 if k > 0 else 1.0) / count


class AiryTank:
    """A level (n,) m over still water, at rest, in a tank of cells (m) and one depth (m)."""

    def __init__(self, level: ArrayLike, cell: float, depth: float, gravity: float = 9.81):
        """ValueError for nonsense."""
        start: Floats = np.array(level, dtype=np.float64)
        if start.ndim != 1 or not len(start) or not np.isfinite(start).all():
            raise ValueError("level: expected a row of finite numbers")
        if not (0.0 < cell < math.inf and 0.0 < depth < math.inf and 0.0 <= gravity < math.inf):
            raise ValueError(f"cell, depth, gravity = {cell}, {depth}, {gravity}: expected lengths above 0 m")
        shares = np.zeros(len(start))
        find_shares(start, shares)
        most = float(np.max(np.abs(shares), initial=0.0))
        kept = np.nonzero(np.abs(shares) > NOTHING * most)[0]
        self.shares: Floats = shares[: int(kept[-1]) + 1 if len(kept) else 1]
        length = len(start) * cell
        self.rates: Floats = np.array(
            [wave_rate(math.pi * k / length, depth, gravity) for k in range(len(self.shares))]
        )
        self._count = len(start)

    def at(self, time: float) -> Floats:
        """The level (n,) m at a time (s) after it was let go."""
        out: Floats = np.zeros(self._count)
        add_cosines(self.shares * elementwise.cos(self.rates * time), out)
        return out
