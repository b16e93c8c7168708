"""Solids on a grid: open parts of its faces and cells, and how the solid moves there."""

from __future__ import annotations

from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats, Longs
from game.physics.grid.fractions import clearance, close_thin_cells, layers, open_cells, open_faces
from game.physics.grid.layout import Grid

LAYERS = 2  # of closed faces that take on the velocity of the gas beside them
NEAR = 3.0  # cells from a surface within which all is sampled
BLOCK = 8  # cells along the side of a block that is looked at as one first


class SolidFaces(NamedTuple):
    """For kernels."""

    ax: Floats  # (ny, nx + 1) open part of faces, 0 to 1
    ay: Floats  # (ny + 1, nx)
    volume: Floats  # (ny, nx) open part of cells
    u: Floats  # (ny, nx + 1) m/s of the solid there
    v: Floats  # (ny + 1, nx)
    clear: Floats  # (ny, nx) cells to the nearest that is not all open
    layer_u: Longs  # (ny, nx + 1) 0 open, 1 ... closed ones by how deep
    layer_v: Longs  # (ny + 1, nx)
    body: Longs  # (ny, nx) which body is nearest, -1 for none


class Found(Protocol):
    """What of a sample is used: arrays of n rows."""

    @property
    def distance(self) -> Floats: ...
    @property
    def velocity(self) -> Floats: ...
    @property
    def body(self) -> Longs: ...


class Sampled(Protocol):
    """Anything that answers for a solid, as `physics.surfaces` do."""

    def sample(self, points: Floats) -> Found:
        """Signed distance (m, negative inside), velocity (m/s), body at points (n, 2) m."""


def all_open(grid: Grid) -> SolidFaces:
    """No solid at all."""
    ny, nx = grid.shape
    return SolidFaces(
        np.ones((ny, nx + 1)), np.ones((ny + 1, nx)), np.ones((ny, nx)), np.zeros((ny, nx + 1)),
        np.zeros((ny + 1, nx)), np.full((ny, nx), float(ny + nx)), np.zeros((ny, nx + 1), np.int64),
        np.zeros((ny + 1, nx), np.int64), np.full((ny, nx), -1, np.int64),
    )  # fmt: skip


