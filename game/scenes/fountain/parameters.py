"""The parameters of the fountain: its nozzle, its method, its world and its air."""

from __future__ import annotations

from game.physics.particles import CONTACTS, METHODS
from game.stage import Choice, Param, Parameters, Toggle


class FountainParameters(Parameters):
    """What of the fountain can be chosen."""

    rate = Param(
        8_000.0, 0.0, 100_000.0, unit="1/s", step=100.0, group="Emitter", label="Emit rate",
        help="particles a second from all nozzles, evenly in time, also within a step",
    )  # fmt: skip
    speed = Param(9.0, 0.0, 25.0, unit="m/s", group="Emitter", help="with which each particle starts")
    spread = Param(
        16.0, 0.0, 180.0, unit="°", group="Emitter", help="directions are random within ± this of the axis"
    )
    life = Param(2.4, 0.01, 30.0, unit="s", log=True, group="Emitter", help="how long each particle lives")
    method = Choice(
        "verlet",
        METHODS,
        labels=(
            "Explicit Euler", "Semi-implicit Euler", "Midpoint", "Verlet", "Störmer-Verlet", "Runge-Kutta 4",
            "Exponential",
        ),
        group="Method",
        label="Integrator",
        help="how position and velocity go on by a step",
    )  # fmt: skip
    split = Toggle(
        False, group="Method", label="Three methods", rebuild=True,
        help="explicit Euler, midpoint and Verlet side by side, from the same births",
    )  # fmt: skip
    contact = Choice(
        "chord",
        CONTACTS,
        labels=("Step end", "Chord", "Root"),
        group="Method",
        label="Impact",
        help="found at the end of the step, where its chord crosses, or by solving for the instant",
    )
    step_length = Param(
        1.0 / 240.0, 1.0 / 2000.0, 0.5, unit="s", log=True, group="Method", label="Time step",
        help="of the fixed-step clock",
    )  # fmt: skip
    smooth = Toggle(
        True, group="Method", label="Substeps for stiff drag", help="as many as drag needs to be stable"
    )
    restitution = Param(0.5, 0.0, 1.0, group="World", help="part of the normal speed that a stone gives back")
    ground_restitution = Param(
        0.2, 0.0, 1.0, group="World", label="Ground restitution", help="the same of the ground"
    )
    gravity = Param(9.81, 0.0, 30.0, unit="m/s²", group="World", help="downwards")
    drag = Param(
        0.4, 0.001, 500.0, unit="1/s", log=True, group="Air", label="Air drag", help="k in a = −k (v − w)"
    )
    wind = Param(2.5, -30.0, 30.0, unit="m/s", group="Air", help="w, to the right; felt through drag")
    fast_drag = Param(
        0.05, 0.001, 10.0, unit="1/m", log=True, group="Air", label="Quadratic drag",
        help="q in a = −q |v − w| (v − w)",
    )  # fmt: skip
    whirl = Param(
        5.0, -50.0, 50.0, unit="m²/s", group="Air", label="Vortex",
        help="circulation over 2π, counter-clockwise; drag its centre",
    )  # fmt: skip
    places = Param(
        40_000, 1, 1_000_000, whole=True, log=True, group="Pool", rebuild=True,
        help="particles that can live at a time; further births are dropped and counted",
    )  # fmt: skip
