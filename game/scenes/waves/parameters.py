"""Controls of water in a channel, and the tools of the hand."""

from __future__ import annotations

from game.physics.waves import METHODS
from game.stage import Choice, Param, Parameters, Toggle
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
    gravity = Param(9.81, 0.0, 30.0, unit="m/s²", group="Channel", help="downwards")
    roughness = Param(0.0, 0.0, 0.1, unit="m^(-1/3) s", group="Channel", label="Manning's number",
                      help="of the bed: 0.01 glass, 0.03 a river")  # fmt: skip
    rain = Param(0.0, 0.0, 100_000.0, unit="mm/h", group="Channel",
                 help="a cloudburst has 50")  # fmt: skip
    swell = Param(0.0, 0.0, 2.0, unit="m", group="Waves", help="height of waves that come from the left")
    period = Param(4.0, 0.2, 60.0, unit="s", log=True, group="Waves", help="of the swell")
    poured = Param(1.0, 0.01, 100.0, unit="m²/s", log=True, group="Waves", label="Pours",
                   help="what the hand pours, for each metre of width")  # fmt: skip
    cells = Param(800, 20, 20_000, whole=True, log=True, group="Method", rebuild=True, help="of the channel")
    method = Choice("linear", METHODS, labels=("Constant (Godunov)", "Linear (MUSCL-Hancock)"),
                    group="Method", label="In a cell")  # fmt: skip
    courant = Param(0.5, 0.05, 1.0, group="Method", label="Courant number",
                    help="cells that the fastest wave crosses in a step")  # fmt: skip
    exact = Toggle(True, group="Shown", help="the exact surface, where it is known")
    arrows = Toggle(False, group="Shown", help="how fast the water flows")
