"""What can be chosen about the marble run."""

from __future__ import annotations

from game.stage import Param, Parameters, Toggle
from game.worlds.hands.hand import Tool, choose_tool
from game.worlds.members import solids

TOOLS = (
    Tool("hand", "Move a ball", "move a ball", "drag a ball"),
    Tool("bend", "Bend a track", "bend a track", "drag a track"),
    Tool("draw", "Draw a track", "draw a track", "draw a track"),
    Tool("ball", "New ball", "new ball", "click, drag, let go"),
    Tool("size", "Size of a ball", "size of a ball", "drag from a ball's middle outwards"),
    Tool("delete", "Delete", "delete", "click a ball or a track"),
)
OF_PICTURE = ("marks",)
OF_TOOLS = ("tool", "radius", "bending")


class MetalParameters(Parameters):
    """Tools, balls, steps, and what is shown."""

    tool = choose_tool(TOOLS)
    radius = Param(0.12, 0.03, 0.5, unit="m", log=True, group="Tools", help="of a new ball")
    bending = Param(
        0.6, 0.05, 5.0, unit="m", log=True, group="Tools", help="how far along a track a bend reaches"
    )
    friction = Param(0.3, 0.0, 2.0, group="Balls", help="Coulomb's coefficient of steel on all it meets")
    restitution = Param(
        0.3, 0.0, 1.0, group="Balls", help="part of the speed of an impact that comes back, off the tracks"
    )
    gravity = Param(9.81, 0.0, 30.0, unit="m/s²", group="Balls", help="downwards")
    tier = solids.choose_quality()
    substeps = solids.choose_substeps(128)
    solver = solids.choose_solver()
    step_length = solids.choose_step(1.0 / 120.0, 1.0 / 2000.0, 1.0 / 60.0)
    marks = Toggle(False, group="Shown", label="Contacts and speeds", help="in a story F7 shows them as well")
