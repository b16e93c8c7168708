"""What is kept of a game of carom: as a level, and against a crash."""

from __future__ import annotations

import msgspec

from game.scenes.carom.level import CaromContent
from game.scenes.carom.model import CaromModel


def content_of(model: CaromModel) -> CaromContent:
    """Game and table as they are; in the midst of a stroke, as they were before it."""
    white, yellow, red = model.frame.places
    return CaromContent(
        game=model.frame.game.kind, players=model.content.players, white=white, yellow=yellow, red=red,
        practice=len(model.frame.game.players) == 1, saved=msgspec.to_builtins(model.frame.game),
    )  # fmt: skip


def worth_keeping(model: CaromModel, plays_itself: bool) -> object:
    """Game and places once something has been done; else None."""
    frame = model.frame
    if plays_itself or frame.earlier is None:
        return None
    return frame.game, frame.places
