"""What can be chosen in the world of dominoes."""

from __future__ import annotations

from game.stage import Param, Parameters, Toggle
from game.worlds.hands.hand import Tool, choose_tool
from game.worlds.members import solids

TOOLS = (
    Tool("push", "Push", "tool: push"), Tool("drag", "Drag", "tool: drag"), Tool("add", "Add", "tool: add"),
    Tool("remove", "Remove", "tool: remove"),
)  # fmt: skip
OF_PICTURE = ("marks",)


class DominoParameters(Parameters):
    """The dominoes, the solver, and what the hand does."""

    tool = choose_tool(TOOLS)
    spacing = Param(
        0.3, 0.02, 0.95, unit="m", step=0.01, rebuild=True, group="Dominoes",
        help="gap between two; they are 1 m high",
    )  # fmt: skip
    friction = Param(0.2, 0.0, 1.5, group="Dominoes", help="Coulomb's coefficient between two dominoes")
    floor_friction = Param(
        1.0, 0.0, 5.0, group="Dominoes", label="On the floor",
        help="Coulomb's coefficient of dominoes and balls with a floor",
    )  # fmt: skip
    restitution = Param(0.5, 0.0, 1.0, group="Dominoes", help="of balls: part of the speed that comes back")
    gravity = Param(9.81, 0.0, 30.0, unit="m/s²", group="Dominoes", help="downwards")
    tier = solids.choose_quality()
    substeps = solids.choose_substeps(128)
    iterations = solids.choose_iterations(50)
    solver = solids.choose_solver()
    step_length = solids.choose_step(1.0 / 60.0, 1.0 / 2000.0, 1.0 / 30.0)
    marks = Toggle(False, group="Shown", label="Contacts and speeds", help="in a story F7 shows them as well")
