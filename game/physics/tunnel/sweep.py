"""A sweep over the angle of attack: which angles, one after another, and what is kept of each."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.tunnel.averages import Mean
from game.physics.tunnel.outlines import TunnelOutline

ANGLE, DRAG, LIFT, MOMENT = range(4)  # columns of the table: angle rad, means along the wall
SPREAD, BOOK, DRIFT, STROUHAL, CHECK, DONE = 4, 7, 10, 11, 12, 13
COLUMNS = 14
MOST_ANGLES = 96


class SweepPlan(NamedTuple):
    """angles: of a whole turn, a multiple of four; checks: further ones in between, that no fit is given;
    symmetry: what an outline's own symmetry says need not be measured.
    """

    angles: int = 24
    checks: int = 3
    symmetry: bool = True

    def measured(self, outline: TunnelOutline) -> tuple[Floats, Floats]:
        """Angles (rad, rising) to be fitted, and to check the fit by. ValueError for a plan that is none."""
        n = self.angles
        if isinstance(n, bool) or not isinstance(n, int) or n % 4 or not 4 <= n <= MOST_ANGLES:
            raise ValueError(f"angles = {n!r}: expected a multiple of 4, from 4 to {MOST_ANGLES}")
        if not isinstance(self.checks, int) or not 0 <= self.checks <= MOST_ANGLES:
            raise ValueError(f"checks = {self.checks!r}: expected a whole number from 0 to {MOST_ANGLES}")
        first, last = -n // 2 + 1, n // 2
        if self.symmetry and outline.mirrored:
            first, last = 0, (n // 4 if outline.turned else n // 2)
        elif self.symmetry and outline.turned:
            first, last = -n // 4 + 1, n // 4
        step = 2.0 * math.pi / n
        gaps = last - first
        count = min(self.checks, gaps)
        between = [math.floor((k + 0.5) * gaps / count) + 0.5 for k in range(count)]
        fitted = step * np.arange(first, last + 1).astype(np.float64)
        return fitted, step * (first + np.array(between, dtype=np.float64))


class Sweep:
    """``table`` (n, COLUMNS): a row for each angle; ``at`` (2,): which is measured, 1 while it runs."""

    def __init__(self) -> None:
        self.table: Floats = np.zeros((0, COLUMNS))
        self.at: Floats = np.zeros(2)

    def begin(self, outline: TunnelOutline, plan: SweepPlan) -> float:
        """Forget what there is; the first angle, rad."""
        fitted, checks = plan.measured(outline)
        self.table = np.zeros((len(fitted) + len(checks), COLUMNS))
        self.table[:, ANGLE] = np.concatenate([fitted, checks])
        self.table[len(fitted) :, CHECK] = 1.0
        self.at[:] = 0.0, 1.0
        return float(self.table[0, ANGLE])

    def stop(self) -> None:
        """What was measured stays."""
        self.at[1] = 0.0

    def clear(self) -> None:
        """Nothing was measured."""
        self.table, self.at[:] = np.zeros((0, COLUMNS)), 0.0

    @property
    def running(self) -> bool:
        """Whether an angle is being measured."""
        return bool(self.at[1] > 0.5)

    @property
    def complete(self) -> bool:
        """Whether all angles that are to be fitted have been measured."""
        wanted = self.table[:, CHECK] < 0.5
        return bool(len(self.table) and (self.table[wanted, DONE] > 0.5).all())

    def keep(self, mean: Mean) -> float | None:
        """Enter what was found at the present angle; the next one (rad), None if that was the last."""
        k = int(self.at[0])
        row = self.table[k]
        row[DRAG : MOMENT + 1], row[SPREAD : SPREAD + 3] = mean.wall, mean.spread
        row[BOOK : BOOK + 3], row[DRIFT], row[STROUHAL], row[DONE] = mean.book, mean.drift, mean.strouhal, 1.0
        if k + 1 >= len(self.table):
            self.stop()
            return None
        self.at[0] = k + 1.0
        return float(self.table[k + 1, ANGLE])

    def measured(self, checks: bool = False) -> Floats:
        """Rows of the angles that are done: those to be fitted, or those that check the fit."""
        chosen = (self.table[:, DONE] > 0.5) & ((self.table[:, CHECK] > 0.5) == checks)
        return self.table[chosen]


def with_images(rows: Floats, outline: TunnelOutline) -> tuple[Floats, Floats]:
    """Angles (n,) in (-pi, pi] and coefficients (n, 3) of rows and of their images by symmetry.

    Mirrored, drag is even, lift and moment are odd in the angle; after half a turn all are the same.
    """
    angles, values = rows[:, ANGLE], rows[:, DRAG : MOMENT + 1]
    if outline.mirrored:
        angles = np.concatenate([angles, -angles])
        values = np.concatenate([values, values * (1.0, -1.0, -1.0)])
    if outline.turned:
        angles = np.concatenate([angles, angles + math.pi])
        values = np.concatenate([values, values])
    turned = angles - 2.0 * math.pi * np.ceil((angles - math.pi) / (2.0 * math.pi) - 1e-9)
    kept: dict[int, int] = {}
    for k, angle in enumerate(turned.tolist()):
        kept.setdefault(round(angle * 1e6), k)
    order = [kept[key] for key in sorted(kept)]
    return turned[order], values[order]
