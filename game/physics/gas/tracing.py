"""Where the gas in each cell was a step ago: the displacement of every cell's centre, in cells.

Faces take the mean displacement of their two cells. That is of second order as everything else here, and
costs one trace a cell instead of three.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, kernel, lean_kernel
from game.physics.gas.places import FARTHEST, midpoint
from game.physics.grid import borders
from game.physics.grid.sampling import clamped, wrapped
from game.physics.kernels.magnitudes import from_bits, largest

STRIDE = 0.5  # cells between two looks for walls along a way


@lean_kernel
def largest_speed(u, v):
    """The larger of the largest of |u| and of |v|, m/s; nan if there is one."""
    most = 0
    for field in (u, v):
        for j in range(field.shape[0]):
            most = largest(field[j], most)
    return from_bits(most)


@kernel
def centre_velocities(u, v, before_u, before_v, ahead, w):
    """w (ny, nx, 2): the velocity at centres, ahead of a step that ended with u, v by so many steps."""
    now = 0.5 * (1.0 + ahead)
    then = 0.5 * ahead
    for j in range(w.shape[0]):
        row, low, high, old, old_low, old_high = (
            u[j],
            v[j],
            v[j + 1],
            before_u[j],
            before_v[j],
            before_v[j + 1],
        )
        for i in range(w.shape[1]):
            w[j, i, 0] = now * (row[i] + row[i + 1]) - then * (old[i] + old[i + 1])
            w[j, i, 1] = now * (low[i] + high[i]) - then * (old_low[i] + old_high[i])


@inner_kernel
def _velocity_at(w, x, y, joined_x, joined_y):
    """Bilinear between centres; as at the outermost centres beyond them."""
    ny, nx = w.shape[0], w.shape[1]
    x = wrapped(x, nx) if joined_x else clamped(x, 0.0, nx - 1.0)
    y = wrapped(y, ny) if joined_y else clamped(y, 0.0, ny - 1.0)
    i, j = int(x), int(y)
    f, g = x - i, y - j
    i = min(i, nx - 1)
    j = min(j, ny - 1)
    k, m = i + 1, j + 1
    if k == nx:
        k = 0 if joined_x else i
    if m == ny:
        m = 0 if joined_y else j
    a, b = (1.0 - g) * (1.0 - f), (1.0 - g) * f
    c, d = g * (1.0 - f), g * f
    along = (a * w[j, i, 0] + b * w[j, k, 0]) + (c * w[m, i, 0] + d * w[m, k, 0])
    up = (a * w[j, i, 1] + b * w[j, k, 1]) + (c * w[m, i, 1] + d * w[m, k, 1])
    return along, up


@inner_kernel
def _side_limit(kind, wall, beyond):
    """How far a way may lead at a side: to a wall, or a cell beyond an open one."""
    if kind == borders.PERIODIC:
        return math.inf if beyond > 0.0 else -math.inf
    return beyond if kind in (borders.OPEN, borders.INFLOW) else wall


@inner_kernel
def free_way(ax, ay, j, i, dx, dy, joined):
    """How much (0 to 1) of a displacement back from a cell's centre can be gone before a closed face."""
    ny, nx = ay.shape[0] - 1, ax.shape[1] - 1
    steps = math.ceil(max(abs(dx), abs(dy)) / STRIDE)
    x, y = i, j
    for k in range(1, steps + 1):
        part = k / steps
        nu, nv = math.floor(i - part * dx + 0.5), math.floor(j - part * dy + 0.5)
        if not joined[0]:
            nu = min(max(nu, 0), nx - 1)
        if not joined[1]:
            nv = min(max(nv, 0), ny - 1)
        if nu == x and nv == y:
            continue
        u, r = (x + nx) % nx if joined[0] else x, (y + ny) % ny if joined[1] else y
        c, s = (nu + nx) % nx if joined[0] else nu, (nv + ny) % ny if joined[1] else nv
        face_x, face_y = u + (1 if nu > x else 0), r + (1 if nv > y else 0)
        way_x = (nu == x or ax[r, face_x] > 0.0) and (nv == y or ay[face_y, c] > 0.0)
        way_y = (nv == y or ay[face_y, u] > 0.0) and (nu == x or ax[s, face_x] > 0.0)
        if not (way_x or way_y):
            return (k - 1) / steps
        x, y = nu, nv
    return 1.0


@lean_kernel
def trace(w, scale, kinds, straight, shift):
    """shift (ny, nx, 2): displacement in cells over a step, by the midpoint rule; scale is dt / h.

    straight: with the velocity at the centre itself (Euler). The way back, centre minus shift, ends on walls
    and at most a cell beyond open sides.
    """
    ny, nx = w.shape[0], w.shape[1]
    joined_x, joined_y = kinds[borders.LEFT] == borders.PERIODIC, kinds[borders.BOTTOM] == borders.PERIODIC
    low_x, high_x = (
        _side_limit(kinds[borders.LEFT], -0.5, -1.5),
        _side_limit(kinds[borders.RIGHT], nx - 0.5, nx + 0.5),
    )
    low_y, high_y = (
        _side_limit(kinds[borders.BOTTOM], -0.5, -1.5),
        _side_limit(kinds[borders.TOP], ny - 0.5, ny + 0.5),
    )
    if not (straight or joined_x or joined_y):
        flat, goal, bounds = w.reshape(-1), shift.reshape(-1), (low_x, high_x, low_y, high_y)
        for j in range(ny):
            for i in range(nx):
                midpoint(flat, (ny, nx), j, i, scale, bounds, goal)
        return
    for j in range(ny):
        for i in range(nx):
            dx, dy = scale * w[j, i, 0], scale * w[j, i, 1]
            if not straight and abs(dx) < FARTHEST and abs(dy) < FARTHEST:
                vx, vy = _velocity_at(w, i - 0.5 * dx, j - 0.5 * dy, joined_x, joined_y)
                dx, dy = scale * vx, scale * vy
            if not (abs(dx) < FARTHEST and abs(dy) < FARTHEST):
                dx, dy = 0.0, 0.0
            shift[j, i, 0] = i - clamped(i - dx, low_x, high_x)
            shift[j, i, 1] = j - clamped(j - dy, low_y, high_y)


@kernel
def stop_at_walls(shift, clear, ax, ay, kinds):
    """Shorten ways that lead through closed faces. clear (ny, nx): cells to the nearest of them."""
    joined = (kinds[borders.LEFT] == borders.PERIODIC, kinds[borders.BOTTOM] == borders.PERIODIC)
    for j in range(shift.shape[0]):
        for i in range(shift.shape[1]):
            dx, dy = shift[j, i, 0], shift[j, i, 1]
            if clear[j, i] <= max(abs(dx), abs(dy)) + 1.0 and (dx != 0.0 or dy != 0.0):
                part = free_way(ax, ay, j, i, dx, dy, joined)
                shift[j, i, 0], shift[j, i, 1] = part * dx, part * dy
