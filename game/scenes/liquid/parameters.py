"""Controls of a tank of liquid, and the tools of the hand."""

from __future__ import annotations

from game.physics.liquid import LiquidSettings
from game.stage import Choice, Param, Parameters, Toggle, control_of
from game.worlds.hands.hand import Tool, choose_tool
from game.worlds.members.solids import choose_quality, choose_substeps

TOOLS = (
    Tool("pour", "Pour", "pour", "hold to pour water", icon="pour"),
    Tool("stir", "Stir", "stir", "drag the water along", icon="push"),
    Tool("drop", "Let a drop fall", "let a drop fall", "click: a drop falls from there", icon="dye"),
    Tool("grab", "Grab", "grab", "drag a solid", icon="grab", apart=True),
    Tool("box", "Put in a box", "put in a box", "click: a box", icon="box"),
    Tool("ball", "Put in a ball", "put in a ball", "click: a ball", icon="ball"),
    Tool(
        "scoop", "Scoop out", "scoop out", "hold to take out water, click a solid to take it", icon="delete"
    ),
    Tool("tap", "Put in a tap", "put in a tap", "drag: a tap that runs that way", icon="bend", apart=True),
    Tool("drain", "Put in a drain", "put in a drain", "click: a drain", icon="cut"),
)
LOOKS = ("water", "dots", "cells", "pressure")
OF_PICTURE = ("tool", "look", "arrows", "densities", "poured", "size", "weight")


class LiquidParameters(Parameters):
    """The liquid, its method, the hand, and what is shown."""

    tool = choose_tool(TOOLS)
    gravity = control_of(LiquidSettings, "gravity", minimum=-30.0, maximum=30.0, group="World")
    running = Toggle(True, group="World", label="Taps", help="whether they run")
    poured = Param(0.15, 0.005, 2.0, unit="m²/s", log=True, group="Hand", label="Pours",
                   help="for each metre of depth")  # fmt: skip
    size = Param(0.08, 0.02, 0.5, unit="m", log=True, group="Hand", label="Size",
                 help="half of a solid, radius of a drop")  # fmt: skip
    weight = Param(0.5, 0.0, 20.0, group="Hand", label="Density",
                   help="of solids put in, beside water's; 0: it stays where it is")  # fmt: skip
    cells = Param(96, 16, 320, whole=True, log=True, group="Method", rebuild=True, help="along the tank")
    spread = Param(2, 1, 4, whole=True, group="Method", rebuild=True, label="Particles along a cell")
    carrier = control_of(
        LiquidSettings, "carrier", labels=("PIC and FLIP", "APIC"), group="Method", label="Speeds by"
    )
    flip = control_of(LiquidSettings, "flip", group="Method", label="FLIP share")
    surface = control_of(
        LiquidSettings, "surface", labels=("At its place (ghost fluid)", "In cells of air"), group="Method",
        label="Pressure 0",
    )  # fmt: skip
    keeping = control_of(LiquidSettings, "keeping", group="Method", label="Volume correction")
    courant = control_of(LiquidSettings, "courant", group="Method", label="Courant number")
    tier = choose_quality()
    substeps = choose_substeps(32)
    look = Choice("water", LOOKS, labels=("Water", "Dots", "Cells", "Pressure"), group="Shown",
                  help="the liquid, its particles, wet cells, or the pressure")  # fmt: skip
    arrows = Toggle(False, group="Shown", help="how fast the water flows")
    densities = Toggle(False, group="Shown", help="at each solid, its density beside water's")
