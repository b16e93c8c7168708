"""What a gas carries in flux form: in substeps, with what goes through the sides."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.gas.conserving import flux_stage, largest_outflow, space_for, substeps_for
from game.physics.gas.ledger import fields_through
from game.physics.grid.borders import INFLOW, OPEN
from game.physics.grid.ghosts import fill_scalar_ghosts
from game.physics.grid.layout import PAD


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
    space = space_for(inner.shape[:2])
    count = substeps_for(largest_outflow(u, v, faces.ax, faces.ay), scale)
    for _ in range(count):
        np.copyto(begun, inner)
        for mix, out in ((0.0, stage), (0.5, begun)):
            fill_scalar_ghosts(padded, *sides)
            see(padded, count)
            flux_stage(padded, u, v, faces, scale / count, kept, mix, out, space)
            inner[:] = out


def carry_densities(gas: Any, densities: Floats, surrounding: Floats, dt: float) -> Floats:
    """Carry densities (ny, nx, k) of anything, per m³, for dt (s) by the velocity that a gas has now.

    After a step this is the velocity that agrees with the expansion of that step. The sum over the cells
    changes by what goes through the sides alone, whatever walls there are (van Leer 1974). surrounding (k,):
    the densities beyond open sides. Returns what left (k,), per m of depth: the integral over time of the
    flux there.
    """
    (ny, nx, count), cell, kinds = densities.shape, gas.grid.cell, gas.edges.kinds
    padded, left, through = np.zeros((ny + 2 * PAD, nx + 2 * PAD, count)), np.zeros(count), np.zeros(count)
    padded[PAD:-PAD, PAD:-PAD] = densities

    def see(stage: Floats, substeps: int) -> None:
        fields_through(stage, gas.u, gas.v, gas.faces, kinds, True, cell, through)
        np.subtract(left, 0.5 * dt / substeps * through, out=left)

    held = np.repeat(np.isin(kinds, (OPEN, INFLOW))[:, None], count, axis=1)
    sides = kinds, held, np.tile(np.asarray(surrounding, dtype=np.float64), (4, 1))
    room = padded, np.zeros(densities.shape), np.zeros(densities.shape)
    flow = gas.u, gas.v, gas.faces
    carry_in_flux_form(room, flow, sides, np.ones(count, np.bool_), dt / cell, see)
    densities[:] = padded[PAD:-PAD, PAD:-PAD]
    return left
