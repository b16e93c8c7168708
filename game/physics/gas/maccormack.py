"""MacCormack's correction of semi-Lagrangian advection (Selle, Fedkiw, Kim, Liu and Rossignac 2008)."""

from __future__ import annotations

import math

from game.compiler.decorator import kernel
from game.physics.gas.carrying import INSIDE
from game.physics.grid.borders import BOTTOM, LEFT, PERIODIC
from game.physics.grid.layout import PAD
from game.physics.grid.sampling import bounds_at, clamped, wrapped


@kernel
def correct_face(padded, shift, kinds, axis, returned, out):
    """out += half of what there and back has lost, kept within the four old values it comes from.

    padded: the old values; returned (as out): those carried there and back; axis 0: u, 1: v.
    """
    rows, columns = out.shape
    ny, nx = shift.shape[0], shift.shape[1]
    joined_x, joined_y = kinds[LEFT] == PERIODIC, kinds[BOTTOM] == PERIODIC
    for j in range(rows):
        for i in range(columns):
            one_i, one_j = i, j
            if axis == 0:
                one_i = i - 1 if i > 0 else (nx - 1 if joined_x else 0)
            else:
                one_j = j - 1 if j > 0 else (ny - 1 if joined_y else 0)
            two_i = i if i < nx else (0 if joined_x else nx - 1)
            two_j = j if j < ny else (0 if joined_y else ny - 1)
            x = i - 0.5 * (shift[one_j, one_i, 0] + shift[two_j, two_i, 0])
            y = j - 0.5 * (shift[one_j, one_i, 1] + shift[two_j, two_i, 1])
            x = wrapped(x, nx) if joined_x else clamped(x, -1.0, columns - INSIDE)
            y = wrapped(y, ny) if joined_y else clamped(y, -1.0, rows - INSIDE)
            low, high = bounds_at(padded.reshape(-1), padded.shape[1], x, y)
            out[j, i] = clamped(out[j, i] + 0.5 * (padded[j + PAD, i + PAD] - returned[j, i]), low, high)


@kernel
def correct_scalars(padded, shift, kinds, returned, out):
    """The same for scalars (ny, nx, fields)."""
    ny, nx, fields = out.shape
    joined_x, joined_y = kinds[LEFT] == PERIODIC, kinds[BOTTOM] == PERIODIC
    for j in range(ny):
        for i in range(nx):
            x, y = i - shift[j, i, 0], j - shift[j, i, 1]
            x = wrapped(x, nx) if joined_x else clamped(x, -1.0, nx - INSIDE)
            y = wrapped(y, ny) if joined_y else clamped(y, -1.0, ny - INSIDE)
            c, r = math.floor(x) + PAD, math.floor(y) + PAD
            for k in range(fields):
                one, two = padded[r, c, k], padded[r, c + 1, k]
                three, four = padded[r + 1, c, k], padded[r + 1, c + 1, k]
                low, high = min(min(one, two), min(three, four)), max(max(one, two), max(three, four))
                found = out[j, i, k] + 0.5 * (padded[j + PAD, i + PAD, k] - returned[j, i, k])
                out[j, i, k] = clamped(found, low, high)
