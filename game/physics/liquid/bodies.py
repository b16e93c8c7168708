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
from game.physics.liquid.surface import SEALED
from game.physics.surfaces.surface import Sample, Surface

MOST = 256  # bodies that liquid moves
CLOSED = 1e-9  # of a face: what the outline of a whole body may lack, by rounding


class Grips(NamedTuple):
    """What bodies feel: rows of the system and how the pressure there acts."""

    row: Longs  # (n,) rows of wet cells at bodies, once for each body there
    slot: Longs  # (n,) which body
    share: Floats  # (n, 3) parts of faces that it closes: along x, along y, their torque (m)
    sizes: Longs  # (3,) rows; bodies; closed cells
    mobility: Floats  # (MOST, 3) change of a body's velocity and spin for q times share
    gain: Floats  # (MOST, 3) the same of what changed since the bodies were sampled, m/s, rad/s
    lift: Floats  # (MOST, 3) m/s², rad/s²: what contacts give it, as they did in the step before
    sums: Floats  # (MOST, 3) spare
    centre: Floats  # (MOST, 2) m
    of_row: Longs  # (ny, nx) row whose pressure acts in a cell, 0 for none
    closed: Longs  # (n,) cells sealed between bodies that are merged with others
    of_u: Longs  # (ny, nx + 1) body at a face, -1 for none that liquid moves
    of_v: Longs  # (ny + 1, nx)


