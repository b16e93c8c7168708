"""Scalars that spread by themselves: explicit, in flux form, through the open parts of faces."""

from __future__ import annotations

from game.compiler.decorator import kernel
from game.physics.grid.layout import PAD

STABLE = 0.2  # D dt / h² of a substep


@kernel
def diffuse(scalars, padded, ax, ay, strength):
    """scalars (ny, nx, fields) gain strength (fields,) = D dt / h² times the flux sums of padded ones.

    At the sides the ghosts decide: equal to the cell they let nothing through.
    """
    ny, nx, fields = scalars.shape
    for j in range(ny):
        low, row, high = padded[j + PAD - 1], padded[j + PAD], padded[j + PAD + 1]
        for i in range(nx):
            left, right = ax[j, i], ax[j, i + 1]
            down, up = ay[j, i], ay[j + 1, i]
            m = i + PAD
            for k in range(fields):
                here = row[m, k]
                total = left * (row[m - 1, k] - here) + right * (row[m + 1, k] - here)
                total += down * (low[m, k] - here) + up * (high[m, k] - here)
                scalars[j, i, k] += strength[k] * total
