"""A body led along a curve, and handed over: key-framed it has infinite mass and exactly the curve's
velocity.

In each step the body's velocity is what brings it from where it is to where the curve is at the end of the
step. So what it touches feels a velocity that agrees with its motion, and places never drift from the curve.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from game.physics.solids.world import SolidWorld

Curve = Callable[[float], tuple[float, float, float]]


class KeyFrames:
    """Leads one body of a world along a curve: time s -> x m, y m, angle rad."""

    def __init__(self, world: SolidWorld, body: int, curve: Curve):
        self.world, self.body, self.curve = world, body, curve
        world.set_kind(body, "key-framed")

    def lead(self, time: float, dt: float) -> None:
        """Give the body the velocity for a step that begins at time (s) and lasts dt. ValueError for the
        curve.
        """
        x, y, angle = self.curve(time + dt)
        goal: NDArray[np.float64] = np.array([x, y, angle], dtype=np.float64)
        if not np.isfinite(goal).all():
            raise ValueError(f"curve: {goal.tolist()} at {time + dt:g} s: expected finite numbers")
        rows = self.world.bodies
        velocity = (goal[:2] - rows.positions[self.body]) / dt
        self.world.set_velocity(self.body, velocity, float(goal[2] - rows.angles[self.body]) / dt)

    def let_go(self) -> None:
        """Hand the body over to dynamics: pose, velocity and spin stay as they are."""
        self.world.set_kind(self.body, "dynamic")
