"""Bodies in a liquid, both ways (Batty, Bertails and Bridson 2007).

The velocities of bodies are unknowns of the pressure. A wet cell's pressure pushes a body through the closed
parts of its faces; what the body sweeps there flows out of the cell. An impulse that came a step late would
make whatever floats diverge.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats, Longs
from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.grid.obstacles import SolidFaces
from game.physics.surfaces.surface import Sample, Surface

MOST = 256  # bodies that liquid moves


class Grips(NamedTuple):
    """What bodies feel: rows of the system and how the pressure there acts."""

    row: Longs  # (n,) rows of wet cells at bodies
    slot: Longs  # (n,) which body
    share: Floats  # (n, 3) closed parts: along x, along y, their torque (m)
    sizes: Longs  # (2,) rows; bodies
    mobility: Floats  # (MOST, 3) change of a body's velocity and spin for q times share
    gain: Floats  # (MOST, 3) the same of what changed since the bodies were sampled, m/s, rad/s
    sums: Floats  # (MOST, 3) spare
    centre: Floats  # (MOST, 2) m
    of_cell: Longs  # (ny, nx) body of a cell, -1 for none


def make_grips(ny: int, nx: int) -> Grips:
    """Of no bodies."""
    n = ny * nx
    return Grips(
        np.zeros(n, np.int64), np.zeros(n, np.int64), np.zeros((n, 3)), np.zeros(2, np.int64),
        np.zeros((MOST, 3)), np.zeros((MOST, 3)), np.zeros((MOST, 3)), np.zeros((MOST, 2)),
        np.full((ny, nx), -1, np.int64),
    )  # fmt: skip


class Numbered:
    """A surface of several, whose bodies have numbers of their own: body times how many, plus which."""

    def __init__(self, surface: Surface, which: int, many: int):
        self.surface, self.which, self.many = surface, which, many

    def sample(self, points: Floats) -> Sample:
        """As the surface's own."""
        found = self.surface.sample(points)
        numbers = np.where(found.body >= 0, found.body * self.many + self.which, -1)
        return found._replace(body=numbers)


class Held(NamedTuple):
    """A body of a surface that the liquid moves."""

    surface: Surface
    body: int


def hold_bodies(grips: Grips, surfaces: tuple[Surface, ...], body: Longs, scale: float) -> list[Held]:
    """Which bodies can be moved, by the numbers that cells (ny, nx) gave; scale: density cell^2, kg/m."""
    held: list[Held] = []
    grips.of_cell[:], grips.gain[:] = -1, 0.0
    for number in np.unique(body[body >= 0]).tolist():
        surface, own = surfaces[number % len(surfaces)], number // len(surfaces)
        mass, inertia, centre = surface.inverse_mass(own)
        if mass > 0.0 and len(held) < MOST:
            grips.of_cell[body == number] = len(held)
            grips.mobility[len(held)] = scale * mass, scale * mass, scale * inertia
            grips.centre[len(held)] = centre
            held.append(Held(surface, own))
    grips.sizes[:] = 0, len(held)
    return held


def push(held: Held, centre: ArrayLike, impulse: Floats) -> None:
    """Linear impulse (N s) and angular one (N m s) on a body, as pushes at points."""
    x, y = np.asarray(centre, dtype=np.float64).tolist()
    jx, jy, turn = impulse.tolist()
    held.surface.push(held.body, (x, y), (jx, jy - turn))
    held.surface.push(held.body, (x + 1.0, y), (0.0, turn))


@lean_kernel
def grip(grips, rank, solids: SolidFaces, origin):
    """Find the wet cells at bodies, and the closed parts of their faces."""
    ny, nx = rank.shape
    h, count = origin[2], 0
    for j in range(ny):
        for i in range(nx):
            slot = grips.of_cell[j, i]
            if rank[j, i] == 0 or slot < 0:
                continue
            left, right = 1.0 - solids.ax[j, i], 1.0 - solids.ax[j, i + 1]
            low, high = 1.0 - solids.ay[j, i], 1.0 - solids.ay[j + 1, i]
            if left + right + low + high <= 0.0:
                continue
            x = origin[0] + (i + 0.5) * h - grips.centre[slot, 0]
            y = origin[1] + (j + 0.5) * h - grips.centre[slot, 1]
            grips.row[count], grips.slot[count] = rank[j, i], slot
            grips.share[count, 0], grips.share[count, 1] = right - left, high - low
            grips.share[count, 2] = x * (high - low) - y * (right - left)
            count += 1
    grips.sizes[0] = count


@lean_kernel
def sweep(grips, b):
    """Take from b what bodies sweep out of cells beyond what was sampled."""
    for m in range(grips.sizes[0]):
        k, slot = grips.row[m], grips.slot[m]
        for n in range(3):
            b[k] -= grips.share[m, n] * grips.gain[slot, n]


@inner_kernel
def gather(grips, field):
    """sums (bodies, 3) of share times field: what the field as a pressure does to each body."""
    grips.sums[: grips.sizes[1]] = 0.0
    for m in range(grips.sizes[0]):
        value = field[grips.row[m]]
        for n in range(3):
            grips.sums[grips.slot[m], n] += grips.share[m, n] * value


@inner_kernel
def answer(grips, field, out):
    """Add to out what bodies that the field moves sweep out of cells; field times that."""
    if grips.sizes[0] == 0:
        return 0.0
    gather(grips, field)
    total = 0.0
    for m in range(grips.sizes[0]):
        k, slot, swept = grips.row[m], grips.slot[m], 0.0
        for n in range(3):
            swept += grips.share[m, n] * grips.mobility[slot, n] * grips.sums[slot, n]
        out[k] += swept
        total += swept * field[k]
    return total
