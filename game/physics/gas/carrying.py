"""Semi-Lagrangian advection: a new value is the old one where the gas comes from (Stam 1999).

What is carried is padded with ghosts (`grid.ghosts`); places count from the first unpadded value.
"""

from __future__ import annotations

import math

import numpy as np

from game.compiler.decorator import inner_kernel, kernel, lean_kernel
from game.physics.gas.places import origin
from game.physics.grid.borders import BOTTOM, LEFT, PERIODIC
from game.physics.grid.cubic import cubic_pair, cubic_sum, limited_eight, limited_four
from game.physics.grid.layout import PAD
from game.physics.grid.sampling import (
    bounds_at,
    clamped,
    corner,
    cubic_at,
    linear_at,
    wrapped,
)

LINEAR, CUBIC, LIMITED = range(3)  # how values between points are found; limited: cubic without new extrema
INSIDE = 1e-9


@inner_kernel
def _place(x, count, period, joined):
    """A place brought to where a padded field of so many values answers."""
    if joined:
        return wrapped(x, period)
    return clamped(x, -1.0, count - INSIDE)


@inner_kernel(forceinline=True)
def _value(flat, width, x, y, how):
    if how == LINEAR:
        return linear_at(flat, width, x, y)
    found = cubic_at(flat, width, x, y)
    if how == LIMITED:
        low, high = bounds_at(flat, width, x, y)
        return clamped(found, low, high)
    return found


@inner_kernel(forceinline=True)
def _cubic_from(flat, width, moves, one, other, place, half, bounds):
    """The cubic value at a place less half of two moves: see `origin`."""
    column, row, f, g = origin(moves, np.uint64(one), np.uint64(other), place, half, bounds)
    return cubic_sum(flat, corner(row, column, 1, width, 1), np.uint64(width), f, g)


@lean_kernel
def carry_u(padded, shift, way, kinds, how, out):
    """out (ny, nx + 1): padded u where each face comes from, back by way times its shift."""
    ny, nx = shift.shape[0], shift.shape[1]
    joined_x, joined_y = kinds[LEFT] == PERIODIC, kinds[BOTTOM] == PERIODIC
    half, flat, width = 0.5 * way, padded.reshape(-1), padded.shape[1]
    if how == CUBIC and not (joined_x or joined_y):
        all_moves, bounds = shift.reshape(-1), (-1.0, nx + 1 - INSIDE, -1.0, ny - INSIDE)
        for j in range(ny):
            goal, at = out[j], 2 * j * nx
            for i in range(nx + 1):
                one, other = at + 2 * max(i - 1, 0), at + 2 * min(i, nx - 1)
                place = (float(i), float(j))
                goal[i] = _cubic_from(flat, width, all_moves, one, other, place, half, bounds)
        return
    for j in range(ny):
        goal, moves = out[j], shift[j]
        for i in range(nx + 1):
            left, right = i - 1, i
            if i == 0:
                left = nx - 1 if joined_x else 0
            elif i == nx:
                right = 0 if joined_x else nx - 1
            x = _place(i - half * (moves[left, 0] + moves[right, 0]), nx + 1, nx, joined_x)
            y = _place(j - half * (moves[left, 1] + moves[right, 1]), ny, ny, joined_y)
            goal[i] = _value(flat, width, x, y, how)


