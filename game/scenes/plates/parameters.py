"""What can be chosen about plates that fall."""

from __future__ import annotations

import math

from game.physics.plates import METHODS
from game.stage import Choice, Param, Parameters, Toggle

OF_PLATE = (
    "half_chord", "inertia", "thickness", "glide", "turn", "drag", "drag_turn", "torque", "torque_2", "curl",
    "bend_hz", "balance",
)  # fmt: skip
OF_PICTURE = ("traces", "forces")


class PlatesParameters(Parameters):
    """The plate that a click drops, the air, the method, and what is shown."""

    inertia = Param(
        1.1, 0.001, 1000.0, log=True, group="Plate", label="Inertia I*",
        help="of the plate beside that of the air it takes along: density ratio times thickness ratio",
    )  # fmt: skip
    thickness = Param(1.0 / 14.0, 0.0, 1.0, group="Plate", label="Thickness β", help="beside its chord")
    half_chord = Param(0.03, 0.002, 0.2, unit="m", log=True, group="Plate", label="Half chord")
    tilt = Param(0.2, -3.2, 3.2, unit="rad", group="Plate", help="at which a click lets it go")
    curl = Param(0.0, -1.0, 1.0, unit="rad", group="Plate", help="by which its halves are turned up at rest")
    bend_hz = Param(0.0, 0.0, 60.0, unit="Hz", group="Plate", label="Bends at", help="0: rigid")
    balance = Param(
        0.0, -0.6, 0.6, group="Plate", help="how far ahead of the middle its mass lies, in half chords"
    )
    glide = Param(
        1.2, 0.0, 4.0, group="Coefficients", label="Lift C_T", help="C_L = C_T sin 2α; thin wings π"
    )
    turn = Param(math.pi, 0.0, 8.0, group="Coefficients", label="Lift of spin C_R")
    drag = Param(1.4, 0.0, 5.0, group="Coefficients", label="Drag A", help="C_D = A − B cos 2α")
    drag_turn = Param(1.0, 0.0, 5.0, group="Coefficients", label="Drag B", help="at most A")
    torque = Param(0.2, 0.0, 5.0, group="Coefficients", label="Torque μ1", help="against spin, as the spin")
    torque_2 = Param(0.2, 0.0, 5.0, group="Coefficients", label="Torque μ2", help="as its square")
    wind = Param(0.0, -20.0, 20.0, unit="m/s", group="Air", help="to the right; a jump of it is an impulse")
    gravity = Param(9.81, 0.0, 30.0, unit="m/s²", group="Air", help="downwards")
    method = Choice("rk4", METHODS, labels=("Explicit Euler", "Midpoint", "Runge-Kutta 4"), group="Method",
                    label="Integrator")  # fmt: skip
    step_length = Param(1.0 / 240.0, 1.0 / 2000.0, 1.0 / 20.0, unit="s", log=True, group="Method",
                        label="Time step")  # fmt: skip
    traces = Toggle(True, group="Shown", help="where plates were, as in a photograph of many flashes")
    forces = Toggle(False, group="Shown", help="velocity and acceleration of the chosen plate")
