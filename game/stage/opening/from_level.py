"""What a scene takes over from a level, and what of the level it refuses."""

from __future__ import annotations

from typing import Any

from game.levels import Level, LevelError
from game.physics.kernels.limits import LimitError
from game.stage.parameters import ParameterError
from game.teaching import TeachingError


def take_over(scene: Any, level: Level) -> None:
    """Set a scene's parameters and effects as the level says; LevelError naming its file and field."""
    if level.scene != scene.name:
        raise LevelError(level.path, "scene", f"is {level.scene!r}, expected {scene.name!r}")
    for key, value in level.parameters.items():
        try:
            scene.parameter(key).__set__(scene, value)
        except ParameterError as error:
            raise LevelError(level.path, f"parameters.{key}", str(error).removeprefix(f"{key}: ")) from None
    for name in level.effects_off:
        try:
            scene.active = scene.active.without(scene.effect(name))
        except ParameterError as error:
            raise LevelError(level.path, "effects.off", str(error)) from None


def check_locks(scene: Any, level: Level | None) -> None:
    """ParameterError if something that the level locks is not as the level has it."""
    if level is None or level.teaching is None:
        return
    try:
        level.teaching.check_names(scene.declared_parameters(), [effect.name for effect in scene.effects])
    except TeachingError as error:
        raise LevelError(level.path, f"teaching.{error.field}", error.reason) from None
    for name in level.teaching.fixed:
        if scene.values[name] != scene.level_value(name):
            raise ParameterError(f"{name} = {scene.values[name]!r}: locked by the level")
    for name in level.teaching.locked_effects:
        if (scene.effect(name) in scene.active) == (name in level.effects_off):
            raise ParameterError(f"{name}: locked by the level")


def check_teaching(scene: Any, level: Level | None) -> None:
    """LevelError for a readout that a level's task asks for and that is never measured."""
    if level is None or level.teaching is None:
        return
    known = [readout.name for readout in scene.readouts()]
    known += [name for strip in scene.strips for name in strip.sometimes]
    try:
        level.teaching.check_readouts(known)
    except TeachingError as error:
        raise LevelError(level.path, f"teaching.{error.field}", error.reason) from None


def refusal(error: ValueError, level: Level | None, asked_beside: bool) -> ValueError:
    """What an error in building says of the level, if that is to blame; the error itself otherwise.

    asked_beside: parameters were set otherwise than the level says, so a limit may be theirs.
    """
    beyond = isinstance(error, LimitError)
    if isinstance(error, LevelError | ParameterError) or level is None or (asked_beside and beyond):
        return error
    if level.content is None and not beyond:
        return error
    return LevelError(level.path, "content" if level.content is not None else "parameters", str(error))
