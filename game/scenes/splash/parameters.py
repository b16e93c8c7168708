"""Level and controls of the splash."""

from __future__ import annotations

from typing import Annotated

import msgspec

from game.physics.liquid import LiquidSettings
from game.stage import Param, Parameters, Toggle, control_of
from game.worlds.entries.entry import LevelEntry, Point, View
from game.worlds.expectations import Expectations
from game.worlds.hands.hand import Tool, choose_tool

WIDE, HIGH = 2.7, 1.35  # m, of the pool's box
STEP = 1.0 / 120.0  # s
TOOLS = (
    Tool("drop", "Drop", "tool: drop", "click: a drop falls; drag: it is thrown", icon="pour"),
    Tool("stir", "Stir", "tool: stir", "drag the water along", icon="push"),
)


class DropEntry(LevelEntry, frozen=True, kw_only=True):
    """A drop in the air: its middle m, radius m, speed m/s."""

    at: Point
    radius: Annotated[float, msgspec.Meta(ge=0.01, le=0.3)] = 0.09
    speed: tuple[Annotated[float, msgspec.Meta(ge=-40.0, le=40.0)], ...] = (0.0, -3.0)


class SplashContent(LevelEntry, frozen=True, kw_only=True):
    """[content] of a level: drops that fall as it begins."""

    drops: Annotated[tuple[DropEntry, ...], msgspec.Meta(max_length=40)] = ()
    expected: Expectations = ()
    view: View = View(left=0.15, bottom=0.0, right=2.55, top=HIGH)


class SplashParameters(Parameters):
    """The drop, the pool, the method, and what is shown."""

    tool = choose_tool(TOOLS)
    size = Param(0.09, 0.02, 0.2, unit="m", log=True, group="Drop", label="Radius")
    speed = Param(3.2, 0.3, 8.0, unit="m/s", log=True, group="Drop", help="as it meets the water")
    angle = Param(0.0, -75.0, 75.0, unit="°", group="Drop", help="of its flight, from straight down")
    depth = Param(0.45, 0.03, 0.9, unit="m", group="Pool", help="a change makes the water still")
    gravity = control_of(LiquidSettings, "gravity", minimum=0.0, maximum=30.0, group="Pool")
    cells = Param(192, 48, 320, whole=True, log=True, group="Method", rebuild=True, help="along the pool")
    carrier = control_of(
        LiquidSettings, "carrier", labels=("PIC and FLIP", "APIC"), group="Method", label="Speeds by"
    )
    flip = control_of(LiquidSettings, "flip", group="Method", label="FLIP share")
    keeping = control_of(LiquidSettings, "keeping", group="Method", label="Volume correction")
    courant = control_of(LiquidSettings, "courant", group="Method", label="Courant number")
    law = Toggle(False, group="Shown", label="Limit", help="how deep a crater can be by energy alone")
