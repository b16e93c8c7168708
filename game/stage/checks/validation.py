"""The check that every event passes: only what the scene can know, in plain numbers."""

from __future__ import annotations

import math
from typing import get_args

from game.levels import Level
from game.stage.events import Action, Decision, Pointer, PointerKind, SetEffect, SetParameter, StageEvent
from game.stage.parameters import ParameterError
from game.stage.scene import Scene

LOCKED = "locked by this level"
MOST_VALUES = 64  # numbers of a decision
_POINTER_KINDS: tuple[str, ...] = get_args(PointerKind)


def checked_event(event: StageEvent, scene_type: type[Scene], level: Level | None = None) -> StageEvent:
    """The event in plain numbers; ParameterError for one that the scene cannot know, or the level locks."""
    if isinstance(event, Pointer):
        return _checked_pointer(event)
    if isinstance(event, Action):
        if event.name not in [action.name for action in scene_type.actions]:
            raise ParameterError(f"{event.name}: {scene_type.name} has no such action")
        return event
    if isinstance(event, Decision):
        return _checked_decision(event)
    if isinstance(event, SetParameter):
        parameter = scene_type.parameter(event.name)
        if parameter.name in locked_parameters(level):
            raise ParameterError(f"{parameter.label}: {LOCKED}")
        return SetParameter(parameter.name, parameter.check(event.value))
    if isinstance(event, SetEffect):
        effect = scene_type.effect(event.name)
        if level is not None and level.teaching is not None and effect.name in level.teaching.locked_effects:
            raise ParameterError(f"{effect.label}: {LOCKED}")
        return SetEffect(effect.name, bool(event.on))
    raise ParameterError(f"{type(event).__name__} is no stage event")


def locked_parameters(level: Level | None) -> frozenset[str]:
    """Names of the parameters that cannot be changed in a level."""
    return level.teaching.fixed if level is not None and level.teaching is not None else frozenset()


def _checked_decision(event: Decision) -> Decision:
    """The event in plain numbers; ParameterError if there are too many or one is not finite."""
    try:
        values = tuple(float(value) for value in event.values)
    except (TypeError, ValueError, OverflowError):
        raise ParameterError("decision: expected numbers") from None
    if len(values) > MOST_VALUES or not all(map(math.isfinite, values)):
        raise ParameterError(f"decision: expected at most {MOST_VALUES} finite numbers")
    return Decision(str(event.name), values)


def _checked_pointer(event: Pointer) -> Pointer:
    """The event in plain numbers; ParameterError if its kind is none or a number is not finite."""
    if event.kind not in _POINTER_KINDS:
        raise ParameterError(f"pointer: {event.kind!r} is not one of {', '.join(_POINTER_KINDS)}")
    try:
        x, y, wheel, button = float(event.x), float(event.y), float(event.wheel), int(event.button)
    except (TypeError, ValueError, OverflowError):
        raise ParameterError("pointer: expected numbers") from None
    if not all(map(math.isfinite, (x, y, wheel))):
        raise ParameterError("pointer: expected finite coordinates")
    return Pointer(event.kind, x, y, button, wheel, bool(event.shift), bool(event.control))
