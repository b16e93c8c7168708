"""Where the liquid's surface is: from the share of liquid around a cell's centre.

With hats as weights, a flat surface at a distance d (cells) outside a centre leaves the share (1 - d)^2 / 2
there, one inside 1 - (1 - |d|)^2 / 2. So the share gives the distance, and at rest it is exact.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.liquid.arrays import LEAST_OPEN
from game.physics.liquid.transfer import fill_around

BESIDE = 0.5 - 1e-9  # cells: with its centre nearer to a solid a cell is looked at more closely
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
    """Settle phi of a cell whose centre lies near a solid or in one: it is wet if the cell behind its widest
    face is, and with its centre outside also by its own fill. With its centre inside it counts as full.
    """
    part, y, x = _widest(walls, j, i)
    if part < LEAST_OPEN:
        cells.phi[j, i] = 1.0
        return
    behind = 1.0
    if 0 <= y < cells.phi.shape[0] and 0 <= x < cells.phi.shape[1]:
        behind = cells.phi[y, x]
    cells.phi[j, i] = min(cells.phi[j, i], behind)
    if cells.room[j, i] <= 0.0 and cells.phi[j, i] < 0.0:
        cells.fill[j, i] = 1.0


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
            if cells.rank[y, x] == 0 and cells.room[y, x] > 0.0:
                return False
    return True


@lean_kernel
def wet_cells(cells, volume):
    """Cells' worth of liquid: wet cells inside are full, others as far as they are; volume: open parts.

    So liquid that crowds is missing, and a thin sheet counts in full.
    """
    total = 0.0
    for j in range(cells.fill.shape[0]):
        for i in range(cells.fill.shape[1]):
            full = 1.0 if cells.rank[j, i] > 0 and lies_inside(cells, j, i) else min(cells.fill[j, i], 1.0)
            total += full * min(max(volume[j, i], 0.0), 1.0)
    return total


@lean_kernel
def fill_room(cells, walls, quarters):
    """room: what a lattice of quarters of cells would fill, were there no air; 0 with the centre in a solid.

    quarters: (2 ny, 2 nx), spare, for their open parts.
    """
    distance = walls.distance
    cells.room[:] = 0.0
    for j in range(quarters.shape[0]):
        for i in range(quarters.shape[1]):
            d = 0.25 * (distance[j, i] + distance[j, i + 1] + distance[j + 1, i] + distance[j + 1, i + 1])
            quarters[j, i] = min(max(0.5 + 2.0 * d, 0.0), 1.0)
            fill_around(cells.room, 0.5 * i - 0.25, 0.5 * j - 0.25, 0.25 * quarters[j, i], walls)
    for j in range(cells.room.shape[0]):
        for i in range(cells.room.shape[1]):
            if distance[2 * j + 1, 2 * i + 1] < 0.0:
                cells.room[j, i] = 0.0
