"""Level and controls of the valley."""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.physics.liquid import LiquidSettings
from game.stage import Choice, Param, Parameters, Toggle, control_of
from game.worlds.entries.entry import LevelEntry, View
from game.worlds.expectations import Expectations
from game.worlds.hands.hand import Tool, choose_tool
from game.worlds.members import solids

TOOLS = (
    Tool("pour", "Pour", "pour", "hold to pour water", icon="pour"),
    Tool("drag", "Drag", "drag", "drag a piece", icon="grab"),
)


class ValleyContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level. block: m, how large a piece of the dam is; logs: of timber in the yard below."""

    block: Annotated[float, msgspec.Meta(ge=0.8, le=4.0)] = 1.0
    logs: Annotated[int, msgspec.Meta(ge=0, le=8)] = 6
    expected: Expectations = ()
    view: View = View(left=-46.0, bottom=-4.0, right=80.0, top=40.0)


class ValleyParameters(Parameters):
    """The water, the rocket, the method, the solver, and what is shown."""

    tool = choose_tool(TOOLS)
    level = Param(10.0, 1.0, 11.8, unit="m", group="Water", rebuild=True, label="Water level",
                  help="above the foot of the dam, which is 12 m high")  # fmt: skip
    poured = Param(10.0, 1.0, 60.0, unit="m²/s", log=True, group="Water", label="Pours",
                   help="for each metre of the valley's width")  # fmt: skip
    aim = Param(4.5, 0.5, 11.5, unit="m", group="Rocket", label="Aims at", help="height on the dam")
    charge = Param(200.0, 5.0, 1000.0, unit="kg", log=True, group="Rocket", help="of TNT, that it carries")
    dam = Choice("breaks", ("breaks", "vanishes"), group="Rocket", label="The dam", rebuild=True,
                 help="what the explosion does to it: Ritter's dam is gone at once")  # fmt: skip
    gravity = control_of(LiquidSettings, "gravity", minimum=1.0, maximum=30.0, group="World")
    cells = Param(256, 120, 640, whole=True, log=True, group="Method", rebuild=True, help="along the valley")
    carrier = control_of(
        LiquidSettings, "carrier", labels=("PIC and FLIP", "APIC"), group="Method", label="Speeds by"
    )
    tier = solids.choose_quality()
    substeps = solids.choose_substeps(32)
    fronts = Toggle(True, group="Shown", help="where the water's front is by theory, model and experiment")
