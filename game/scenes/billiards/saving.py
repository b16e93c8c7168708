"""What is kept of a billiard game: as a level, and against a crash."""

from __future__ import annotations

import msgspec

from game.billiards.game.arrangement import Arrangement
from game.billiards.game.frame import BestStroke
from game.billiards.game.games import Drill
from game.scenes.billiards.level import BestPlayed, BilliardsContent, PlacedBall
from game.scenes.billiards.model import BilliardsModel


def content_of(model: BilliardsModel) -> BilliardsContent:
    """Game and table as they are; in the midst of a stroke, as they were before it."""
    best = model.frame.best
    return BilliardsContent(
        game=model.content.game, players=model.content.players, calling=model.content.calling,
        balls=_placed(model.frame.layout), solution=model.content.solution,
        saved=msgspec.to_builtins(model.frame.game), tallies=model.frame.tallies,
        best=_told(best) if best is not None else None,
    )  # fmt: skip


def _placed(layout: Arrangement) -> list[PlacedBall]:
    return [PlacedBall(number=number, position=(x, y)) for number, x, y in layout.places]


def _told(best: BestStroke) -> BestPlayed:
    """A stroke as a level tells of it."""
    frame, stroke, call = best.struck
    return BestPlayed(
        balls=_placed(frame.layout), game=msgspec.to_builtins(frame.game), stroke=(*stroke,),
        **call._asdict(),
    )  # fmt: skip


def worth_keeping(model: BilliardsModel, plays_itself: bool) -> object:
    """Game and places once a stroke has been played; None for a drill, which begins again with each."""
    frame = model.frame
    if isinstance(frame.game, Drill) or plays_itself or not frame.strokes:
        return None
    return frame.game, frame.layout.places
