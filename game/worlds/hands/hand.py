"""The hand in a world: what it holds, where it is, and the tools by which it acts."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

from game.arrays import Point
from game.stage import Choice, Hint, Part, Pointer, SceneAction, ToolButton

NOBODY = -1


class Tool(NamedTuple):
    """A tool as it can be chosen: option, label, words beside its key, what the hand does next.

    key: its own; "": the next number. icon: its sign on the stage; "": it has none. apart: another group of
    the bar begins with it.
    """

    name: str
    label: str
    words: str = ""
    next: str = ""
    key: str = ""
    icon: str = ""
    apart: bool = False


def choose_tool(tools: Sequence[Tool]) -> Choice:
    """The parameter ``tool``; the first one is in the hand at the beginning."""
    names, labels = tuple(tool.name for tool in tools), tuple(tool.label for tool in tools)
    return Choice(names[0], names, labels=labels, group="Tools", help="what the left button does")


def tool_keys(tools: Sequence[Tool], prefix: str = "") -> tuple[SceneAction, ...]:
    """An action for each tool that has words, on its own key or on the keys 1, 2, 3 and so on."""
    return tuple(
        SceneAction(prefix + tool.name, tool.words, tool.key or str(k + 1))
        for k, tool in enumerate(tool for tool in tools if tool.words)
    )


def tool_buttons(tools: Sequence[Tool], chosen: str, prefix: str = "") -> tuple[ToolButton, ...]:
    """A button on the stage for each tool that has a sign."""
    return tuple(
        ToolButton(
            prefix + tool.name,
            tool.icon,
            f"{tool.label}: {tool.next}" if tool.next else tool.label,
            tool.key,
            tool.name == chosen,
            tool.apart,
        )
        for tool in tools
        if tool.icon
    )


def next_of(tools: Sequence[Tool], name: str) -> str:
    """What the hand does next with a tool, or ""."""
    return next(tool.next for tool in tools if tool.name == name)


def hint_of(tools: Sequence[Tool], name: str) -> tuple[Hint, ...]:
    """A hint that says so, if there is something to say."""
    words = next_of(tools, name)
    return (Hint(("Mouse",), words),) if words else ()


def legend_of(tools: Sequence[Tool], name: str) -> list[tuple[str, str, str]]:
    """A row of the legend that says so, if there is something to say."""
    words = next_of(tools, name)
    return [("ring:accent", words, "")] if words else []


def nothing(hand: Hand) -> str:
    """What a button does that does nothing."""
    return ""


class Use(NamedTuple):
    """What a tool does as the button goes down, while the pointer moves, and as it comes up again.

    Each gets the hand, and returns why it could not, or "".
    """

    press: Callable[[Hand], str] = nothing
    move: Callable[[Hand], str] = nothing
    release: Callable[[Hand], str] = nothing


class Hand(Part):
    """``uses`` of its tools, by name. ``right``: the tool of the right button, "": none; ``left``: that of
    the left one, "": the parameter ``tool`` says it.

    held: number of what it holds, or NOBODY; kind: of what that is, where a tool takes more than one. start,
    point: where a drag began, and is, m, None when there is none; before: where it was at the last event;
    path: of a drawn line. verb: the tool of the drag; shift: whether that key is held.
    """

    def __init__(
        self,
        model: Any,
        uses: Mapping[str, Use],
        low: Point,
        high: Point,
        *,
        left: str = "",
        right: str = "",
        drop: Callable[[Hand], None] | None = None,
    ):
        """low, high: corners of where a hand may be, m. drop: what letting go does to the model."""
        self.model, self.parameters = model, model.parameters
        self._uses, self._low, self._high, self._drop = uses, low, high, drop
        self._left, self._right = left, right
        self.held, self.kind, self.verb, self.shift = NOBODY, "", "", False
        self.start: Point | None = None
        self.point: Point | None = None
        self.before: Point = (0.0, 0.0)
        self.moved: Point = (0.0, 0.0)
        self.path: list[Point] = []

    @property
    def at(self) -> Point:
        """Where it is, m."""
        return self.point or self.before

    def reach(self, share: float, most: float = 1e9) -> float:
        """How near to something it takes it: a share of the height in view, m."""
        view = self.model.content.view
        return min(share * (view.top - view.bottom), most)

    def take(self, event: Pointer) -> str:
        """A pointer event; what there is to say about it."""
        point = tuple(map(_within, (event.x, event.y), self._low, self._high))
        if event.kind == "down" and (event.button == 1 or (event.button == 3 and self._right)):
            self.let_go()
            self.verb = self._right if event.button == 3 else self._left or self.parameters.tool
            self.start = self.point = self.before = point[0], point[1]
            self.path, self.shift = [self.point], event.shift
            return self._uses.get(self.verb, Use()).press(self)
        if event.kind in ("move", "up") and self.point is not None:
            self.before, self.point = self.point, (point[0], point[1])
            self.moved = self.point[0] - self.before[0], self.point[1] - self.before[1]
            use = self._uses.get(self.verb, Use())
            if event.kind == "move":
                return use.move(self)
            words = use.release(self)
            self.let_go()
            return words
        if event.kind in ("up", "cancel"):
            self.let_go()
        return ""

    def let_go(self) -> None:
        """Hold nothing, and forget what was begun."""
        if self._drop is not None:
            self._drop(self)
        self.held, self.kind, self.verb, self.path = NOBODY, "", "", []
        self.start, self.point, self.moved = None, None, (0.0, 0.0)


def _within(value: float, least: float, most: float) -> float:
    return min(max(value, least), most)
