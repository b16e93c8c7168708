"""Between a fine level and the next coarser one: bilinear up, and its transpose down."""

from __future__ import annotations

from game.compiler.decorator import lean_kernel

NEAR, FAR = 0.75, 0.25  # weights where two cells of one width become one


@lean_kernel
def restrict(fine, row, coarse, x, y):
    """The transpose of bilinear interpolation: fine (padded by one) into coarse (m_y, m_x).

    row: space for one padded fine row. x, y: (members, gather) of the axes, of x also even: between those two
    coarse cells every one has the same weights.
    """
    my, mx = coarse.shape
    width = fine.shape[1]
    start, end = x[2][0], x[2][1]
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
        for side in range(2):
            for i in range(end if side else 0, mx if side else start):
                a, b = x[0][i, 0] + 1, x[0][i, 1] + 1
                w = x[1][i]
                total = (w[0] * row[a] + w[1] * row[b]) + (w[2] * row[a - 1] + w[3] * row[b + 1])
                goal[i] = total + w[4] * row[x[0][i, 2] + 1]
        even, pairs = goal[start:], row[2 * start :]
        for i in range(end - start):
            near = NEAR * pairs[2 * i + 1] + NEAR * pairs[2 * i + 2]
            even[i] = near + (FAR * pairs[2 * i] + FAR * pairs[2 * i + 3]) + 0.0


@lean_kernel
def prolong(coarse, row, fine, norm, x, y):
    """Add norm times the bilinear interpolation of coarse (padded by one) to fine (padded by one).

    row: space for one padded coarse row. x, y: (near, far, share) of the axes, of x also even, as above.
    """
    ny, nx = norm.shape
    width = coarse.shape[1]
    start, end = x[3][0], x[3][1]
    for j in range(ny):
        one, other = coarse[y[0][j] + 1], coarse[y[1][j] + 1]
        w, v = y[2][j, 0], y[2][j, 1]
        for i in range(width):
            row[i] = w * one[i] + v * other[i]
        goal, part = fine[j + 1, 1:], norm[j]
        for side in range(2):
            for i in range(2 * end if side else 0, nx if side else 2 * start):
                goal[i] += part[i] * (x[2][i, 0] * row[x[0][i] + 1] + x[2][i, 1] * row[x[1][i] + 1])
        pairs, parts, source = goal[2 * start :], part[2 * start :], row[start:]
        for k in range(end - start):
            near = NEAR * source[k + 1]
            pairs[2 * k] += parts[2 * k] * (near + FAR * source[k])
            pairs[2 * k + 1] += parts[2 * k + 1] * (near + FAR * source[k + 2])


@lean_kernel
def invert_diagonal(cx, cy, inverse):
    """One over the sum of a cell's conductances, 0 for none."""
    for j in range(inverse.shape[0]):
        for i in range(inverse.shape[1]):
            total = (cx[j, i] + cx[j, i + 1]) + (cy[j, i] + cy[j + 1, i])
            inverse[j, i] = 1.0 / total if total > 0.0 else 0.0
