"""A tank of liquid to pour, stir and drain, with solids that float in it."""

from __future__ import annotations

from game.lab.studies.water.liquid import liquid_study
from game.physics.liquid.effects import LIQUID as ROOM
from game.physics.solids.effects import CONTACTS, FRICTION
from game.scenes.liquid import LIQUID
from game.scenes.liquid.figure import draw_cells
from game.scenes.liquid.level import DEFAULT, LiquidContent
from game.scenes.liquid.parameters import OF_PICTURE, TOOLS, LiquidParameters
from game.scenes.liquid.told import hearing, liquid_hand, readouts
from game.scenes.liquid.view import LiquidView
from game.scenes.liquid.world import LiquidWorld
from game.stage import Equation, Hint, Strip
from game.worlds.hands.hand import tool_keys
from game.worlds.painting.liquid import warm_up_liquid
from game.worlds.scene import Parts, Told, WorldScene


class LiquidScene(WorldScene):
    """Water in a tank. Particles carry it, and a grid of cells makes them flow together.

    In each step the particles give their speeds to the faces of the cells. There gravity acts, and the
    pressure, which lets no more flow into a cell than out of it. Then the particles take the new speeds.

    The surface lies where it lies between cells, not at their faces: still water is still, and waves run at
    their true rate. Solids feel the pressure in the same solve: even the lightest ball floats quietly.

    Such water shrinks by and by, for particles crowd. A second solve moves them apart again.

    In the equations: u speed, p pressure, g gravity, x place, t time, and the density, written with rho.
    """

    name, task, title = LIQUID.names
    parameters_type = LiquidParameters
    parameters: LiquidParameters
    model: LiquidWorld
    parts = Parts(LiquidWorld, liquid_hand, LiquidView)
    told = Told(readouts, hearing=hearing)
    effects = ROOM.known | CONTACTS | FRICTION
    content_type, default_content = LiquidContent, DEFAULT
    not_of_model = OF_PICTURE
    may_be_infinite = frozenset(("solids.joints",))
    study = liquid_study
    figure = staticmethod(draw_cells)
    tools = TOOLS
    tool_prefix = "tool-"
    painters = (("water", warm_up_liquid),)
    dt = 1.0 / 60.0
    hints = (
        Hint(("Drag",), "use the tool in the hand"),
        Hint(("Right click",), "pour"),
    )
    actions = tool_keys(TOOLS, "tool-")
    strips = (
        Strip("Volume", "m²", ("volume", "poured in"), exact=("poured in",)),
        Strip("Energy", "J/m", ("energy", "kinetic energy")),
        Strip("Level", "m", ("level",)),
    )
    equations = (
        Equation(
            "Motion",
            r"\frac{\partial \v{u}}{\partial t} + \v{u} \cdot \nabla \v{u}"
            r" = - \frac{1}{\rho} \nabla p + \v{g}",
            "Euler 1757",
        ),
        Equation("No volume is lost", r"\nabla \cdot \v{u} = 0"),
        Equation("Particles and cells", r"\v{u}_p = \sum_i w_i \v{u}_i", "Harlow 1962"),
        Equation("A wave", r"\omega^2 = g k \text{tanh} (k h)", "Airy 1841"),
    )
    try_this = (
        "Put a ball of density 0.1 under water and let go.",
        "Turn the volume correction off, and stir: a part of the water is gone.",
        "Let the pressure be 0 in cells of air: the water is no longer quite still.",
        "Choose PIC and FLIP with no share of FLIP: waves die out soon.",
    )
