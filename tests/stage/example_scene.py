"""A whole scene in one file: a ball that bounces. Also the README's example of how to write one."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from game.compiler.decorator import kernel
from game.physics.effects import declare_effect
from game.stage import Action, Frame, Param, Pointer, Readout, Scene, SceneAction, Strip, Toggle

GRAVITY = declare_effect("test-gravity", "Gravity", "Pulls everything down.")
GROUND = declare_effect("test-ground", "Ground", "The ball comes back from the ground.")


class BallState(NamedTuple):
    """position and velocity: (2,) m and m/s; bounces: (1,)."""

    position: np.ndarray
    velocity: np.ndarray
    bounces: np.ndarray


@kernel
def step_ball(state: BallState, gravity: float, ground: bool, restitution: float, dt: float) -> None:
    """Semi-implicit Euler; writes ``state``."""
    position, velocity, bounces = state
    velocity[1] -= gravity * dt
    position[0] += velocity[0] * dt
    position[1] += velocity[1] * dt
    if ground and position[1] < 0.0 and velocity[1] < 0.0:
        position[1] = 0.0
        velocity[1] = -restitution * velocity[1]
        bounces[0] += 1


class BouncingBall(Scene):
    """A ball falls and is thrown back by the ground, a little lower each time."""

    name, task, title = "example", "X00", "Bouncing ball"
    effects = GRAVITY | GROUND
    gravity = Param(9.81, 0.0, 100.0, unit="m/s²", help="acceleration downwards")
    restitution = Param(0.8, 0.0, 1.0, help="speed after a bounce over speed before")
    height = Param(1.0, 0.1, 1e6, unit="m", log=True, rebuild=True, help="where the ball begins")
    frozen = Toggle(False, help="the ball stands still")
    strips = (Strip("Energy", "J/kg", ("energy",)),)
    actions = (SceneAction("kick", "Kick", "k"),)

    def build(self, level):
        self.ball = BallState(np.array([0.0, self.height]), np.array([1.0, 0.0]), np.zeros(1, dtype=np.int64))
        self.held = False

    def advance(self, dt):
        if not (self.held or self.frozen):
            gravity = self.gravity if GRAVITY in self.active else 0.0
            step_ball(self.ball, gravity, GROUND in self.active, self.restitution, dt)

    def state(self):
        return self.ball

    def pointer(self, event: Pointer):
        self.held = event.kind == "down" or (self.held and event.kind == "move")
        if self.held:
            self.ball.position[:] = event.x, event.y

    def action(self, name: str):
        self.ball.velocity[1] += 3.0

    def frame(self):
        return Frame(-2.0, -0.5, 2.0, 2.0)

    def readouts(self):
        (_, y), (u, v) = self.ball.position.tolist(), self.ball.velocity.tolist()
        return [
            Readout("energy", 0.5 * (u * u + v * v) + self.gravity * y, "J/kg"),
            Readout("height", y, "m"),
        ]

    def draw(self, canvas, alpha):
        before, now = self.previous.position, self.ball.position
        canvas.ground(0.0)
        canvas.dot(before + alpha * (now - before))


KICK = Action("kick")
