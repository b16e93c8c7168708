"""What is kept of a game of carom: as a level, and against a crash."""

from __future__ import annotations

from typing import TYPE_CHECKING

import msgspec

from game.billiards.game.carom_frame import CaromFrame, CaromStruck
from game.scenes.carom.course import Course
from game.scenes.carom.level import CaromContent
from game.scenes.carom.model import CaromModel
from game.scenes.shared.tables.kept.excerpts import excerpts_of
from game.stage import Decision
from game.stage.records.excerpt import Excerpt

if TYPE_CHECKING:
    from game.stage import Scene


def content_of(model: CaromModel) -> CaromContent:
    """Game and table as they are; in the midst of a stroke, as they were before it."""
    return _content(model, model.frame)


def _content(model: CaromModel, frame: CaromFrame) -> CaromContent:
    """A frame as a level has it."""
    white, yellow, red = frame.places
    return CaromContent(
        game=frame.game.kind, players=model.content.players, cup=model.content.cup, white=white,
        yellow=yellow, red=red, practice=len(frame.game.players) == 1,
        lesson=model.content.lesson, saved=msgspec.to_builtins(frame.game),
    )  # fmt: skip


def worth_keeping(model: CaromModel, plays_itself: bool) -> object:
    """Game and places once something has been done; else None."""
    frame = model.frame
    if plays_itself or frame.earlier is None:
        return None
    return frame.game, frame.places


def highlights(course: Course, scene: Scene) -> tuple[Excerpt, ...]:
    """The strokes that decided the game, each from the position before it."""

    def event(struck: CaromStruck) -> Decision:
        return Decision("play", tuple(struck.stroke))

    return excerpts_of(scene, course, lambda frame: _content(course.model, frame), event)
