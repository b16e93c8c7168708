"""How much of a stroke is shown before it is played: its whole path, that to the first ball, or nothing."""

from __future__ import annotations

from game.billiards.game.games import Drill, Practice, RunDrill
from game.billiards.game.rules import Game
from game.scenes.shared.tables.choices import FIRST, GUIDES, WHOLE


def guide_of(chosen: str, game: Game) -> str:
    """One of GUIDES: the one chosen, or for "auto" the one that suits a game."""
    if chosen in GUIDES:
        return chosen
    return WHOLE if isinstance(game, (Practice, Drill, RunDrill)) else FIRST