@lean_kernel
def carry_v(padded, shift, way, kinds, how, out):
    """out (ny + 1, nx): the same for v."""
    ny, nx = shift.shape[0], shift.shape[1]
    joined_x, joined_y = kinds[LEFT] == PERIODIC, kinds[BOTTOM] == PERIODIC
    half, flat, width = 0.5 * way, padded.reshape(-1), padded.shape[1]
    if how == CUBIC and not (joined_x or joined_y):
        all_moves, bounds = shift.reshape(-1), (-1.0, nx - INSIDE, -1.0, ny + 1 - INSIDE)
        for j in range(ny + 1):
            goal, below, above = out[j], 2 * nx * max(j - 1, 0), 2 * nx * min(j, ny - 1)
            for i in range(nx):
                place = (float(i), float(j))
                one, other = below + 2 * i, above + 2 * i
                goal[i] = _cubic_from(flat, width, all_moves, one, other, place, half, bounds)
        return
    for j in range(ny + 1):
        below, above = j - 1, j
        if j == 0:
            below = ny - 1 if joined_y else 0
        elif j == ny:
            above = 0 if joined_y else ny - 1
        goal, low, high = out[j], shift[below], shift[above]
        for i in range(nx):
            x = _place(i - half * (low[i, 0] + high[i, 0]), nx, nx, joined_x)
            y = _place(j - half * (low[i, 1] + high[i, 1]), ny + 1, ny, joined_y)
            goal[i] = _value(flat, width, x, y, how)


@inner_kernel
def _linear_fields(flat, at, row, f, g, out):
    """Bilinear, all fields of a cell; at: the lower left value, row: values from one row to the next."""
    step = np.uint64(out.size)
    a, b, c, d = (1.0 - g) * (1.0 - f), (1.0 - g) * f, g * (1.0 - f), g * f
    for k in range(out.size):
        m = at + np.uint64(k)
        n = m + row
        out[k] = (a * flat[m] + b * flat[m + step]) + (c * flat[n] + d * flat[n + step])


@inner_kernel(forceinline=True)
def _cubic_fields(flat, at, row, f, g, fields, values, goal):
    """Bicubic, kept within the four values around; at: the lowest left of the sixteen values; goal: where the
    cell's fields begin in all values.

    Five to eight fields are eight at once, where there are as many numbers: what is written too far belongs
    to cells that come later. Else four at once, the last four perhaps once more; below four one by one.
    """
    weights, one = cubic_pair(f, g), np.uint64(fields)
    if fields < 4:
        _few_fields(flat, at, row, weights, values[goal : goal + fields])
        return
    last = at + np.uint64(3) * (row + one) + np.uint64(8)
    if 4 < fields <= 8 and last <= np.uint64(flat.size) and goal + 8 <= values.size:
        limited_eight(flat, at, one, row, weights, values, np.uint64(goal))
        return
    for k in range(0, fields - 3, 4):
        limited_four(flat, at + np.uint64(k), one, row, weights, values, np.uint64(goal + k))
    if fields % 4:
        k = fields - 4
        limited_four(flat, at + np.uint64(k), one, row, weights, values, np.uint64(goal + k))


@inner_kernel
def _few_fields(flat, at, row, weights, out):
    """The same field by field."""
    one = np.uint64(out.size)
    two = one + one
    three = two + one
    a, b, c, d, p, q, r, s = weights
    for k in range(out.size):
        k0 = at + np.uint64(k)
        k1 = k0 + row
        k2 = k1 + row
        k3 = k2 + row
        e0, e1, e2, e3 = flat[k1 + one], flat[k1 + two], flat[k2 + one], flat[k2 + two]
        outer = p * ((a * flat[k0] + d * flat[k0 + three]) + (b * flat[k0 + one] + c * flat[k0 + two]))
        outer += s * ((a * flat[k3] + d * flat[k3 + three]) + (b * flat[k3 + one] + c * flat[k3 + two]))
        inner = q * ((a * flat[k1] + d * flat[k1 + three]) + (b * e0 + c * e1))
        inner += r * ((a * flat[k2] + d * flat[k2 + three]) + (b * e2 + c * e3))
        low, other = (e0 if e0 < e1 else e1), (e2 if e2 < e3 else e3)
        high, another = (e0 if e0 > e1 else e1), (e2 if e2 > e3 else e3)
        out[k] = clamped(outer + inner, low if low < other else other, high if high > another else another)


