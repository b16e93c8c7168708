"""Controls of water in a channel, and the tools of the hand."""

from __future__ import annotations

from game.physics.waves import ShallowSettings
from game.stage import Param, Parameters, Toggle, control_of
from game.worlds.hands.hand import Tool, choose_tool

TOOLS = (
    Tool("pour", "Pour", "pour", "hold to pour water", "O", "pour"),
    Tool("push", "Push", "push", "drag water along", "U", "push"),
    Tool("bed", "Draw the bed", "draw the bed", "draw the bed", "B", "track"),
)
OF_PICTURE = ("exact", "arrows", "tool")


class WavesParameters(Parameters):
    """The channel, what comes into it, the method, and what is shown."""

    tool = choose_tool(TOOLS)
    length = Param(
        40.0, 1.0, 1000.0, unit="m", log=True, group="Channel", rebuild=True, help="from end to end"
    )
    gravity = control_of(ShallowSettings, "gravity", group="Channel")
    roughness = control_of(
        ShallowSettings, "roughness", maximum=0.1, group="Channel", label="Manning's number"
    )
    rain = Param(0.0, 0.0, 100_000.0, unit="mm/h", group="Channel",
                 help="a cloudburst has 50")  # fmt: skip
    swell = Param(0.0, 0.0, 2.0, unit="m", group="Waves", help="height of waves that come from the left")
    period = Param(4.0, 0.2, 60.0, unit="s", log=True, group="Waves", help="of the swell")
    poured = Param(1.0, 0.01, 100.0, unit="m²/s", log=True, group="Waves", label="Pours",
                   help="what the hand pours, for each metre of width")  # fmt: skip
    cells = Param(800, 20, 20_000, whole=True, log=True, group="Method", rebuild=True, help="of the channel")
    method = control_of(
        ShallowSettings,
        "method",
        labels=("Constant (Godunov)", "Linear (MUSCL-Hancock)"),
        group="Method",
        label="In a cell",
    )
    courant = control_of(ShallowSettings, "courant", group="Method", label="Courant number")
    exact = Toggle(True, group="Shown", help="the surface by theory, where there is one")
    arrows = Toggle(False, group="Shown", help="how fast the water flows")
