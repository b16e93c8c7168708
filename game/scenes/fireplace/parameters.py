"""What can be chosen about the fireplace."""

from __future__ import annotations

from game.stage import Choice, Param, Parameters, Toggle
from game.worlds.hands.hand import Tool, choose_tool
from game.worlds.members.solids import choose_step
from game.worlds.quality import Quality

TOOLS = (
    Tool("blow", "Blow"), Tool("drag", "Drag"), Tool("log", "Add a log"), Tool("match", "Match"),
    Tool("water", "Water"),
)  # fmt: skip
OF_PICTURE = ("marks", "view")
VIEWS = ("fire", "temperature", "speed", "oxygen")
QUALITY = Quality(64, 96, 128, "cells across")


class FireplaceParameters(Parameters):
    """Tools, wood, air, how finely it is computed, and what is shown."""

    tool = choose_tool(TOOLS)
    damper = Param(1.0, 0.0, 1.0, group="Air", label="Flue open", help="share of the flue that is open")
    wind = Param(
        0.0, -3.0, 3.0, unit="m/s", group="Air", label="Draught", help="through the room, to the right"
    )
    haste = Param(
        1.0, 0.25, 4.0, log=True, group="Wood", label="Burning rate",
        help="times as quick as usual; the wood is light, so that an hour of real wood passes in a minute",
    )  # fmt: skip
    moisture = Param(
        0.0, 0.0, 1.0, group="Wood", rebuild=True,
        help="kg of water in a kg of logs, beside what a level says",
    )  # fmt: skip
    tier = QUALITY.choose("teach", "Gas")
    cells = Param(96, 16, 256, step=16, whole=True, group="Gas", rebuild=True, help="across, with Own")
    cycles = Param(
        6, 3, 20, whole=True, group="Gas", label="V-cycles",
        help="of the pressure in a step, at most; with walls fewer let its errors grow",
    )  # fmt: skip
    step_length = choose_step(1.0 / 60.0, 1.0 / 1000.0, 1.0 / 30.0, "Gas")
    view = Choice("fire", VIEWS, group="Shown", label="Gas", help="the fire, or what is measured of the gas")
    marks = Toggle(False, group="Shown", label="Temperatures", help="of each piece of wood")

    def cells_now(self) -> int:
        """By the quality that is chosen."""
        return QUALITY.parts(self.tier, self.cells)
