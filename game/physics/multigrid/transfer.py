"""Between a fine level and the next coarser one: bilinear up, and its transpose down."""

from __future__ import annotations

from game.physics.kernels.lean import lean_kernel


@lean_kernel
def restrict(fine, row, coarse, x, y):
    """The transpose of bilinear interpolation: fine (padded by one) into coarse (m_y, m_x).

    row: room for one padded fine row. x, y: (members, gather) of the axes.
    """
    my, mx = coarse.shape
    width = fine.shape[1]
    for j in range(my):
        first, last, mid = y[0][j, 0] + 1, y[0][j, 1] + 1, y[0][j, 2] + 1
        w0, w1, w2, w3, w4 = y[1][j, 0], y[1][j, 1], y[1][j, 2], y[1][j, 3], y[1][j, 4]
        r0, r1, r2, r3 = fine[first], fine[last], fine[first - 1], fine[last + 1]
        for i in range(width):
            row[i] = (w0 * r0[i] + w1 * r1[i]) + (w2 * r2[i] + w3 * r3[i])
        if w4 > 0.0:
            r4 = fine[mid]
            for i in range(width):
                row[i] += w4 * r4[i]
        goal = coarse[j]
        for i in range(mx):
            a, b = x[0][i, 0] + 1, x[0][i, 1] + 1
            w = x[1][i]
            total = (w[0] * row[a] + w[1] * row[b]) + (w[2] * row[a - 1] + w[3] * row[b + 1])
            goal[i] = total + w[4] * row[x[0][i, 2] + 1]


@lean_kernel
def prolong(coarse, row, fine, norm, x, y):
    """Add norm times the bilinear interpolation of coarse (padded by one) to fine (padded by one).

    row: room for one padded coarse row. x, y: (near, far, share) of the axes.
    """
    ny, nx = norm.shape
    width = coarse.shape[1]
    for j in range(ny):
        one, other = coarse[y[0][j] + 1], coarse[y[1][j] + 1]
        w, v = y[2][j, 0], y[2][j, 1]
        for i in range(width):
            row[i] = w * one[i] + v * other[i]
        goal, part = fine[j + 1, 1:], norm[j]
        for i in range(nx):
            goal[i] += part[i] * (x[2][i, 0] * row[x[0][i] + 1] + x[2][i, 1] * row[x[1][i] + 1])


@lean_kernel
def invert_diagonal(cx, cy, inverse):
    """One over the sum of a cell's conductances, 0 for none."""
    for j in range(inverse.shape[0]):
        for i in range(inverse.shape[1]):
            total = (cx[j, i] + cx[j, i + 1]) + (cy[j, i] + cy[j + 1, i])
            inverse[j, i] = 1.0 / total if total > 0.0 else 0.0
