"""A playground of floating bodies: draw one, and see how it swims."""

from __future__ import annotations

from game.lab.studies.water.floating import floating_study
from game.physics.liquid.effects import LIQUID as ROOM
from game.physics.solids.effects import CONTACTS, FRICTION, JOINTS
from game.scenes.floating import FLOATING
from game.scenes.floating.figure import draw_heel
from game.scenes.floating.hand import floating_hand
from game.scenes.floating.level import FloatingContent
from game.scenes.floating.parameters import OF_PICTURE, TOOLS, FloatingParameters
from game.scenes.floating.told import hearing, readouts, saved
from game.scenes.floating.view import FloatingView
from game.scenes.floating.world import FloatingWorld
from game.stage import Equation, Hint, SceneAction, Strip
from game.worlds.hands.hand import tool_keys
from game.worlds.painting.liquid import warm_up_liquid
from game.worlds.scene import Parts, Told, WorldScene


class Floating(WorldScene):
    """A body that floats, twice: on the left by hydrostatics, on the right in a liquid that flows.

    A body sinks until it displaces its own mass. Its weight acts at G, the centre of mass; the lift at B, the
    centre of what is displaced. As it heels, B moves to the lower side, and the two turn it back or over.

    For small angles the lift always passes through M, the metacentre. The body is stable if M is above G.
    The curve below shows by how much: the righting arm between weight and lift, for all angles. A body
    rests where it is 0: stable where it rises, unstable where it falls. Click in it to set the body down.

    Hydrostatics takes a flat surface, and for the water that moves along half an ellipse of added mass. The
    liquid needs no such choice: the body's speed is an unknown of its pressure. It costs far more.

    In the equations: m mass, I inertia, A area under water, b width of the waterline, s density beside
    water's.
    """

    name, task, title = FLOATING.names
    parameters_type = FloatingParameters
    parameters: FloatingParameters
    model: FloatingWorld
    parts = Parts(FloatingWorld, floating_hand, FloatingView)
    told = Told(readouts, saved, hearing=hearing)
    effects = ROOM.known | CONTACTS | FRICTION | JOINTS
    content_type, default_content = FloatingContent, FloatingContent()
    not_of_model = OF_PICTURE
    may_be_infinite = frozenset(("solids.joints",))
    study = floating_study
    figure = staticmethod(draw_heel)
    tools = TOOLS
    tool_prefix = "tool-"
    builds = True
    painters = (("water", warm_up_liquid),)
    dt = 1.0 / 60.0
    hints = (
        Hint(("Drag",), "move the body, in either tank"),
        Hint(("Click the curve",), "set it down at that angle"),
    )
    actions = (
        *tool_keys(TOOLS, "tool-"),
        SceneAction("upright", "set it down upright", "U"),
        SceneAction("capsize", "set it down upside down", "O"),
    )
    strips = (
        Strip(
            "Angle", "°", ("angle", "angle, liquid", "stable angle"), exact=("stable angle",),
            sometimes=("angle, liquid", "stable angle"), colors=("amber", "chalk", "text1"),
        ),
        Strip("Draft", "m", ("draft", "draft, liquid"), sometimes=("draft, liquid",),
              colors=("amber", "chalk")),
        Strip(
            "Displaced", "m²", ("displaced", "displaced, liquid", "at rest"),
            exact=("at rest",), sometimes=("displaced, liquid",),
            colors=("amber", "chalk", "text1"),
        ),
    )  # fmt: skip
    equations = (
        Equation("Archimedes", r"m = \rho A"),
        Equation("Metacentre", r"BM = \frac{b^3}{12 A}", "Bouguer 1746"),
        Equation("Roll", r"T = 2 \pi \sqrt{\frac{I}{m g GM}}"),
        Equation("A square log tilts", r"\text{tan}^2 \theta = 12 s (1 - s) - 2", "Huygens 1650"),
    )
    try_this = (
        "Take the square log, and go slowly through all densities: it tilts between 0.21 and 0.79.",
        "Put ballast into the hull's keel, and set it down upside down.",
        "Draw a body of your own, and guess from its curve how it will float.",
        "Let the added mass be none: the roll is now quicker than in the liquid.",
        "Hang the plank on its hinge, and change how deep that is.",
    )

    def do(self, name: str) -> str:
        """Upright, or upside down."""
        self.model.set_down(0.0 if name == "upright" else 3.14)
        return ""
