"""What is kept of a billiard game: as a level, and against a crash."""

from __future__ import annotations

import msgspec

from game.billiards.game.games import Drill
from game.scenes.billiards.level import BilliardsContent, PlacedBall
from game.scenes.billiards.model import BilliardsModel


def content_of(model: BilliardsModel) -> BilliardsContent:
    """Game and table as they are; in the midst of a stroke, as they were before it."""
    balls = [PlacedBall(number=number, position=(x, y)) for number, x, y in model.frame.layout.places]
    return BilliardsContent(
        game=model.content.game, players=model.content.players, calling=model.content.calling,
        balls=balls, solution=model.content.solution,
        saved=msgspec.to_builtins(model.frame.game), tallies=model.frame.tallies,
    )  # fmt: skip


def worth_keeping(model: BilliardsModel, plays_itself: bool) -> object:
    """Game and places once a stroke has been played; None for a drill, which begins again with each."""
    frame = model.frame
    if isinstance(frame.game, Drill) or plays_itself or not frame.strokes:
        return None
    return frame.game, frame.layout.places
