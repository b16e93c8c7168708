"""The body by hydrostatics as a member of the world, with the hand that pulls it."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from game.arrays import Point
from game.physics.hydrostatics import FloatingBody
from game.physics.hydrostatics.motion import SPIN, VX, X, Y
from game.physics.kernels import elementary
from game.worlds.members.water import DENSITY
from game.worlds.stopwatch import Stopwatch
from game.worlds.world import Member

PARTS = 8  # of a step
HERTZ, DAMPING = 3.0, 0.7  # of the hand's spring


class ByLaw(Member):
    """``body``: by hydrostatics. held: point of it (from its centre) that a hand pulls to ``goal``, m."""

    def __init__(self, body: FloatingBody):
        self.body, self.watch = body, Stopwatch()
        self.held: Point | None = None
        self.goal: Point = (0.0, 0.0)

    def step(self, dt: float) -> None:
        self.body.pull[:] = self._pull()
        with self.watch.time("step"):
            self.body.step(dt, PARTS)

    def _pull(self) -> tuple[float, float, float]:
        """The hand's force N and torque N m."""
        if self.held is None:
            return 0.0, 0.0, 0.0
        pose, floater = self.body.pose, self.body.floater
        ((x, y),) = self.body.placed(np.array([self.held])).tolist()
        rx, ry = x - float(pose[X]), y - float(pose[Y])
        whole = floater.mass + DENSITY * floater.area
        stiff = whole * elementary.square(math.tau * HERTZ)
        slow = 2.0 * DAMPING * math.sqrt(stiff * whole)
        vx, vy = float(pose[VX] - pose[SPIN] * ry), float(pose[VX + 1] + pose[SPIN] * rx)
        fx, fy = stiff * (self.goal[0] - x) - slow * vx, stiff * (self.goal[1] - y) - slow * vy
        share = floater.inertia / (floater.inertia + floater.mass * (rx * rx + ry * ry))
        fx, fy = share * fx, share * fy
        return fx, fy, rx * fy - ry * fx

    def state(self) -> tuple[Any, ...]:
        return (self.body.state(),)

    def restore(self, fields: Iterator[Any]) -> None:
        self.body.restore(next(fields))
