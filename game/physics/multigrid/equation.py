"""The pressure equation of a grid: its faces, its right side, and sums over it that every solver needs."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.kernels.jit import kernel
from game.physics.multigrid.smoothing import wrap_ghosts

Floats = NDArray[np.float64]
Whole = NDArray[np.int64]


LAST_PLACE = 2.220446049250313e-16


class Equation(NamedTuple):
    """A p = b: the sum over a cell's faces of c (p - p_neighbour) is b."""

    p: Floats  # (ny + 2, nx + 2), the unknown, padded by one ghost
    b: Floats  # (ny, nx)
    cx: Floats  # (ny, nx + 1) conductance of faces: their open part; twice that on an open side
    cy: Floats  # (ny + 1, nx)
    inverse: Floats  # (ny, nx) one over the sum of a cell's conductances, 0 for a closed cell
    r: Floats  # (ny, nx) residual
    d: Floats  # (ny + 2, nx + 2) direction of a search
    z: Floats  # (ny, nx) room
    labels: Whole  # (ny, nx) region of a cell, -1 for closed ones
    fixed: NDArray[np.bool_]  # (ny nx,) of a region, whether an open side fixes its pressure
    sums: Floats  # (2, ny nx) room, for each region
    stack: Whole  # (ny nx,) room
    joined: NDArray[np.bool_]  # (2,) whether x, y are periodic


class Found(NamedTuple):
    """What a solver did: turns of its loop, and the largest residual before and after (as b)."""

    turns: int
    before: float
    after: float


def make_equation(nx: int, ny: int, joined: tuple[bool, bool]) -> Equation:
    """For ny rows and nx columns, all faces closed."""
    cell = (ny, nx)
    return Equation(
        np.zeros((ny + 2, nx + 2)), np.zeros(cell), np.zeros((ny, nx + 1)), np.zeros((ny + 1, nx)),
        np.zeros(cell), np.zeros(cell), np.zeros((ny + 2, nx + 2)), np.zeros(cell),
        np.zeros(cell, np.int64), np.zeros(nx * ny, np.bool_), np.zeros((2, nx * ny)),
        np.zeros(nx * ny, np.int64), np.array(joined),
    )  # fmt: skip


@kernel
def label_regions(e):
    """Number the connected regions of cells, and note which an open side fixes; how many regions."""
    ny, nx = e.b.shape
    count = 0
    e.labels[:] = -1
    for j in range(ny):
        for i in range(nx):
            if e.labels[j, i] >= 0 or e.inverse[j, i] <= 0.0:
                continue
            e.fixed[count] = False
            e.labels[j, i], e.stack[0], top = count, j * nx + i, 1
            while top > 0:
                top -= 1
                y, x = e.stack[top] // nx, e.stack[top] % nx
                for side in range(4):
                    u, v, c = x, y, 0.0
                    if side == 0:
                        u, c = x - 1, e.cx[y, x]
                    elif side == 1:
                        u, c = x + 1, e.cx[y, x + 1]
                    elif side == 2:
                        v, c = y - 1, e.cy[y, x]
                    else:
                        v, c = y + 1, e.cy[y + 1, x]
                    if c <= 0.0:
                        continue
                    if e.joined[0]:
                        u = (u + nx) % nx
                    if e.joined[1]:
                        v = (v + ny) % ny
                    if u < 0 or v < 0 or u >= nx or v >= ny:
                        e.fixed[count] = True
                    elif e.labels[v, u] < 0:
                        e.labels[v, u] = count
                        e.stack[top] = v * nx + u
                        top += 1
            count += 1
    return count


@kernel
def balance(e, field, count, pad):
    """Take its mean over each closed region out of a field (padded by pad); sums[0] holds the means."""
    ny, nx = e.b.shape
    if count == 1 and e.fixed[0]:
        e.sums[0, 0] = 0.0
        return
    for k in range(count):
        e.sums[0, k], e.sums[1, k] = 0.0, 0.0
    for j in range(ny):
        total, cells, last = 0.0, 0.0, -1
        for i in range(nx):
            k = e.labels[j, i]
            if k != last:
                if last >= 0:
                    e.sums[0, last] += total
                    e.sums[1, last] += cells
                total, cells, last = 0.0, 0.0, k
            total += field[j + pad, i + pad]
            cells += 1.0
        if last >= 0:
            e.sums[0, last] += total
            e.sums[1, last] += cells
    for k in range(count):
        e.sums[0, k] = 0.0 if e.fixed[k] else e.sums[0, k] / e.sums[1, k]
    for j in range(ny):
        for i in range(nx):
            k = e.labels[j, i]
            if k >= 0:
                field[j + pad, i + pad] -= e.sums[0, k]
            elif pad == 0:
                field[j, i] = 0.0


