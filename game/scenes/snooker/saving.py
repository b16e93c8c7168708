"""What is kept of a game of snooker: as a level, and against a crash."""

from __future__ import annotations

import msgspec

from game.scenes.snooker.level import PlacedBall, SnookerContent
from game.scenes.snooker.model import SnookerModel


def content_of(model: SnookerModel) -> SnookerContent:
    """Game and table as they are; in the midst of a stroke, as they were before it."""
    balls = [PlacedBall(number=number, position=(x, y)) for number, x, y in model.frame.layout.places]
    return SnookerContent(
        game=model.content.game, players=model.content.players, balls=balls, practice=model.content.practice,
        drill=model.content.drill, saved=msgspec.to_builtins(model.game), put_back=_put_back(model),
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
