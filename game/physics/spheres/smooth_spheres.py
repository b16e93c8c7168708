"""Smooth spheres from impact to impact, without a time step: what steps are measured against.

Between impacts all fly freely, along lines or parabolas. The next impact is the least root of quadratics, and
there the impulse along the line of centres acts. All pairs are looked at for each impact, so it is for some
dozens of spheres. Impacts at one time come in the order of the spheres.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.spheres.time_of_impact import falling_time, meeting_time

CLOSE = 1e-12  # of the radius: nearer than that is touching
NOBODY = -1


@inner_kernel
def wall_speed(v, i, wall):
    """How fast sphere i leaves a wall (left, right, bottom, top), m/s."""
    speed = v[i, wall // 2]
    return -speed if wall % 2 else speed


@inner_kernel
def wall_gap(x, radii, window, i, wall):
    """Gap between sphere i and a wall, m."""
    axis = wall // 2
    edge = window[axis + 2] if wall % 2 else window[axis]
    return (edge - x[i, axis] if wall % 2 else x[i, axis] - edge) - radii[i]


@inner_kernel
def next_impact(x, v, radii, window, gravity, h):
    """Seconds to the next impact, at most h; its sphere, and the other one or n + wall (-1: none)."""
    n = radii.shape[0]
    first, one, other = h, NOBODY, NOBODY
    for i in range(n):
        close = CLOSE * radii[i]
        for j in range(i + 1, n):
            dx, dy, dz = x[j, 0] - x[i, 0], x[j, 1] - x[i, 1], x[j, 2] - x[i, 2]
            vx, vy, vz = v[j, 0] - v[i, 0], v[j, 1] - v[i, 1], v[j, 2] - v[i, 2]
            if not dx * vx + dy * vy + dz * vz < 0.0:
                continue
            reach = radii[i] + radii[j]
            near = math.sqrt(dx * dx + dy * dy + dz * dz) - reach <= close
            t = 0.0 if near else meeting_time(dx, dy, dz, vx, vy, vz, reach, close)
            if t < first:
                first, one, other = t, i, j
        for wall in range(4):
            gap, speed = wall_gap(x, radii, window, i, wall), wall_speed(v, i, wall)
            bend = 0.0 if wall < 2 else 0.5 * gravity if wall == 2 else -0.5 * gravity
            t = 0.0 if gap <= close and speed < 0.0 else falling_time(gap, speed, bend, close)
            if t < first:
                first, one, other = t, i, n + wall
    return first, one, other


@inner_kernel
def strike(x, v, masses, i, other, e, wall_e):
    """The impulse of an impact."""
    n = masses.shape[0]
    if other >= n:
        axis = (other - n) // 2
        v[i, axis] = -wall_e * v[i, axis]
        return
    nx, ny, nz = x[other, 0] - x[i, 0], x[other, 1] - x[i, 1], x[other, 2] - x[i, 2]
    length = math.sqrt(nx * nx + ny * ny + nz * nz)
    nx, ny, nz = nx / length, ny / length, nz / length
    speed = (v[other, 0] - v[i, 0]) * nx + (v[other, 1] - v[i, 1]) * ny + (v[other, 2] - v[i, 2]) * nz
    weight_i, weight_j = 1.0 / masses[i], 1.0 / masses[other]
    j = -(1.0 + e) * speed / (weight_i + weight_j)
    v[i, 0] -= j * weight_i * nx
    v[i, 1] -= j * weight_i * ny
    v[i, 2] -= j * weight_i * nz
    v[other, 0] += j * weight_j * nx
    v[other, 1] += j * weight_j * ny
    v[other, 2] += j * weight_j * nz


@lean_kernel
def fly(x, v, radii, masses, window, numbers, duration, most):
    """Let spheres fly for so long (s); x, v (n, 3) are written. Returns impacts, or -1 for more than most.

    numbers: gravity m/s², restitution, the same at walls.
    """
    gravity, e, wall_e = numbers[0], numbers[1], numbers[2]
    left = duration
    made = 0
    while True:
        h, one, other = next_impact(x, v, radii, window, gravity, left)
        for i in range(radii.shape[0]):
            if not masses[i] < math.inf:
                continue
            x[i, 0] += h * v[i, 0]
            x[i, 1] += h * v[i, 1] - 0.5 * gravity * h * h
            x[i, 2] += h * v[i, 2]
            v[i, 1] -= gravity * h
        left -= h
        if one == NOBODY:
            return made
        if made == most:
            return -1
        strike(x, v, masses, one, other, e, wall_e)
        made += 1


class SmoothSpheres:
    """Smooth spheres that fly from impact to impact.

    positions, velocities: (n, 3) or (n, 2) m and m/s. radii: (n,) m. masses: (n,) kg. window: (4,) m, as x0
    y0 x1 y1. ValueError for what makes no sense, and from `fly` if impacts never end (a bouncing sphere that
    comes to rest has infinitely many).
    """

    def __init__(
        self,
        positions: ArrayLike,
        velocities: ArrayLike,
        radii: ArrayLike,
        masses: ArrayLike = 1.0,
        *,
        restitution: float = 1.0,
        wall_restitution: float = 1.0,
        gravity: float = 0.0,
        window: ArrayLike = (-1e6, -1e6, 1e6, 1e6),
    ):
        x, v = np.array(positions, dtype=np.float64), np.array(velocities, dtype=np.float64)
        if x.ndim != 2 or x.shape != v.shape or x.shape[1] not in (2, 3) or not len(x):
            raise ValueError("positions, velocities: expected equally many rows of two or three numbers")
        self.positions, self.velocities = np.zeros((len(x), 3)), np.zeros((len(x), 3))
        self.positions[:, : x.shape[1]], self.velocities[:, : x.shape[1]] = x, v
        self.radii = np.array(np.broadcast_to(np.asarray(radii, dtype=np.float64), len(x)))
        self.masses = np.array(np.broadcast_to(np.asarray(masses, dtype=np.float64), len(x)))
        self.window = np.array(window, dtype=np.float64)
        self._numbers = np.array((gravity, restitution, wall_restitution), dtype=np.float64)
        self.impacts = 0
        if not (np.isfinite(self.positions).all() and np.isfinite(self.velocities).all()):
            raise ValueError("positions, velocities: must be finite")
        if not ((self.radii > 0.0).all() and (self.masses > 0.0).all() and np.isfinite(self._numbers).all()):
            raise ValueError("radii, masses: must be above 0, and gravity and restitution finite")
        if not (0.0 <= restitution <= 1.0 and 0.0 <= wall_restitution <= 1.0):
            raise ValueError("restitution: expected 0 to 1")

    def fly(self, duration: float, most: int = 100_000) -> int:
        """Go on for so long (s); how many impacts there were. ValueError after more than ``most``."""
        if not 0.0 <= duration < math.inf:
            raise ValueError(f"duration = {duration!r}: expected a finite number from 0 s on")
        made: int = fly(
            self.positions, self.velocities, self.radii, self.masses, self.window, self._numbers,
            float(duration), most,
        )  # fmt: skip
        if made < 0:
            raise ValueError(f"more than {most} impacts: they do not end")
        self.impacts += made
        return made

    @property
    def gravity(self) -> float:
        """m/s² downwards."""
        return float(self._numbers[0])

    def energy(self) -> float:
        """J; height counts from y = 0."""
        free = np.isfinite(self.masses)
        mass, v = self.masses[free], self.velocities[free]
        moving = 0.5 * (mass * (v * v).sum(axis=1)).sum()
        return float(moving + self._numbers[0] * (mass * self.positions[free, 1]).sum())
