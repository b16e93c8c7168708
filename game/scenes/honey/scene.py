"""Liquids of particles: drops, honey, slime, a lava lamp, two liquids, boiling, trapped air."""

from __future__ import annotations

from game.lab.studies.particle_fluids import fluid_study
from game.physics.particle_fluids.effects import PARTICLE_FLUIDS as ROOM
from game.scenes.honey import HONEY
from game.scenes.honey.figure import draw_kernel
from game.scenes.honey.level import DEFAULT, HoneyContent
from game.scenes.honey.parameters import OF_PICTURE, TOOLS, HoneyParameters
from game.scenes.honey.told import honey_hand, readouts
from game.scenes.honey.view import HoneyView
from game.scenes.honey.world import HoneyWorld
from game.stage import Equation, Hint, Strip
from game.worlds.hands.hand import tool_keys
from game.worlds.painting.liquid import warm_up_backdrop
from game.worlds.painting.particle_liquid import warm_up_particle_liquid
from game.worlds.scene import Parts, Told, WorldScene


class Honey(WorldScene):
    """Liquid made of particles that carry it along. Each feels those around it: a dozen, nearer than twice
    the spacing. What they add up to is the density, and pressure keeps that from growing.

    Four laws for the pressure can be chosen. Müller's of 2003 squeezes and pushes back. Clavet's of 2005
    moves particles apart, and adds springs for slime. Position based fluids solve for densities as for links.
    DFSPH solves for a flow that squeezes nothing, and is the careful one. Its steps become shorter where a
    light liquid lies deep, or under a heavy one.

    Beyond a wall there are no particles, and a density would lack them. The share of the kernel that lies
    there is added, for a vessel of any shape.
    What it leaves out: the air above. Air is made only where falling liquid encloses it.

    In the equations: V area of a particle, W kernel, h its reach, p pressure, v velocity, n direction of a
    pair, r its distance, k springs, L their length.
    """

    name, task, title = HONEY.names
    parameters_type = HoneyParameters
    parameters: HoneyParameters
    model: HoneyWorld
    parts = Parts(HoneyWorld, honey_hand, HoneyView)
    told = Told(readouts)
    effects = ROOM.known
    content_type, default_content = HoneyContent, DEFAULT
    not_of_model = OF_PICTURE
    dt = 1.0 / 120.0
    study = fluid_study
    figure = staticmethod(draw_kernel)
    tools = TOOLS
    tool_prefix = "tool-"
    painters = (("backdrop", warm_up_backdrop), ("liquid", warm_up_particle_liquid))
    hints = (
        Hint(("Drag",), "pour, stir or scoop"),
        Hint(("Right click",), "pour"),
    )
    actions = tool_keys(TOOLS, "tool-")
    strips = (
        Strip("Density", "", ("mean error", "densest")),
        Strip("Energy", "J/m", ("motion", "height energy")),
        Strip("Mean height", "m", ("mean height", "first's height"),
              sometimes=("mean height", "first's height")),
    )  # fmt: skip
    equations = (
        Equation(
            "Density beside rest", r"\alpha_i = \text{sum of } V_j W(r_{ij})", "Solenthaler, Pajarola 2008"
        ),
        Equation(
            "Pressure",
            r"\v{F}_{ij} = - V_i V_j (p_i + p_j) \nabla W",
            "what follows from a density as a constraint",
        ),
        Equation(
            "Viscosity", r"\v{F}_{ij} = - 8 \mu V_i V_j \frac{\abs{W'}}{r} (\v{v}_{ij} \cdot \v{n}) \v{n}",
            "Weiler and others 2018, in the plane",
        ),
        Equation(
            "A spring of slime",
            r"\Delta r = \Delta t^2 k (1 - \frac{L}{h}) (L - r)",
            "Clavet, Beaudoin, Poulin 2005",
        ),
    )  # fmt: skip
    try_this = (
        "Let walls feel nothing: the rows beside them pack closer.",
        "Choose Müller's law: the liquid is springy, and lies lower at rest.",
        "Make the viscosity 100 times as large while the liquid moves.",
        "Show densities as colours, and lessen the iterations to 3.",
    )
