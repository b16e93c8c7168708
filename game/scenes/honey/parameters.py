"""Controls of liquids of particles, and the tools of the hand."""

from __future__ import annotations

from game.physics.particle_fluids import FluidSettings
from game.stage import Choice, Param, Parameters, Toggle, control_of
from game.worlds.hands.hand import Tool, choose_tool

TOOLS = (
    Tool("pour", "Pour", "pour", "hold to pour", "O", "pour"),
    Tool("stir", "Stir", "stir", "drag through the liquid", "U", "push"),
    Tool("scoop", "Scoop", "scoop out", "drag to take liquid away", "X", "delete"),
)
OF_PICTURE = ("dots", "colours", "tool")
COLOURS = ("kind", "temperature", "density", "speed", "order")


class HoneyParameters(Parameters):
    """The liquids, the law and its walls, and what is shown."""

    tool = choose_tool(TOOLS)
    poured = Param(
        0, 0, 7, whole=True, group="Tools", label="Pours kind", help="as the level counts them, from 0"
    )
    gravity = control_of(FluidSettings, "gravity", group="Liquid")
    thickness = Param(1.0, 0.01, 1000.0, log=True, group="Liquid", label="Viscosity",
                      help="times as much as the level says")  # fmt: skip
    hold = Param(
        1.0, 0.0, 20.0, group="Liquid", label="Surface tension", help="times as much as the level says"
    )
    diffusivity = control_of(FluidSettings, "diffusivity", group="Liquid", label="Heat spreads")
    sticking = control_of(FluidSettings, "sticking", group="Liquid", label="Walls hold on")
    law = control_of(
        FluidSettings, "law",
        labels=("Müller 2003 (P09)", "Clavet 2005 (P11)", "Position based", "DFSPH"),
        group="Method", label="Pressure by",
    )  # fmt: skip
    iterations = control_of(FluidSettings, "iterations", group="Method", maximum=100)
    walls = control_of(
        FluidSettings, "walls",
        labels=("Nothing", "Table of a plane (P12)", "Exact share", "Wall particles"),
        group="Method", label="Walls are felt by",
    )  # fmt: skip
    kernel = control_of(FluidSettings, "kernel", labels=("Cubic spline", "Wendland C2"), group="Method")
    search = control_of(
        FluidSettings, "search",
        labels=("Counting sort", "Z-order (P13)", "Hash table (P04)"), group="Method", label="Neighbours by",
    )  # fmt: skip
    softness = control_of(FluidSettings, "softness", group="Method", label="Speed of sound")
    stiffness = control_of(FluidSettings, "stiffness", group="Springs")
    borne = control_of(FluidSettings, "borne", group="Springs", label="Borne stretch")
    flow = control_of(FluidSettings, "flow", group="Springs")
    colours = Choice(
        "kind", COLOURS, labels=("Kind", "Temperature", "Density", "Speed", "Order in memory"), group="Shown"
    )
    dots = Toggle(False, group="Shown", help="particles, not a body of liquid")
