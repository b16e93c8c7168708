"""A sail with four corners: a cloth that the wind presses, held by a mast, a gaff and the end of a boom.

The cloth is position based, in short substeps (Macklin and others 2019), each thread as long as it was cut.
The wind's pressure is normal to the cloth. It is that of a thin plate at any angle between none and all
(Duchemin 1842): c ½ ρ V² 2 s / (1 + s²), with s the sine of the angle between the wind and the cloth.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.kernels import elementary

X, Y, Z, VX, VY, VZ, WAS_X, WAS_Y, WAS_Z, LIGHT, AREA = range(11)  # rows of nodes: m, m/s, m, 1/kg, m²
ROWS = 11
FX, FY, FZ, TURN, LEAN, BACK = range(6)  # of a force: N, N m about the mast, about the long axis, across it
TINY = 1e-12


class Wind(NamedTuple):
    """Air in the frame of the boat: m/s, its density times the coefficient of a plate square to it kg/m³."""

    x: float
    y: float
    z: float
    press: float


@inner_kernel
def _pull(nodes, ja, ia, jb, ib, rest, slack):
    """One thread; with ``slack`` it only resists being longer."""
    wa, wb = nodes[LIGHT, ja, ia], nodes[LIGHT, jb, ib]
    dx = nodes[X, jb, ib] - nodes[X, ja, ia]
    dy = nodes[Y, jb, ib] - nodes[Y, ja, ia]
    dz = nodes[Z, jb, ib] - nodes[Z, ja, ia]
    length = math.sqrt(dx * dx + dy * dy + dz * dz) + TINY
    pull = (1.0 - rest / length) / (wa + wb + TINY)
    if slack and pull < 0.0:
        return
    nodes[X, ja, ia] += wa * pull * dx
    nodes[Y, ja, ia] += wa * pull * dy
    nodes[Z, ja, ia] += wa * pull * dz
    nodes[X, jb, ib] -= wb * pull * dx
    nodes[Y, jb, ib] -= wb * pull * dy
    nodes[Z, jb, ib] -= wb * pull * dz


@inner_kernel
def _normal(nodes, j, i):
    """Unit normal of the cloth at a node, from its neighbours."""
    left, right = max(i - 1, 0), min(i + 1, nodes.shape[2] - 1)
    up, down = max(j - 1, 0), min(j + 1, nodes.shape[1] - 1)
    ax, ay = nodes[X, j, right] - nodes[X, j, left], nodes[Y, j, right] - nodes[Y, j, left]
    az = nodes[Z, j, right] - nodes[Z, j, left]
    bx, by = nodes[X, up, i] - nodes[X, down, i], nodes[Y, up, i] - nodes[Y, down, i]
    bz = nodes[Z, up, i] - nodes[Z, down, i]
    x, y, z = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
    length = math.sqrt(x * x + y * y + z * z) + TINY
    return x / length, y / length, z / length


@lean_kernel
def blow_sail(nodes, rests, wind, gravity, calm, substeps, dt, total):
    """Move a sail for dt (s); into total (6,) the mean force of the wind on it, see FX.

    rests (4, rows, columns) m: threads across, down and both diagonals from each node. gravity m/s² downwards
    the mast; calm 1/s: the cloth's own friction.
    """
    rows, columns = nodes.shape[1], nodes.shape[2]
    h = dt / substeps
    keep = 1.0 / (1.0 + calm * h)
    for k in range(6):
        total[k] = 0.0
    for _ in range(substeps):
        for j in range(rows):
            for i in range(columns):
                nx, ny, nz = _normal(nodes, j, i)
                ax, ay = wind.x - nodes[VX, j, i], wind.y - nodes[VY, j, i]
                az = wind.z - nodes[VZ, j, i]
                square = ax * ax + ay * ay + az * az
                through = ax * nx + ay * ny + az * nz
                # Duchemin: V² 2 s / (1 + s²) with s V = through
                push = 2.0 * wind.press * nodes[AREA, j, i] * square * math.sqrt(square) * through
                push /= square + through * through + TINY
                fx, fy, fz = push * nx, push * ny, push * nz
                total[FX] += fx
                total[FY] += fy
                total[FZ] += fz
                total[TURN] += fx * nodes[Z, j, i] - fz * nodes[X, j, i]
                total[LEAN] += fz * nodes[Y, j, i] - fy * nodes[Z, j, i]
                total[BACK] += fy * nodes[X, j, i] - fx * nodes[Y, j, i]
                for axis in range(3):
                    nodes[WAS_X + axis, j, i] = nodes[X + axis, j, i]
                light = nodes[LIGHT, j, i]
                if light > 0.0:
                    # cloth is light: it does not overtake the air within a substep
                    part = 2.0 * wind.press * nodes[AREA, j, i] * math.sqrt(square) * light * h
                    fx, fy, fz = fx / (1.0 + part), fy / (1.0 + part), fz / (1.0 + part)
                    nodes[VX, j, i] = keep * (nodes[VX, j, i] + h * light * fx)
                    nodes[VY, j, i] = keep * (nodes[VY, j, i] + h * (light * fy - gravity))
                    nodes[VZ, j, i] = keep * (nodes[VZ, j, i] + h * light * fz)
                    for axis in range(3):
                        nodes[X + axis, j, i] += h * nodes[VX + axis, j, i]
        for j in range(rows):
            for i in range(columns):
                if i + 1 < columns:
                    _pull(nodes, j, i, j, i + 1, rests[0, j, i], False)
                if j + 1 < rows:
                    _pull(nodes, j, i, j + 1, i, rests[1, j, i], False)
                    if i + 1 < columns:
                        _pull(nodes, j, i, j + 1, i + 1, rests[2, j, i], True)
                        _pull(nodes, j, i + 1, j + 1, i, rests[3, j, i], True)
        for j in range(rows):
            for i in range(columns):
                if nodes[LIGHT, j, i] > 0.0:
                    for axis in range(3):
                        nodes[VX + axis, j, i] = (nodes[X + axis, j, i] - nodes[WAS_X + axis, j, i]) / h
    for k in range(6):
        total[k] /= substeps


class SailState(NamedTuple):
    """nodes (ROWS, rows, columns)."""

    nodes: Floats


class Sail:
    """Corners (4, 2) m from the mast and the origin of the boat: tack, throat, peak, clew; u aft of the
    mast, y up. weight kg/m²; fullness: share by which it is cut wider than it is set. ValueError for
    nonsense.

    Its plane turns about the mast by an angle, 0 with the boom aft (towards -x), above 0 towards +z.
    """

    def __init__(self, corners: Floats, columns: int, rows: int, weight: float = 0.4, fullness: float = 0.04):
        if corners.shape != (4, 2) or min(columns, rows) < 3 or not 0.0 < weight < 100.0:
            raise ValueError(f"corners {corners.shape}, columns, rows = {columns}, {rows}: out of range")
        self.flat = _grid(corners, columns, rows)
        self.nodes: Floats = np.zeros((ROWS, rows, columns))
        areas = np.zeros((rows, columns))
        u, y = self.flat
        for dj in range(2):
            for di in range(2):  # each mesh gives a quarter of itself to its corners
                areas[dj : rows - 1 + dj, di : columns - 1 + di] += 0.25 * _meshes(u, y)
        self.nodes[AREA] = areas
        self.area = float(np.sum(areas))
        self.nodes[LIGHT] = 1.0 / (weight * areas)
        self.held = np.zeros((rows, columns), dtype=bool)
        self.held[:, 0] = self.held[0] = self.held[-1, -1] = True
        self.nodes[LIGHT][self.held] = 0.0
        cut = u * (1.0 + fullness)
        self.rests: Floats = np.zeros((4, rows, columns))
        self.rests[0, :, :-1] = _lengths(cut[:, 1:] - cut[:, :-1], y[:, 1:] - y[:, :-1])
        self.rests[1, :-1] = _lengths(cut[1:] - cut[:-1], y[1:] - y[:-1])
        self.rests[2, :-1, :-1] = _lengths(cut[1:, 1:] - cut[:-1, :-1], y[1:, 1:] - y[:-1, :-1])
        self.rests[3, :-1, :-1] = _lengths(cut[1:, :-1] - cut[:-1, 1:], y[1:, :-1] - y[:-1, 1:])
        self.force: Floats = np.zeros(6)

    def hoist(self, angle: float) -> None:
        """Lay all of it into the plane at an angle, at rest."""
        self.nodes[X], self.nodes[Y], self.nodes[Z] = self._turned(angle, ...)
        self.nodes[VX : VZ + 1] = 0.0

    def _turned(self, angle: float, where: object) -> tuple[Floats, Floats, Floats]:
        u, y = self.flat[0][where], self.flat[1][where]
        return -u * elementary.cos(angle), y, u * elementary.sin(angle)

    def step(self, angle: float, rate: float, wind: Wind, gravity: float, dt: float, substeps: int) -> Floats:
        """Mast, gaff and clew at an angle (rad) that changes at a rate (rad/s); the force (6,), see FX."""
        x, y, z = self._turned(angle, self.held)
        self.nodes[X][self.held], self.nodes[Y][self.held], self.nodes[Z][self.held] = x, y, z
        self.nodes[VX][self.held], self.nodes[VZ][self.held] = rate * z, -rate * x
        blow_sail(self.nodes, self.rests, wind, gravity, 0.6, substeps, dt, self.force)
        return self.force

    def flapping(self) -> float:
        """m/s, the mean speed of the cloth beside that of its spars."""
        free = self.nodes[VX : VZ + 1][:, ~self.held]
        return float(np.mean(np.sqrt(np.sum(free * free, axis=0))))

    def belly(self) -> float:
        """m that the cloth is away from its plane at most."""
        corner = self.nodes[X : Z + 1, [0, -1, -1], [0, 0, -1]]
        one, other = corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]
        normal = np.cross(one, other)
        normal /= max(float(np.sqrt(np.sum(normal * normal))), TINY)
        off = self.nodes[X : Z + 1] - corner[:, 0, None, None]
        return float(np.max(np.abs(np.sum(off * normal[:, None, None], axis=0))))

    def state(self) -> SailState:
        """All that later steps depend on."""
        return SailState(self.nodes)

    def restore(self, state: SailState) -> None:
        """Take over a copy of a state."""
        self.nodes[...] = state.nodes


def _grid(corners: Floats, columns: int, rows: int) -> Floats:
    """(2, rows, columns) u, y between four corners, the head in row 0, the mast in column 0."""
    tack, throat, peak, clew = (corners[k][:, None, None] for k in range(4))
    along, down = np.arange(columns) / (columns - 1.0), (np.arange(rows) / (rows - 1.0))[:, None]
    head, foot = throat + (peak - throat) * along, tack + (clew - tack) * along
    return np.ascontiguousarray(head + (foot - head) * down)


def _lengths(one: Floats, other: Floats) -> Floats:
    return np.sqrt(one * one + other * other)


def _meshes(u: Floats, y: Floats) -> Floats:
    """m² of meshes (rows - 1, columns - 1), by their diagonals."""
    return np.asarray(
        0.5 * np.abs((u[1:, 1:] - u[:-1, :-1]) * (y[1:, :-1] - y[:-1, 1:])
                     - (u[1:, :-1] - u[:-1, 1:]) * (y[1:, 1:] - y[:-1, :-1]))
    )  # fmt: skip
