"""Scalars in flux form: what leaves a cell enters its neighbour, so that sums stay to rounding.

Upwind with van Leer's (1974) limited slopes, Heun's two stages, as many substeps as keep the share that
leaves a cell below a half. A cell that is not closed has its whole volume; the flux goes through open
parts only.
"""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.compiler.decorator import inner_kernel, kernel
from game.physics.grid.layout import PAD

MOST_SHARE = 0.5  # of a cell that leaves it in a substep


@kernel
def largest_outflow(u, v, ax, ay):
    """Largest sum of what leaves a cell, m/s."""
    most = 0.0
    for j in range(ay.shape[0] - 1):
        for i in range(ax.shape[1] - 1):
            out = max(0.0, ax[j, i + 1] * u[j, i + 1]) + max(0.0, -ax[j, i] * u[j, i])
            out += max(0.0, ay[j + 1, i] * v[j + 1, i]) + max(0.0, -ay[j, i] * v[j, i])
            most = max(most, out)
    return most


@inner_kernel
def upwind(a, b, c, d, speed):
    """Value on the face between b and c, from where the gas comes. It has no branches: rows are vectors."""
    ahead = speed >= 0.0
    one, two = (b - a if ahead else d - c), c - b
    both = one * two
    bend = (both if both > 0.0 else 0.0) / (one + two if both > 0.0 else 1.0)
    return b + bend if ahead else c - bend


@inner_kernel
def _across_faces(a, b, c, d, part, speed, flux):
    """What flows through a row of faces between b and c, of which a part is open."""
    for i in range(flux.size):
        fast = part[i] * speed[i]
        flux[i] = fast * upwind(a[i], b[i], c[i], d[i], fast)


@kernel
def flux_stage(padded, u, v, solids, scale, kept, mix, out, space):
    """out = mix out + (1 - mix) (padded - scale (flux out of the cell)), for fields that are kept.

    scale: dt / h; padded with ghosts. space: a plane as large as a padded field, a row for the faces along x,
    and two rows for those below and above.
    """
    ny, nx, fields = out.shape
    plane, along, up = space
    for k in range(fields):
        if not kept[k]:
            continue
        for m in range(ny + 2 * PAD):
            row = plane[m]
            for n in range(nx + 2 * PAD):
                row[n] = padded[m, n, k]
        for j in range(ny + 1):
            below, above = up[1 - j % 2], up[j % 2]
            _across_faces(
                plane[j, PAD : PAD + nx], plane[j + 1, PAD : PAD + nx], plane[j + 2, PAD : PAD + nx],
                plane[j + 3, PAD : PAD + nx], solids.ay[j], v[j], above,
            )  # fmt: skip
            if j == 0:
                continue
            row = plane[j + 1]
            _across_faces(row, row[1:], row[2:], row[3:], solids.ax[j - 1], u[j - 1], along)
            goal, now = out[j - 1], row[PAD:]
            for i in range(nx):
                total = along[i + 1] - along[i] - below[i] + above[i]
                goal[i, k] = mix * goal[i, k] + (1.0 - mix) * (now[i] - scale * total)


def space_for(shape: tuple[int, int]) -> tuple[Floats, Floats, Floats]:
    """What `flux_stage` needs for fields (ny, nx)."""
    ny, nx = shape
    return np.empty((ny + 2 * PAD, nx + 2 * PAD)), np.empty(nx + 1), np.empty((2, nx))


def substeps_for(most: float, scale: float) -> int:
    """How many substeps keep the share that leaves a cell below MOST_SHARE."""
    return max(1, math.ceil(most * scale / MOST_SHARE))
