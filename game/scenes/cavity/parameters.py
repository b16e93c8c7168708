"""What can be chosen about a cavity."""

from __future__ import annotations

from game.physics.gas import ADVECTIONS
from game.physics.multigrid import SOLVERS
from game.stage import Choice, Param, Parameters, Toggle

VIEWS = ("speed", "vorticity", "pressure", "temperature")
OF_PICTURE = ("view", "profiles", "tracers")
OF_MAKING = ("flow", "cells", "number", "rayleigh")


class CavityParameters(Parameters):
    """The flow, the grid, the method, and what is shown."""

    flow = Choice(
        "lid", ("lid", "heated"), labels=("Moving lid", "Hot and cold wall"), group="Flow", rebuild=True
    )
    number = Param(1000.0, 1.0, 10_000.0, log=True, group="Flow", rebuild=True, label="Reynolds number",
                   help="of the lid; Ghia's tables are for 100, 400, 1000")  # fmt: skip
    rayleigh = Param(10_000.0, 100.0, 1e6, log=True, group="Flow", rebuild=True, label="Rayleigh number",
                     help="of the heated cavity; air of Prandtl number 0.71")  # fmt: skip
    lid = Param(1.0, -2.0, 2.0, unit="m/s", group="Flow", label="Speed of the lid")
    cells = Param(64, 8, 256, whole=True, log=True, group="Method", rebuild=True, help="along a side")
    advection = Choice("time-centred", ADVECTIONS, group="Method", help="how the gas is carried along")
    centring = Param(
        0.52, 0.5, 1.0, group="Method", help="q, the part of the pressure from the end of a step"
    )
    pressure = Choice("multigrid", SOLVERS, group="Method", help="how the pressure is found")
    turns = Param(
        2, 1, 200, whole=True, log=True, group="Method", help="of the pressure solver in a step, at most"
    )
    courant = Param(1.0, 0.1, 20.0, log=True, group="Method", label="Courant number",
                    help="cells that the lid moves in a step of the gas")  # fmt: skip
    view = Choice("speed", VIEWS, group="Shown", label="Field")
    profiles = Toggle(True, group="Shown", help="speeds on both centre lines, beside published ones")
    tracers = Toggle(True, group="Shown", help="specks that drift along")
