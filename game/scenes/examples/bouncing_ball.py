"""A bouncing ball, its impacts found at the end of a step or at the root: a whole scene in one file."""

import math
from typing import NamedTuple

import numpy as np

from game.lab.studies.motion import bounce_study
from game.physics.fields import GRAVITY, GROUND
from game.physics.oscillators import bounce_height, fall
from game.scenes.examples import BOUNCING_BALL
from game.scenes.examples.figure import draw_late_impact
from game.scenes.examples.marks import arrow_legend, mark_bounces, mark_flight, may_be_read
from game.stage import Choice, Equation, Frame, Param, Pointer, Readout, Scene, Strip
from game.ui.canvas.canvas import EXACT_DASH

RADIUS = 0.08  # m


class BallState(NamedTuple):
    """ball: (2,) height of its lowest point (m) and speed upwards (m/s)."""

    ball: np.ndarray


class BouncingBall(Scene):
    """A ball falls and is thrown back by the ground, a little lower each time. Between impacts a step is
    exact. What is lost is lost at the impact, if it is only seen at the end of the step it falls in. The
    dashed outline bounces exactly.
    """

    name, task, title = BOUNCING_BALL.names
    effects = GRAVITY | GROUND
    impact = Choice(
        "step-end", ("step-end", "root"), labels=("Step end", "Root"), help="when an impact is found"
    )
    restitution = Param(0.8, 0.0, 1.0, rebuild=True, help="speed after an impact over speed before")
    height = Param(1.0, 0.1, 10.0, unit="m", rebuild=True, help="from which the ball falls")
    step_length = Param(1.0 / 60.0, 1.0 / 2000.0, 0.1, unit="s", log=True, help="of time")
    strips = (Strip("Height", "m", ("height", "exact"), ("exact",)), Strip("Energy", "J/kg", ("energy",)))
    equations = (Equation("Impact", r"v^+ = -e \, v^-", "Newton 1687"),)
    try_this = ("Choose a long step, then the root: the ball is where it should be.",)
    figure = staticmethod(draw_late_impact)
    legend = arrow_legend
    study = bounce_study("bouncing-ball")

    def build(self, level):
        self.ball, self.time, self.free = np.array([self.height, 0.0]), 0.0, True

    def advance(self, dt):
        self.time += dt
        pull = 9.81 if GRAVITY in self.active else 0.0
        restitution = self.restitution if GROUND in self.active else None
        height, speed = self.ball.tolist()
        self.ball[:] = fall(height, speed, pull, restitution, self.impact == "root", dt)

    def state(self):
        return BallState(self.ball)

    def pointer(self, event: Pointer):
        if event.kind == "down" or (event.kind == "move" and event.button):
            self.ball[:], self.free = (max(event.y - RADIUS, 0.0), 0.0), False

    def effects_changed(self):
        self.free = False

    def frame(self):
        return Frame(-self.height, -0.15 * self.height, self.height, 1.15 * self.height + 2.0 * RADIUS)

    def exact(self, ago=0.0):
        time = max(self.time - ago, 0.0)
        return bounce_height(self.height, self.restitution, 9.81, time) if self.free else math.nan

    def readouts(self):
        y, v = self.ball.tolist()
        rows = (("height", y, "m"), ("exact", self.exact(), "m"), ("error", abs(y - self.exact()), "m"))
        return [*(Readout(*row) for row in rows), Readout("energy", 0.5 * v * v + 9.81 * y, "J/kg")]

    def draw(self, canvas, alpha):
        canvas.grid()
        canvas.ground(0.0)
        if self.free and may_be_read(self, "exact"):
            mark_bounces(canvas, self.height, self.restitution)
        y = self.previous.ball[0] + alpha * (self.ball[0] - self.previous.ball[0])
        canvas.circle((0.0, y + RADIUS), RADIUS, "chalk")
        exact = self.exact((1.0 - alpha) * self.step_length) + RADIUS
        canvas.circle((0.0, exact), RADIUS, outline="text1", width=1.4, dash=EXACT_DASH)
        weight = 9.81 if GRAVITY in self.active else 0.0
        mark_flight(canvas, (0.0, y + RADIUS), y, float(self.ball[1]), (weight, self.height))
