"""Coarser levels beside walls: which fine cells a coarse cell stands for, and what may be interpolated.

A coarse cell stands for the largest connected part of its fine cells; of two equal parts for none. Nothing is
interpolated through a closed face. Fine cells where that changes the weights are *irregular*: they have norm
0 in the plain transfer, and are added one by one from a list.
"""

from __future__ import annotations

from game.compiler.decorator import inner_kernel, lean_kernel

OWN, ALONG_X, ALONG_Y, ACROSS = 1, 2, 4, 8
REGULAR = 15


@inner_kernel
def _spread(stands, cx, cy, top, bottom, left, right, mark):
    """Let a mark spread within a block of fine cells through open faces; how many cells have it."""
    count, changed = 1, True
    while changed:
        changed = False
        for j in range(top, bottom + 1):
            for i in range(left, right + 1):
                if stands[j, i] != 0:
                    continue
                near = j > top and cy[j, i] > 0.0 and stands[j - 1, i] == mark
                near = near or (j < bottom and cy[j + 1, i] > 0.0 and stands[j + 1, i] == mark)
                near = near or (i > left and cx[j, i] > 0.0 and stands[j, i - 1] == mark)
                near = near or (i < right and cx[j, i + 1] > 0.0 and stands[j, i + 1] == mark)
                if near:
                    stands[j, i] = mark
                    count += 1
                    changed = True
    return count


@inner_kernel
def _choose(stands, inverse, cx, cy, top, bottom, left, right):
    """Set stands to 1 in the largest connected part of a block, else to 0."""
    for j in range(top, bottom + 1):
        for i in range(left, right + 1):
            stands[j, i] = 0 if inverse[j, i] > 0.0 else -1
    best, most, mark = 0, 0, 0
    for j in range(top, bottom + 1):
        for i in range(left, right + 1):
            if stands[j, i] == 0:
                mark += 1
                stands[j, i] = mark
                count = _spread(stands, cx, cy, top, bottom, left, right, mark)
                if count > most:
                    best, most = mark, count
                elif count == most:
                    best = 0
    for j in range(top, bottom + 1):
        for i in range(left, right + 1):
            stands[j, i] = 1 if best > 0 and stands[j, i] == best else 0


@lean_kernel
def choose_cells(stands, inverse, cx, cy, x_members, y_members):
    """stands (ny, nx) int64: 1 for fine cells that their coarse cell stands for."""
    for j in range(y_members.shape[0]):
        for i in range(x_members.shape[0]):
            _choose(
                stands, inverse, cx, cy, y_members[j, 0], y_members[j, 1], x_members[i, 0], x_members[i, 1]
            )


@lean_kernel
def coarsen_x(fine, coarse, stands, mid, ratio, members):
    """Conductances across x of a coarse level: of the fine faces in it, between cells that are stood for."""
    nx = fine.shape[1] - 1
    for j in range(coarse.shape[0]):
        for i in range(coarse.shape[1]):
            face, total = mid[i], 0.0
            for r in range(members[j, 0], members[j, 1] + 1):
                left = stands[r, (face - 1 + nx) % nx] if i > 0 or fine[r, 0] == fine[r, nx] else 1
                right = stands[r, face % nx] if face < nx or fine[r, 0] == fine[r, nx] else 1
                if left == 1 and right == 1:
                    total += fine[r, face]
            coarse[j, i] = total * ratio[i]


@lean_kernel
def coarsen_y(fine, coarse, stands, mid, ratio, members):
    """The same across y."""
    ny = fine.shape[0] - 1
    for j in range(coarse.shape[0]):
        for i in range(coarse.shape[1]):
            face, total = mid[j], 0.0
            for r in range(members[i, 0], members[i, 1] + 1):
                below = stands[(face - 1 + ny) % ny, r] if j > 0 or fine[0, r] == fine[ny, r] else 1
                above = stands[face % ny, r] if face < ny or fine[0, r] == fine[ny, r] else 1
                if below == 1 and above == 1:
                    total += fine[face, r]
            coarse[j, i] = total * ratio[j]


