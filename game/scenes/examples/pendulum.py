"""A pendulum by five methods beside its exact motion: a whole scene in one file."""

import math
from typing import NamedTuple

import numpy as np

from game.lab.studies.motion import swing_study
from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY
from game.physics.integrators import METHODS, integrate
from game.physics.kernels import elementary
from game.physics.oscillators import pendulum_angle, pendulum_period, rod_pull
from game.scenes.examples import PENDULUM
from game.scenes.examples.figure import draw_forces
from game.scenes.examples.marks import arrow_legend, mark_swing
from game.stage import Choice, Equation, Frame, Param, Pointer, Readout, Scene, Strip
from game.ui.canvas.canvas import EXACT_DASH


class PendulumState(NamedTuple):
    """swing: (2,) angle (rad, 0 is down) and rate (rad/s)."""

    swing: np.ndarray


class Pendulum(Scene):
    """A mass on a rod without weight. The farther it swings, the longer it takes: let go at 60 degrees, 7 %
    longer than one that hardly moves. Explicit Euler feeds energy to it; Verlet keeps its energy within
    bounds, however long one looks. The dashed rod moves exactly. Drag the mass and let it go.
    """

    name, task, title = PENDULUM.names
    effects = EffectSet([GRAVITY])
    method = Choice("verlet", METHODS, help="how a step is made")
    length = Param(1.0, 0.1, 10.0, unit="m", log=True, rebuild=True, help="of the rod")
    start = Param(60.0, -179.0, 179.0, unit="°", rebuild=True, help="angle at which it is let go")
    step_length = Param(1.0 / 120.0, 1.0 / 2000.0, 0.1, unit="s", log=True, help="of time")
    strips = (Strip("Energy", "J/kg", ("energy",)), Strip("Error", "°", ("error",)))
    equations = (Equation("Motion", r"\ddot{\phi} = -\frac{g}{l} \sin \phi", "Newton 1687"),)
    try_this = ("Choose explicit Euler: the energy grows, until the pendulum turns over.",)
    figure = staticmethod(draw_forces)
    legend = arrow_legend
    study = swing_study("pendulum")

    def build(self, level):
        self.swing, self.time, self.held = np.radians([self.start, 0.0]), 0.0, False
        self.free = float(self.swing[0]), 0.0  # angle and time of letting go, for the exact motion
        self.passed = self.period = math.nan  # when it last swung to the right through its lowest point; s

    def advance(self, dt):
        self.time += dt
        if self.held:
            self.free = float(self.swing[0]), self.time
        else:
            angle, rate = integrate(self.method, rod_pull(self.pull), self.swing[:1], self.swing[1:], dt, 1)
            if self.swing[0] < 0.0 <= angle[0]:
                now = self.time - dt * float(angle[0] / (angle[0] - self.swing[0]))
                self.passed, self.period = now, now - self.passed
            self.swing[:] = angle[0], rate[0]

    @property
    def pull(self):
        return 9.81 / self.length if GRAVITY in self.active else 0.0  # g / l, 1/s²

    def state(self):
        return PendulumState(self.swing)

    def pointer(self, event: Pointer):
        self.held = event.kind == "down" or (self.held and event.kind == "move")
        if self.held:
            self.swing[:] = elementary.atan2(event.x, -event.y), 0.0
            self.free, self.passed = (float(self.swing[0]), self.time), math.nan

    def effects_changed(self):
        self.free = math.nan, self.time  # another motion begins, of which no exact one is known

    def frame(self):
        return Frame(-1.6 * self.length, -1.3 * self.length, 1.6 * self.length, 1.2 * self.length)

    def exact(self, ago=0.0):
        return pendulum_angle(self.free[0], self.pull, max(self.time - ago - self.free[1], 0.0))

    def readouts(self):
        angle, rate = self.swing.tolist()
        energy = (self.length * self.length) * (0.5 * rate * rate + self.pull * (1.0 - elementary.cos(angle)))
        error = (angle - self.exact() + math.pi) % math.tau - math.pi
        law = pendulum_period(self.free[0], self.pull)
        rows = [Readout("error", math.degrees(error), "°"), Readout("energy", energy, "J/kg")]
        return [*rows, Readout("period", self.period, "s"), Readout("by the law", law, "s")]

    def draw(self, canvas, alpha):
        canvas.grid()
        angle = self.previous.swing[0] + alpha * (self.swing[0] - self.previous.swing[0])
        exact = self.exact((1.0 - alpha) * self.step_length)
        for turn, color, dash in ((exact, "text3", EXACT_DASH), (angle, "chalk", None)):
            mass = self.length * elementary.sin(turn), -self.length * elementary.cos(turn)
            canvas.line((0.0, 0.0), mass, "text2", 1.6, dash)
            canvas.circle(mass, 0.07 * self.length, color)
        mark_swing(canvas, self, (angle, self.swing[1]), self.length, self.pull)
