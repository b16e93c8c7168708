"""Stable fluids as its author printed it: velocity in the middles of cells, in a box of walls.

Stam 1999, "Stable Fluids", SIGGRAPH: forces, then the velocity carried along by tracing back from each cell
through the velocity field in two stages. Then come viscosity implicitly, and the projection on what has no
divergence. Both linear systems solved to the end. Stam 2003, "Real-Time Fluid Dynamics for Games", GDC:
viscosity, projection, one straight trace back, projection again, each system by 20 sweeps of Gauss and Seidel
from a start of nothing (of the diffusion: from the old values).

Arrays (ny + 2, nx + 2), one row and column of ghosts around the cells; carried things (ny + 2, nx + 2,
fields). The velocity is m/s. Divergence and gradient are central differences over two cells, while the
pressure's equation is that of five neighbouring cells: so some divergence is left however well it is solved.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel

# how a field meets walls: as beside them, as u (mirrored across x), as v (across y)
PLAIN, ACROSS, ALONG = range(3)


@lean_kernel
def fill_ghosts(a, kind):
    """Values beyond the walls: the same as beside them, or the opposite of a velocity into them."""
    ny, nx = a.shape[0] - 2, a.shape[1] - 2
    for j in range(1, ny + 1):
        sign = -1.0 if kind == ACROSS else 1.0
        a[j, 0], a[j, nx + 1] = sign * a[j, 1], sign * a[j, nx]
    for i in range(1, nx + 1):
        sign = -1.0 if kind == ALONG else 1.0
        a[0, i], a[ny + 1, i] = sign * a[1, i], sign * a[ny, i]
    a[0, 0], a[0, nx + 1] = 0.5 * (a[0, 1] + a[1, 0]), 0.5 * (a[0, nx] + a[1, nx + 1])
    a[ny + 1, 0] = 0.5 * (a[ny + 1, 1] + a[ny, 0])
    a[ny + 1, nx + 1] = 0.5 * (a[ny + 1, nx] + a[ny, nx + 1])


@lean_kernel
def relax(x, right, number, share, kind, sweeps, over):
    """Sweeps of Gauss and Seidel for share x = right + number (sum of the four neighbours); gives the last
    change. over: 1, or more (below 2) for successive over-relaxation (Young 1954).
    """
    ny, nx = x.shape[0] - 2, x.shape[1] - 2
    change = 0.0
    for _ in range(sweeps):
        change = 0.0
        for j in range(1, ny + 1):
            for i in range(1, nx + 1):
                around = x[j, i - 1] + x[j, i + 1] + x[j - 1, i] + x[j + 1, i]
                move = over * ((right[j, i] + number * around) / share - x[j, i])
                change = max(change, abs(move))
                x[j, i] += move
        fill_ghosts(x, kind)
    return change


@lean_kernel
def write_divergence(u, v, cell, out):
    """Central differences over two cells, 1/s."""
    for j in range(1, u.shape[0] - 1):
        for i in range(1, u.shape[1] - 1):
            out[j, i] = 0.5 * (u[j, i + 1] - u[j, i - 1] + v[j + 1, i] - v[j - 1, i]) / cell


@lean_kernel
def take_gradient(u, v, p, cell):
    """Subtract the pressure's central differences (p: m²/s, time step included) from a velocity."""
    for j in range(1, u.shape[0] - 1):
        for i in range(1, u.shape[1] - 1):
            u[j, i] -= 0.5 * (p[j, i + 1] - p[j, i - 1]) / cell
            v[j, i] -= 0.5 * (p[j + 1, i] - p[j - 1, i]) / cell
    fill_ghosts(u, ACROSS)
    fill_ghosts(v, ALONG)


@inner_kernel
def _clamp(x, y, u):
    """A place in cells, within the ring of the ghosts' middles."""
    return min(max(x, 0.5), u.shape[1] - 1.5), min(max(y, 0.5), u.shape[0] - 1.5)


@inner_kernel
def _linear(a, x, y):
    i, j = math.floor(x), math.floor(y)
    f, g = x - i, y - j
    low = (1.0 - f) * a[j, i] + f * a[j, i + 1]
    high = (1.0 - f) * a[j + 1, i] + f * a[j + 1, i + 1]
    return (1.0 - g) * low + g * high


@inner_kernel
def _origin(u, v, j, i, part, stages):
    """Where what is in a cell now was one step ago, in cells; part: dt / cell."""
    if stages == 1:
        return _clamp(i - part * u[j, i], j - part * v[j, i], u)
    x, y = _clamp(i - 0.5 * part * u[j, i], j - 0.5 * part * v[j, i], u)
    return _clamp(i - part * _linear(u, x, y), j - part * _linear(v, x, y), u)


@lean_kernel
def carry_velocity(u, v, part, stages, new_u, new_v):
    """The velocity carried along by itself."""
    for j in range(1, u.shape[0] - 1):
        for i in range(1, u.shape[1] - 1):
            x, y = _origin(u, v, j, i, part, stages)
            new_u[j, i], new_v[j, i] = _linear(u, x, y), _linear(v, x, y)
    fill_ghosts(new_u, ACROSS)
    fill_ghosts(new_v, ALONG)


@lean_kernel
def carry_fields(fields, u, v, part, stages, new):
    """Fields (ny + 2, nx + 2, k) carried along; their ghosts are as beside the walls."""
    ny, nx, count = u.shape[0] - 2, u.shape[1] - 2, fields.shape[2]
    for j in range(1, ny + 1):
        for i in range(1, nx + 1):
            x, y = _origin(u, v, j, i, part, stages)
            a, b = math.floor(x), math.floor(y)
            f, g = x - a, y - b
            for k in range(count):
                low = (1.0 - f) * fields[b, a, k] + f * fields[b, a + 1, k]
                high = (1.0 - f) * fields[b + 1, a, k] + f * fields[b + 1, a + 1, k]
                new[j, i, k] = (1.0 - g) * low + g * high
    for k in range(count):
        for j in range(1, ny + 1):
            new[j, 0, k], new[j, nx + 1, k] = new[j, 1, k], new[j, nx, k]
        for i in range(nx + 2):
            inner = min(max(i, 1), nx)
            new[0, i, k], new[ny + 1, i, k] = new[1, inner, k], new[ny, inner, k]
