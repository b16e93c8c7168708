"""Round floats and a hull among wave particles, both ways. Yuksel, House, Keyser 2007, sections 5 and 7.

From water to float: lift by the volume under water (Archimedes), a push down the slope of the surface, drag.
From float to water: each face of the outline moves volume as it goes forward or sinks. What it has moved
within a short time becomes one wave particle that leaves along the face's normal, of that volume.

Floats are upright cylinders. A wave leaves from a radius outside, so that no float is lifted by its own.
Heeling and the flow of water beside the waves are left out.

Where we differ: the paper gives waves to the water for nothing, so a pond full of floats rises without end.
Here what drag takes from a float is taken from the particles below it. Its own waves get no more than that.
"""

from __future__ import annotations

import math
from typing import Annotated, NamedTuple

import numpy as np

from game.arrays import Floats, Longs
from game.compiler.decorator import kernel
from game.physics.kernels import elementary
from game.physics.waves.wave_particles import HEIGHT, KIND, WaveParticles, X, Y
from game.settings import Number

FACES = 8
COLUMNS = 12
FX, FY, FZ, FVX, FVY, FVZ, RADIUS, TALL, DENSITY, UNDER, MASS, TOOK = range(COLUMNS)
HUMP = 9.0 / 16.0  # of g a² r²: the energy of a particle by itself, in motion and height
# Waves that leave one after the other, 0.4 radii apart, add up: (4/3) r / 0.4 r times their single energies.
TRAIN = 10.0 / 3.0
REST = 0.3  # restitution of floats that meet


class FloatSettings(NamedTuple):
    """How water holds a float back."""

    drag: Annotated[float, Number(0.0, 5.0, help="coefficient across and along, of a cylinder")] = 1.0
    heave: Annotated[float, Number(0.0, 20.0, help="coefficient up and down")] = 4.0


class FloatState(NamedTuple):
    """rows: (n, COLUMNS); moved: (n, FACES) m³ since the last waves left."""

    rows: Floats
    moved: Floats


@kernel
def level_at(heights, cell, x, y):
    """Height (m) of the surface at a place, and its slopes along x and y."""
    ny, nx = heights.shape
    i = min(max(x / cell - 0.5, 0.0), nx - 1.001)
    j = min(max(y / cell - 0.5, 0.0), ny - 1.001)
    ci, cj = int(i), int(j)
    u, v = i - ci, j - cj
    a, b = heights[cj, ci], heights[cj, ci + 1]
    c, d = heights[cj + 1, ci], heights[cj + 1, ci + 1]
    level = (a * (1.0 - u) + b * u) * (1.0 - v) + (c * (1.0 - u) + d * u) * v
    return level, ((b - a) * (1.0 - v) + (d - c) * v) / cell, ((c - a) * (1.0 - u) + (d - b) * u) / cell


@kernel
def move_floats(rows, moved, normals, heights, cell, gravity, settings, dt):
    """One step of all floats by the surface as it is, and the volume that their faces move."""
    for f in range(rows.shape[0]):
        level, slope_x, slope_y = level_at(heights, cell, rows[f, FX], rows[f, FY])
        radius, tall = rows[f, RADIUS], rows[f, TALL]
        area = math.pi * radius * radius
        under = min(max(level - rows[f, FZ], 0.0), tall)
        mass = rows[f, DENSITY] * area * tall
        lift = gravity * area * under / mass
        speed = elementary.hypot(rows[f, FVX], rows[f, FVY])
        held = 0.5 * settings.heave * area / mass if under > 0.0 else 0.0
        # drag is taken at the end of the step, so that it only slows
        free = rows[f, FVZ] + (lift - gravity) * dt
        rows[f, FVZ] = free / (1.0 + held * abs(free) * dt)
        rows[f, TOOK] += 0.5 * mass * (free * free - rows[f, FVZ] * rows[f, FVZ])
        slowed = 1.0 / (1.0 + settings.drag * radius * under / mass * speed * dt)
        vx, vy = rows[f, FVX] - lift * slope_x * dt, rows[f, FVY] - lift * slope_y * dt
        rows[f, FVX], rows[f, FVY] = vx * slowed, vy * slowed
        rows[f, TOOK] += 0.5 * mass * (vx * vx + vy * vy) * (1.0 - slowed * slowed)
        rows[f, FX] += dt * rows[f, FVX]
        rows[f, FY] += dt * rows[f, FVY]
        rows[f, FZ] += dt * rows[f, FVZ]
        now = min(max(level - rows[f, FZ], 0.0), tall)
        sunk = area * (now - rows[f, UNDER]) / moved.shape[1]
        rows[f, UNDER] = now
        width = 2.0 * math.pi * radius / moved.shape[1] * now * dt
        for k in range(moved.shape[1]):
            ahead = normals[k, 0] * rows[f, FVX] + normals[k, 1] * rows[f, FVY]
            moved[f, k] += sunk + width * ahead


