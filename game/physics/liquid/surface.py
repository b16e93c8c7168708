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
NOW, LATER = -1, -2  # for rank, of cells that are not settled yet
SEALED = 2.0  # cells: phi where no open face leads to liquid or to air
LEAST_ROOM = 0.15  # of a cell's surroundings; in less the share is not trusted


@inner_kernel
def _behind(cells, walls, j, i):
    """The open part of a cell's widest face to a cell that is settled, and phi there."""
    ny, nx = cells.phi.shape
    best, phi = 0.0, SEALED
    for side in range(4):
        x, y = i + (side == 1) - (side == 0), j + (side == 3) - (side == 2)
        part = walls.ax[j, i + side] if side < 2 else walls.ay[j + side - 2, i]
        if part < LEAST_OPEN or part <= best:
            continue
        if x < 0 or y < 0 or x >= nx or y >= ny:
            best, phi = part, 1.0
        elif cells.rank[y, x] == 0:
            best, phi = part, cells.phi[y, x]
    return best, phi


@inner_kernel
def _is_open(walls, j, i):
    """Whether a cell has an open face."""
    across, upright = max(walls.ax[j, i], walls.ax[j, i + 1]), max(walls.ay[j, i], walls.ay[j + 1, i])
    return max(across, upright) >= LEAST_OPEN


@inner_kernel
def _settle_within(cells, walls, count):
    """Settle the cells that lie within solids, as many as ``front`` names, from outside inwards.

    Each is wet if the cell behind its widest face is. It counts as full, or as fuller than a whole cell if
    it is. Were one taken for air, its pressure of 0 would draw in all around.
    """
    nx, front = cells.phi.shape[1], cells.front
    found = True
    while found:
        found, left = False, 0
        for m in range(count):
            j, i = front[m] // nx, front[m] % nx
            part, behind = _behind(cells, walls, j, i)
            if part > 0.0:
                cells.phi[j, i], cells.rank[j, i], found = behind, NOW, True
        for m in range(count):
            j, i = front[m] // nx, front[m] % nx
            if cells.rank[j, i] == NOW:
                cells.rank[j, i] = 0
                if cells.phi[j, i] < 0.0 and cells.room[j, i] <= 0.0:
                    cells.fill[j, i] = max(1.0, LEAST_ROOM * cells.fill[j, i])
            else:
                front[left] = front[m]
                left += 1
        count = left


@inner_kernel
def _settle(cells, walls):
    """Settle phi of cells near solids. With its centre outside a cell is wet by its own fill, or if the cell
    behind its widest face is.
    """
    ny, nx = cells.phi.shape
    within = 0
    for j in range(ny):
        for i in range(nx):
            cells.rank[j, i] = 0
            if walls.distance[2 * j + 1, 2 * i + 1] < 0.0:
                cells.phi[j, i], cells.rank[j, i], cells.front[within] = SEALED, LATER, j * nx + i
                within += 1
    for j in range(ny):
        for i in range(nx):
            if cells.rank[j, i] == 0 and walls.distance[2 * j + 1, 2 * i + 1] < BESIDE:
                part, behind = _behind(cells, walls, j, i)
                if part > 0.0:
                    cells.phi[j, i] = min(cells.phi[j, i], behind)
                elif cells.phi[j, i] >= 0.0 or not _is_open(walls, j, i):
                    cells.phi[j, i], cells.rank[j, i], cells.front[within] = SEALED, LATER, j * nx + i
                    within += 1
    _settle_within(cells, walls, within)


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
    if walls.present[0]:
        _settle(cells, walls)
    for j in range(ny):
        for i in range(nx):
            cells.rank[j, i] = 0
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
