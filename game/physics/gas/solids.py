"""Solids in a gas: their faces, what they cover and uncover, and what viscosity needs of them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.compiler.decorator import kernel
from game.physics.gas.arrays import Drag, GasState, make_drag
from game.physics.grid.layout import PAD, Grid
from game.physics.grid.obstacles import GridObstacles, Sampled, SolidFaces


@kernel
def _closed(ax, ay, j, i):
    return max(max(ax[j, i], ax[j, i + 1]), max(ay[j, i], ay[j + 1, i])) <= 0.0


@kernel
def move_covered(scalars, old_x, old_y, ax, ay, around, kept):
    """What becomes of the fields (ny, nx, fields) where solids close or open cells.

    A cell that opens takes the mean of its open neighbours; one that closes goes back to what is around
    (fields,). Of fields that are kept (fields,) in flux form the neighbours give or get what it takes or
    loses. So the sum over open cells stays, if there are any.
    """
    ny, nx, fields = scalars.shape
    for turn in range(2):  # first what opens, so that it can take what is pushed out
        for j in range(ny):
            for i in range(nx):
                was, now = _closed(old_x, old_y, j, i), _closed(ax, ay, j, i)
                if was == now or now != (turn == 1):
                    continue
                count = 0
                for side in range(4):
                    y, x = j + (side == 3) - (side == 2), i + (side == 1) - (side == 0)
                    inside = 0 <= y < ny and 0 <= x < nx
                    if inside and not _closed(ax, ay, y, x) and (turn or not _closed(old_x, old_y, y, x)):
                        count += 1
                for k in range(fields):
                    share, rest = (scalars[j, i, k] - around[k]) / max(count, 1), 0.0
                    for side in range(4):
                        y, x = j + (side == 3) - (side == 2), i + (side == 1) - (side == 0)
                        if not (0 <= y < ny and 0 <= x < nx) or _closed(ax, ay, y, x):
                            continue
                        if turn == 1 and kept[k]:
                            scalars[y, x, k] += share
                        elif turn == 0 and not _closed(old_x, old_y, y, x):
                            part = (scalars[y, x, k] - around[k]) / (count + (1 if kept[k] else 0))
                            rest += part
                            if kept[k]:
                                scalars[y, x, k] -= part
                    scalars[j, i, k] = around[k] + rest


class GasSolids:
    """The solids that a gas flows around."""

    def __init__(self, grid: Grid):
        self._obstacles = GridObstacles(grid)
        self.drag: Drag = make_drag(grid)
        self.surfaces: tuple[Sampled, ...] = ()
        self.present, self.moving = False, False

    @property
    def faces(self) -> SolidFaces:
        """Open parts, velocities, and how far walls are."""
        return self._obstacles.faces

    def set(self, surfaces: tuple[Sampled, ...], moving: bool) -> None:
        """Sample these from now on."""
        self.surfaces, self.moving, self.present = surfaces, moving and bool(surfaces), bool(surfaces)
        if surfaces:
            self._obstacles.update(*surfaces)
        else:
            self._obstacles.clear()
        self._derive()

    def set_parts(self, ax: Floats, ay: Floats) -> None:
        """Given open parts, at rest."""
        self._obstacles.set_parts(ax, ay)
        self.surfaces, self.moving, self.present = (), False, True
        self._derive()

    def restore(self, ax: Floats, ay: Floats) -> None:
        """Open parts as they were; surfaces are sampled again at the next step if they move."""
        self._obstacles.set_parts(ax, ay)
        if self.surfaces:
            self._obstacles.update(*self.surfaces)
        self._derive()

    def follow(self, dt: float) -> bool:
        """Sample moving solids; whether anything moved."""
        if not self.moving:
            return False
        self._obstacles.update(*self.surfaces)
        self._derive()
        return True

    def move_scalars(self, state: GasState, around: Floats, kept: NDArray[np.bool_]) -> None:
        """What becomes of the fields in cells that closed or opened."""
        faces = self.faces
        move_covered(state.scalars, state.solid_x, state.solid_y, faces.ax, faces.ay, around, kept)

    def set_slip(self, slip: bool) -> None:
        """Whether closed faces drag what flows along them."""
        for gain, part in ((self.drag.gain_u, self.faces.ax), (self.drag.gain_v, self.faces.ay)):
            gain[PAD:-PAD, PAD:-PAD] = 1.0 if not slip else part > 0.0

    def _derive(self) -> None:
        self.drag.free_u[:], self.drag.free_v[:] = self.faces.ax > 0.0, self.faces.ay > 0.0
