"""Level and controls of the trebuchet."""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.stage import Param, Parameters
from game.worlds.entries.entry import LevelEntry, Metre, View
from game.worlds.expectations import Expectations
from game.worlds.hands.hand import Tool, choose_tool
from game.worlds.members import solids

TOOLS = (
    Tool("drag", "Drag", "tool: drag", "drag a block"),
    Tool("push", "Push", "tool: push", "push a block"),
)


class TrebuchetContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level. wall: m, its near face; columns: blocks side by side in each course."""

    wall: Metre = 100.0
    columns: Annotated[int, msgspec.Meta(ge=1, le=6)] = 2
    expected: Expectations = ()
    view: View = View(left=-14.0, bottom=-5.0, right=142.0, top=58.0)


class TrebuchetParameters(Parameters):
    """The machine, the wall, the solver, and what the hand does."""

    tool = choose_tool(TOOLS)
    counterweight = Param(12000.0, 500.0, 30000.0, unit="kg", log=True, group="Machine")
    stone = Param(300.0, 10.0, 1000.0, unit="kg", log=True, group="Machine", help="a ball of stone")
    sling = Param(4.5, 0.4, 6.5, unit="m", group="Machine", help="its length; 0.4 m is hardly one")
    release = Param(45.0, -20.0, 85.0, unit="°", group="Machine", label="Lets go at",
                    help="angle of flight at which the hook lets the sling go")  # fmt: skip
    rows = Param(14, 1, 30, whole=True, rebuild=True, group="Wall", label="Courses", help="0.55 m high each")
    friction = Param(0.6, 0.0, 1.5, rebuild=True, group="Wall", help="Coulomb's coefficient of its blocks")
    gravity = Param(9.81, 0.5, 30.0, unit="m/s²", group="World", help="downwards; the Moon has 1.62")
    tier = solids.choose_quality()
    substeps = solids.choose_substeps(64)
    solver = solids.choose_solver()
    step_length = solids.choose_step(1.0 / 240.0, 1.0 / 2000.0, 1.0 / 20.0)
