"""A pond from above: stones, rain, floats and a boat, with waves carried by particles (P15)."""

from __future__ import annotations

from game.lab.studies.water.wave_particles import ring_study
from game.physics.waves.effects import POND as ROOM
from game.scenes.pond import POND
from game.scenes.pond.figure import draw_splitting
from game.scenes.pond.level import DEFAULT, PondContent
from game.scenes.pond.parameters import OF_PICTURE, TOOLS, PondParameters
from game.scenes.pond.told import pond_hand, readouts, saved
from game.scenes.pond.view import PondView
from game.scenes.pond.world import PondWorld
from game.stage import Equation, Hint, Strip
from game.worlds.hands.hand import tool_keys
from game.worlds.scene import Parts, Told, WorldScene


class Pond(WorldScene):
    """A front of waves is carried by particles, each a hump that goes straight on. Neighbours that come too
    far apart become three. So a ring stays round however far it goes, and still water costs nothing.

    Floats are lifted and pushed, and make waves of their own. A boat that is faster than its waves drags
    them in a wedge. Drop stones, lead the boat, put floats.

    What it leaves out: waves of one length have one speed, so a boat's wake is not Kelvin's. Floats and boat
    send waves but throw no shadow, and nothing breaks.

    In the equations: a height, r radius, d distance from where the front began, c speed, h depth.
    """

    name, task, title = POND.names
    dt = 1.0 / 60.0
    parameters_type = PondParameters
    parameters: PondParameters
    model: PondWorld
    parts = Parts(PondWorld, pond_hand, PondView)
    told = Told(readouts, saved)
    effects = ROOM.known
    content_type, default_content = PondContent, DEFAULT
    not_of_model = OF_PICTURE
    study = ring_study
    figure = staticmethod(draw_splitting)
    tools = TOOLS
    tool_prefix = "tool-"
    hints = (
        Hint(("Drag",), "drop stones, lead the boat, put floats"),
        Hint(("Right click",), "drop a stone"),
    )
    actions = tool_keys(TOOLS, "tool-")
    strips = (
        Strip("Particles", "", ("particles",)),
        Strip("Surface", "m", ("highest", "lowest")),
        Strip("Wave energy", "J", ("wave energy",)),
    )
    equations = (
        Equation("A particle", r"\frac{a}{2} (\cos \frac{\pi u}{r} + 1)", "Yuksel, House, Keyser 2007"),
        Equation("Speed", r"c^2 = \frac{g}{k} \text{tanh} k h, \quad k = \frac{\pi}{r}", "Airy 1845"),
        Equation("A ring that keeps its energy", r"a \propto \frac{1}{\sqrt{d}}"),
        Equation("Wedge of a fast boat", r"\sin \alpha = \frac{c}{U}", "Mach 1887"),
    )
    try_this = (
        "Lead the boat slower than its waves, then faster: the wedge.",
        "Switch splitting off and drop a stone: the ring falls into dots.",
        "Let a front keep its height, as printed: rings die away sooner than on water.",
        "Push a heavy float and watch its neighbours.",
    )
