"""A hull that is led through a pond: its faces push the water aside, which leaves as wave particles.

Yuksel, House, Keyser 2007, section 5. A hull that goes faster than its waves has them within a wedge of
sin(angle) = c / U on either side, as Mach (1887) has it for sound. A real boat's wedge is Kelvin's (1887),
as on deep water long waves run faster than short ones; particles of one radius have one speed.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementary
from game.physics.waves.floats import FVX, FVY, FX, FY, RADIUS
from game.physics.waves.wave_particles import WaveParticles

FACES = 24
HX, HY, HVX, HVY, HCOS, HSIN = range(6)
TURNING = 4.0  # 1/s: how fast the bow turns to where it goes
LEAST_ANGLE = 0.05  # that a particle of a flat face stands for
SLOW = 0.05  # m/s; slower, it does not turn


class HullState(NamedTuple):
    """pose: (6,) place m, velocity m/s, cos and sin of its heading; moved: (FACES,) m³ since waves left."""

    pose: Floats
    moved: Floats


class Hull:
    """A hull of a length, a width and a draft (m), pointed at both ends, at a place (m)."""

    def __init__(
        self, water: WaveParticles, place: tuple[float, float], length: float, width: float, draft: float
    ):
        """ValueError for nonsense."""
        if not all(0.0 < one < 1e3 for one in (length, width, draft)):
            raise ValueError(f"length, width, draft = {length}, {width}, {draft}: expected lengths above 0 m")
        self.water, self.draft, self.size = water, draft, (length, width)
        self.outline = outline_of(length, width)
        ends = np.roll(self.outline, -1, axis=0)
        along = ends - self.outline
        self.lengths: Floats = np.sqrt((along * along).sum(axis=1))
        self.normals: Floats = np.stack([along[:, 1], -along[:, 0]], axis=1) / self.lengths[:, None]
        self.middles: Floats = 0.5 * (self.outline + ends)
        self.pose: Floats = np.array((*place, 0.0, 0.0, 1.0, 0.0))
        self.moved: Floats = np.zeros(FACES)

    @property
    def speed(self) -> float:
        """m/s."""
        return float(elementary.hypot(self.pose[HVX], self.pose[HVY]))

    def bow(self) -> tuple[float, float]:
        """Where it is foremost, m."""
        reach = float(self.outline[0, 0])
        return (
            float(self.pose[HX] + reach * self.pose[HCOS]),
            float(self.pose[HY] + reach * self.pose[HSIN]),
        )

    def corners(self) -> Floats:
        """(FACES, 2) of its outline in the pond, m."""
        return self._placed(self.outline) + self.pose[[HX, HY]]

    def _placed(self, local: Floats) -> Floats:
        c, s = float(self.pose[HCOS]), float(self.pose[HSIN])
        return np.stack([c * local[:, 0] - s * local[:, 1], s * local[:, 0] + c * local[:, 1]], axis=1)

    def step(self, velocity: tuple[float, float], dt: float) -> None:
        """Go at a velocity (m/s) for dt (s); the bow turns there, the banks stop it."""
        pose, size = self.pose, self.water.size
        speed = float(elementary.hypot(*velocity))
        if speed > SLOW:
            share = -float(elementary.expm1(-TURNING * dt))
            c = pose[HCOS] + share * (velocity[0] / speed - pose[HCOS])
            s = pose[HSIN] + share * (velocity[1] / speed - pose[HSIN])
            length = float(elementary.hypot(c, s))
            if length > 1e-6:
                pose[HCOS], pose[HSIN] = c / length, s / length
        for axis in range(2):
            before = float(pose[axis])
            pose[axis] = min(max(before + dt * velocity[axis], 0.0), size[axis])
            pose[HVX + axis] = (float(pose[axis]) - before) / dt
        normals = self._placed(self.normals)
        ahead = normals[:, 0] * pose[HVX] + normals[:, 1] * pose[HVY]
        self.moved += ahead * self.lengths * (self.draft * dt)

    def push_aside(self, rows: Floats) -> None:
        """Put floats (`floats`) that it meets beside it, at least as fast as it comes.

        It is taken as an ellipse; floats are light beside it.
        """
        pose = self.pose
        c, s = float(pose[HCOS]), float(pose[HSIN])
        dx, dy = rows[:, FX] - pose[HX], rows[:, FY] - pose[HY]
        long = 0.5 * self.size[0] + rows[:, RADIUS]
        wide = 0.5 * self.size[1] + rows[:, RADIUS]
        u, v = (c * dx + s * dy) / long, (c * dy - s * dx) / wide
        inside = np.sqrt(u * u + v * v)
        for f in np.nonzero((inside < 1.0) & (inside > 0.0))[0].tolist():
            nx, ny = float(u[f] / long[f]), float(v[f] / wide[f])
            nx, ny = c * nx - s * ny, s * nx + c * ny
            length = float(elementary.hypot(nx, ny))
            nx, ny = nx / length, ny / length
            rows[f, FX] = pose[HX] + dx[f] / inside[f]
            rows[f, FY] = pose[HY] + dy[f] / inside[f]
            closing = (pose[HVX] - rows[f, FVX]) * nx + (pose[HVY] - rows[f, FVY]) * ny
            if closing > 0.0:
                rows[f, FVX] += closing * nx
                rows[f, FVY] += closing * ny

    def send_waves(self, kind: int) -> None:
        """Let what the faces have moved go off as particles of a kind, and begin anew."""
        radius = float(self.water.radii[kind])
        normals, places = self._placed(self.normals), self._placed(self.middles)
        least = self.water.settings.lowest * radius * radius
        for k in np.nonzero(np.abs(self.moved) > least)[0].tolist():
            c, s = normals[k].tolist()
            x, y = (places[k] + self.pose[[HX, HY]]).tolist()
            (c0, s0), (c1, s1) = normals[k - 1].tolist(), normals[(k + 1) % FACES].tolist()
            angle = max(0.5 * abs(float(elementary.atan2(c0 * s1 - s0 * c1, c0 * c1 + s0 * s1))), LEAST_ANGLE)
            height = float(self.moved[k]) / (radius * radius)
            away = float(self.lengths[k]) / angle
            self.water.add((x, y), (c, s), height, angle, away, kind)
            self.moved[k] = 0.0

    def state(self) -> HullState:
        """All that later steps depend on."""
        return HullState(self.pose, self.moved)

    def restore(self, state: HullState) -> None:
        """Take over a copy of a state."""
        self.pose[...] = state.pose
        self.moved[...] = state.moved


def outline_of(length: float, width: float) -> Floats:
    """(FACES, 2) corners against the clock from the bow: two sides, each a sine."""
    half = FACES // 2
    x = [0.5 * length * (1.0 - 2.0 * k / half) for k in range(half)]
    y = [0.5 * width * float(elementary.sin(math.pi * k / half)) for k in range(half)]
    lower = [(-a, -b) for a, b in zip(x, y, strict=True)]
    return np.array([*zip(x, y, strict=True), *lower])
