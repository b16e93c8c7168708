"""Solids for tests: anything that answers `sample` as the surfaces of rooms do."""

from __future__ import annotations

import numpy as np

from game.physics.surfaces import empty_sample


class Disc:
    """Centre m, radius m, velocity m/s, spin rad/s."""

    def __init__(self, centre, radius, velocity=(0.0, 0.0), spin=0.0):
        self.centre, self.radius = np.array(centre, float), radius
        self.velocity, self.spin = np.array(velocity, float), spin

    def sample(self, points):
        found = empty_sample(len(points))
        away = points - self.centre
        found.distance[:] = np.hypot(*away.T) - self.radius
        found.velocity[:] = self.velocity + self.spin * np.stack([-away[:, 1], away[:, 0]], axis=1)
        found.body[:] = 0
        return found


class Box:
    """Centre, half sizes m, angle rad, velocity m/s, spin rad/s."""

    def __init__(self, centre, half, angle=0.0, velocity=(0.0, 0.0), spin=0.0):
        self.centre, self.half, self.angle = np.array(centre, float), np.array(half, float), angle
        self.velocity, self.spin = np.array(velocity, float), spin

    def sample(self, points):
        found = empty_sample(len(points))
        away = points - self.centre
        c, s = np.cos(self.angle), np.sin(self.angle)
        over = (
            np.abs(np.stack([c * away[:, 0] + s * away[:, 1], c * away[:, 1] - s * away[:, 0]], 1))
            - self.half
        )
        outside = np.hypot(*np.maximum(over, 0.0).T)
        found.distance[:] = outside + np.minimum(np.max(over, axis=1), 0.0)
        found.velocity[:] = self.velocity + self.spin * np.stack([-away[:, 1], away[:, 0]], axis=1)
        found.body[:] = 0
        return found
