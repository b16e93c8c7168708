"""Scenes whose work is done by parts: a model that moves, a hand that acts on it, a view that shows both."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Any, ClassVar, NamedTuple, Protocol

from game.physics.effects import EffectSet
from game.stage import Frame, Pointer, Scene, SetParameter
from game.stage.messages import Messages
from game.worlds.expectations import captions_of, draw_captions, with_headroom


class Model(Protocol):
    """What moves: it has a state, and computes some effects."""

    def state(self) -> NamedTuple:
        """All that later steps depend on."""

    def restore(self, state: Any) -> None:
        """Take over a state that ``state`` gave."""

    def change_effects(self, active: EffectSet) -> None:
        """Compute these effects from now on."""


class BuiltModel(Model, Protocol):
    """A model that is built from a level, and saved as one."""

    @property
    def content(self) -> Any:
        """The content of the level."""

    def change_parameter(self, name: str) -> None:
        """Take over a parameter's new value."""


class Hand(Protocol):
    """What a person does to the model."""

    def take(self, event: Pointer) -> str:
        """Let the pointer act; returns why it could not, or ""."""


class View(Protocol):
    """What shows model and hand."""

    def draw(self, canvas: Any, previous: Any, alpha: float) -> None:
        """Draw the model ``alpha`` of the way from a state before to now."""

    def legend(self) -> Sequence[tuple[str, str, str]]:
        """Rows of the legend, as `Scene.legend`."""


class ModelScene(Scene):
    """A scene whose state and effects are those of its ``model``."""

    model: Model

    def effects_changed(self) -> None:
        self.model.change_effects(self.active)

    def state(self) -> NamedTuple:
        return self.model.state()

    def restore(self, state: Any) -> None:
        self.model.restore(state)


class BuiltScene(ModelScene):
    """A scene in which a person builds: of a model, a hand and a view.

    The content of its levels has a ``view`` (the part of the world to show, m) and what is ``expected``.
    ``not_of_model``: parameters of the picture and of the tools; the model is told of all others.
    ``of_tier``: those that go by the quality unless that is one's own.
    """

    model: BuiltModel
    hand: Hand
    view: View
    not_of_model: ClassVar[Collection[str]] = ()
    of_tier: ClassVar[Collection[str]] = ("substeps",)

    def check_content(self, content: Any) -> None:
        """ValueError if it expects a readout that there is not; to be called when all is built."""
        self.said = Messages()
        captions_of(content.expected, self.readouts())

    def pointer(self, event: Pointer) -> None:
        self.said.say(self.hand.take(event))

    def messages(self) -> Sequence[str]:
        return self.said.take()

    def parameter_changed(self, name: str) -> None:
        if name == "tool":
            self.tool_changed()
        elif name not in self.not_of_model:
            self.model.change_parameter(name)

    def tool_changed(self) -> None:
        """Another tool is in the hand."""

    def why_idle(self, name: str) -> str:
        """The quality says some of them, unless it is one's own."""
        if name in self.of_tier and self.values.get("tier", "own") != "own":
            return "The quality says how many there are; choose Own."
        return ""

    def takes_long(self, event: Any) -> bool:
        """Another solver is compiled first."""
        return isinstance(event, SetParameter) and event.name == "solver"

    def legend(self) -> Sequence[tuple[str, str, str]]:
        return self.view.legend()

    def shown(self) -> Frame:
        """The part of the world to show, without room for what is expected."""
        view = self.model.content.view
        return Frame(view.left, view.bottom, view.right, view.top)

    def frame(self) -> Frame:
        return with_headroom(self.shown(), len(self.model.content.expected))

    def draw(self, canvas: Any, alpha: float) -> None:
        self.view.draw(canvas, self.previous, alpha)
        expected = self.model.content.expected
        if expected:
            frame = self.frame()
            top = (0.5 * (frame.left + frame.right), frame.top)
            draw_captions(canvas, top, captions_of(expected, self.readouts()))