class GridObstacles:
    """Samples solids onto a grid, into the same arrays each time.

    First blocks of 8 x 8 cells are asked at their centres. Only those that a surface may cross are sampled in
    full, so the cost grows with the length of the outlines.

    body_u (ny, nx + 1), body_v (ny + 1, nx): which body is nearest to the middle of a face, -1 for none.
    """

    def __init__(self, grid: Grid):
        self.grid = grid
        self.faces = all_open(grid)
        ny, nx = grid.shape
        shapes = ((ny + 1, nx + 1), (ny, nx + 1), (ny + 1, nx), (ny, nx))
        places = (grid.nodes(), grid.u_places(), grid.v_places(), grid.centres())
        self._distances = [np.zeros(shape) for shape in shapes]
        self.body_u, self.body_v = np.full(shapes[1], -1, np.int64), np.full(shapes[2], -1, np.int64)
        self._points = [np.stack([x.ravel(), y.ravel()], axis=1) for x, y in places]
        self._blocks = [self._block_of(shape) for shape in shapes]
        bx, by = -(-(nx + 1) // BLOCK), -(-(ny + 1) // BLOCK)
        across, upright = np.meshgrid(np.arange(bx) + 0.5, np.arange(by) + 0.5)
        middle = np.stack([across.ravel(), upright.ravel()], axis=1) * BLOCK * grid.cell
        self._middles: Floats = middle + np.asarray(grid.lower)

    def _block_of(self, shape: tuple[int, int]) -> Longs:
        """(n,) which block each point of a field of this shape lies in."""
        j, i = np.meshgrid(np.arange(shape[0]), np.arange(shape[1]), indexing="ij")
        columns = -(-(self.grid.nx + 1) // BLOCK)
        return np.asarray((j // BLOCK * columns + i // BLOCK).ravel(), dtype=np.int64)

    def update(self, *solids: Sampled) -> SolidFaces:
        """The faces now. ValueError if a solid answers with what is no number."""
        h, faces = self.grid.cell, self.faces
        near, deep = self._look(solids)
        faces.u[:], faces.v[:], faces.body[:] = 0.0, 0.0, -1
        self.body_u[:], self.body_v[:] = -1, -1
        for k, field in enumerate(self._distances):
            flat, block = field.reshape(-1), self._blocks[k]
            flat[:] = np.where(deep, -NEAR * h, NEAR * h)[block]
            chosen = np.flatnonzero(near[block])
            if not len(chosen):
                continue
            distance, velocity, body = _nearest(solids, self._points[k][chosen])
            flat[chosen] = distance
            if k == 1:
                faces.u.reshape(-1)[chosen], self.body_u.reshape(-1)[chosen] = velocity[:, 0], body
            elif k == 2:
                faces.v.reshape(-1)[chosen], self.body_v.reshape(-1)[chosen] = velocity[:, 1], body
            elif k == 3:
                faces.body.reshape(-1)[chosen] = body
        return self._derive()

    @property
    def distances(self) -> tuple[Floats, Floats, Floats, Floats]:
        """Distances (m) at nodes, in the middle of faces across x and y, at centres; `NEAR` cells at most."""
        nodes, mid_x, mid_y, centres = self._distances
        return nodes, mid_x, mid_y, centres

    def clear(self) -> SolidFaces:
        """No solid any more."""
        self.body_u[:], self.body_v[:] = -1, -1
        for old, new in zip(self.faces, all_open(self.grid), strict=True):
            old[:] = new
        return self.faces

    def set_parts(self, ax: Floats, ay: Floats) -> SolidFaces:
        """Given open parts of faces, at rest, for tests and drawings. ValueError out of 0 to 1."""
        for name, value, goal in (("ax", ax, self.faces.ax), ("ay", ay, self.faces.ay)):
            if np.shape(value) != goal.shape or not (np.min(value) >= 0.0 and np.max(value) <= 1.0):
                raise ValueError(f"{name}: expected numbers from 0 to 1, {goal.shape}")
            goal[:] = value
        faces = self.faces
        faces.u[:], faces.v[:], faces.body[:] = 0.0, 0.0, -1
        faces.volume[:] = 0.25 * (faces.ax[:, 1:] + faces.ax[:, :-1] + faces.ay[1:] + faces.ay[:-1])
        self._rest()
        return faces

    def _look(self, solids: tuple[Sampled, ...]) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
        """(blocks,) whether a surface may be near a block's points, and whether it lies deep inside."""
        distance, _, _ = _nearest(solids, self._middles)
        reach = (0.75 * BLOCK + NEAR) * self.grid.cell
        return np.abs(distance) < reach, distance <= -reach

    def _derive(self) -> SolidFaces:
        nodes, mid_x, mid_y, centres = self._distances
        faces, h = self.faces, self.grid.cell
        open_faces(nodes, mid_x, mid_y, centres, h, faces.ax, faces.ay)
        close_thin_cells(nodes, centres, faces.ax, faces.ay)
        open_cells(nodes, centres, faces.volume)
        self._rest()
        return faces

    def _rest(self) -> None:
        faces = self.faces
        clearance(faces.ax, faces.ay, faces.clear)
        layers(faces.ax, LAYERS, faces.layer_u)
        layers(faces.ay, LAYERS, faces.layer_v)


def _nearest(solids: tuple[Sampled, ...], points: Floats) -> tuple[Floats, Floats, Longs]:
    """Distance, velocity and body of the nearest of several solids."""
    distance, velocity = np.full(len(points), np.inf), np.zeros((len(points), 2))
    body = np.full(len(points), -1, np.int64)
    for solid in solids:
        found = solid.sample(points)
        if np.isnan(found.distance).any() or not np.isfinite(found.velocity).all():
            raise ValueError("obstacle: its surface answers with what is no number")
        closer = found.distance < distance
        distance[closer] = found.distance[closer]
        velocity[closer], body[closer] = found.velocity[closer], found.body[closer]
    return distance, velocity, body