@kernel
def residual_of(e):
    """r = b - A p where cells conduct, else 0; the largest of |r|."""
    wrap_ghosts(e.p, e.joined[0], e.joined[1])
    ny, nx = e.b.shape
    m0, m1 = 0.0, 0.0
    for j in range(ny):
        middle, below, above, goal = e.p[j + 1], e.p[j, 1:], e.p[j + 2, 1:], e.r[j]
        across, down, up, right, inv = e.cx[j], e.cy[j], e.cy[j + 1], e.b[j], e.inverse[j]
        for i in range(nx):
            here = middle[i + 1]
            rest = across[i] * (middle[i] - here) + across[i + 1] * (middle[i + 2] - here)
            rest += down[i] * (below[i] - here) + up[i] * (above[i] - here)
            goal[i] = right[i] + rest if inv[i] > 0.0 else 0.0
        for i in range(nx // 2):
            a, b = abs(goal[2 * i]), abs(goal[2 * i + 1])
            m0 = a if a > m0 else m0
            m1 = b if b > m1 else m1
        m0 = max(m0, abs(goal[nx - 1]))
    return max(m0, m1)


@kernel
def rounding(e):
    """The residual that rounding alone leaves: a few times the last place of what is summed in a cell."""
    ny, nx = e.b.shape
    right, unknown = 0.0, 0.0
    for j in range(ny):
        for i in range(nx):
            right = max(right, abs(e.b[j, i]))
            unknown = max(unknown, abs(e.p[j + 1, i + 1]))
    return 16.0 * LAST_PLACE * (right + unknown)


@kernel
def dot(a, b):
    """The sum of products of two fields (rows, columns), in four interleaved sums a row, in a fixed order."""
    total = 0.0
    for j in range(a.shape[0]):
        u, v = a[j], b[j]
        n = u.size // 4
        s0, s1, s2, s3 = 0.0, 0.0, 0.0, 0.0
        for k in range(n):
            s0 += u[4 * k] * v[4 * k]
            s1 += u[4 * k + 1] * v[4 * k + 1]
            s2 += u[4 * k + 2] * v[4 * k + 2]
            s3 += u[4 * k + 3] * v[4 * k + 3]
        for i in range(4 * n, u.size):
            s0 += u[i] * v[i]
        total += (s0 + s1) + (s2 + s3)
    return total


@kernel
def direct(e, z, beta):
    """d = z + beta d, inside; z (ny + 2, nx + 2) padded."""
    for j in range(e.b.shape[0]):
        goal, source = e.d[j + 1], z[j + 1]
        for i in range(1, e.b.shape[1] + 1):
            goal[i] = source[i] + beta * goal[i]


@kernel
def apply(e):
    """z = A d; d times A d."""
    wrap_ghosts(e.d, e.joined[0], e.joined[1])
    ny, nx = e.b.shape
    for j in range(ny):
        middle, below, above, goal = e.d[j + 1], e.d[j, 1:], e.d[j + 2, 1:], e.z[j]
        across, down, up = e.cx[j], e.cy[j], e.cy[j + 1]
        for i in range(nx):
            here = middle[i + 1]
            rest = across[i] * (here - middle[i]) + across[i + 1] * (here - middle[i + 2])
            goal[i] = rest + (down[i] * (here - below[i]) + up[i] * (here - above[i]))
    return dot(e.z, e.d[1 : ny + 1, 1 : nx + 1])


@kernel
def walk(e, alpha):
    """p += alpha d, r -= alpha A d; the largest of |r|."""
    ny, nx = e.b.shape
    m0, m1 = 0.0, 0.0
    for j in range(ny):
        unknown, way, rest, turned = e.p[j + 1], e.d[j + 1], e.r[j], e.z[j]
        for i in range(nx):
            unknown[i + 1] += alpha * way[i + 1]
            rest[i] -= alpha * turned[i]
        for i in range(nx // 2):
            a, b = abs(rest[2 * i]), abs(rest[2 * i + 1])
            m0 = a if a > m0 else m0
            m1 = b if b > m1 else m1
        m0 = max(m0, abs(rest[nx - 1]))
    return max(m0, m1)
