"""Scenes whose work is done by parts: a model that moves, a hand that acts on it, a view that shows both."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from typing import Any, ClassVar, NamedTuple, Protocol

from game.arrays import Point
from game.levels import Level
from game.physics.effects import EffectSet
from game.stage import Choice, Frame, Hearing, Pointer, Readout, Scene, SetParameter, ToolButton, WarmUp
from game.stage.messages import Messages
from game.worlds.expectations import captions_now, captions_of, draw_captions, with_headroom
from game.worlds.hands.hand import Tool, tool_buttons
from game.worlds.world import World


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


class Taking(Protocol):
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
    """A scene whose steps, state and effects are those of its ``model``; a ``hand`` takes pointer events."""

    model: Model
    hand: Any

    def advance(self, dt: float) -> None:
        moving: Any = self.model
        moving.advance(dt)

    def pointer(self, event: Pointer) -> None:
        self.hand.take(event)

    def effects_changed(self) -> None:
        self.model.change_effects(self.active)

    def state(self) -> NamedTuple:
        return self.model.state()

    def restore(self, state: Any) -> None:
        self.model.restore(state)


class BuiltScene(ModelScene):
    """A scene in which a person builds: of a model, a hand and a view.

    The content of its levels has a ``view`` (the part of the world to show, m) and what is ``expected``.
    ``not_of_model``: parameters of the picture and of the tools; all others go to the model. ``of_tier``:
    those that the quality decides, unless it is one's own.
    """

    model: BuiltModel
    hand: Taking
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
        """The part of the world to show, without the space for what is expected."""
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
            draw_captions(canvas, top, captions_now(self, expected))


def _nowhere(model: Any) -> Mapping[str, Point]:
    return {}


def _sizeless(model: Any) -> Mapping[str, float]:
    return {}


def _nameless(model: Any) -> Sequence[tuple[Point, str]]:
    return ()


def _silence(model: Any) -> None:
    return None


class Parts(NamedTuple):
    """What a `WorldScene` is made of: classes of its world, hand and view, and functions of the world.

    world(content, parameters, active, seed); hand(world); view(world, hand). readouts: what is measured;
    saved: the content as it is now; targets: what a story may look at, m; hearing: what is heard; names: of
    single things, where they are, m; sizes: how large what stands at a target is, m.
    """

    world: Callable[..., Any]
    hand: Callable[[Any], Any]
    view: Callable[[Any, Any], View]
    readouts: Callable[[Any], Sequence[Readout]]
    saved: Callable[[Any], Any] | None = None
    targets: Callable[[Any], Mapping[str, Point]] = _nowhere
    hearing: Callable[[Any], Hearing | None] = _silence
    names: Callable[[Any], Sequence[tuple[Point, str]]] = _nameless
    sizes: Callable[[Any], Mapping[str, float]] = _sizeless


class WorldScene(BuiltScene):
    """A scene of ``parts``; what it adds is its words, and the deeds of its own keys.

    tools: those of the bar on the stage. tool_prefix: of actions that choose a tool, before the tool's name;
    None: there are none. painters: what
    is compiled beside a step, by names; tiny: parameters with which that step is quick.
    """

    model: World
    hand: Any
    parts: ClassVar[Parts]
    tools: ClassVar[Sequence[Tool]] = ()
    tool_prefix: ClassVar[str | None] = None
    painters: ClassVar[Sequence[tuple[str, Callable[[], None]]]] = ()
    tiny: ClassVar[Mapping[str, Any]] = {}
    takes = frozenset(("right",))
    covers = True

    @classmethod
    def warm_ups(cls) -> Sequence[WarmUp]:
        """A step, and what paints."""
        step = WarmUp("step", lambda: cls(parameters=cls.tiny).advance(cls.dt))
        return (step, *(WarmUp(*one) for one in cls.painters))

    def build(self, level: Level | None) -> None:
        content, parts = self.content_of(level), self.parts
        self.model = parts.world(content, self.parameters, self.active, self.seed)
        for member in self.model.members:
            member.check()
        self.hand = parts.hand(self.model)
        self.view = parts.view(self.model, self.hand)
        self.check_content(content)

    def tool_changed(self) -> None:
        self.hand.let_go()

    def advance(self, dt: float) -> None:
        self.said.say(self.model.advance(dt))

    def action(self, name: str) -> None:
        """Choose a tool, or do what `do` does."""
        prefix = self.tool_prefix
        tool = name.removeprefix(prefix) if prefix is not None and name.startswith(prefix) else ""
        choice = self.parameter("tool") if tool else None
        if isinstance(choice, Choice) and tool in choice.options:
            choice.__set__(self, tool)
            self.hand.let_go()
        else:
            self.said.say(self.do(name))

    def do(self, name: str) -> str:
        """One of ``actions`` that is no tool; why it could not be done, or ""."""
        return ""

    def tool_bar(self) -> Sequence[ToolButton]:
        if not self.tools:
            return ()
        return tool_buttons(self.tools, self.values["tool"], self.tool_prefix or "")

    def readouts(self) -> Sequence[Readout]:
        return self.parts.readouts(self.model)

    def save_content(self) -> Any:
        return None if self.parts.saved is None else self.parts.saved(self.model)

    def story_targets(self) -> Mapping[str, Point]:
        return self.parts.targets(self.model)

    def story_sizes(self) -> Mapping[str, float]:
        return self.parts.sizes(self.model)

    def story_names(self) -> Sequence[tuple[Point, str]]:
        return self.parts.names(self.model)

    def hearing(self) -> Hearing | None:
        return self.parts.hearing(self.model)
