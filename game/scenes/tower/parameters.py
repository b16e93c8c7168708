"""What can be chosen about the tower."""

from __future__ import annotations

from game.stage import Param, Parameters, Toggle
from game.worlds.hands.hand import Tool, choose_tool
from game.worlds.members import solids

OF_PICTURE = ("marks", "dust")
TOOLS = (
    Tool("cut", "Cut a column", "tool: cut a column"), Tool("break", "Break a floor", "tool: break a floor"),
)  # fmt: skip


class TowerParameters(Parameters):
    """The charges, the strength of what breaks, and the solver."""

    tool = choose_tool(TOOLS)
    first = Param(
        0, 0, 40, whole=True, group="Charges", label="First storey",
        help="whose columns are cut first, counted from the ground; 0: as the level says",
    )  # fmt: skip
    delay = Param(0.04, 0.0, 2.0, unit="s", group="Charges", help="from column to column, the left one first")
    gives_way = Toggle(
        True, group="Charges", label="Give way", help="columns below give way where the floors strike"
    )
    blast = Param(3.0, 0.0, 20.0, unit="m/s", group="Charges", help="at which pieces of columns fly off")
    strength = Param(
        4.0, 0.1, 100.0, unit="m/s", log=True, group="Strength", help="a floor that is stopped faster breaks"
    )
    joints = Param(
        2.0, 0.01, 1000.0, log=True, group="Strength", label="Joints of floors",
        help="load at which they part, in weights of a floor's bay",
    )  # fmt: skip
    friction = Param(0.5, 0.0, 2.0, group="World", help="Coulomb's coefficient of everything")
    gravity = Param(9.81, 0.5, 30.0, unit="m/s²", group="World", help="downwards")
    tier = solids.choose_quality()
    substeps = solids.choose_substeps(128)
    solver = solids.choose_solver()
    step_length = solids.choose_step(1.0 / 60.0, 1.0 / 2000.0, 1.0 / 30.0)
    dust = Toggle(True, group="Shown", label="Dust")
    marks = Toggle(False, group="Shown", label="Front and law", help="in a story F7 shows them as well")