@inner_kernel
def _ways(stands, cx, cy, j, i, to_x, to_y):
    """Which of the four coarse cells around a fine cell it may take values from, as bits."""
    ny, nx = stands.shape
    x, y = (i + to_x + nx) % nx, (j + to_y + ny) % ny
    face_x, face_y = (i + 1 if to_x > 0 else i), (j + 1 if to_y > 0 else j)
    open_x = to_x == 0 or cx[j, face_x] > 0.0
    open_y = to_y == 0 or cy[face_y, i] > 0.0
    way = OWN if stands[j, i] == 1 else 0
    if open_x and stands[j, x] == 1:
        way |= ALONG_X
    if open_y and stands[y, i] == 1:
        way |= ALONG_Y
    beside = (to_y == 0 or cy[face_y, x] > 0.0, to_x == 0 or cx[y, face_x] > 0.0)
    if stands[y, x] == 1 and ((open_x and beside[0]) or (open_y and beside[1])):
        way |= ACROSS
    return way


@inner_kernel
def weights(way, w, v, q, r):
    """Weights of the own coarse cell, those along x and y and across, w, v of x (near, far), q, r of y."""
    a, b, c, d = w * q, v * q, w * r, v * r
    if not way & ALONG_X:
        a, b = a + b, 0.0
    if not way & ALONG_Y:
        a, c = a + c, 0.0
    if not way & ACROSS:
        a, d = a + d, 0.0
    if way & OWN:
        return a, b, c, d
    rest = b + c + d
    if rest > 0.0:
        return 0.0, b / rest, c / rest, d / rest
    return 0.0, 0.0, 0.0, 0.0


@lean_kernel
def list_irregular(norm, ways, listed, stands, inverse, cx, cy, x, y):
    """norm 1 for regular fine cells, 0 for others, which are listed with their ways; how many.

    x, y: (near, far, share) of the axes. An end without a far cell (share 0) is no irregularity.
    """
    ny, nx = norm.shape
    count = 0
    for j in range(ny):
        up = y[1][j] - y[0][j]
        to_y = 0 if up == 0 else (1 if up > 0 else -1)
        for i in range(nx):
            norm[j, i] = 0.0
            if inverse[j, i] <= 0.0:
                continue
            right = x[1][i] - x[0][i]
            to_x = 0 if right == 0 else (1 if right > 0 else -1)
            way = _ways(stands, cx, cy, j, i, to_x, to_y)
            if way == REGULAR:
                norm[j, i] = 1.0
            else:
                listed[count], ways[count] = j * nx + i, way
                count += 1
    return count


@lean_kernel
def restrict_irregular(r, coarse, ways, listed, x, y):
    """Add the residual of irregular fine cells, r (ny + 2, nx + 2), to the coarse right side."""
    my, mx = coarse.shape
    nx = r.shape[1] - 2
    for k in range(listed.size):
        j, i = listed[k] // nx, listed[k] % nx
        a, b, c, d = weights(ways[k], x[2][i, 0], x[2][i, 1], y[2][j, 0], y[2][j, 1])
        near, far = x[0][i], (x[1][i] + mx) % mx
        low, high = y[0][j], (y[1][j] + my) % my
        value = r[j + 1, i + 1]
        coarse[low, near] += a * value
        coarse[low, far] += b * value
        coarse[high, near] += c * value
        coarse[high, far] += d * value


@lean_kernel
def prolong_irregular(coarse, fine, ways, listed, x, y):
    """Add what is interpolated to irregular fine cells; both padded by one."""
    nx = fine.shape[1] - 2
    for k in range(listed.size):
        j, i = listed[k] // nx, listed[k] % nx
        a, b, c, d = weights(ways[k], x[2][i, 0], x[2][i, 1], y[2][j, 0], y[2][j, 1])
        one, other = coarse[y[0][j] + 1], coarse[y[1][j] + 1]
        near, far = x[0][i] + 1, x[1][i] + 1
        fine[j + 1, i + 1] += (a * one[near] + b * one[far]) + (c * other[near] + d * other[far])
