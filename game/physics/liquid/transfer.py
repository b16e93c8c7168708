"""Speeds from particles to faces, and back: PIC and FLIP (Zhu and Bridson 2005), APIC (Jiang et al. 2015).

Weights are hats of one cell to either side. Places beyond the first and last points of a field count as these
points. So a wall at the grid's rim neither holds back nor drags.
"""

from __future__ import annotations

import numpy as np

from game.compiler.decorator import inner_kernel, lean_kernel

ONE = np.uint64(1)  # by unsigned places, for which no sign has to be looked at


@inner_kernel
def split(x, last):
    """The point at or before x, how far x is behind it, and whether x lies between two points."""
    if not x > 0.0:
        return np.uint64(0), 0.0, 0.0
    if x >= last:
        return np.uint64(last - 1), 1.0, 0.0
    i = int(x)
    return np.uint64(i), x - i, 1.0


@inner_kernel
def value_at(field, x, y):
    """Bilinear value at a place in points of the field."""
    i, f, _ = split(x, field.shape[1] - 1)
    j, g, _ = split(y, field.shape[0] - 1)
    low, high = field[j], field[j + ONE]
    a, b = low[i] + f * (low[i + ONE] - low[i]), high[i] + f * (high[i + ONE] - high[i])
    return a + g * (b - a)


@inner_kernel
def _scatter(total, weight, x, y, value, along, up):
    """Add a value with its changes along x and y (a point) to the four points around a place."""
    i, f, _ = split(x, total.shape[1] - 1)
    j, g, _ = split(y, total.shape[0] - 1)
    w = (1.0 - f) * (1.0 - g), f * (1.0 - g), (1.0 - f) * g, f * g
    base = value + along * (i - x) + up * (j - y)
    total[j, i] += w[0] * base
    total[j, i + ONE] += w[1] * (base + along)
    total[j + ONE, i] += w[2] * (base + up)
    total[j + ONE, i + ONE] += w[3] * (base + along + up)
    weight[j, i] += w[0]
    weight[j, i + ONE] += w[1]
    weight[j + ONE, i] += w[2]
    weight[j + ONE, i + ONE] += w[3]


@inner_kernel
def fill_around(field, x, y, share, walls):
    """Add a share to the four cells around a place (points of centres), by hats. What would go to cells whose
    centres lie in solids goes to the others.
    """
    i, f, _ = split(x, field.shape[1] - 1)
    j, g, _ = split(y, field.shape[0] - 1)
    a, b, c, d = (1.0 - f) * (1.0 - g), f * (1.0 - g), (1.0 - f) * g, f * g
    if walls.present[0]:
        row, column = int(2 * j + ONE), int(2 * i + ONE)
        a_open = a if walls.distance[row, column] >= 0.0 else 0.0
        b_open = b if walls.distance[row, column + 2] >= 0.0 else 0.0
        c_open = c if walls.distance[row + 2, column] >= 0.0 else 0.0
        d_open = d if walls.distance[row + 2, column + 2] >= 0.0 else 0.0
        total = (a_open + b_open) + (c_open + d_open)
        if total > 0.0:
            a, b, c, d = a_open / total, b_open / total, c_open / total, d_open / total
    field[j, i] += share * a
    field[j, i + ONE] += share * b
    field[j + ONE, i] += share * c
    field[j + ONE, i + ONE] += share * d


@inner_kernel
def _divide(field, weight):
    for j in range(field.shape[0]):
        for i in range(field.shape[1]):
            if weight[j, i] > 0.0:
                field[j, i] /= weight[j, i]


@lean_kernel
def to_cells(particles, cells, walls, origin, share):
    """Speeds at faces and the fill of cells. origin: x, y (m) of the grid and its cell; share: of a cell that
    a particle fills.
    """
    cells.u[:], cells.v[:], cells.weight_u[:], cells.weight_v[:] = 0.0, 0.0, 0.0, 0.0
    cells.fill[:] = 0.0
    for k in range(particles.alive[0]):
        x = (particles.places[k, 0] - origin[0]) / origin[2]
        y = (particles.places[k, 1] - origin[1]) / origin[2]
        c = particles.affine[k]
        _scatter(cells.u, cells.weight_u, x, y - 0.5, particles.speeds[k, 0], c[0], c[1])
        _scatter(cells.v, cells.weight_v, x - 0.5, y, particles.speeds[k, 1], c[2], c[3])
        fill_around(cells.fill, x - 0.5, y - 0.5, share, walls)
    _divide(cells.u, cells.weight_u)
    _divide(cells.v, cells.weight_v)


@inner_kernel
def _gather(field, x, y):
    """Value and its changes along x and y at a place."""
    i, f, inside = split(x, field.shape[1] - 1)
    j, g, within = split(y, field.shape[0] - 1)
    a, b, c, d = field[j, i], field[j, i + ONE], field[j + ONE, i], field[j + ONE, i + ONE]
    low, high = a + f * (b - a), c + f * (d - c)
    along = (b - a) + g * ((d - c) - (b - a))
    return low + g * (high - low), inside * along, within * (high - low)


@lean_kernel
def to_particles(particles, cells, origin, apic, flip):
    """New speeds of the particles. apic: whether they carry changes along x and y; flip: share of FLIP."""
    for k in range(particles.alive[0]):
        x = (particles.places[k, 0] - origin[0]) / origin[2]
        y = (particles.places[k, 1] - origin[1]) / origin[2]
        speed, c = particles.speeds[k], particles.affine[k]
        u, ux, uy = _gather(cells.u, x, y - 0.5)
        v, vx, vy = _gather(cells.v, x - 0.5, y)
        if apic:
            speed[0], speed[1], c[0], c[1], c[2], c[3] = u, v, ux, uy, vx, vy
        else:
            was_u, was_v = value_at(cells.old_u, x, y - 0.5), value_at(cells.old_v, x - 0.5, y)
            speed[0] = u + flip * (speed[0] - was_u)
            speed[1] = v + flip * (speed[1] - was_v)
            c[0], c[1], c[2], c[3] = 0.0, 0.0, 0.0, 0.0
