"""What is kept of a game of snooker: as a level, and against a crash."""

from __future__ import annotations

from typing import TYPE_CHECKING

import msgspec

from game.billiards.game.frame import Frame, Struck
from game.scenes.shared.tables.kept.excerpts import excerpts_of
from game.scenes.snooker.course import Course
from game.scenes.snooker.level import PlacedBall, SnookerContent
from game.scenes.snooker.model import SnookerModel
from game.scenes.snooker.opponents import decision_of
from game.stage import Decision
from game.stage.records.excerpt import Excerpt

if TYPE_CHECKING:
    from game.stage import Scene


def content_of(model: SnookerModel) -> SnookerContent:
    """Game and table as they are; in the midst of a stroke, as they were before it."""
    balls = [PlacedBall(number=number, position=(x, y)) for number, x, y in model.frame.layout.places]
    return SnookerContent(
        game=model.content.game, players=model.content.players, cup=model.content.cup, balls=balls,
        practice=model.content.practice,
        drill=model.content.drill, lesson=model.content.lesson,
        saved=msgspec.to_builtins(model.game), put_back=_put_back(model),
    )  # fmt: skip


def _put_back(model: SnookerModel) -> list[PlacedBall]:
    """Where the balls lay before a miss that may have to be played again."""
    before = model.frame.before_miss if model.game.before is not None else None
    if before is None:
        return []
    return [PlacedBall(number=number, position=(x, y)) for number, x, y in before.places]


def worth_keeping(model: SnookerModel, plays_itself: bool) -> object:
    """Game and places once a stroke has been played; None for a drill, which begins again with each."""
    frame = model.frame
    if model.game.drill or plays_itself or not frame.strokes:
        return None
    return frame.game, frame.layout.places


def highlights(course: Course, scene: Scene) -> tuple[Excerpt, ...]:
    """The strokes that decided the match, each from the position before it."""
    model = course.model

    def before(frame: Frame) -> SnookerContent:
        balls = [PlacedBall(number=number, position=(x, y)) for number, x, y in frame.layout.places]
        return SnookerContent(
            game=model.content.game, players=model.content.players, balls=balls,
            saved=msgspec.to_builtins(frame.game),
        )  # fmt: skip

    def event(struck: Struck) -> Decision:
        return decision_of(struck.stroke, struck.call)

    return excerpts_of(scene, course, before, event)
