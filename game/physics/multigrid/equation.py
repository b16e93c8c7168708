"""The pressure equation of a grid: its faces, its right side, and sums over it that every solver needs."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats, Longs
from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.kernels.magnitudes import from_bits, largest
from game.physics.multigrid.smoothing import flow_into, mostly_plain, wrap_ghosts

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
    labels: Longs  # (ny, nx) region of a cell, -1 for closed ones
    fixed: NDArray[np.bool_]  # (ny nx,) of a region, whether an open side fixes its pressure
    sums: Floats  # (2, ny nx) room, for each region
    stack: Longs  # (ny nx,) room
    joined: NDArray[np.bool_]  # (2,) whether x, y are periodic
    plain: Longs  # (ny, 2) of each row, a run of cells whose faces all conduct 1
    whole: NDArray[np.bool_]  # (1,) whether all cells are of one region


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
        np.zeros(nx * ny, np.int64), np.array(joined), np.zeros((ny, 2), np.int64),
        np.zeros(1, np.bool_),
    )  # fmt: skip


@lean_kernel
def label_regions(e):
    """Number the connected regions of cells, and note which an open side fixes; how many regions."""
    ny, nx = e.b.shape
    count, open_cells = 0, 0
    e.labels[:] = -1
    for j in range(ny):
        for i in range(nx):
            if e.labels[j, i] >= 0 or e.inverse[j, i] <= 0.0:
                continue
            e.fixed[count] = False
            e.labels[j, i], e.stack[0], top = count, j * nx + i, 1
            while top > 0:
                top -= 1
                open_cells += 1
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
    e.whole[0] = count == 1 and open_cells == nx * ny
    return count


@lean_kernel
def balance(e, field, count, pad):
    """Take its mean over each closed region out of a field (padded by pad); sums[0] holds the means."""
    if count == 1 and e.fixed[0]:
        e.sums[0, 0] = 0.0
        return
    if count == 1 and e.whole[0]:
        _balance_all(e, field, pad)
    else:
        _balance_regions(e, field, count, pad)


@inner_kernel
def _balance_all(e, field, pad):
    """The same if every cell belongs to one region: four rows' sums side by side, for each is a chain."""
    ny, nx = e.b.shape
    whole = 0.0
    for j in range(0, ny - 3, 4):
        one, two, three, four = field[j + pad], field[j + pad + 1], field[j + pad + 2], field[j + pad + 3]
        s0, s1, s2, s3 = 0.0, 0.0, 0.0, 0.0
        for i in range(pad, nx + pad):
            s0 += one[i]
            s1 += two[i]
            s2 += three[i]
            s3 += four[i]
        whole = whole + s0 + s1 + s2 + s3
    for j in range(ny - ny % 4, ny):
        row, total = field[j + pad], 0.0
        for i in range(pad, nx + pad):
            total += row[i]
        whole += total
    e.sums[0, 0], e.sums[1, 0] = whole / (nx * ny), float(nx * ny)
    mean = e.sums[0, 0]
    for j in range(pad, ny + pad):
        row = field[j]
        for i in range(pad, nx + pad):
            row[i] -= mean


@inner_kernel
def _balance_regions(e, field, count, pad):
    """The same for any regions."""
    ny, nx = e.b.shape
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


@lean_kernel
def residual_of(e):
    """r = b - A p where cells conduct, else 0; the largest of |r|."""
    wrap_ghosts(e.p, e.joined[0], e.joined[1])
    ny, nx = e.b.shape
    most = 0
    for j in range(ny):
        first, last = e.plain[j, 0], e.plain[j, 1]
        if not mostly_plain(e.plain, j, nx):
            middle, below, above, goal = e.p[j + 1], e.p[j, 1:], e.p[j + 2, 1:], e.r[j]
            across, down, up, right, inv = e.cx[j], e.cy[j], e.cy[j + 1], e.b[j], e.inverse[j]
            for i in range(nx):
                here = middle[i + 1]
                rest = across[i] * (middle[i] - here) + across[i + 1] * (middle[i + 2] - here)
                rest += down[i] * (below[i] - here) + up[i] * (above[i] - here)
                goal[i] = right[i] + rest if inv[i] > 0.0 else 0.0
        else:
            middle, below, above = e.p[j + 1, first:], e.p[j, first + 1 :], e.p[j + 2, first + 1 :]
            goal, right = e.r[j, first:], e.b[j, first:]
            for i in range(last - first):
                here = middle[i + 1]
                rest = (middle[i] - here) + (middle[i + 2] - here)
                rest += (below[i] - here) + (above[i] - here)
                goal[i] = right[i] + rest
            for k in range(first + nx - last):
                i = k if k < first else k - first + last
                conducts = e.inverse[j, i] > 0.0
                e.r[j, i] = e.b[j, i] + flow_into(e.p, e.cx, e.cy, j, i) if conducts else 0.0
        most = largest(e.r[j], most)
    return from_bits(most)


