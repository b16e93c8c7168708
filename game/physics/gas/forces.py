"""Accelerations of the gas: buoyancy, a given field of forces, vorticity confinement."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import inner_kernel, kernel, lean_kernel
from game.physics.grid import borders

CALM = 1e-9  # 1/s per cell: a steepness of the vorticity below this has no direction


class Pushed(NamedTuple):
    """Velocities, and the forces on them."""

    u: NDArray[np.float64]  # (ny, nx + 1)
    v: NDArray[np.float64]  # (ny + 1, nx)
    force_u: NDArray[np.float64]
    force_v: NDArray[np.float64]


@inner_kernel
def _row_of_cells(scalars, given, weights, gravity, j, out):
    """Row j of `cell_forces`."""
    warm, thick = int(weights[0]), int(weights[1])
    fields, own, ambient = scalars[j], given[j], gravity[3]
    row, x, y = out[j], gravity[0], gravity[1]
    for i in range(row.shape[0]):
        excess = 0.0
        if warm >= 0:
            excess -= (fields[i, warm] - ambient) / ambient
        if thick >= 0:
            excess += gravity[2] * fields[i, thick]
        row[i, 0] = own[i, 0] + x * excess
        row[i, 1] = own[i, 1] + y * excess


@lean_kernel
def cell_forces(scalars, given, weights, gravity, out):
    """out (ny, nx, 2) m/s²: the given force and gravity times the excess of density.

    weights (2,): column of the temperature (-1: none) and of the smoke; gravity (4,): x, y m/s², how much
    heavier than air smoke of 1 is, and the ambient temperature K. Hot gas is lighter by (T - ambient) /
    ambient (ideal gas, small changes).
    """
    for j in range(out.shape[0]):
        _row_of_cells(scalars, given, weights, gravity, j, out)


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
    joined = (kinds[borders.LEFT] == borders.PERIODIC, kinds[borders.BOTTOM] == borders.PERIODIC)
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
    return kind in (borders.WALL, borders.NO_SLIP, borders.INFLOW)


@inner_kernel
def _row_of_u(cells, kinds, j, goal):
    """Row j of the forces on u."""
    row, nx = cells[j], cells.shape[1]
    for i in range(1, nx):
        goal[i] = 0.5 * (row[i - 1, 0] + row[i, 0])
    if kinds[borders.LEFT] == borders.PERIODIC:
        goal[0] = 0.5 * (row[nx - 1, 0] + row[0, 0])
        goal[nx] = goal[0]
    else:
        goal[0] = 0.0 if _holds(kinds[borders.LEFT]) else row[0, 0]
        goal[nx] = 0.0 if _holds(kinds[borders.RIGHT]) else row[nx - 1, 0]


@inner_kernel
def _row_of_v(cells, j, goal):
    """Row j of the forces on v, between two rows of cells."""
    low, high = cells[j - 1], cells[j]
    for i in range(goal.size):
        goal[i] = 0.5 * (low[i, 1] + high[i, 1])


@inner_kernel
def _sides_of_v(cells, kinds, fv):
    """The forces on v at the bottom and the top."""
    ny = cells.shape[0]
    for i in range(cells.shape[1]):
        if kinds[borders.BOTTOM] == borders.PERIODIC:
            fv[0, i] = 0.5 * (cells[ny - 1, i, 1] + cells[0, i, 1])
            fv[ny, i] = fv[0, i]
        else:
            fv[0, i] = 0.0 if _holds(kinds[borders.BOTTOM]) else cells[0, i, 1]
            fv[ny, i] = 0.0 if _holds(kinds[borders.TOP]) else cells[ny - 1, i, 1]


@lean_kernel
def face_forces(cells, kinds, fu, fv):
    """Mean of the two cells of each face: fu (ny, nx + 1), fv (ny + 1, nx); 0 where a side holds it."""
    for j in range(cells.shape[0]):
        _row_of_u(cells, kinds, j, fu[j])
        if j > 0:
            _row_of_v(cells, j, fv[j])
    _sides_of_v(cells, kinds, fv)


@inner_kernel
def _push_row(goal, force, dt):
    for i in range(goal.size):
        goal[i] += dt * force[i]


@lean_kernel
def push_cells(scalars, given, weights, gravity, cells, kinds, moves, dt):
    """`cell_forces`, `face_forces` and `push` in one, while a row is at hand; moves: `Pushed`."""
    ny = cells.shape[0]
    for j in range(ny):
        _row_of_cells(scalars, given, weights, gravity, j, cells)
        _row_of_u(cells, kinds, j, moves.force_u[j])
        _push_row(moves.u[j], moves.force_u[j], dt)
        if j > 0:
            _row_of_v(cells, j, moves.force_v[j])
            _push_row(moves.v[j], moves.force_v[j], dt)
    _sides_of_v(cells, kinds, moves.force_v)
    _push_row(moves.v[0], moves.force_v[0], dt)
    _push_row(moves.v[ny], moves.force_v[ny], dt)


@lean_kernel
def push(u, v, fu, fv, dt):
    """Velocities gain dt times the forces of faces."""
    for j in range(u.shape[0]):
        _push_row(u[j], fu[j], dt)
    for j in range(v.shape[0]):
        _push_row(v[j], fv[j], dt)


@lean_kernel
def buoyancy(cells, column, ambient, gravity, force):
    """Write the upward acceleration (ny, nx, 2) m/s² of hot gas: g (T - Ta) over the mean of both.

    For small differences it is that of Boussinesq; hot gas, which is light, has to move the air around it.
    """
    for j in range(cells.shape[0]):
        for i in range(cells.shape[1]):
            warm = max(cells[j, i, column], 0.5 * ambient)
            force[j, i, 1] = gravity * (warm - ambient) / (0.5 * (warm + ambient))
