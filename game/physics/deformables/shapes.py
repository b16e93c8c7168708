"""Meshes to begin with: round ones, and ones of squares cut in two (strips, sheets, combs)."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from game.physics.deformables.meshes import Mesh
from game.physics.kernels import elementary

MOST_RINGS, MOST_CELLS = 60, 400


def blob(radius: float, rings: int) -> Mesh:
    """A disc (radius m) of so many rings of triangles: 6 rings² of them. ValueError for nonsense."""
    if not 0.0 < radius < math.inf:
        raise ValueError(f"radius = {radius!r}: expected a finite number above 0 m")
    if isinstance(rings, bool) or not isinstance(rings, int) or not 1 <= rings <= MOST_RINGS:
        raise ValueError(f"rings = {rings!r}: expected a whole number, 1 to {MOST_RINGS}")
    points, triangles = [(0.0, 0.0)], []
    for ring in range(1, rings + 1):
        for k in range(6 * ring):
            angle = math.pi * k / (3.0 * ring)
            far = radius * ring / rings
            points.append((far * elementary.cos(angle), far * elementary.sin(angle)))
    for ring in range(1, rings + 1):
        outer, inner = _ring_start(ring), _ring_start(ring - 1)
        around, within = 6 * ring, max(6 * (ring - 1), 1)
        for k in range(around):
            sector, place = divmod(k, ring)
            below = inner + (sector * (ring - 1) + place) % within
            triangles.append((outer + k, outer + (k + 1) % around, below))
            if place < ring - 1:
                beside = inner + (sector * (ring - 1) + place + 1) % within
                triangles.append((below, outer + (k + 1) % around, beside))
    return Mesh(np.array(points), np.array(triangles, dtype=np.int64))


def _ring_start(ring: int) -> int:
    """Number of the first vertex of a ring."""
    return 1 + 3 * ring * (ring - 1) if ring else 0


def of_cells(cells: NDArray[np.bool_], width: float, height: float) -> Mesh:
    """The squares of a pattern (rows, columns; the lowest row first) within width x height (m) about the
    origin, each cut in two. Every other one is cut the other way. ValueError for nonsense.
    """
    if cells.ndim != 2 or not cells.any() or max(cells.shape) > MOST_CELLS:
        raise ValueError(f"cells: expected rows and columns, 1 to {MOST_CELLS}, one or more of them full")
    for name, value in (("width", width), ("height", height)):
        if not 0.0 < value < math.inf:
            raise ValueError(f"{name} = {value!r}: expected a finite number above 0 m")
    rows, columns = cells.shape
    triangles = []
    for j, i in np.argwhere(cells).tolist():
        a = j * (columns + 1) + i
        b, c, d = a + 1, a + columns + 2, a + columns + 1
        triangles += [(a, b, c), (a, c, d)] if (i + j) % 2 else [(a, b, d), (b, c, d)]
    x = (np.arange(columns + 1) / columns - 0.5) * width
    y = (np.arange(rows + 1) / rows - 0.5) * height
    places = np.stack(np.meshgrid(x, y), axis=-1).reshape(-1, 2)
    corners = np.array(triangles, dtype=np.int64)
    used, renamed = np.unique(corners, return_inverse=True)
    return Mesh(places[used], renamed.reshape(-1, 3).astype(np.int64))


def strip(width: float, height: float, columns: int, rows: int) -> Mesh:
    """A rectangle (m) of columns x rows squares: a worm if it is long, a sheet if it is not."""
    return of_cells(np.ones((rows, columns), dtype=np.bool_), width, height)


def comb(width: float, height: float, columns: int, rows: int) -> Mesh:
    """A comb of columns x rows squares: its back is the lowest row, above each third column is a tooth."""
    cells = np.zeros((rows, columns), dtype=np.bool_)
    cells[0] = True
    cells[:, ::3] = True
    return of_cells(cells, width, height)
