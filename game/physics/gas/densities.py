"""What a gas carries in flux form: in substeps, with what goes through the sides."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.gas.conserving import flux_stage, largest_outflow, substeps_for
from game.physics.gas.ledger import fields_through
from game.physics.grid.borders import INFLOW, OPEN
from game.physics.grid.ghosts import fill_scalar_ghosts
from game.physics.grid.layout import PAD

ONE = np.ones(1, np.bool_)


def carry_in_flux_form(
    room: tuple[Floats, Floats, Floats], flow: tuple[Floats, Floats, Any],
    sides: tuple[NDArray[np.int64], NDArray[np.bool_], Floats], kept: NDArray[np.bool_], scale: float,
    see: Callable[[Floats, int], None],
) -> None:  # fmt: skip
    """Carry fields that are kept (fields,) by Heun's rule, in as many substeps as are stable.

    room: fields padded with ghosts, which are written, and two buffers (ny, nx, fields). flow: u, v m/s and
    `SolidFaces`. sides: kinds (4,), what is held there (4, fields) and its values. scale: dt / h. ``see`` is
    called with the padded fields of each stage and the number of substeps; a stage has half of the substep.
    """
    padded, begun, stage = room
    u, v, faces = flow
    inner = padded[PAD:-PAD, PAD:-PAD]
    count = substeps_for(largest_outflow(u, v, faces.ax, faces.ay), scale)
    for _ in range(count):
        np.copyto(begun, inner)
        for mix, out in ((0.0, stage), (0.5, begun)):
            fill_scalar_ghosts(padded, *sides)
            see(padded, count)
            flux_stage(padded, u, v, faces, scale / count, kept, mix, out)
            inner[:] = out


def carry_density(gas: Any, density: Floats, surrounding: float, dt: float) -> float:
    """Carry a density (ny, nx) of anything, per m³, for dt (s) by the velocity that a gas has now.

    After a step this is the velocity that agrees with the expansion of that step. The sum over the cells
    changes by what goes through the sides alone, whatever walls there are (van Leer 1974). surrounding: the
    density beyond open sides. Returns what left, per m of depth: the integral over time of the flux there.
    """
    ny, nx = gas.grid.shape
    cell, kinds = gas.grid.cell, gas.edges.kinds
    padded, left, through = np.zeros((ny + 2 * PAD, nx + 2 * PAD, 1)), 0.0, np.zeros(1)
    padded[PAD:-PAD, PAD:-PAD, 0] = density

    def see(stage: Floats, count: int) -> None:
        nonlocal left
        fields_through(stage, gas.u, gas.v, gas.faces, kinds, True, cell, through)
        left -= 0.5 * dt / count * float(through[0])

    held = np.isin(kinds, (OPEN, INFLOW))[:, None].copy()
    sides = kinds, held, np.full((4, 1), surrounding)
    room = padded, np.zeros((ny, nx, 1)), np.zeros((ny, nx, 1))
    carry_in_flux_form(room, (gas.u, gas.v, gas.faces), sides, ONE, dt / cell, see)
    density[:] = padded[PAD:-PAD, PAD:-PAD, 0]
    return left
