"""Residual and smoothing of the pressure equation, row by row.

The unknown p is padded by one ghost each way (ny + 2, nx + 2); faces conduct cx (ny, nx + 1), cy (ny + 1,
nx): the sum over the four faces of c (p - p_neighbour) is b (ny, nx). A face of conductance 0 is closed.
Beyond an open side the ghost is 0; inverse (ny, nx) is one over the sum of the four, 0 where nothing
conducts.

Smoothing is Jacobi's with the factors of Chebyshev's polynomial on the upper part of the spectrum (Adams,
Brezina, Hu and Tuminaro 2003): any order of the cells gives the same bits, a mirrored field a mirrored one.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.kernels import elementary

LOW, HIGH = 0.25, 2.0  # of the spectrum of a line-free Laplacian divided by its diagonal: what is smoothed

FEW = 8  # cells of a row that are not plain, up to which they are done one by one


def chebyshev_factors(degree: int, low: float = LOW, high: float = HIGH) -> tuple[float, ...]:
    """One over the roots of Chebyshev's polynomial of a degree on an interval."""
    half, middle = 0.5 * (high - low), 0.5 * (high + low)
    return tuple(1.0 / (middle + half * elementary.cos(math.pi * (k + 0.5) / degree)) for k in range(degree))


FACTORS = chebyshev_factors(3)


@lean_kernel
def wrap_ghosts(p, joined_x, joined_y):
    """Ghosts of a periodic field padded by one."""
    rows, columns = p.shape
    if joined_x:
        for j in range(rows):
            p[j, 0] = p[j, columns - 2]
            p[j, columns - 1] = p[j, 1]
    if joined_y:
        for i in range(columns):
            p[0, i] = p[rows - 2, i]
            p[rows - 1, i] = p[1, i]


@lean_kernel
def find_plain(cx, cy, plain):
    """plain (ny, 2): of each row, the longest run [first, last) of cells whose four faces all conduct 1.

    There a product with a conductance changes nothing, and the diagonal is 4: the same bits come from fewer
    numbers, in half the time.
    """
    nx = cy.shape[1]
    for j in range(plain.shape[0]):
        across, down, up = cx[j], cy[j], cy[j + 1]
        first, best, most = 0, 0, 0
        for i in range(nx + 1):
            if i < nx and across[i] == 1.0 and across[i + 1] == 1.0 and down[i] == 1.0 and up[i] == 1.0:
                continue
            if i - first > most:
                best, most = first, i - first
            first = i + 1
        plain[j, 0], plain[j, 1] = best, best + most


@inner_kernel(forceinline=True)
def flow_into(p, cx, cy, j, i):
    """-A p of one cell: the sum over its faces of c (p_neighbour - p)."""
    here = p[j + 1, i + 1]
    rest = cx[j, i] * (p[j + 1, i] - here) + cx[j, i + 1] * (p[j + 1, i + 2] - here)
    return rest + (cy[j, i] * (p[j, i + 1] - here) + cy[j + 1, i] * (p[j + 2, i + 1] - here))


@inner_kernel(forceinline=True)
def mostly_plain(plain, j, nx):
    """Whether a row is worth its plain way: the cells before and behind are then done one by one."""
    return plain[j, 0] + (nx - plain[j, 1]) <= FEW


@lean_kernel
def relax(p, out, b, cx, cy, inverse, plain, factor):
    """out = p + factor inverse (b - A p), inside."""
    ny, nx = b.shape
    quarter = factor * 0.25
    for j in range(ny):
        if not mostly_plain(plain, j, nx):
            middle, below, above, goal = p[j + 1], p[j, 1:], p[j + 2, 1:], out[j + 1, 1:]
            across, down, up, right, inv = cx[j], cy[j], cy[j + 1], b[j], inverse[j]
            for i in range(nx):
                here = middle[i + 1]
                rest = across[i] * (middle[i] - here) + across[i + 1] * (middle[i + 2] - here)
                rest += down[i] * (below[i] - here) + up[i] * (above[i] - here)
                goal[i] = here + factor * inv[i] * (right[i] + rest)
            continue
        first, last = plain[j, 0], plain[j, 1]
        middle, below, above = p[j + 1, first:], p[j, first + 1 :], p[j + 2, first + 1 :]
        goal, right = out[j + 1, first + 1 :], b[j, first:]
        for i in range(last - first):
            here = middle[i + 1]
            rest = (middle[i] - here) + (middle[i + 2] - here)
            rest += (below[i] - here) + (above[i] - here)
            goal[i] = here + quarter * (right[i] + rest)
        for k in range(first + nx - last):
            i = k if k < first else k - first + last
            gain = factor * inverse[j, i] * (b[j, i] + flow_into(p, cx, cy, j, i))
            out[j + 1, i + 1] = p[j + 1, i + 1] + gain


@lean_kernel
def begin(out, b, inverse, factor):
    """The same from p = 0."""
    ny, nx = b.shape
    for j in range(ny):
        goal, right, inv = out[j + 1, 1:], b[j], inverse[j]
        for i in range(nx):
            goal[i] = factor * inv[i] * right[i]


@lean_kernel
def residual(p, out, b, cx, cy, plain):
    """out = b - A p, padded by one."""
    ny, nx = b.shape
    for j in range(ny):
        if not mostly_plain(plain, j, nx):
            middle, below, above, goal = p[j + 1], p[j, 1:], p[j + 2, 1:], out[j + 1, 1:]
            across, down, up, right = cx[j], cy[j], cy[j + 1], b[j]
            for i in range(nx):
                here = middle[i + 1]
                rest = across[i] * (middle[i] - here) + across[i + 1] * (middle[i + 2] - here)
                rest += down[i] * (below[i] - here) + up[i] * (above[i] - here)
                goal[i] = right[i] + rest
            continue
        first, last = plain[j, 0], plain[j, 1]
        middle, below, above = p[j + 1, first:], p[j, first + 1 :], p[j + 2, first + 1 :]
        goal, right = out[j + 1, first + 1 :], b[j, first:]
        for i in range(last - first):
            here = middle[i + 1]
            rest = (middle[i] - here) + (middle[i + 2] - here)
            rest += (below[i] - here) + (above[i] - here)
            goal[i] = right[i] + rest
        for k in range(first + nx - last):
            i = k if k < first else k - first + last
            out[j + 1, i + 1] = b[j, i] + flow_into(p, cx, cy, j, i)