@kernel
def part_floats(rows, width, height):
    """Floats that meet part again, with what impulse they have; banks send them back."""
    count = rows.shape[0]
    for f in range(count):
        for other in range(f + 1, count):
            dx, dy = rows[other, FX] - rows[f, FX], rows[other, FY] - rows[f, FY]
            near = rows[f, RADIUS] + rows[other, RADIUS]
            apart = dx * dx + dy * dy
            if apart >= near * near or apart == 0.0:
                continue
            apart = math.sqrt(apart)
            nx, ny = dx / apart, dy / apart
            own, their = rows[f, MASS], rows[other, MASS]
            share = their / (own + their)
            for k in range(2):
                n = nx if k == 0 else ny
                rows[f, FX + k] -= share * (near - apart) * n
                rows[other, FX + k] += (1.0 - share) * (near - apart) * n
            closing = (rows[other, FVX] - rows[f, FVX]) * nx + (rows[other, FVY] - rows[f, FVY]) * ny
            if closing < 0.0:
                impulse = -(1.0 + REST) * closing * own * share
                rows[f, FVX] -= impulse / own * nx
                rows[f, FVY] -= impulse / own * ny
                rows[other, FVX] += impulse / their * nx
                rows[other, FVY] += impulse / their * ny
        for k in range(2):
            radius, end = rows[f, RADIUS], width if k == 0 else height
            if rows[f, FX + k] < radius:
                rows[f, FX + k] = radius
                rows[f, FVX + k] = REST * abs(rows[f, FVX + k])
            elif rows[f, FX + k] > end - radius:
                rows[f, FX + k] = end - radius
                rows[f, FVX + k] = -REST * abs(rows[f, FVX + k])


@kernel
def take_from_waves(fields, count, radii, rows, owner, cell, gravity, share):
    """Lower the particles below each float by the energy (J at 1 kg/m³) that its drag took.

    Work: owner (ny, nx) int64, number of the float that covers a cell, or -1; share (n, 2).
    """
    ny, nx = owner.shape
    for j in range(ny):
        for i in range(nx):
            owner[j, i] = -1
    for f in range(rows.shape[0]):
        radius = rows[f, RADIUS]
        for j in range(
            max(int((rows[f, FY] - radius) / cell), 0), min(int((rows[f, FY] + radius) / cell) + 1, ny)
        ):
            for i in range(
                max(int((rows[f, FX] - radius) / cell), 0), min(int((rows[f, FX] + radius) / cell) + 1, nx)
            ):
                owner[j, i] = f
        share[f, 0], share[f, 1] = 0.0, 1.0
    for p in range(count):
        j, i = min(int(fields[Y, p] / cell), ny - 1), min(int(fields[X, p] / cell), nx - 1)
        f = owner[j, i]
        if f >= 0:
            tall = fields[HEIGHT, p] * radii[int(fields[KIND, p])]
            share[f, 0] += HUMP * gravity * tall * tall
    for f in range(rows.shape[0]):
        if share[f, 0] > 0.0:
            share[f, 1] = math.sqrt(max(0.0, 1.0 - rows[f, TOOK] / share[f, 0]))
    for p in range(count):
        j, i = min(int(fields[Y, p] / cell), ny - 1), min(int(fields[X, p] / cell), nx - 1)
        f = owner[j, i]
        if f >= 0:
            fields[HEIGHT, p] *= share[f, 1]