@lean_kernel
def rounding(e):
    """The residual that rounding alone leaves: a few times the last place of what is summed in a cell."""
    right, unknown = 0, 0
    for j in range(e.b.shape[0]):
        right = largest(e.b[j], right)
        unknown = largest(e.p[j + 1, 1 : e.b.shape[1] + 1], unknown)
    return 16.0 * LAST_PLACE * (from_bits(right) + from_bits(unknown))


@lean_kernel
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


@lean_kernel
def direct(e, z, beta):
    """d = z + beta d, inside; z (ny + 2, nx + 2) padded."""
    for j in range(e.b.shape[0]):
        goal, source = e.d[j + 1], z[j + 1]
        for i in range(1, e.b.shape[1] + 1):
            goal[i] = source[i] + beta * goal[i]


@lean_kernel
def apply(e):
    """z = A d; d times A d."""
    wrap_ghosts(e.d, e.joined[0], e.joined[1])
    ny, nx = e.b.shape
    for j in range(ny):
        first, last = e.plain[j, 0], e.plain[j, 1]
        if not mostly_plain(e.plain, j, nx):
            middle, below, above, goal = e.d[j + 1], e.d[j, 1:], e.d[j + 2, 1:], e.z[j]
            across, down, up = e.cx[j], e.cy[j], e.cy[j + 1]
            for i in range(nx):
                here = middle[i + 1]
                rest = across[i] * (here - middle[i]) + across[i + 1] * (here - middle[i + 2])
                goal[i] = rest + (down[i] * (here - below[i]) + up[i] * (here - above[i]))
            continue
        middle, below, above = e.d[j + 1, first:], e.d[j, first + 1 :], e.d[j + 2, first + 1 :]
        goal = e.z[j, first:]
        for i in range(last - first):
            here = middle[i + 1]
            rest = (here - middle[i]) + (here - middle[i + 2])
            goal[i] = rest + ((here - below[i]) + (here - above[i]))
        for k in range(first + nx - last):
            i = k if k < first else k - first + last
            e.z[j, i] = -flow_into(e.d, e.cx, e.cy, j, i)
    return dot(e.z, e.d[1 : ny + 1, 1 : nx + 1])


@lean_kernel
def walk(e, alpha):
    """p += alpha d, r -= alpha A d; the largest of |r|."""
    ny, nx = e.b.shape
    most = 0
    for j in range(ny):
        unknown, way, rest, turned = e.p[j + 1, 1:], e.d[j + 1, 1:], e.r[j], e.z[j]
        for i in range(nx):
            unknown[i] += alpha * way[i]
        for i in range(nx):
            rest[i] -= alpha * turned[i]
        most = largest(rest, most)
    return from_bits(most)


@inner_kernel
def advance_conjugate(e, z, old):
    """One step of conjugate gradients (Hestenes and Stiefel 1952) along z (ny + 2, nx + 2), the residual
    preconditioned; old: r times z of the step before, 0 in the first. r times z, which is 0 where the search
    has come to its end, and the largest residual then.
    """
    new = dot(e.r, z[1 : e.b.shape[0] + 1, 1 : e.b.shape[1] + 1])
    if not new > 0.0:
        return 0.0, 0.0
    direct(e, z, new / old if old > 0.0 else 0.0)
    steep = apply(e)
    if not steep > 0.0:
        return 0.0, 0.0
    return new, walk(e, new / steep)
