"""Speeds at faces: gravity, walls, and how speeds go on into the air."""

from __future__ import annotations

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.liquid.arrays import LEAST_OPEN

LAYERS = 2  # of faces beyond the last particle to which speeds are continued


@lean_kernel
def pull(cells, change):
    """Keep the speeds as they came; then gravity: change of v, m/s."""
    for j in range(cells.u.shape[0]):
        for i in range(cells.u.shape[1]):
            cells.old_u[j, i] = cells.u[j, i]
    for j in range(cells.v.shape[0]):
        for i in range(cells.v.shape[1]):
            cells.old_v[j, i] = cells.v[j, i]
            if cells.weight_v[j, i] > 0.0:
                cells.v[j, i] += change


@inner_kernel
def _reaches(walls, j, i):
    """Whether a cell of the grid has an open face."""
    ny, nx = walls.ay.shape[0] - 1, walls.ax.shape[1] - 1
    if j < 0 or i < 0 or j >= ny or i >= nx:
        return True
    across, upright = max(walls.ax[j, i], walls.ax[j, i + 1]), max(walls.ay[j, i], walls.ay[j + 1, i])
    return max(across, upright) >= LEAST_OPEN


@lean_kernel
def close(cells, walls):
    """Closed faces beside open cells move as the wall does; deeper ones have no speed of their own."""
    nx = walls.ay.shape[1]
    for m in range(walls.closed_u.size):
        j, i = walls.closed_u[m] // (nx + 1), walls.closed_u[m] % (nx + 1)
        fixed = _reaches(walls, j, i - 1) or _reaches(walls, j, i)
        cells.u[j, i], cells.weight_u[j, i] = walls.u[j, i], 1.0 if fixed else 0.0
    for m in range(walls.closed_v.size):
        j, i = walls.closed_v[m] // nx, walls.closed_v[m] % nx
        fixed = _reaches(walls, j - 1, i) or _reaches(walls, j, i)
        cells.v[j, i], cells.weight_v[j, i] = walls.v[j, i], 1.0 if fixed else 0.0


@inner_kernel
def _mean(field, weight, j, i, layer):
    """Give a face the mean of those beside it that had a speed before this layer; whether there were any."""
    rows, columns = field.shape
    total, count = 0.0, 0
    if i > 0 and weight[j, i - 1] != 0.0 and weight[j, i - 1] > layer:
        total, count = total + field[j, i - 1], count + 1
    if i < columns - 1 and weight[j, i + 1] != 0.0 and weight[j, i + 1] > layer:
        total, count = total + field[j, i + 1], count + 1
    if j > 0 and weight[j - 1, i] != 0.0 and weight[j - 1, i] > layer:
        total, count = total + field[j - 1, i], count + 1
    if j < rows - 1 and weight[j + 1, i] != 0.0 and weight[j + 1, i] > layer:
        total, count = total + field[j + 1, i], count + 1
    if count > 0:
        field[j, i], weight[j, i] = total / count, layer
    return count > 0


@inner_kernel
def _continue(field, weight, front):
    """The first layer is looked for everywhere, each further one beside the one before."""
    rows, columns = field.shape
    first, last = 0, 0
    for j in range(rows):
        for i in range(columns):
            if weight[j, i] == 0.0 and _mean(field, weight, j, i, -1.0):
                front[last] = j * columns + i
                last += 1
    for layer in range(2, LAYERS + 1):
        end = last
        for m in range(first, end):
            j, i = front[m] // columns, front[m] % columns
            for side in range(4):
                y, x = j + (side == 3) - (side == 2), i + (side == 1) - (side == 0)
                if x < 0 or y < 0 or x >= columns or y >= rows or weight[y, x] != 0.0:
                    continue
                if _mean(field, weight, y, x, -float(layer)):
                    front[last] = y * columns + x
                    last += 1
        first = end


@lean_kernel
def continue_speeds(cells):
    """Faces without a speed of their own take the mean of those beside them, two layers deep."""
    _continue(cells.u, cells.weight_u, cells.front)
    _continue(cells.v, cells.weight_v, cells.front)
