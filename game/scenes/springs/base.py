"""What the two mass-spring scenes share: a network of particles and links that is built, moved and torn."""

from __future__ import annotations

from collections.abc import Sequence
from typing import ClassVar

from game.physics.constraints import AREAS, ATTACHMENTS, CONTACTS, DAMPING, LINKS, TEARING
from game.physics.fields import GRAVITY, GROUND
from game.scenes.springs.hand import SpringHand
from game.scenes.springs.level import LinkEntry, ParticleEntry, SpringContent
from game.scenes.springs.links import LinkLaw
from game.scenes.springs.model import SpringModel
from game.scenes.springs.parameters import OF_CHOSEN, OF_PICTURE, MassSpringParameters
from game.scenes.springs.readouts import readouts
from game.scenes.springs.saving import content_of
from game.scenes.springs.view import SpringView
from game.stage import Hint, SceneAction, Strip
from game.worlds.expectations import Caption
from game.worlds.scene import ModelScene, Told

TOOL_HINTS = {
    "particle": (Hint(("Click",), "new particle"), Hint(("Delete",), "delete what is chosen")),
    "link": (
        Hint(("Click",), "one end of a link, then the other"),
        Hint(("Delete",), "delete what is chosen"),
    ),
    "pin": (Hint(("Click",), "pin or free a particle"),),
    "cut": (Hint(("Drag",), "cut links"),),
}  # instead of the first of the scene's hints
STILL = "It stands still while you build: 1, Move, lets it go"


class MassSpringScene(ModelScene):
    """Base of C14 and C15. A subclass says how stiff a link is."""

    effects = GRAVITY | GROUND | LINKS | AREAS | ATTACHMENTS | TEARING | DAMPING | CONTACTS
    parameters: MassSpringParameters
    model: SpringModel
    content_type = SpringContent
    told = Told(readouts, content_of)
    not_of_model = OF_PICTURE
    takes: ClassVar[frozenset[str]] = frozenset(("right",))

    hints = (
        Hint(("Drag",), "move a particle"),
        Hint(("Right drag",), "cut"),
        Hint(("1", "…", "5"), "tools"),
    )
    actions = (
        SceneAction("hand", "move", "1"),
        SceneAction("particle", "new particle", "2"),
        SceneAction("link", "link two", "3"),
        SceneAction("pin", "pin or free", "4"),
        SceneAction("cut", "cut", "5"),
        SceneAction("delete", "delete what is chosen", "delete"),
    )
    strips = (
        Strip("Stretch", "", ("worst", "overall")),
        Strip("Energy", "J", ("kinetic", "potential", "sum")),
        Strip("Constraint error", "m", ("residual",)),
    )
    default_content: ClassVar[SpringContent] = SpringContent(
        particles=(ParticleEntry(position=(0.0, 3.0), inverse_mass=0.0), ParticleEntry(position=(1.5, 3.0))),
        links=(LinkEntry(ends=(0, 1)),),
        walls=(-4.6, 4.6),
    )

    def hints_now(self) -> Sequence[Hint]:
        return (*TOOL_HINTS.get(self.parameters.tool, self.hints[:1]), *self.hints[1:])

    def link_law(self) -> LinkLaw:
        """How stiff links are, by the scene's parameters."""
        raise NotImplementedError

    # -- building -----------------------------------------------------------------------------------

    def make(self, content: SpringContent) -> None:
        self.model = SpringModel(content, self.parameters, self.link_law(), self.active)
        self.hand = SpringHand(self.model)
        self.view = SpringView(self.model, self.hand)

    def parameter_changed(self, name: str) -> None:
        if name in OF_CHOSEN:
            self.hand.apply_parameter(name)
        elif name == "tool":
            self.hand.begin_again()
        else:
            super().parameter_changed(name)

    # -- a step, and what comes in ------------------------------------------------------------------

    def advance(self, dt: float) -> None:
        if self.model.advance(dt):
            self.said.say("A link is torn.")

    def action(self, name: str) -> None:
        if name == "delete":
            self.said.say(self.hand.delete())
        else:
            self.parameters.tool = name
            self.hand.begin_again()

    # -- what there is to see -----------------------------------------------------------------------

    def captions(self) -> Sequence[Caption]:
        still = [Caption(STILL, met=False)] if self.model.at_rest else []
        return [*super().captions(), *still]
