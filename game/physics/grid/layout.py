"""The staggered (MAC) grid of square cells (Harlow and Welch 1965).

Cell (j, i) is row j, column i; its centre lies at lower + (i + 1/2, j + 1/2) h. Cell fields are (ny, nx), the
velocity along x lives on the faces between columns, u (ny, nx + 1), that along y on the faces between rows,
v (ny + 1, nx). Scalars that are carried together lie interleaved in one array (ny, nx, fields).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from game.arrays import Floats

FEWEST, LONGEST, MOST = 4, 1 << 16, 1 << 24  # cells along a side, at most along a side, in all
PAD = 2  # rows and columns of ghosts around a padded field


@dataclass(frozen=True, slots=True)
class Grid:
    """So many columns and rows of square cells of a length (m), the first corner at lower (m).

    ValueError for fewer than 4 cells along a side, more than 2^24 in all, or a cell that is no length.
    """

    nx: int
    ny: int
    cell: float
    lower: tuple[float, float] = (0.0, 0.0)

    def __post_init__(self) -> None:
        for name in ("nx", "ny"):
            count = getattr(self, name)
            if isinstance(count, bool) or not isinstance(count, int) or not FEWEST <= count <= LONGEST:
                raise ValueError(f"{name} = {count!r}: expected a whole number of cells, at least {FEWEST}")
        if self.nx * self.ny > MOST:
            raise ValueError(f"nx = {self.nx}, ny = {self.ny}: expected at most {MOST} cells in all")
        if not 1e-150 < self.cell < 1e150:
            raise ValueError(f"cell = {self.cell!r}: expected a length above 0, m")
        if len(self.lower) != 2 or not all(map(math.isfinite, self.lower)):
            raise ValueError(f"lower = {self.lower!r}: expected a finite point, m")

    @property
    def upper(self) -> tuple[float, float]:
        """The corner opposite to lower, m."""
        return self.lower[0] + self.nx * self.cell, self.lower[1] + self.ny * self.cell

    @property
    def shape(self) -> tuple[int, int]:
        """(rows, columns)."""
        return self.ny, self.nx

    def centres(self) -> tuple[Floats, Floats]:
        """x and y (ny, nx) m of the cells' centres."""
        return self._places(0.5, 0.5, self.nx, self.ny)

    def u_places(self) -> tuple[Floats, Floats]:
        """x and y (ny, nx + 1) m of where u lives."""
        return self._places(0.0, 0.5, self.nx + 1, self.ny)

    def v_places(self) -> tuple[Floats, Floats]:
        """x and y (ny + 1, nx) m of where v lives."""
        return self._places(0.5, 0.0, self.nx, self.ny + 1)

    def nodes(self) -> tuple[Floats, Floats]:
        """x and y (ny + 1, nx + 1) m of the cells' corners."""
        return self._places(0.0, 0.0, self.nx + 1, self.ny + 1)

    def cell_at(self, x: float, y: float) -> tuple[int, int]:
        """Row and column of the cell at a place (m), the nearest if it lies outside."""
        i = math.floor((x - self.lower[0]) / self.cell)
        j = math.floor((y - self.lower[1]) / self.cell)
        return min(max(j, 0), self.ny - 1), min(max(i, 0), self.nx - 1)

    def _places(self, right: float, up: float, columns: int, rows: int) -> tuple[Floats, Floats]:
        x = self.lower[0] + (np.arange(columns) + right) * self.cell
        y = self.lower[1] + (np.arange(rows) + up) * self.cell
        across, upright = np.meshgrid(x, y)
        return across, upright
