"""The playground of solids."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

from game.lab.studies.stacks import stack_study
from game.physics.solids.effects import USUAL
from game.scenes.solids import SOLIDS as ROW
from game.scenes.solids.figure import draw_contact
from game.scenes.solids.hand import SolidHand
from game.scenes.solids.joint_card import OF_JOINT, card_of
from game.scenes.solids.level import ArchEntry, SolidContent, View
from game.scenes.solids.model import SolidModel
from game.scenes.solids.parameters import OF_CHOSEN, OF_PICTURE, OF_TOOLS, TOOLS, SolidParameters
from game.scenes.solids.picking import NOBODY
from game.scenes.solids.told import hearing, readouts, saved
from game.scenes.solids.view import SolidView
from game.stage import Equation, Hint, Inspected, SceneAction, Strip
from game.worlds.hands.hand import next_of, tool_keys
from game.worlds.painting.polygons import warm_up_painter
from game.worlds.scene import Parts, Told, WorldScene


class Solids(WorldScene):
    """Rigid bodies that touch: a contact pushes only, never pulls, and rubs with at most μ times its push. A
    step is cut into substeps; in each, impulses go round over all contacts and joints, and what overlaps is
    driven apart gently: contacts are soft, like stiff damped springs. So a tall stack sinks a little, and
    less with more substeps.

    Draw bodies, pin and weld them, hang them on ropes and springs, give them motors, cut them. What has come
    to rest falls asleep, island by island, and costs nothing until something touches it.

    In the equations: n normal, t tangent, r lever, j impulse, w inverse mass, I inertia, s gap, v speed of
    the gap, h substep, ζ damping, ω angular frequency of a contact, μ friction, g gravity.
    """

    name, task, title = ROW.names
    parameters_type = SolidParameters
    parameters: SolidParameters
    model: SolidModel
    hand: SolidHand
    parts = Parts(SolidModel, SolidHand, SolidView)
    told = Told(readouts, saved, hearing=hearing)
    tools = TOOLS
    tool_prefix = ""
    edits = frozenset((*OF_CHOSEN, "delete-chosen"))
    painters = (("polygons", warm_up_painter),)
    covers = False
    builds = True
    not_of_model = (*OF_PICTURE, *OF_TOOLS, *OF_CHOSEN)
    effects = USUAL
    content_type = SolidContent
    study = stack_study
    may_be_infinite = frozenset(("world.joints",))

    hints = (
        Hint(("Drag",), "move a body"),
        Hint(("Right drag",), "cut"),
        Hint(("Right click",), "its own properties"),
    )
    actions = (
        *tool_keys(TOOLS),
        SceneAction("delete-chosen", "delete what is chosen", "delete"),
        SceneAction("card", "own properties of what is chosen", "Q"),
    )
    strips = (
        Strip("Energy", "J", ("moving", "turning", "height", "sum")),
        Strip("Deepest overlap", "m", ("deepest",)),
        Strip("Awake", "", ("awake", "contacts")),
    )
    figure = staticmethod(draw_contact)
    equations = (
        Equation("Contact", r"s \ge 0,  j_n \ge 0,  s j_n = 0", "Signorini 1933"),
        Equation("Friction", r"\abs{j_t} \le \mu j_n", "Coulomb 1785"),
        Equation(
            "Effective mass",
            r"\frac{1}{m_n} = w_a + w_b + \frac{(r_a \times n)^2}{I_a} + \frac{(r_b \times n)^2}{I_b}",
            "Catto 2005",
        ),
        Equation("Soft contact", r"j_n = -m_n (v + \frac{\omega s}{2 \zeta + h \omega})", "Catto 2011, 2023"),
        Equation(
            "A column of n sinks", r"\frac{5 g}{2 \omega^2} (\frac{n(n-1)}{2} + \frac{n}{8})", "unit boxes"
        ),
    )
    try_this = (
        "Open the pyramid, and then choose Film: it sinks by less than a tenth.",
        "Pull the keystone out of the arch with the mouse.",
        "Draw a boat, a hook, a spoon: concave outlines are cut into convex parts.",
        "Cut a wheel in two with the right button while it rolls.",
        "Show the contact forces, and build a tower until it falls.",
        "Load the bridge until it breaks: statics says which bar is the first.",
        "Make the clock's bob lighter, or its pendulum shorter: cut it, and read the period.",
    )
    default_content: ClassVar[SolidContent] = SolidContent(
        arches=(ArchEntry(at=(0.0, 0.0), radius=3.0, thickness=0.6, blocks=13, colour="stone"),),
        view=View(left=-6.0, bottom=-0.8, right=6.0, top=5.6),
    )

    def do(self, name: str) -> str:
        """Take away what was touched last, or show what is its own."""
        return self.hand.delete_chosen() if name == "delete-chosen" else self.hand.inspect_chosen()

    def parameter_changed(self, name: str) -> None:
        if name in OF_CHOSEN or name in OF_JOINT:
            self.said.say(self.hand.give(name))
        else:
            super().parameter_changed(name)

    def why_idle(self, name: str) -> str:
        if name in OF_CHOSEN and self.inspected() is None:
            return "No body is chosen."
        if name in OF_JOINT and self.hand.shown_joint == NOBODY:
            return "No joint is chosen."
        return super().why_idle(name)

    def inspected(self) -> Inspected | None:
        """The body or joint that was clicked, if it is still there."""
        if self.hand.shown_joint != NOBODY:
            return card_of(self.model.world, self.hand.shown_joint)
        body = self.hand.inspected
        if body == NOBODY or body not in self.model.movable():
            return None
        return Inspected(f"Body {body}", OF_CHOSEN, "card")

    def hints_now(self) -> Sequence[Hint]:
        """What the tool in the hand does."""
        tool = self.parameters.tool
        words = next_of(TOOLS, tool)
        return (Hint((tool.capitalize(),), words), *self.hints[1:]) if words else self.hints
