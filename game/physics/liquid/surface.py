"""Where the liquid's surface is: from the share of liquid around a cell's centre.

With hats as weights, a flat surface at a distance d (cells) outside a centre leaves the share (1 - d)^2 / 2
there, one inside 1 - (1 - |d|)^2 / 2. So the share gives the distance, and at rest it is exact.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.liquid.arrays import LEAST_OPEN

BESIDE = 0.5 - 1e-9  # cells: with its centre nearer to a solid a cell is looked at more closely
SOLID = 0.5  # of a cell's surroundings that is no solid: with less, its centre lies in one
CROWDED = 1.5  # a fill of such a cell that is beyond doubt
LEAST_ROOM = 0.15  # of a cell's surroundings; in less the share is not trusted


@inner_kernel
def _widest(walls, j, i):
    """The open part of a cell's widest face, and the row and column of the cell behind it."""
    best, y, x = walls.ax[j, i], j, i - 1
    if walls.ax[j, i + 1] > best:
        best, y, x = walls.ax[j, i + 1], j, i + 1
    if walls.ay[j, i] > best:
        best, y, x = walls.ay[j, i], j - 1, i
    if walls.ay[j + 1, i] > best:
        best, y, x = walls.ay[j + 1, i], j + 1, i
    return best, y, x


@inner_kernel
def _beside(cells, walls, j, i):
    """Settle fill and phi of a cell whose centre lies near a solid or in one.

    With its centre outside it has a fill of its own, and is wet if it or the cell behind its widest face is.
    With its centre inside, its own fill counts as far as it is beyond doubt: never too empty, seldom too full.
    """
    part, y, x = _widest(walls, j, i)
    if part < LEAST_OPEN:
        cells.phi[j, i] = 1.0
        return
    own, behind = cells.fill[j, i], 1.0
    if 0 <= y < cells.phi.shape[0] and 0 <= x < cells.phi.shape[1]:
        behind = cells.phi[y, x]
    if cells.room[j, i] >= SOLID:
        cells.phi[j, i] = min(cells.phi[j, i], behind) if own > 0.0 else behind
        return
    cells.phi[j, i] = behind if own < CROWDED else min(behind, -0.5)
    if cells.phi[j, i] < 0.0:
        cells.fill[j, i] = max(own - (CROWDED - 1.0), 1.0)


@lean_kernel
def find_surface(cells, walls):
    """Write phi, and the fill as a share of the room that solids leave; how many cells are wet.

    rank: the number of a wet cell, row by row from 1, 0 for others.
    """
    ny, nx = cells.fill.shape
    count = 0
    for j in range(ny):
        for i in range(nx):
            if cells.fill[j, i] <= 0.0:
                cells.phi[j, i] = 1.0
                continue
            share = cells.fill[j, i] / max(cells.room[j, i], LEAST_ROOM)
            cells.fill[j, i] = share
            cells.phi[j, i] = (
                1.0 - math.sqrt(2.0 * share) if share < 0.5 else math.sqrt(2.0 * max(1.0 - share, 0.0)) - 1.0
            )
    for j in range(ny):
        for i in range(nx):
            cells.rank[j, i] = 0
            if walls.present[0] and walls.distance[2 * j + 1, 2 * i + 1] < BESIDE:
                _beside(cells, walls, j, i)
            if cells.phi[j, i] < 0.0:
                count += 1
                cells.rank[j, i] = count
    return count


@inner_kernel
def lies_inside(cells, j, i):
    """Whether all cells around one are wet or in solids."""
    ny, nx = cells.rank.shape
    for y in range(max(j - 1, 0), min(j + 2, ny)):
        for x in range(max(i - 1, 0), min(i + 2, nx)):
            if cells.rank[y, x] == 0 and cells.room[y, x] >= SOLID:
                return False
    return True


@lean_kernel
def wet_cells(cells, volume):
    """Cells' worth of liquid: wet cells inside are full, others as full as they are; volume: their open parts.

    So liquid that crowds is missing, and a thin sheet counts in full.
    """
    total = 0.0
    for j in range(cells.fill.shape[0]):
        for i in range(cells.fill.shape[1]):
            full = 1.0 if cells.rank[j, i] > 0 and lies_inside(cells, j, i) else min(cells.fill[j, i], 1.0)
            total += full * min(max(volume[j, i], 0.0), 1.0)
    return total


@lean_kernel
def fill_room(cells, distance, quarters):
    """room: what a lattice of quarters of cells would fill, were there no air.

    distance: (2 ny + 1, 2 nx + 1) cells to the solid; quarters: (2 ny, 2 nx), spare, for their open parts.
    """
    ny, nx = cells.room.shape
    for j in range(2 * ny):
        for i in range(2 * nx):
            d = 0.25 * (distance[j, i] + distance[j, i + 1] + distance[j + 1, i] + distance[j + 1, i + 1])
            quarters[j, i] = min(max(0.5 + 2.0 * d, 0.0), 1.0)
    for j in range(ny):
        for i in range(nx):
            total = 0.0
            for m in range(4):
                y = min(max(2 * j - 1 + m, 0), 2 * ny - 1)
                for n in range(4):
                    x = min(max(2 * i - 1 + n, 0), 2 * nx - 1)
                    total += quarters[y, x] * (3.0 if m in (1, 2) else 1.0) * (3.0 if n in (1, 2) else 1.0)
            cells.room[j, i] = total / 64.0
