"""What the keys do: the scene's named actions."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from game.physics.animation import INTERPOLATIONS
from game.scenes.key_frames.keying import insert_here, toggle_corner
from game.scenes.key_frames.model import KeyFrameModel


def take_action(model: KeyFrameModel, name: str) -> None:
    """Do what an action says; a drag ends there."""
    model.document.let_go()
    ACTIONS[name](model)
    model.place_box()


def _undo(model: KeyFrameModel) -> None:
    model.document.undo()


def _redo(model: KeyFrameModel) -> None:
    model.document.redo()


def _delete(model: KeyFrameModel) -> None:
    if model.document.chosen >= 0:
        model.document.delete_key(model.document.chosen)


def _play(model: KeyFrameModel) -> None:
    model.parameters.playing = not model.parameters.playing
    model.player.follow_playing()


def _next_interpolation(model: KeyFrameModel) -> None:
    place = INTERPOLATIONS.index(model.parameters.interpolation)
    model.parameters.interpolation = INTERPOLATIONS[(place + 1) % len(INTERPOLATIONS)]
    model.document.note_shaping()


def _earlier(model: KeyFrameModel) -> None:
    """Stand still at the key before the present time, or at the last one."""
    times, now = _times(model), model.player.present()
    _go_to(model, next((t for t in reversed(times) if t < now - 1e-9), times[-1]))


def _later(model: KeyFrameModel) -> None:
    """Stand still at the key after the present time, or at the first one."""
    times, now = _times(model), model.player.present()
    _go_to(model, next((t for t in times if t > now + 1e-9), times[0]))


def _times(model: KeyFrameModel) -> list[float]:
    return sorted({key.time for key in model.motion.keys})


def _go_to(model: KeyFrameModel, time: float) -> None:
    model.player.pause_at(time)
    model.document.choose(max(i for i, key in enumerate(model.motion.keys) if key.time == time))


ACTIONS: Mapping[str, Callable[[KeyFrameModel], None]] = {
    "undo": _undo,
    "redo": _redo,
    "insert": insert_here,
    "delete": _delete,
    "corner": toggle_corner,
    "play": _play,
    "method": _next_interpolation,
    "earlier": _earlier,
    "later": _later,
}
