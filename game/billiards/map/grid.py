"""The strokes that a map begins with: aims that suit the position, times speeds, times places of the tip."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.search import strokes as s
from game.physics.kernels import elementary, elementwise

THINNEST = 0.985  # of the sum of radii is the farthest hit beside the middle
AROUND = 0.45  # share of the aims that go all round, for strokes by a cushion first


class Grid(NamedTuple):
    """Values of each variable: aims rad, speeds of the cue m/s, tip left and up in ball radii."""

    aims: Floats
    speeds: Floats
    lefts: Floats
    ups: Floats

    @property
    def shape(self) -> tuple[int, int, int, int]:
        """How many values there are of each."""
        return len(self.aims), len(self.speeds), len(self.lefts), len(self.ups)

    @property
    def strokes(self) -> Floats:
        """All of them (m, 5), aims varying slowest."""
        values = np.meshgrid(*self, indexing="ij")
        strokes = np.zeros((values[0].size, 5))
        for column, value in zip((s.AZIMUTH, s.SPEED, s.TIP_LEFT, s.TIP_UP), values, strict=True):
            strokes[:, column] = value.ravel()
        return strokes


def aims_of(places: Floats, radii: Floats, cue: int, count: int) -> Floats:
    """Aims (count,) rad, ascending: at every ball that is not the cue ball, evenly from thin to thin, and a
    share of them all round. places (n, 2) m, radii (n,) m.
    """
    targets = [row for row in range(len(places)) if row != cue]
    round_about = max(round(AROUND * count), count % max(len(targets), 1), 4)
    each = (count - round_about) // max(len(targets), 1)
    round_about = count - each * len(targets)
    aims = [-math.pi + math.tau * (np.arange(round_about) + 0.5) / round_about]
    for row in targets:
        dx, dy = (places[row] - places[cue]).tolist()
        distance = max(elementary.hypot(dx, dy), radii[row] + radii[cue])
        reach = (radii[row] + radii[cue]) / distance
        off = elementwise.arcsin(np.clip(THINNEST * reach * np.linspace(-1.0, 1.0, each), -1.0, 1.0))
        aims.append(elementary.atan2(dy, dx) + off)
    wrapped = np.concatenate(aims)
    return np.sort((wrapped + math.pi) % math.tau - math.pi)


def neighbours(keys: NDArray[np.int64], shape: tuple[int, int, int, int]) -> NDArray[np.int64]:
    """How many of the eight strokes next to each (m,), in one variable, have the same key; a key of 0 has
    none.

    keys (m,), of the strokes of a `Grid` of that shape. Aims go round.
    """
    cells = keys.reshape(shape)
    count = np.zeros(shape, np.int64)
    for axis in range(4):
        for step in (-1, 1):
            moved = np.roll(cells, step, axis)
            if axis > 0:
                edge = [slice(None)] * 4
                edge[axis] = slice(0, 1) if step == 1 else slice(-1, None)
                moved[tuple(edge)] = 0
            count += (moved == cells) & (cells != 0)
    return count.ravel()
