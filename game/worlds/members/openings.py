"""Solids in a gas that lie so close that only slits are left between them: what of the gas is open."""

from __future__ import annotations

from typing import Any

import numpy as np

from game.arrays import Floats, Longs
from game.compiler.decorator import lean_kernel


@lean_kernel
def find_open(ax: Any, ay: Any, slit: float, nearest: Any, queue: Any) -> None:
    """Close faces ax (ny, nx + 1), ay (ny + 1, nx) of which less than ``slit`` is open. Then those of pockets
    are closed, from which nothing leads to a side of the grid.

    nearest (ny, nx), written: the number of the open cell that is nearest, in steps from cell to cell; of an
    open cell its own; -1 if there is none. queue (ny nx,) is a buffer.
    """
    ny, nx = nearest.shape
    for j in range(ny):
        for i in range(nx + 1):
            ax[j, i] = ax[j, i] if ax[j, i] >= slit else 0.0
    for j in range(ny + 1):
        for i in range(nx):
            ay[j, i] = ay[j, i] if ay[j, i] >= slit else 0.0
    end = 0
    for j in range(ny):
        for i in range(nx):
            nearest[j, i] = -1
            left, right = i == 0 and ax[j, 0] > 0.0, i == nx - 1 and ax[j, nx] > 0.0
            low, high = j == 0 and ay[0, i] > 0.0, j == ny - 1 and ay[ny, i] > 0.0
            if left or right or low or high:
                nearest[j, i] = j * nx + i
                queue[end] = j * nx + i
                end += 1
    for through in range(2):  # first along what is open, then from there into what is closed
        begin = 0
        while begin < end:
            j, i = queue[begin] // nx, queue[begin] % nx
            begin += 1
            for side in range(4):
                y, x = j + (side == 0) - (side == 1), i + (side == 2) - (side == 3)
                if y < 0 or y >= ny or x < 0 or x >= nx or nearest[y, x] >= 0:
                    continue
                face = ay[max(j, y), i] if side < 2 else ax[j, max(i, x)]
                if through == 1 or face > 0.0:
                    nearest[y, x] = y * nx + x if through == 0 else nearest[j, i]
                    queue[end] = y * nx + x
                    end += 1
        if through == 0:
            for j in range(ny):
                for i in range(nx):
                    if nearest[j, i] < 0:
                        ax[j, i], ax[j, i + 1], ay[j, i], ay[j + 1, i] = 0.0, 0.0, 0.0, 0.0


class Openings:
    """Which cells (ny, nx) of a gas are open, and which open one is nearest to each."""

    def __init__(self, shape: tuple[int, int]):
        self.nearest: Longs = np.zeros(shape, np.int64)
        self._queue = np.zeros(shape[0] * shape[1], np.int64)

    def take(self, ax: Floats, ay: Floats, slit: float) -> None:
        """Of a gas whose faces are open by ax and ay, which are written: see `find_open`."""
        find_open(ax, ay, slit, self.nearest, self._queue)

    @property
    def open(self) -> Any:
        """(ny, nx) bool."""
        return self.nearest == np.arange(self.nearest.size).reshape(self.nearest.shape)

    def nearest_to(self, rows: Longs, columns: Longs) -> tuple[Longs, Longs]:
        """Rows and columns of the open cells nearest to others (...); those themselves if none is open."""
        found, nx = self.nearest[rows, columns], self.nearest.shape[1]
        return np.where(found < 0, rows, found // nx), np.where(found < 0, columns, found % nx)
