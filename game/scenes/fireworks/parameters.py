"""The parameters of the fireworks: the show, the stars, the air, the method, the listener."""

from __future__ import annotations

from game.physics.generations import METHODS
from game.scenes.fireworks.shells import SHELLS
from game.stage import Choice, Param, Parameters, Toggle


class FireworksParameters(Parameters):
    """What of the fireworks can be chosen."""

    shell = Choice("peony", SHELLS, group="Show", help="what a click fires, to burst where you click")
    programme = Toggle(True, group="Show", help="shells are fired as the level says")
    star_mass = Param(
        1.0, 0.1, 20.0, log=True, group="Stars", label="Star mass",
        help="beside that of a common star: what is heavier feels the air less",
    )  # fmt: skip
    sparks = Param(
        1.0, 0.1, 2.0, group="Stars", rebuild=True, help="how many sparks trails leave, beside the usual"
    )
    places = Param(
        1.0, 0.01, 1.0, log=True, group="Stars", rebuild=True, label="Places",
        help="share of the 136 000 places for stars; what finds none is dropped and counted",
    )  # fmt: skip
    wind = Param(
        2.0, -40.0, 40.0, unit="m/s", group="Air", help="to the right, at the ground; gusts come on top"
    )
    shear = Param(
        0.004, 0.0, 0.02, unit="1/m", group="Air", label="Wind shear",
        help="the wind grows by this share with each metre of height",
    )  # fmt: skip
    air = Param(
        1.0, 0.001, 100_000.0, log=True, group="Air", label="Air density", help="beside that at sea level"
    )
    gravity = Param(9.81, 0.0, 30.0, unit="m/s²", group="Air", help="downwards")
    bearing = Param(
        0.0, -120.0, 120.0, unit="°", group="Camera",
        help="from where the show is seen: the camera goes round it",
    )  # fmt: skip
    method = Choice(
        "split-drag",
        METHODS,
        labels=("Split drag", "Explicit Euler", "Semi-implicit Euler", "Midpoint", "Runge-Kutta 4"),
        group="Method",
        label="Integrator",
        help="how stars go on by a step",
    )
    step_length = Param(
        1.0 / 60.0, 1.0 / 2000.0, 0.1, unit="s", log=True, group="Method", label="Time step",
        help="of the fixed-step clock",
    )  # fmt: skip
    distance = Param(
        260.0, 0.0, 2000.0, unit="m", group="Sound", label="Listener's distance",
        help="of the listener from the shore; drag the listener to walk along the bank",
    )  # fmt: skip
