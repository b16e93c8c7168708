"""Solids in a gas that lie so close that only slits are left between them: what of the gas is open."""

from __future__ import annotations

from typing import Any

import numpy as np

from game.arrays import Floats, Longs
from game.compiler.decorator import lean_kernel


@lean_kernel
def close_dead_ends(ax: Any, ay: Any, sides: Any) -> None:
    """Close cells with one open face alone, and those that become such by it: nothing flows through them, so
    what is given to the gas there would stay. Faces at sides (4,) that are not ways count as closed.
    """
    ny, nx = ay.shape[0] - 1, ax.shape[1] - 1
    for j in range(ny):
        for i in range(nx):
            j0, i0 = j, i
            while True:
                count, last = 0, -1
                for side in range(4):  # left, right, below, above
                    rim = (side == 0 and i0 == 0) or (side == 1 and i0 == nx - 1)
                    rim = rim or (side == 2 and j0 == 0) or (side == 3 and j0 == ny - 1)
                    part = ax[j0, i0 + side] if side < 2 else ay[j0 + side - 2, i0]
                    if part > 0.0 and (not rim or sides[side]):
                        count += 1
                        last = side
                if count != 1:
                    break
                if last < 2:
                    ax[j0, i0 + last] = 0.0
                else:
                    ay[j0 + last - 2, i0] = 0.0
                j0, i0 = j0 + (last == 3) - (last == 2), i0 + (last == 1) - (last == 0)
                if j0 < 0 or j0 >= ny or i0 < 0 or i0 >= nx:
                    break


@lean_kernel
def find_open(ax: Any, ay: Any, slit: float, sides: Any, nearest: Any, queue: Any) -> None:
    """Close faces ax (ny, nx + 1), ay (ny + 1, nx) of which less than ``slit`` is open, and dead ends. Then
    those of pockets are closed, from which nothing leads to a side that is a way (``sides``, (4,) bool).

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
    close_dead_ends(ax, ay, sides)
    end = 0
    for j in range(ny):
        for i in range(nx):
            nearest[j, i] = -1
            left = sides[0] and i == 0 and ax[j, 0] > 0.0
            right = sides[1] and i == nx - 1 and ax[j, nx] > 0.0
            low, high = sides[2] and j == 0 and ay[0, i] > 0.0, sides[3] and j == ny - 1 and ay[ny, i] > 0.0
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
    """Which cells (ny, nx) of a gas are open, and which open one is nearest to each.

    ways: whether gas reaches the cells from the left, right, lower and upper side; a floor is no way.
    """

    def __init__(self, shape: tuple[int, int], ways: tuple[bool, bool, bool, bool] = (True,) * 4):
        self._ways = np.array(ways)
        self.nearest: Longs = np.zeros(shape, np.int64)
        self._queue = np.zeros(shape[0] * shape[1], np.int64)

    def take(self, ax: Floats, ay: Floats, slit: float) -> None:
        """Of a gas whose faces are open by ax and ay, which are written: see `find_open`."""
        find_open(ax, ay, slit, self._ways, self.nearest, self._queue)

    @property
    def open(self) -> Any:
        """(ny, nx) bool."""
        return self.nearest == np.arange(self.nearest.size).reshape(self.nearest.shape)

    def nearest_to(self, rows: Longs, columns: Longs) -> tuple[Longs, Longs]:
        """Rows and columns of the open cells nearest to others (...); those themselves if none is open."""
        found, nx = self.nearest[rows, columns], self.nearest.shape[1]
        return np.where(found < 0, rows, found // nx), np.where(found < 0, columns, found % nx)
