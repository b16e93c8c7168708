"""Scenes whose work is done by parts: a model that moves, a hand that acts on it, a view that shows both."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from typing import Any, ClassVar, NamedTuple, Protocol

from game.arrays import Point
from game.levels import Level
from game.physics.effects import EffectSet
from game.stage import (
    Choice,
    Comparison,
    Frame,
    Hearing,
    Pointer,
    Readout,
    Scene,
    SetParameter,
    ToolButton,
    WarmUp,
)
from game.stage.messages import Messages
from game.worlds.expectations import (
    Caption,
    Expectation,
    captions_now,
    captions_of,
    draw_captions,
    with_headroom,
)
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

    def change_parameter(self, name: str) -> None:
        """Take over a parameter's new value."""


class Taking(Protocol):
    """What a person does to the model."""

    def take(self, event: Pointer) -> str | None:
        """Let the pointer act; returns why it could not, or nothing."""


class View(Protocol):
    """What shows model and hand."""

    def draw(self, canvas: Any, previous: Any, alpha: float) -> None:
        """Draw the model ``alpha`` of the way from a state before to now."""

    def legend(self) -> Sequence[tuple[str, str, str]]:
        """Rows of the legend, as `Scene.legend`."""


def expected_of(content: Any) -> Sequence[Expectation]:
    """What a level's content expects; nothing where its form has no such field."""
    found: Sequence[Expectation] = getattr(content, "expected", ())
    return found


def _nothing(model: Any) -> None:
    return None


def _nowhere(model: Any) -> Mapping[str, Point]:
    return {}


def _nameless(model: Any) -> Mapping[str, Any]:
    return {}


def _rowless(model: Any) -> Sequence[Any]:
    return ()


class Told(NamedTuple):
    """What a scene says of its model, as functions of it.

    readouts: what is measured; saved: the content as it is now; targets: what a story may look at, m;
    hearing: what is heard; names: of single things, where they are, m; sizes: how large what stands at a
    target is, m; charts: measured beside expected, by the names that a story gives them.
    """

    readouts: Callable[[Any], Sequence[Readout]] = _rowless
    saved: Callable[[Any], Any] = _nothing
    targets: Callable[[Any], Mapping[str, Point]] = _nowhere
    hearing: Callable[[Any], Hearing | None] = _nothing
    names: Callable[[Any], Sequence[tuple[Point, str]]] = _rowless
    sizes: Callable[[Any], Mapping[str, float]] = _nameless
    charts: Callable[[Any], Mapping[str, Comparison]] = _nameless


class ModelScene(Scene):
    """A scene of a model, a hand and a view, which `make` makes. What the model has to say is ``told``.

    said: messages that are not read yet; `make` may put the model's own in their place. The content of its
    levels has what is ``expected``, and a ``view`` (the part of the world to show, m) unless `shown` says
    another. ``not_of_model``: parameters of the picture and of the tools; all others go to the model.
    ``at_once``: no time must pass before what is expected is measured.
    """

    model: Any
    hand: Any = None  # of a scene that is only watched there is none
    view: Any = None  # a scene without one draws by functions
    told: ClassVar[Told] = Told()
    not_of_model: ClassVar[Collection[str]] = ()
    at_once: ClassVar[bool] = False

    def build(self, level: Level | None) -> None:
        """Make the parts; ValueError if the content expects a readout that there is not."""
        content = self.content_of(level)
        self.said = Messages()
        self.make(content)
        captions_of(expected_of(content), self.readouts())

    def make(self, content: Any) -> None:
        """Make model, hand and view from the content of a level."""
        raise NotImplementedError

    def advance(self, dt: float) -> None:
        self.said.say(self.model.advance(dt))

    def pointer(self, event: Pointer) -> None:
        if self.hand is not None:
            self.said.say(self.hand.take(event))

    def parameter_changed(self, name: str) -> None:
        if name not in self.not_of_model:
            self.model.change_parameter(name)

    def effects_changed(self) -> None:
        self.model.change_effects(self.active)

    def state(self) -> NamedTuple:
        state: NamedTuple = self.model.state()
        return state

    def restore(self, state: Any) -> None:
        self.model.restore(state)

    def messages(self) -> Sequence[str]:
        return self.said.take()

    def readouts(self) -> Sequence[Readout]:
        return self.told.readouts(self.model)

    def save_content(self) -> Any:
        return self.told.saved(self.model)

    def hearing(self) -> Hearing | None:
        return self.told.hearing(self.model)

    @classmethod
    def is_heard(cls) -> bool:
        return cls.told.hearing is not _nothing or cls.hearing is not ModelScene.hearing

    def story_targets(self) -> Mapping[str, Point]:
        return self.told.targets(self.model)

    def story_names(self) -> Sequence[tuple[Point, str]]:
        return self.told.names(self.model)

    def story_sizes(self) -> Mapping[str, float]:
        return self.told.sizes(self.model)

    def story_charts(self) -> Mapping[str, Comparison]:
        return self.told.charts(self.model)

    def legend(self) -> Sequence[tuple[str, str, str]]:
        return self.view.legend() if self.view is not None else ()

    def shown(self) -> Frame:
        """The part of the world to show, without the space for what is expected."""
        view = self.model.content.view
        return Frame(view.left, view.bottom, view.right, view.top)

    def frame(self) -> Frame:
        return self.shown()

    def draw(self, canvas: Any, alpha: float) -> None:
        self.view.draw(canvas, self.previous, alpha)
        self.draw_expected(canvas)

    def captions(self) -> Sequence[Caption]:
        """What is expected beside what is measured."""
        expected = expected_of(self.model.content)
        if not expected:
            return ()
        return captions_of(expected, self.readouts()) if self.at_once else captions_now(self, expected)

    def draw_expected(self, canvas: Any) -> None:
        """The captions in the middle of the frame's top."""
        captions = self.captions()
        if captions:
            frame = self.frame()
            draw_captions(canvas, (0.5 * (frame.left + frame.right), frame.top), captions)


class BuiltScene(ModelScene):
    """A scene in which a person builds, with space for what is expected above what is shown.

    ``of_tier``: parameters that the quality decides, unless it is one's own.
    """

    of_tier: ClassVar[Collection[str]] = ("substeps",)

    def parameter_changed(self, name: str) -> None:
        if name == "tool":
            self.tool_changed()
        else:
            super().parameter_changed(name)

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

    def frame(self) -> Frame:
        return with_headroom(self.shown(), len(expected_of(self.model.content)))


class Parts(NamedTuple):
    """What a `WorldScene` is made of: classes of its world, hand and view.

    world(content, parameters, active, seed); hand(world); view(world, hand).
    """

    world: Callable[..., Any]
    hand: Callable[[Any], Any]
    view: Callable[[Any, Any], View]


class WorldScene(BuiltScene):
    """A scene of ``parts``; what it adds is its words, and the deeds of its own keys.

    tools: those of the bar on the stage. tool_prefix: of actions that choose a tool, before the tool's name;
    None: there are none. painters: what is compiled beside a step, by names; tiny: parameters with which that
    step is quick.
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

    def make(self, content: Any) -> None:
        parts = self.parts
        self.model = parts.world(content, self.parameters, self.active, self.seed)
        for member in self.model.members:
            member.check()
        self.hand = parts.hand(self.model)
        self.view = parts.view(self.model, self.hand)

    def tool_changed(self) -> None:
        self.hand.let_go()

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
