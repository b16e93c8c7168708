"""The world of dominoes: a story, and a place to play in."""

from __future__ import annotations

from typing import ClassVar

from game.lab.studies.dominoes import domino_study
from game.physics.fields import GRAVITY
from game.physics.solids.effects import CONTACTS, CONTINUOUS, FRICTION, JOINTS, RESTITUTION, SLEEP
from game.scenes.domino import A01
from game.scenes.domino.figure import draw_leaning
from game.scenes.domino.hand import domino_hand
from game.scenes.domino.level import DominoContent, FloorEntry, PieceEntry, RowEntry, View
from game.scenes.domino.parameters import OF_PICTURE, TOOLS, DominoParameters
from game.scenes.domino.told import hearing, names, readouts, saved, targets
from game.scenes.domino.view import DominoView
from game.scenes.domino.world import DominoWorld
from game.stage import Equation, Hint, SceneAction, Strip
from game.worlds.hands.hand import tool_keys
from game.worlds.painting.landscape import warm_up_landscape
from game.worlds.painting.polygons import warm_up_painter
from game.worlds.painting.spheres import warm_up_spheres
from game.worlds.scene import Parts, Told, WorldScene


class Domino(WorldScene):
    """Each domino turns about the lower edge of its face, strikes the next, and leans on it from then on. So
    many of them push the front together. After a dozen the wave runs at a steady speed. It depends on the
    gap, the thickness and the friction between two dominoes, and grows with the square root of their height.

    All bodies are rigid solids; contacts push and rub, and a step is cut into substeps: with more of them the
    measured speed comes nearer to the theory, and a step costs more. What rests is asleep until something
    touches it. The blocks on the incline lie in lanes of their own, each with its friction; the dashed marks
    show where the formula has them stop.

    In the equations: h height, d thickness, s gap, θ angle of a domino from upright, μ friction, I inertia, T
    torque of the weight, r weight of a domino in the train, ω its spin, α slope, g gravity, v speed.
    """

    name, task, title = A01.names
    parameters_type = DominoParameters
    parameters: DominoParameters
    model: DominoWorld
    parts = Parts(DominoWorld, domino_hand, DominoView)
    told = Told(readouts, saved, targets, hearing, names)
    effects = GRAVITY | CONTACTS | FRICTION | RESTITUTION | CONTINUOUS | SLEEP | JOINTS
    content_type = DominoContent
    not_of_model = OF_PICTURE
    study = domino_study
    tool_prefix = "tool-"
    painters = (("polygons", warm_up_painter), ("landscape", warm_up_landscape), ("spheres", warm_up_spheres))
    may_be_infinite = frozenset(("world.joints",))

    strips = (
        Strip("Wave speed", "m/s", ("wave speed", "theory"), ("theory",), sometimes=("wave speed", "theory")),
        Strip("Struck and awake", "", ("struck", "awake")),
        Strip("Fastest ball", "m/s", ("fastest ball",)),
    )
    hints = (
        Hint(("Click",), "push a domino"),
        Hint(("Shift", "Click"), "push it back"),
        Hint(("Right click",), "take one away"),
        Hint(("1", "2", "3", "4"), "push, drag, add, remove"),
    )
    actions = (SceneAction("push", "push the first", "U"), *tool_keys(TOOLS, "tool-"))
    figure = staticmethod(draw_leaning)
    equations = (
        Equation(
            "A domino leans on the next",
            r"\sin(\theta_i - \theta_{i+1}) = \frac{s+d}{h} \cos \theta_{i+1} - \frac{d}{h}",
            "van Leeuwen 2010",
        ),
        Equation("The train moves", r"\sum r_i (I \ddot{\theta}_i - T_i) = 0", "van Leeuwen 2010"),
        Equation("An impact keeps", r"\sum r_i I \omega_i", "van Leeuwen 2010"),
        Equation("Stopping distance", r"\frac{v^2}{2 g (\mu \cos \alpha - \sin \alpha)}", "Coulomb 1785"),
        Equation("Friction", r"\abs{j_t} \le \mu j_n", "Coulomb 1785"),
    )
    try_this = (
        "Click on any domino: the wave runs both ways if you push it back with Shift.",
        "Take the friction between dominoes away: the wave is a fifth faster.",
        "Set the gap to 0.9 m: each strikes the foot of the next.",
        "Remove three dominoes, and see whether the fourth is still reached.",
        "Choose Own and one substep, then sixteen: compare the wave speed with the theory.",
    )
    default_content: ClassVar[DominoContent] = DominoContent(
        floors=(FloorEntry(start=(-6.0, 0.0), pieces=(PieceEntry(run=60.0),)),),
        rows=(RowEntry(x=0.0, count=60),),
        pushed_at=0.5,
        view=View(left=-2.0, right=30.0, bottom=-3.0, top=9.0),
    )

    def why_idle(self, name: str) -> str:
        if name == "spacing" and all(row.gap is not None for row in self.model.content.rows):
            return "This level says how far apart its dominoes stand."
        return super().why_idle(name)

    def do(self, name: str) -> str:
        self.model.push_first()
        return ""
