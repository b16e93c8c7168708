"""What the gas does to solids: the pressure on their outlines, and the drag along them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.compiler.decorator import kernel
from game.physics.grid.obstacles import SolidFaces


class Load(NamedTuple):
    """On one body, for a metre of depth."""

    body: int
    force: tuple[float, float]  # N/m
    torque: float  # N about the point that was asked for


@kernel
def sum_loads(p, u, v, solids, places, numbers, out):
    """Add force x, y and torque of each body to out (bodies, 3), over the density of the gas.

    p: padded by one. places (4,): x, y of the first cell's centre, x, y of the point of the torque. numbers
    (2,): cell m, viscosity m²/s (0 if the gas slips). The pressure acts on the part of a cell's outline that
    the open parts of its faces leave. The drag on closed faces beside open ones.
    """
    ny, nx = solids.volume.shape
    h, nu = numbers[0], numbers[1]
    for j in range(ny):
        y = places[1] + j * h - places[3]
        for i in range(nx):
            k = solids.body[j, i]
            if k < 0 or k >= out.shape[0]:
                continue
            x = places[0] + i * h - places[2]
            across = solids.ax[j, i + 1] - solids.ax[j, i]
            up = solids.ay[j + 1, i] - solids.ay[j, i]
            fx, fy = -p[j + 1, i + 1] * across * h, -p[j + 1, i + 1] * up * h
            if nu > 0.0:
                fx += _shear(u, solids.ax, solids.u, j, i, 1, 0, nu)
                fx += _shear(u, solids.ax, solids.u, j, i, -1, 0, nu)
                fy += _shear(v, solids.ay, solids.v, j, i, 0, 1, nu)
                fy += _shear(v, solids.ay, solids.v, j, i, 0, -1, nu)
            out[k, 0] += fx
            out[k, 1] += fy
            out[k, 2] += x * fy - y * fx


@kernel
def _shear(field, part, own, j, i, to_y, to_x, nu):
    """Drag on the closed face (j, i) by its open neighbour along itself: nu times the jump, each h long."""
    m, n = j + to_y, i + to_x
    if part[j, i] > 0.0 or m < 0 or n < 0 or m >= part.shape[0] or n >= part.shape[1] or part[m, n] <= 0.0:
        return 0.0
    return nu * (field[m, n] - own[j, i])


def loads_on(
    p: Floats, u: Floats, v: Floats, solids: SolidFaces, places: Floats, numbers: Floats
) -> list[Load]:  # fmt: skip
    """Loads on all bodies that are in the gas, over the density of the gas."""
    count = int(np.max(solids.body, initial=-1)) + 1
    out = np.zeros((max(count, 1), 3))
    sum_loads(p, u, v, solids, places, numbers, out)
    return [Load(k, (float(out[k, 0]), float(out[k, 1])), float(out[k, 2])) for k in range(count)]
