"""The pressure equation on wet cells.

The surface is at its true distance (Gibou et al. 2002; Enright et al. 2003). Walls count by the open parts of
faces (Batty, Bertails and Bridson 2007).

The unknown q is pressure times dt over density and cell (m/s): a face between two wet cells loses the
difference of q, one at the surface q over the distance of the surface in cells. Over the faces of a wet cell
the sum of open part times that loss is what flows out too much.
"""

from __future__ import annotations

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.liquid.arrays import LEAST_OPEN
from game.physics.liquid.surface import lies_inside

NEAREST = 0.01  # cells from a centre to the surface, at least


@inner_kernel
def _apart(cells, j, i, y, x, ghost):
    """Cells from a wet cell's centre to the surface on the way to a dry one."""
    if not ghost:
        return 1.0
    here, there = cells.phi[j, i], cells.phi[y, x]
    return max(here / (here - there), NEAREST) if there > 0.0 else 1.0


@inner_kernel
def assemble(cells, walls, s, count, ghost):
    """Fill the system of so many wet cells; ghost: whether the surface is where phi is 0."""
    ny, nx = cells.phi.shape
    s.left[: count + 3], s.below[: count + 3], s.factor[: count + 3] = 0.0, 0.0, 0.0
    k = 0
    for j in range(ny):
        for i in range(nx):
            if cells.rank[j, i] == 0:
                continue
            k += 1
            s.cell[k], s.down[k], s.up[k] = j * nx + i, 0, 0
            full = 0.0
            for side in range(4):
                x, y = i + (side == 1) - (side == 0), j + (side == 3) - (side == 2)
                part = walls.ax[j, i + side] if side < 2 else walls.ay[j + side - 2, i]
                if part < LEAST_OPEN:
                    continue
                if x < 0 or y < 0 or x >= nx or y >= ny:
                    if cells.ends[side] == 1:
                        full += 2.0 * part
                    continue
                other = cells.rank[y, x]
                if other > 0:
                    full += part
                    if side == 0:
                        s.left[k] = part
                    elif side == 2:
                        s.below[k], s.down[k] = part, other
                    elif side == 3:
                        s.up[k] = other
                else:
                    full += part / _apart(cells, j, i, y, x, ghost)
            s.diagonal[k] = full


@inner_kernel
def free_regions(s, count):
    """Number the connected regions of wet cells; sums[2] is 1 for those that no surface ends. How many."""
    s.region[: count + 1] = -1
    regions = 0
    for first in range(1, count + 1):
        if s.region[first] >= 0:
            continue
        s.region[first], s.stack[0], top, loose = regions, first, 1, 1.0
        while top > 0:
            top -= 1
            k = s.stack[top]
            rest = s.diagonal[k] - s.left[k] - s.left[k + 1] - s.below[k]
            if s.up[k] > 0:
                rest -= s.below[s.up[k]]
            if rest > 1e-12 * s.diagonal[k]:
                loose = 0.0
            for side in range(4):
                other = 0
                if side == 0 and s.left[k] > 0.0:
                    other = k - 1
                elif side == 1 and s.left[k + 1] > 0.0:
                    other = k + 1
                elif side == 2:
                    other = s.down[k]
                elif side == 3:
                    other = s.up[k]
                if other > 0 and s.region[other] < 0:
                    s.region[other] = regions
                    s.stack[top] = other
                    top += 1
        s.sums[2, regions] = loose
        regions += 1
    return regions


@inner_kernel
def balance(s, field, count, regions):
    """Take the mean out of a field in regions that no surface ends."""
    if regions == 1 and s.sums[2, 0] == 0.0:
        return
    s.sums[0, :regions], s.sums[1, :regions] = 0.0, 0.0
    for k in range(1, count + 1):
        s.sums[0, s.region[k]] += field[k]
        s.sums[1, s.region[k]] += 1.0
    for k in range(1, count + 1):
        m = s.region[k]
        field[k] -= s.sums[2, m] * (s.sums[0, m] / s.sums[1, m])


@inner_kernel
def outflow(cells, walls, s, count):
    """b: what flows into each wet cell too much, m/s; p: the pressure of the last step."""
    nx = cells.phi.shape[1]
    for k in range(1, count + 1):
        j, i = s.cell[k] // nx, s.cell[k] % nx
        right = walls.u[j, i + 1] + walls.ax[j, i + 1] * (cells.u[j, i + 1] - walls.u[j, i + 1])
        left = walls.u[j, i] + walls.ax[j, i] * (cells.u[j, i] - walls.u[j, i])
        up = walls.v[j + 1, i] + walls.ay[j + 1, i] * (cells.v[j + 1, i] - walls.v[j + 1, i])
        down = walls.v[j, i] + walls.ay[j, i] * (cells.v[j, i] - walls.v[j, i])
        s.b[k] = (left - right) + (down - up)
        s.p[k] = cells.q[j, i]


@inner_kernel
def crowding(cells, s, count, share):
    """b: the part of a cell by which it is too full, or below 0 too empty, times a share; p as it was.

    A cell beside air is only ever too full, one beside a solid also too empty (Kugelstadt, Longva, Thürey and
    Bender 2021).
    """
    nx = cells.phi.shape[1]
    for k in range(1, count + 1):
        j, i = s.cell[k] // nx, s.cell[k] % nx
        excess = min(max(cells.fill[j, i] - 1.0, -0.5), 0.5)
        if excess < 0.0 and not lies_inside(cells, j, i):
            excess = 0.0
        s.b[k] = share * excess
        s.p[k] = cells.q_shift[j, i]


@inner_kernel
def keep(s, count, q):
    """Write the unknown back to cells (ny, nx); 0 in dry ones."""
    nx = q.shape[1]
    q[:] = 0.0
    for k in range(1, count + 1):
        q[s.cell[k] // nx, s.cell[k] % nx] = s.p[k]


@lean_kernel
def take_slope(cells, walls, q, times, ghost):
    """Take ``times`` the slope of q from the open faces of wet cells.

    A face between a wet cell and air loses q over the distance of the surface.
    """
    ny, nx = q.shape
    for j in range(ny):
        for i in range(nx):
            if cells.rank[j, i] == 0:
                continue
            here = times * q[j, i]
            if walls.ax[j, i] >= LEAST_OPEN:
                if i == 0:
                    cells.u[j, i] -= 2.0 * here
                elif cells.rank[j, i - 1] > 0:
                    cells.u[j, i] -= here - times * q[j, i - 1]
                else:
                    cells.u[j, i] -= here / _apart(cells, j, i, j, i - 1, ghost)
            if walls.ax[j, i + 1] >= LEAST_OPEN and (i == nx - 1 or cells.rank[j, i + 1] == 0):
                cells.u[j, i + 1] += (
                    2.0 * here if i == nx - 1 else here / _apart(cells, j, i, j, i + 1, ghost)
                )
            if walls.ay[j, i] >= LEAST_OPEN:
                if j == 0:
                    cells.v[j, i] -= 2.0 * here
                elif cells.rank[j - 1, i] > 0:
                    cells.v[j, i] -= here - times * q[j - 1, i]
                else:
                    cells.v[j, i] -= here / _apart(cells, j, i, j - 1, i, ghost)
            if walls.ay[j + 1, i] >= LEAST_OPEN and (j == ny - 1 or cells.rank[j + 1, i] == 0):
                cells.v[j + 1, i] += (
                    2.0 * here if j == ny - 1 else here / _apart(cells, j, i, j + 1, i, ghost)
                )