def circle_normals(count: int) -> Floats:
    """(count, 2) unit normals of a circle's faces."""
    turns = [math.tau * k / count for k in range(count)]
    return np.array([(float(elementary.cos(turn)), float(elementary.sin(turn))) for turn in turns])


class FloatingBodies:
    """Round floats on a pond of wave particles."""

    def __init__(self, water: WaveParticles, settings: FloatSettings | None = None):
        self.water = water
        self.settings = settings or FloatSettings()
        self.rows: Floats = np.zeros((0, COLUMNS))
        self.moved: Floats = np.zeros((0, FACES))
        self._normals = circle_normals(FACES)
        self._owner: Longs = np.zeros(water.heights.shape, np.int64)

    def __len__(self) -> int:
        return len(self.rows)

    def add(self, place: tuple[float, float], radius: float, tall: float, density: float) -> None:
        """A float at rest in still water. radius, tall: m; density: water has 1. ValueError for nonsense."""
        if not (0.0 < radius < 1e3 and 0.0 < tall < 1e3 and 0.0 < density <= 10.0):
            raise ValueError(
                f"radius, tall, density = {radius}, {tall}, {density}: expected lengths above 0 m, "
                "a density above 0 and up to 10"
            )
        if not all(math.isfinite(one) for one in place):
            raise ValueError(f"place = {place!r}: expected two finite numbers")
        row = np.zeros((1, COLUMNS))
        under = min(density, 1.0) * tall
        row[0, [FX, FY, FZ, RADIUS, TALL, DENSITY, UNDER]] = *place, -under, radius, tall, density, under
        row[0, MASS] = density * math.pi * radius * radius * tall
        self.rows = np.concatenate([self.rows, row])
        self.moved = np.concatenate([self.moved, np.zeros((1, FACES))])

    def remove(self, number: int) -> None:
        """Take a float out."""
        self.rows = np.delete(self.rows, number, axis=0)
        self.moved = np.delete(self.moved, number, axis=0)

    def step(self, dt: float) -> None:
        """Go on by dt (s) on the heights that the water has found last."""
        gravity = self.water.settings.gravity
        move_floats(
            self.rows, self.moved, self._normals, self.water.heights, self.water.cell, gravity,
            self.settings, dt,
        )  # fmt: skip
        part_floats(self.rows, *self.water.size)

    def send_waves(self, kind: int) -> None:
        """Let what the faces have moved go off as particles of a kind, as far as drag paid for it."""
        water = self.water
        gravity, radius, angle = water.settings.gravity, float(water.radii[kind]), math.tau / FACES
        take_from_waves(
            water.fields, water.count, water.radii, self.rows, self._owner, water.cell, gravity,
            np.zeros((len(self.rows), 2)),
        )  # fmt: skip
        heights = self.moved / (radius * radius)
        cost = TRAIN * HUMP * gravity * radius * radius * (heights * heights).sum(axis=1)
        paid = np.sqrt(np.minimum(1.0, self.rows[:, TOOK] / np.maximum(cost, 1e-300)))
        heights *= paid[:, None]
        for f, k in np.argwhere(np.abs(heights) > water.settings.lowest).tolist():
            x, y, own = self.rows[f, [FX, FY, RADIUS]].tolist()
            c, s = self._normals[k].tolist()
            away = own + radius
            water.add((x + away * c, y + away * s), (c, s), float(heights[f, k]), angle, away, kind)
        self.moved[...] = 0.0
        self.rows[:, TOOK] = 0.0

    def state(self) -> FloatState:
        """All that later steps depend on."""
        return FloatState(self.rows, self.moved)

    def restore(self, state: FloatState) -> None:
        """Take over a copy of a state."""
        self.rows, self.moved = state.rows.copy(), state.moved.copy()
