"""What can be chosen about smoke."""

from __future__ import annotations

from game.physics.multigrid import SOLVERS
from game.stage import Choice, Param, Parameters, Toggle

METHODS = ("time-centred", "maccormack", "cubic", "linear", "stam-1999", "stam-2003")
PRINTED = ("stam-1999", "stam-2003")
TOOLS = ("stir", "dye", "fire", "solid", "clear")
VIEWS = ("smoke", "temperature", "speed", "vorticity", "divergence", "schlieren", "pressure")
DYES = ("blue", "pink", "yellow")
INKS = ("smoke", *DYES)  # what the hand paints, and a source gives
OF_PICTURE = ("view", "arrows", "tool", "brush", "dye")


class SmokeParameters(Parameters):
    """The hand, the gas, the method, and what is shown."""

    tool = Choice("stir", TOOLS, labels=("Stir", "Dye", "Fire", "Solid", "Clear"), group="Hand",
                  help="what a drag does; Solid moves the nearest disc or puts a new one")  # fmt: skip
    dye = Choice("smoke", INKS, labels=("Smoke", "Blue", "Pink", "Yellow"), group="Hand",
                 help="what Dye and the right button paint; dyes mix where they meet")  # fmt: skip
    brush = Param(0.07, 0.02, 0.3, unit="m", log=True, group="Hand", help="radius of the hand")
    lift = Param(1.0, 0.0, 4.0, group="Gas", label="Buoyancy", help="times as strong as hot gas is lifted")
    viscosity = Param(0.0, 0.0, 0.1, unit="m²/s", group="Gas", help="of the gas; air has 1.5e-5")
    confinement = Param(0.0, 0.0, 1.0, group="Gas", help="of vorticity (Fedkiw, Stam and Jensen 2001)")
    method = Choice(
        "maccormack", METHODS,
        labels=("Time-centred", "MacCormack", "Cubic", "Linear", "Stam 1999, printed", "Stam 2003, printed"),
        group="Method", rebuild=True, help="how the gas is carried along",
    )  # fmt: skip
    pressure = Choice("multigrid", SOLVERS, group="Method", help="how the pressure is found")
    turns = Param(10, 1, 400, whole=True, log=True, group="Method",
                  help="V-cycles or sweeps at most; of Stam 2003 at least 20 sweeps")  # fmt: skip
    cells = Param(128, 16, 320, step=16, whole=True, group="Method", rebuild=True, help="across two metres")
    step_length = Param(1.0 / 60.0, 1.0 / 1000.0, 1.0 / 10.0, unit="s", log=True, group="Method",
                        label="Time step")  # fmt: skip
    flux = Toggle(False, group="Method", label="In flux form", help="smoke, heat and the rest: what leaves a "
                  "cell enters its neighbour, so that their sums are kept; slower")  # fmt: skip
    books = Toggle(False, group="Shown", label="Books", help="of momentum and heat, step by step, "
                   "beside the picture; they take a quarter of a step")  # fmt: skip
    view = Choice("smoke", VIEWS, group="Shown", label="Gas", help="what is shown of the gas")
    arrows = Toggle(False, group="Shown", label="Arrows", help="the velocity, here and there")
