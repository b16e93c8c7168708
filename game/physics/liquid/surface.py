"""Where the liquid's surface is: from the share of liquid around a cell's centre.

With hats as weights, a flat surface at a distance d (cells) outside a centre leaves the share (1 - d)^2 / 2
there, one inside 1 - (1 - |d|)^2 / 2. So the share gives the distance, and at rest it is exact.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.liquid.arrays import LEAST_OPEN

BESIDE = 0.5  # cells: a centre so near to a solid has no fill of its own that could be trusted
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


@lean_kernel
def find_surface(cells, walls):
    """Write phi, and the fill as a share of the room that solids leave; how many cells are wet.

    A cell whose centre is in a solid is as wet as the one behind its widest face, and counts as full. rank:
    the number of a wet cell, row by row from 1, 0 for others.
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
                part, y, x = _widest(walls, j, i)
                if part < LEAST_OPEN or y < 0 or x < 0 or y >= ny or x >= nx:
                    continue
                cells.phi[j, i], cells.fill[j, i] = cells.phi[y, x], 1.0
            if cells.phi[j, i] < 0.0:
                count += 1
                cells.rank[j, i] = count
    return count


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
