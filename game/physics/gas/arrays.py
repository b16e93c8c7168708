"""The arrays of a gas: what it is, and space for a step."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.grid.layout import PAD, Grid

TIME, LAST, SETTLED = range(3)


class GasState(NamedTuple):
    """All that later steps depend on."""

    u: Floats  # (ny, nx + 1) m/s
    v: Floats  # (ny + 1, nx) m/s
    before_u: Floats  # as they were a step before
    before_v: Floats
    force_u: Floats  # m/s² at the end of the last step, on faces
    force_v: Floats
    pressure: Floats  # (ny + 2, nx + 2) m²/s², over the density of air, padded
    scalars: Floats  # (ny, nx, fields)
    clock: Floats  # (3,) s simulated, s of the last step, whether pressure and velocity before are of use
    solid_x: Floats  # (ny, nx + 1) open part of faces
    solid_y: Floats  # (ny + 1, nx)


class Room(NamedTuple):
    """Space for a step."""

    shift: Floats  # (ny, nx, 2) cells
    back: Floats  # the same forward, for MacCormack
    centre: Floats  # (ny, nx, 2) velocities, then forces
    pad_u: Floats
    pad_v: Floats
    pad_s: Floats
    other_u: Floats
    other_v: Floats
    other_s: Floats
    way_u: Floats
    way_v: Floats
    way_s: Floats
    stage_s: Floats
    curl: Floats  # (ny, nx)
    kept: Floats  # (ny, nx, fields) scalars as the step found them


class Drag(NamedTuple):
    """What viscosity needs of solids: see `viscosity`."""

    gain_u: Floats
    gain_v: Floats
    free_u: Floats
    free_v: Floats


def _padded(rows: int, columns: int, *more: int) -> Floats:
    return np.zeros((rows + 2 * PAD, columns + 2 * PAD, *more))


def make_state(grid: Grid, fields: int, pressure: Floats) -> GasState:
    """Gas at rest; the solver's own padded pressure is kept, not copied."""
    ny, nx = grid.shape
    u, v = (ny, nx + 1), (ny + 1, nx)
    return GasState(
        np.zeros(u), np.zeros(v), np.zeros(u), np.zeros(v), np.zeros(u), np.zeros(v), pressure,
        np.zeros((ny, nx, fields)), np.zeros(3), np.ones(u), np.ones(v),
    )  # fmt: skip


def make_room(grid: Grid, fields: int) -> Room:
    """Space for a step of so many fields."""
    ny, nx = grid.shape
    return Room(
        np.zeros((ny, nx, 2)), np.zeros((ny, nx, 2)), np.zeros((ny, nx, 2)),
        _padded(ny, nx + 1), _padded(ny + 1, nx), _padded(ny, nx, fields),
        _padded(ny, nx + 1), _padded(ny + 1, nx), _padded(ny, nx, fields),
        np.zeros((ny, nx + 1)), np.zeros((ny + 1, nx)), np.zeros((ny, nx, fields)),
        np.zeros((ny, nx, fields)), np.zeros((ny, nx)), np.zeros((ny, nx, fields)),
    )  # fmt: skip


def make_drag(grid: Grid) -> Drag:
    """Nothing is closed."""
    ny, nx = grid.shape
    return Drag(
        np.ones((ny + 2 * PAD, nx + 1 + 2 * PAD)), np.ones((ny + 1 + 2 * PAD, nx + 2 * PAD)),
        np.ones((ny, nx + 1)), np.ones((ny + 1, nx)),
    )  # fmt: skip