def make_grips(ny: int, nx: int) -> Grips:
    """Of no bodies."""
    n = 4 * ny * nx
    return Grips(
        np.zeros(n, np.int64), np.zeros(n, np.int64), np.zeros((n, 3)), np.zeros(3, np.int64),
        np.zeros((MOST, 3)), np.zeros((MOST, 3)), np.zeros((MOST, 3)), np.zeros((MOST, 3)),
        np.zeros((MOST, 2)), np.zeros((ny, nx), np.int64), np.zeros(ny * nx, np.int64),
        np.full((ny, nx + 1), -1, np.int64), np.full((ny + 1, nx), -1, np.int64),
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


def hold_bodies(
    grips: Grips, surfaces: tuple[Surface, ...], body_u: Longs, body_v: Longs, scale: float
) -> list[Held]:
    """Which bodies can be moved, by their numbers at faces, (ny, nx + 1) and (ny + 1, nx); scale: density
    cell^2, kg/m. The closed rim of the grid belongs to none.
    """
    held: list[Held] = []
    grips.of_u[:], grips.of_v[:], grips.gain[:], grips.lift[:] = -1, -1, 0.0, 0.0
    for number in np.union1d(body_u[body_u >= 0], body_v[body_v >= 0]).tolist():
        surface, own = surfaces[number % len(surfaces)], number // len(surfaces)
        mass, inertia, centre = surface.inverse_mass(own)
        if mass > 0.0 and len(held) < MOST:
            grips.of_u[body_u == number], grips.of_v[body_v == number] = len(held), len(held)
            grips.mobility[len(held)] = scale * mass, scale * mass, scale * inertia
            grips.centre[len(held)] = centre
            held.append(Held(surface, own))
    grips.sizes[:] = 0, len(held), 0
    return held


def find_lift(grips: Grips, held: list[Held], scale: float, pull: float, dt: float) -> None:
    """What contacts hold bodies up with in a step of dt (s); scale: as above; pull: gravity, m/s².

    A stone on the floor does not fall. Would the liquid take its fall for granted, it would flow out from
    under it in each step. A body at rest is held with its weight at most. What is more is of an impact.
    """
    if not held or dt <= 0.0:
        return
    most = abs(pull)
    for surface in {id(one.surface): one.surface for one in held}.values():
        rows = [k for k, one in enumerate(held) if one.surface is surface]
        own = np.array([held[k].body for k in rows], np.int64)
        lift = surface.held_up(own, dt) * grips.mobility[rows] / (scale * dt)
        size = np.sqrt(lift[:, 0] * lift[:, 0] + lift[:, 1] * lift[:, 1])
        grips.lift[rows] = lift * np.minimum(1.0, most / np.maximum(size, 1e-300))[:, None]


def push(held: Held, centre: ArrayLike, impulse: Floats, during: float) -> None:
    """Linear impulse (N s) and angular one (N m s) on a body, as pushes at points, during s (`Surface`)."""
    x, y = np.asarray(centre, dtype=np.float64).tolist()
    jx, jy, turn = impulse.tolist()
    held.surface.push(held.body, (x, y), (jx, jy - turn), during)
    held.surface.push(held.body, (x + 1.0, y), (0.0, turn), during)


@inner_kernel
def _take_hold(grips, first, count, row, slot, along, up, torque):
    """Note the closed part of one face of a cell whose entries began at first; how many entries there are."""
    m = first
    while m < count and grips.slot[m] != slot:
        m += 1
    if m == count:
        grips.row[m], grips.slot[m], count = row, slot, count + 1
        grips.share[m, 0], grips.share[m, 1], grips.share[m, 2] = 0.0, 0.0, 0.0
    grips.share[m, 0] += along
    grips.share[m, 1] += up
    grips.share[m, 2] += torque
    return count


@inner_kernel
def _lies_between(grips, j, i):
    """Whether a cell's faces belong to a body that liquid moves, and not all to this one."""
    a, b, c, d = grips.of_u[j, i], grips.of_u[j, i + 1], grips.of_v[j, i], grips.of_v[j + 1, i]
    return max(max(a, b), max(c, d)) >= 0 and not (a == b and b == c and c == d)


@inner_kernel
def _merge(grips, rank, phi):
    """Sealed cells between bodies are merged with a wet cell beside them (Johansen and Colella 1998).

    They have no equation of their own: what the bodies sweep out of them comes out beside, where also the
    pressure is that pushes the bodies apart. Without it all the liquid around would press them together.
    """
    ny, nx = rank.shape
    row, closed, count = grips.of_row, grips.closed, 0
    for j in range(ny):
        for i in range(nx):
            row[j, i] = rank[j, i]
            if phi[j, i] == SEALED and _lies_between(grips, j, i):
                closed[count] = j * nx + i
                count += 1
    done, found = 0, True
    while found:
        found, first = False, done
        for m in range(first, count):
            j, i = closed[m] // nx, closed[m] % nx
            beside = 0
            for side in range(4):
                x, y = i + (side == 1) - (side == 0), j + (side == 3) - (side == 2)
                if beside == 0 and 0 <= x < nx and 0 <= y < ny:
                    beside = row[y, x]
            if beside > 0:
                row[j, i], closed[m], closed[done] = beside, closed[done], closed[m]
                done, found = done + 1, True
    grips.sizes[2] = done


@lean_kernel
def grip(grips, rank, phi, walls, origin):
    """Find the wet cells at bodies, and the closed parts of their faces.

    A face belongs to one body, the same for the cells on both of its sides. Thus what a body sweeps is what
    the right side of the equation was sampled with, and the pressures on it are each other's opposite.
    """
    ny, nx = rank.shape
    h, count = origin[2], 0
    _merge(grips, rank, phi)
    for j in range(ny):
        for i in range(nx):
            row = grips.of_row[j, i]
            if row == 0:
                continue
            first = count
            for side in range(4):
                x, y = i + (side == 1), j + (side == 3)
                slot = grips.of_u[y, x] if side < 2 else grips.of_v[y, x]
                closed = 1.0 - (walls.ax[y, x] if side < 2 else walls.ay[y, x])
                if slot < 0 or closed <= 0.0:
                    continue
                part = closed if side % 2 == 1 else -closed
                if side < 2:
                    lever = origin[1] + (j + 0.5) * h - grips.centre[slot, 1]
                    count = _take_hold(grips, first, count, row, slot, part, 0.0, -lever * part)
                else:
                    lever = origin[0] + (i + 0.5) * h - grips.centre[slot, 0]
                    count = _take_hold(grips, first, count, row, slot, 0.0, part, lever * part)
    grips.sizes[0] = count


@lean_kernel
def sweep(grips, walls, b):
    """Take from b what bodies sweep out of closed cells, and out of all beyond what was sampled."""
    nx = walls.ay.shape[1]
    for m in range(grips.sizes[2]):
        j, i = grips.closed[m] // nx, grips.closed[m] % nx
        left, right = (1.0 - walls.ax[j, i]) * walls.u[j, i], (1.0 - walls.ax[j, i + 1]) * walls.u[j, i + 1]
        down, up = (1.0 - walls.ay[j, i]) * walls.v[j, i], (1.0 - walls.ay[j + 1, i]) * walls.v[j + 1, i]
        b[grips.of_row[j, i]] += (left - right) + (down - up)
    for m in range(grips.sizes[0]):
        k, slot = grips.row[m], grips.slot[m]
        for n in range(3):
            b[k] -= grips.share[m, n] * grips.gain[slot, n]


@inner_kernel
def tie(grips, region, closed, regions):
    """Set closed (regions,) to 0 where one pressure all over a closed region would move a body.

    There the bodies settle how high the pressure is: what lies between them opens and shuts with them.
    """
    for k in range(regions):
        if closed[k] == 0.0:
            continue
        grips.sums[: grips.sizes[1]] = 0.0
        for m in range(grips.sizes[0]):
            if region[grips.row[m]] == k:
                for n in range(3):
                    grips.sums[grips.slot[m], n] += grips.share[m, n]
        for slot in range(grips.sizes[1]):
            if abs(grips.sums[slot, 0]) + abs(grips.sums[slot, 1]) > CLOSED:
                closed[k] = 0.0


@inner_kernel
def stiffen(grips, diagonal):
    """Add to a diagonal what each row's own pressure, by the bodies that it moves, makes flow out."""
    for m in range(grips.sizes[0]):
        for n in range(3):
            diagonal[grips.row[m]] += grips.share[m, n] * grips.share[m, n] * grips.mobility[grips.slot[m], n]


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
