"""A small scene with every kind of control, strip and legend, for the tests and the gallery of widgets."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.physics.effects import EffectSet, declare_effect
from game.stage import Choice, Equation, Frame, Hint, Param, Readout, Scene, Strip, Toggle

PULL = declare_effect("test-gravity", "Gravity", "Pulls everything down.")
FLOOR = declare_effect("test-ground", "Ground", "The ball comes back from the ground.")
AIR = declare_effect("test-drag", "Air drag", "Slows the ball with its speed.")


class SampleState(NamedTuple):
    body: np.ndarray  # height m, speed m/s


class Sample(Scene):
    """A ball bounces on the ground.

    It falls under gravity and loses a part of its speed at each impact. The dashed line is exact: no ball
    rises above the height it came from.
    """

    name = "sample"
    task = "C04"
    title = "Bouncing ball"
    effects = EffectSet((PULL, FLOOR, AIR))
    drop = Param(3.0, 0.5, 4.0, unit="m", step=0.1, label="Height", group="Start", rebuild=True)
    rate = Param(
        8000,
        1,
        26000,
        unit="1/s",
        whole=True,
        label="Emit rate",
        group="Start",
        help="Particles each second.",
    )
    restitution = Param(0.5, 0.0, 1.0, step=0.01, group="Impact", help="Share of the speed that is kept.")
    stiffness = Param(2.0e4, 10.0, 1.0e7, unit="N/m", log=True, group="Impact")
    hold = Param(0.004, 0.0, 0.1, unit="s", group="Impact")
    method = Choice("verlet", ("explicit-euler", "midpoint", "verlet"), group="Method",
                    labels=("Explicit Euler", "Midpoint", "Verlet"))  # fmt: skip
    order = Choice(
        "pairwise", ("pairwise", "joint", "random", "as-printed"), label="Order of contacts", group="Solver"
    )
    shadow = Toggle(True, group="Shown")
    axes = Toggle(
        False, label="Separating axes", group="Shown", help="Draws the axes that separate two boxes."
    )
    strips = (
        Strip("Energy", "J", ("pot.", "kin.")),
        Strip("Height", "m", ("now", "exact"), exact=("exact",)),
        Strip("Step time", "s", ("step",)),
    )
    equations = (
        Equation("Motion, with drag", r"m\v{a} = m\v{g} - k|\v{v}|\v{v}", "Newton 1687"),
        Equation(
            "Velocity Verlet",
            r"\v{x}_{n+1} = \v{x}_n + h\v{v}_n + \frac{1}{2}h^2\v{a}_n",
            "Swope and others 1982",
        ),
        Equation("", r"\v{v}_{n+1} = \v{v}_n + \frac{1}{2}h(\v{a}_n + \v{a}_{n+1})"),
        Equation("Impact", r"\v{v}^+ = \v{v}^- - (1 + e)(\v{v}^-\cdot\v{n})\v{n}", "Newton 1687"),
        Equation("Envelope of all paths", r"y = \frac{v^2}{2g} - \frac{gx^2}{2v^2}", "Torricelli 1644"),
    )
    try_this = (
        "Set the restitution to 1 and watch the energy strip stay level.",
        "Choose explicit Euler and a long step: the ball rises above the dashed line.",
        "Switch the air on: the bar shows what it costs.",
    )
    hints = (Hint(("Drag",), "move the ball"), Hint(("Shift", "Drag"), "throw it"))

    def build(self, level):
        self.body = np.array([self.drop, 0.0])

    def advance(self, dt):
        height, speed = self.body
        speed -= 9.81 * dt * (PULL in self.active)
        height += speed * dt
        if FLOOR in self.active and height < 0.2 and speed < 0.0:
            height, speed = 0.2, -speed * max(self.restitution, 0.9)
        self.body[:] = height, speed

    def state(self):
        return SampleState(self.body)

    def readouts(self):
        height, speed = float(self.body[0]), float(self.body[1])
        return (
            Readout("balls", 12112.0), Readout("pot.", 9.81 * height, "J"),
            Readout("kin.", 0.5 * speed * speed, "J"), Readout("now", height, "m"),
            Readout("exact", self.drop, "m"), Readout("step", 52e-6 + 4e-6 * math.sin(9 * height), "s"),
        )  # fmt: skip

    def legend(self):
        return (
            ("scale:slow:fast", "Speed", "0 9 m/s"),
            ("disc:amber", "touching the ground", ""),
            ("dash:text3", "exact reference", ""),
        )

    def frame(self):
        return Frame(-4.0, 0.0, 4.0, 4.2)

    def draw(self, canvas, alpha):
        canvas.fill()
        canvas.grid()
        canvas.ground(0.0)
        canvas.line((-4.0, self.drop), (4.0, self.drop), "text1", 1.4, (6, 6), 0.75)
        canvas.label((1.0, self.drop), "exact: no ball rises above", anchor="bottomleft", offset=(0, -4))
        center = (0.0, float(self.body[0]))
        canvas.body(center, 0.2, 0.6)
        canvas.arrow(center, (0.0, float(self.body[1])), "chalk", "v", scale=0.1)
        canvas.arrow(center, (0.0, -0.8), "amber", "F")
        canvas.handle((0.2, float(self.body[0])))
        canvas.contact((0.0, 0.0), chosen=True)