@inner_kernel
def _beside_walls(padded, ax, ay, x, y, joined, out):
    """Linear, from the cells that can be reached from the place's own cell; others count as that one."""
    ny, nx = ay.shape[0] - 1, ax.shape[1] - 1
    i, j = math.floor(x + 0.5), math.floor(y + 0.5)
    i = i if joined[0] else min(max(i, 0), nx - 1)
    j = j if joined[1] else min(max(j, 0), ny - 1)
    f, g = abs(x - i), abs(y - j)
    k, m = (i + 1 if x > i else i - 1), (j + 1 if y > j else j - 1)
    u, r = (i + nx) % nx, (j + ny) % ny
    c, s = (k + nx) % nx, (m + ny) % ny
    face_x, face_y = (u + 1 if k > i else u), (r + 1 if m > j else r)
    open_x, open_y = ax[r, face_x] > 0.0, ay[face_y, u] > 0.0
    across = (open_x and ay[face_y, c] > 0.0) or (open_y and ax[s, face_x] > 0.0)
    f, g = min(f, 0.5), min(g, 0.5)
    for n in range(out.size):
        own = padded[j + PAD, i + PAD, n]
        one = padded[j + PAD, k + PAD, n] if open_x else own
        two = padded[m + PAD, i + PAD, n] if open_y else own
        both = padded[m + PAD, k + PAD, n] if across else own
        out[n] = (1.0 - g) * ((1.0 - f) * own + f * one) + g * ((1.0 - f) * two + f * both)


@lean_kernel
def carry_scalars(padded, shift, way, kinds, how, out):
    """out (ny, nx, fields): padded scalars where each cell's gas comes from."""
    ny, nx = shift.shape[0], shift.shape[1]
    flat, row, fields = padded.reshape(-1), np.uint64(padded.shape[1] * padded.shape[2]), padded.shape[2]
    values = out.reshape(-1)
    joined_x, joined_y = kinds[LEFT] == PERIODIC, kinds[BOTTOM] == PERIODIC
    if how != LINEAR and not (joined_x or joined_y):
        all_moves, bounds = shift.reshape(-1), (-1.0, nx - INSIDE, -1.0, ny - INSIDE)
        for j in range(ny):
            for i in range(nx):
                k = j * nx + i
                move, place = np.uint64(2 * k), (float(i), float(j))
                column, line, f, g = origin(all_moves, move, move, place, 0.5 * way, bounds)
                at = corner(line, column, 1, padded.shape[1], fields)
                _cubic_fields(flat, at, row, f, g, fields, values, k * fields)
        return
    for j in range(ny):
        moves, goals = shift[j], out[j]
        for i in range(nx):
            x = _place(i - way * moves[i, 0], nx, nx, joined_x)
            y = _place(j - way * moves[i, 1], ny, ny, joined_y)
            left, low = math.floor(x), math.floor(y)
            before = 0 if how == LINEAR else 1
            at = corner(int(low), int(left), before, padded.shape[1], padded.shape[2])
            if how == LINEAR:
                _linear_fields(flat, at, row, x - left, y - low, goals[i])
            else:
                _cubic_fields(flat, at, row, x - left, y - low, fields, values, (j * nx + i) * fields)


@kernel
def carry_beside_walls(padded, shift, way, kinds, clear, ax, ay, out):
    """Do cells near closed faces again, so that nothing is taken through a wall; closed cells stay."""
    ny, nx = shift.shape[0], shift.shape[1]
    joined = (kinds[LEFT] == PERIODIC, kinds[BOTTOM] == PERIODIC)
    for j in range(ny):
        for i in range(nx):
            dx, dy = way * shift[j, i, 0], way * shift[j, i, 1]
            if clear[j, i] > max(abs(dx), abs(dy)) + 2.0:
                continue
            if ax[j, i] <= 0.0 and ax[j, i + 1] <= 0.0 and ay[j, i] <= 0.0 and ay[j + 1, i] <= 0.0:
                out[j, i] = padded[j + PAD, i + PAD]
                continue
            x, y = _place(i - dx, nx, nx, joined[0]), _place(j - dy, ny, ny, joined[1])
            _beside_walls(padded, ax, ay, x, y, joined, out[j, i])
