"""The divergence of faces partly closed by solids, and the pressure gradient taken from them."""

from __future__ import annotations

from game.compiler.decorator import kernel
from game.physics.grid import borders


@kernel
def right_side(u, v, solids, expansion, h, scale, b):
    """b (ny, nx) = (expansion h - outflow) scale: what the pressure has to make good.

    The outflow counts the gas through the open parts of faces and the solid through the closed ones (Batty,
    Bertails and Bridson 2007 with the normal flux).
    """
    ny, nx = b.shape
    for j in range(ny):
        row, part, own = u[j], solids.ax[j], solids.u[j]
        low, high, part_low, part_high = v[j], v[j + 1], solids.ay[j], solids.ay[j + 1]
        own_low, own_high, goal, grows = solids.v[j], solids.v[j + 1], b[j], expansion[j]
        for i in range(nx):
            right = own[i + 1] + part[i + 1] * (row[i + 1] - own[i + 1])
            left = own[i] + part[i] * (row[i] - own[i])
            up = own_high[i] + part_high[i] * (high[i] - own_high[i])
            down = own_low[i] + part_low[i] * (low[i] - own_low[i])
            goal[i] = scale * (grows[i] * h - ((right - left) + (up - down)))


@kernel
def right_side_free(u, v, expansion, h, scale, b):
    """The same without solids."""
    ny, nx = b.shape
    for j in range(ny):
        row, low, high, goal, grows = u[j], v[j], v[j + 1], b[j], expansion[j]
        for i in range(nx):
            goal[i] = scale * (grows[i] * h - ((row[i + 1] - row[i]) + (high[i] - low[i])))


@kernel
def pressure_ghosts(p, kinds, for_gradient):
    """Ghosts of the pressure: for gradients such that a wall has none and an open side has p = 0 on itself;
    for the solver 0 beyond open sides. Periodic sides go on.
    """
    ny, nx = p.shape[0] - 2, p.shape[1] - 2
    for j in range(1, ny + 1):
        if kinds[borders.LEFT] == borders.PERIODIC:
            p[j, 0], p[j, nx + 1] = p[j, nx], p[j, 1]
            continue
        p[j, 0] = (-p[j, 1] if kinds[borders.LEFT] == borders.OPEN else p[j, 1]) if for_gradient else 0.0
        p[j, nx + 1] = (
            (-p[j, nx] if kinds[borders.RIGHT] == borders.OPEN else p[j, nx]) if for_gradient else 0.0
        )
    for i in range(1, nx + 1):
        if kinds[borders.BOTTOM] == borders.PERIODIC:
            p[0, i], p[ny + 1, i] = p[ny, i], p[1, i]
            continue
        p[0, i] = (-p[1, i] if kinds[borders.BOTTOM] == borders.OPEN else p[1, i]) if for_gradient else 0.0
        p[ny + 1, i] = (
            (-p[ny, i] if kinds[borders.TOP] == borders.OPEN else p[ny, i]) if for_gradient else 0.0
        )


@kernel
def subtract_gradient(u, v, p, slope):
    """u -= slope (p - p to the left), and v alike; p is padded by one, with ghosts for gradients."""
    ny, nx = v.shape[0] - 1, u.shape[1] - 1
    for j in range(ny):
        goal, high = u[j], p[j + 1]
        for i in range(nx + 1):
            goal[i] -= slope * (high[i + 1] - high[i])
    for j in range(ny + 1):
        goal, low, high = v[j], p[j, 1:], p[j + 1, 1:]
        for i in range(nx):
            goal[i] -= slope * (high[i] - low[i])


@kernel
def set_closed_faces(u, v, solids):
    """Closed faces move as the solid does."""
    for j in range(u.shape[0]):
        for i in range(u.shape[1]):
            if solids.ax[j, i] <= 0.0:
                u[j, i] = solids.u[j, i]
    for j in range(v.shape[0]):
        for i in range(v.shape[1]):
            if solids.ay[j, i] <= 0.0:
                v[j, i] = solids.v[j, i]
