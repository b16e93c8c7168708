"""Accelerations of the gas: buoyancy, a given field of forces, vorticity confinement."""

from __future__ import annotations

import math

from game.physics.grid.borders import BOTTOM, INFLOW, LEFT, NO_SLIP, PERIODIC, RIGHT, TOP, WALL
from game.physics.kernels.jit import kernel
from game.physics.kernels.lean import inner_kernel

CALM = 1e-9  # 1/s per cell: a steepness of the vorticity below this has no direction


@kernel
def cell_forces(scalars, given, weights, gravity, ambient, out):
    """out (ny, nx, 2) m/s²: the given force and gravity times the excess of density.

    weights (2,): column of the temperature (-1: none) and of the smoke; gravity (3,): x, y m/s² and how much
    heavier than air smoke of 1 is. Hot gas is lighter by (T - ambient) / ambient (ideal gas, small changes).
    """
    ny, nx = out.shape[0], out.shape[1]
    warm, thick = int(weights[0]), int(weights[1])
    for j in range(ny):
        for i in range(nx):
            excess = 0.0
            if warm >= 0:
                excess -= (scalars[j, i, warm] - ambient) / ambient
            if thick >= 0:
                excess += gravity[2] * scalars[j, i, thick]
            out[j, i, 0] = given[j, i, 0] + gravity[0] * excess
            out[j, i, 1] = given[j, i, 1] + gravity[1] * excess


@inner_kernel
def _curl(u, v, j, i, ny, nx, joined):
    """Vorticity times h at a centre from centre velocities; at sides from the nearest ones."""
    left, right, low, high = i - 1, i + 1, j - 1, j + 1
    if joined[0]:
        left, right = (left + nx) % nx, right % nx
    if joined[1]:
        low, high = (low + ny) % ny, high % ny
    left, right, low, high = max(left, 0), min(right, nx - 1), max(low, 0), min(high, ny - 1)
    rise = (v[j, right] + v[j + 1, right]) - (v[j, left] + v[j + 1, left])
    run = (u[high, i] + u[high, i + 1]) - (u[low, i] + u[low, i + 1])
    return 0.25 * (rise - run)


@kernel
def confine(u, v, strength, kinds, curl, out):
    """Add strength N x omega to out (m/s²; Fedkiw, Stam and Jensen 2001): N points to where |omega| grows.

    strength: m/s for each 1/s, their epsilon times the cell, over the cell, as curl here is omega h.
    """
    ny, nx = curl.shape
    joined = (kinds[LEFT] == PERIODIC, kinds[BOTTOM] == PERIODIC)
    for j in range(ny):
        for i in range(nx):
            curl[j, i] = _curl(u, v, j, i, ny, nx, joined)
    for j in range(1, ny - 1):
        for i in range(1, nx - 1):
            gx = 0.5 * (abs(curl[j, i + 1]) - abs(curl[j, i - 1]))
            gy = 0.5 * (abs(curl[j + 1, i]) - abs(curl[j - 1, i]))
            steep = math.sqrt(gx * gx + gy * gy)
            if steep > CALM:
                out[j, i, 0] += strength * gy / steep * curl[j, i]
                out[j, i, 1] -= strength * gx / steep * curl[j, i]


@inner_kernel
def _holds(kind):
    """Whether the velocity through a side is given, so that no force changes it."""
    return kind in (WALL, NO_SLIP, INFLOW)


@kernel
def face_forces(cells, kinds, fu, fv):
    """Mean of the two cells of each face: fu (ny, nx + 1), fv (ny + 1, nx); 0 where a side holds it."""
    ny, nx = cells.shape[0], cells.shape[1]
    for j in range(ny):
        goal, row = fu[j], cells[j]
        for i in range(1, nx):
            goal[i] = 0.5 * (row[i - 1, 0] + row[i, 0])
        if kinds[LEFT] == PERIODIC:
            goal[0] = 0.5 * (row[nx - 1, 0] + row[0, 0])
            goal[nx] = goal[0]
        else:
            goal[0] = 0.0 if _holds(kinds[LEFT]) else row[0, 0]
            goal[nx] = 0.0 if _holds(kinds[RIGHT]) else row[nx - 1, 0]
    for j in range(1, ny):
        goal, low, high = fv[j], cells[j - 1], cells[j]
        for i in range(nx):
            goal[i] = 0.5 * (low[i, 1] + high[i, 1])
    for i in range(nx):
        if kinds[BOTTOM] == PERIODIC:
            fv[0, i] = 0.5 * (cells[ny - 1, i, 1] + cells[0, i, 1])
            fv[ny, i] = fv[0, i]
        else:
            fv[0, i] = 0.0 if _holds(kinds[BOTTOM]) else cells[0, i, 1]
            fv[ny, i] = 0.0 if _holds(kinds[TOP]) else cells[ny - 1, i, 1]


@kernel
def push(u, v, fu, fv, dt):
    """Velocities gain dt times the forces of faces."""
    for j in range(u.shape[0]):
        goal, force = u[j], fu[j]
        for i in range(u.shape[1]):
            goal[i] += dt * force[i]
    for j in range(v.shape[0]):
        goal, force = v[j], fv[j]
        for i in range(v.shape[1]):
            goal[i] += dt * force[i]
