"""Arrays of a liquid: its particles, and the cells through which they meet."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats, Longs
from game.physics.grid.layout import Grid

LEAST_OPEN = 0.05  # part of a face; less is closed


class Particles(NamedTuple):
    """Rows beyond ``alive`` are spare. Each particle stands for the same area of liquid."""

    places: Floats  # (n, 2) m
    speeds: Floats  # (n, 2) m/s
    affine: Floats  # (n, 4) of both components, change along x and y, m/s a cell
    alive: Longs  # (1,) how many


class Cells(NamedTuple):
    """Fields on a grid of ny rows and nx columns."""

    u: Floats  # (ny, nx + 1) m/s
    v: Floats  # (ny + 1, nx)
    old_u: Floats  # as they came from the particles
    old_v: Floats
    weight_u: Floats  # particles at faces; -1, -2 where the speed is continued
    weight_v: Floats
    fill: Floats  # (ny, nx) share of a cell's surroundings that is liquid; 1 is full
    room: Floats  # (ny, nx) share of them that is no solid
    phi: Floats  # (ny, nx) distance to the surface in cells, below 0 in liquid
    rank: Longs  # (ny, nx) row of a wet cell in the equation, 0 for others
    q: Floats  # (ny, nx) pressure times dt / (density cell), m/s
    q_shift: Floats  # (ny, nx) the same of the correction
    ends: Longs  # (4,) left, right, bottom, top: 1 is open
    front: Longs  # (n,) spare, for places of faces


class Walls(NamedTuple):
    """What is solid."""

    ax: Floats  # (ny, nx + 1) open part of faces
    ay: Floats  # (ny + 1, nx)
    u: Floats  # (ny, nx + 1) m/s of the solid
    v: Floats  # (ny + 1, nx)
    distance: Floats  # (2 ny + 1, 2 nx + 1) cells, at nodes, middles of faces, and centres
    closed_u: Longs  # (m,) places of closed faces in the flat field of u
    closed_v: Longs
    present: NDArray[np.bool_]  # (1,) whether there is any solid


class System(NamedTuple):
    """The equation on wet cells, row by row from 1; rows 0 and those beyond the last hold zeros.

    Neighbours along x are the rows before and behind, whose link is 0 where they are none.
    """

    cell: Longs  # (n,) place in the flat grid
    down: Longs  # (n,) row of the neighbour, 0 for none
    up: Longs
    left: Floats  # (n,) links
    below: Floats
    diagonal: Floats
    b: Floats
    p: Floats
    r: Floats
    d: Floats
    z: Floats
    factor: Floats  # one over the diagonal of the incomplete factor
    back: Floats  # (n, 4) links times factors: forward along x, y, backward along x, y
    region: Longs  # (n,)
    stack: Longs
    sums: Floats  # (3, n)


def make_particles(most: int) -> Particles:
    """At most so many."""
    return Particles(np.zeros((most, 2)), np.zeros((most, 2)), np.zeros((most, 4)), np.zeros(1, np.int64))


def make_cells(grid: Grid) -> Cells:
    """All dry."""
    ny, nx = grid.shape
    u, old_u, weight_u = (np.zeros((ny, nx + 1)) for _ in range(3))
    v, old_v, weight_v = (np.zeros((ny + 1, nx)) for _ in range(3))
    fill, phi, q, q_shift = (np.zeros((ny, nx)) for _ in range(4))
    return Cells(
        u, v, old_u, old_v, weight_u, weight_v, fill, np.ones((ny, nx)), phi,
        np.zeros((ny, nx), np.int64), q, q_shift, np.zeros(4, np.int64),
        np.zeros(2 * (nx + 1) * (ny + 1), np.int64),
    )  # fmt: skip


def make_walls(grid: Grid, far: float) -> Walls:
    """No solid at all; far: its distance, cells."""
    ny, nx = grid.shape
    none: Longs = np.zeros(0, np.int64)
    return Walls(
        np.ones((ny, nx + 1)), np.ones((ny + 1, nx)), np.zeros((ny, nx + 1)), np.zeros((ny + 1, nx)),
        np.full((2 * ny + 1, 2 * nx + 1), far), none, none, np.zeros(1, np.bool_),
    )  # fmt: skip


def make_system(count: int) -> System:
    """Of at most so many wet cells."""
    n = count + 3
    cell, down, up, region, stack = (np.zeros(n, np.int64) for _ in range(5))
    left, below, diagonal, b, p, r, d, z, factor = (np.zeros(n) for _ in range(9))
    return System(
        cell, down, up, left, below, diagonal, b, p, r, d, z, factor, np.zeros((n, 4)), region, stack,
        np.zeros((3, n)),
    )  # fmt: skip
