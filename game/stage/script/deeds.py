"""What a story does to its scene, as the events that a hand would send."""

from __future__ import annotations

from collections.abc import Sequence

from game.stage.events import Action, Pointer, SetEffect, SetParameter, StageEvent
from game.stage.script.lines import Deed

Point = tuple[float, float]
RATE_HZ = 60.0  # of simulated time: how often a deed that takes time goes on


def events_of(deed: Deed, place: Point, to: Point) -> list[StageEvent]:
    """Deeds that are done at once; of a deed that takes time its beginning and end as well."""
    if deed.to is not None:
        return [*begin_of(deed, place), *end_of(deed, to)]
    return begin_of(deed, place) if not deed.over else end_of(deed, to)


def begin_of(deed: Deed, place: Point) -> list[StageEvent]:
    """What is done when its line begins; nothing for a parameter that takes time."""
    if deed.action:
        return [Action(deed.action)]
    if deed.effect:
        return [SetEffect(deed.effect, deed.on)]
    if deed.parameter:
        assert deed.value is not None
        return [] if deed.over else [SetParameter(deed.parameter, deed.value)]
    if deed.pointer == "drag":
        return [_pointer(deed, "move", place, 0), _pointer(deed, "down", place, deed.button)]
    if deed.pointer == "click":
        kinds: Sequence[tuple[str, int]] = (("move", 0), ("down", deed.button), ("up", deed.button))
        return [_pointer(deed, kind, place, button) for kind, button in kinds]
    button = deed.button if deed.pointer in ("down", "up") else 0
    return [_pointer(deed, deed.pointer, place, button)]


def on_the_way(deed: Deed, start: float, place: Point, to: Point, share: float) -> StageEvent:
    """How far a deed that takes time is at a share of it, from 0 to 1. start: what the parameter was."""
    if deed.parameter:
        assert isinstance(deed.value, (int, float))
        return SetParameter(deed.parameter, start + (deed.value - start) * share)
    if deed.pointer == "move":
        share *= share * (3.0 - 2.0 * share)
    at = (place[0] + (to[0] - place[0]) * share, place[1] + (to[1] - place[1]) * share)
    return _pointer(deed, "move", at, _held(deed))


def end_of(deed: Deed, to: Point) -> list[StageEvent]:
    """What is done when a deed that takes time ends."""
    if deed.parameter:
        assert deed.value is not None
        return [SetParameter(deed.parameter, deed.value)]
    moved = _pointer(deed, "move", to, _held(deed))
    return [moved] if deed.pointer == "move" else [moved, _pointer(deed, "up", to, deed.button)]


def _held(deed: Deed) -> int:
    """The button that is down on the way."""
    return deed.button if deed.pointer == "drag" else 0


def _pointer(deed: Deed, kind: str, at: Point, button: int) -> Pointer:
    wheel = deed.wheel if kind == "wheel" else 0.0
    return Pointer(kind, at[0], at[1], button, wheel, deed.shift, deed.control)  # type: ignore[arg-type]
