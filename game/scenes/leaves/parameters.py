"""What can be chosen about leaves in a wind."""

from __future__ import annotations

from game.physics.plates import METHODS
from game.scenes.leaves.species import SPECIES
from game.stage import Choice, Param, Parameters, Toggle

OF_LEAVES = ("weight", "curl", "stiffness", "balance")
OF_PICTURE = ("streaks", "leaf")


class LeavesParameters(Parameters):
    """The wind, the shape of the leaves, the method, and what is shown."""

    wind = Param(0.15, -8.0, 8.0, unit="m/s", group="Wind", help="to the right, far above; the lawn slows it")
    gusts = Param(1.0, 0.0, 3.0, group="Wind", help="strength of gusts that are drawn from now on")
    size = Param(0.7, 0.15, 2.0, unit="m", group="Wind", label="Gust size", help="of those that are drawn")
    leaf = Choice("maple", tuple(SPECIES), group="Leaves", help="that the right button drops")
    weight = Param(1.0, 0.3, 4.0, log=True, group="Leaves", help="of all leaves beside what they are")
    curl = Param(0.0, -0.8, 0.8, unit="rad", group="Leaves", help="more of it for all leaves")
    stiffness = Param(1.0, 0.1, 10.0, log=True, group="Leaves", help="of all leaves beside what they are")
    balance = Param(0.0, -0.4, 0.4, group="Leaves", help="moves the mass of all leaves off their middle")
    gravity = Param(9.81, 0.0, 30.0, unit="m/s²", group="Air", help="downwards")
    friction = Param(0.45, 0.0, 2.0, group="Air", help="of leaves with the ground and with one another")
    method = Choice("rk4", METHODS, labels=("Explicit Euler", "Midpoint", "Runge-Kutta 4"), group="Method",
                    label="Integrator")  # fmt: skip
    step_length = Param(1.0 / 120.0, 1.0 / 1000.0, 1.0 / 30.0, unit="s", log=True, group="Method",
                        label="Time step")  # fmt: skip
    streaks = Toggle(True, group="Shown", label="Wind", help="dust that is seen in the wind")
