"""Scalars in flux form: what leaves a cell enters its neighbour, so that sums stay to rounding.

Upwind with van Leer's (1974) limited slopes, Heun's two stages, as many substeps as keep the share that
leaves a cell below a half. A cell that is not closed has its whole volume; the flux goes through open
parts only.
"""

from __future__ import annotations

import math

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
    """Value on the face between b and c, from where the gas comes."""
    if speed >= 0.0:
        one, two = b - a, c - b
        return b + (one * two / (one + two) if one * two > 0.0 else 0.0)
    one, two = d - c, c - b
    return c - (one * two / (one + two) if one * two > 0.0 else 0.0)


@kernel
def flux_stage(padded, u, v, solids, scale, kept, mix, out):
    """out = mix out + (1 - mix) (padded - scale (flux out of the cell)), for fields that are kept.

    scale: dt / h; padded with ghosts.
    """
    ny, nx, fields = out.shape
    for k in range(fields):
        if not kept[k]:
            continue
        for j in range(ny):
            for i in range(nx):
                m, n = j + PAD, i + PAD
                total = 0.0
                for side in range(2):  # left, right
                    f = i + side
                    speed = solids.ax[j, f] * u[j, f]
                    c = n + side
                    if speed != 0.0:
                        value = upwind(
                            padded[m, c - 2, k],
                            padded[m, c - 1, k],
                            padded[m, c, k],
                            padded[m, c + 1, k],
                            speed,
                        )
                        total += speed * value * (2 * side - 1)
                for side in range(2):  # below, above
                    f = j + side
                    speed = solids.ay[f, i] * v[f, i]
                    c = m + side
                    if speed != 0.0:
                        value = upwind(
                            padded[c - 2, n, k],
                            padded[c - 1, n, k],
                            padded[c, n, k],
                            padded[c + 1, n, k],
                            speed,
                        )
                        total += speed * value * (2 * side - 1)
                out[j, i, k] = mix * out[j, i, k] + (1.0 - mix) * (padded[m, n, k] - scale * total)


def substeps_for(most: float, scale: float) -> int:
    """How many substeps keep the share that leaves a cell below MOST_SHARE."""
    return max(1, math.ceil(most * scale / MOST_SHARE))
