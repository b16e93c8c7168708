"""Controls of splashes between splashes, and the tools of the hand."""

from __future__ import annotations

from game.stage import Param, Parameters, Toggle
from game.worlds.hands.hand import Tool, choose_tool

TOOLS = (
    Tool("hint", "Link two points", "link two points", "drag from the first tank to another",
         icon="bend"),
    Tool("forget", "Forget links", "forget links", "click: all links go", icon="delete"),
)  # fmt: skip
OF_PICTURE = ("tool", "across", "up", "later", "matches")


class BlendParameters(Parameters):
    """The weights, the alignment, and what is shown."""

    tool = choose_tool(TOOLS)
    across = Param(0.5, 0.0, 1.0, group="Between the runs", label="Across",
                   help="0: the runs on the left, 1: those on the right")  # fmt: skip
    up = Param(0.5, 0.0, 1.0, group="Between the runs", label="Up",
               help="of four runs: 0 the lower row, 1 the upper one")  # fmt: skip
    nodes = Param(16, 4, 32, whole=True, group="Alignment", rebuild=True, label="Nodes",
                  help="of the deformation, along its longest side")  # fmt: skip
    later = Param(0.0, -0.5, 0.5, unit="s", group="Alignment", label="Linked later",
                  help="the linked point's time, after that of the first")  # fmt: skip
    matches = Toggle(True, group="Shown", label="Matched points", help="of the surfaces of two runs")
