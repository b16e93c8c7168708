"""Surfaces for a liquid on a large grid: ground sampled once, and bodies asked only where they are."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats, Longs
from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.grid.layout import Grid
from game.physics.solids import SolidWorld
from game.physics.surfaces import Sample, SolidSurface, empty_sample
from game.physics.surfaces.surface import checked_places

REACH, LOOKS = 4.0, 10.0  # cells from which on bodies are not asked: of many points, of the middles of blocks
FEW = 2000  # points; fewer are middles of a grid's blocks, or single ones
BLOCK = 2  # cells along the side of a block in which bodies are looked for


@lean_kernel
def interpolate(places, table, frame, rows, columns, distance, normal):
    """Write distances (n,) and normals (n, 2) at places (n, 2) m.

    table (rows columns, 3): distance, normal at points of a lattice; frame: x, y of the first, their gap, m.
    """
    for m in range(places.shape[0]):
        x = min(max((places[m, 0] - frame[0]) / frame[2], 0.0), columns - 1.0)
        y = min(max((places[m, 1] - frame[1]) / frame[2], 0.0), rows - 1.0)
        i, j = min(int(x), columns - 2), min(int(y), rows - 2)
        f, g, corner = x - i, y - j, j * columns + i
        a, b = (1.0 - f) * (1.0 - g), f * (1.0 - g)
        c, d = (1.0 - f) * g, f * g
        distance[m] = _mean(table, corner, columns, 0, a, b, c, d)
        nx, ny = _mean(table, corner, columns, 1, a, b, c, d), _mean(table, corner, columns, 2, a, b, c, d)
        length = math.sqrt(nx * nx + ny * ny)
        normal[m, 0], normal[m, 1] = (nx / length, ny / length) if length > 0.0 else (0.0, 1.0)


@inner_kernel
def _mean(table, corner, columns, which, a, b, c, d):
    return (
        a * table[corner, which] + b * table[corner + 1, which]
        + c * table[corner + columns, which] + d * table[corner + columns + 1, which]
    )  # fmt: skip


@lean_kernel
def find_marked(places, blocks, frame, found):
    """Write numbers of the places (n, 2) m that lie in marked blocks (rows, columns); how many.

    frame: x, y of the lower left corner, m along the side of a block.
    """
    count = 0
    for m in range(places.shape[0]):
        x = min(max((places[m, 0] - frame[0]) / frame[2], 0.0), blocks.shape[1] - 1.0)
        y = min(max((places[m, 1] - frame[1]) / frame[2], 0.0), blocks.shape[0] - 1.0)
        if blocks[int(y), int(x)]:
            found[count] = m
            count += 1
    return count


class StillGround:
    """A surface that never moves, known on the half cells of a grid and interpolated between them.

    On nodes, faces and centres of the grid it has the very distances that the surface has.
    """

    def __init__(self, surface: SolidSurface, grid: Grid):
        """surface: what is asked once, at all half cells."""
        self.surface = surface
        self._lower, self._pitch = np.asarray(grid.lower), 0.5 * grid.cell
        rows, columns = 2 * grid.ny + 1, 2 * grid.nx + 1
        x, y = np.meshgrid(np.arange(columns), np.arange(rows))
        at = self._lower + self._pitch * np.stack([x.ravel(), y.ravel()], axis=1)
        found = surface.sample(at)
        self._table: Floats = np.concatenate([found.distance[:, None], found.normal], axis=1)
        self._shape = rows, columns
        self._friction = float(found.friction[0]) if len(at) else 0.0

    def sample(self, points: ArrayLike) -> Sample:
        """Distance m, normal and friction at points (n, 2) m; those outside the grid have its edge's."""
        places = checked_places(points)
        found = empty_sample(len(places))
        (x, y), (rows, columns) = self._lower.tolist(), self._shape
        interpolate(places, self._table, (x, y, self._pitch), rows, columns, found.distance, found.normal)
        found.friction[:] = self._friction
        return found

    def inverse_mass(self, body: int) -> tuple[float, float, tuple[float, float]]:
        """Of what never moves: zeros."""
        return 0.0, 0.0, (0.0, 0.0)

    def held_up(self, bodies: Longs, dt: float) -> Floats:
        """Nothing: it does not fall."""
        return np.zeros((len(bodies), 3))

    def push(self, body: int, point: ArrayLike, impulse: ArrayLike, during: float = 0.0) -> None:
        """Nothing moves it."""

    def heat(self, body: int, joule: float) -> None:
        """Nothing warms it."""


class NearBodies(SolidSurface):
    """Bodies of a world that answer within some cells of them, see `REACH`; farther there are none."""

    def __init__(self, world: SolidWorld, grid: Grid, without: ArrayLike = ()):
        super().__init__(world, without=without)
        self.grid = grid

    def sample(self, points: ArrayLike) -> Sample:
        """As `SolidSurface`, and infinitely far away where no body is near."""
        places = checked_places(points)
        found = empty_sample(len(places))
        found.distance[:] = np.inf
        near = self._near(places)
        if len(near):
            own = super().sample(places[near])
            for goal, value in zip(found, own, strict=True):
                goal[near] = value
        return found

    def _near(self, places: Floats) -> Longs:
        """Which points lie in a block that a body may reach."""
        grid, rows, cell = self.grid, self.world.bodies, self.grid.cell
        side, reach = BLOCK * cell, (LOOKS if len(places) < FEW else REACH) * cell
        blocks = np.zeros((-(-grid.ny // BLOCK) + 2, -(-grid.nx // BLOCK) + 2), np.bool_)
        asked = np.setdiff1d(self.world.ids(), self.without)
        x, y = grid.lower[0] - side, grid.lower[1] - side
        far = rows.reaches[asked, None] + reach
        first = np.floor((rows.positions[asked] - far - (x, y)) / side).astype(np.int64)
        last = np.floor((rows.positions[asked] + far - (x, y)) / side).astype(np.int64) + 1
        for (i, j), (m, n) in zip(np.maximum(first, 0).tolist(), np.maximum(last, 0).tolist(), strict=True):
            blocks[j:n, i:m] = True
        found = np.empty(len(places), dtype=np.int64)
        return found[: find_marked(places, blocks, (x, y, side), found)]
