"""All computer players of a family of games by name: the grades, and those of the ladder."""

from __future__ import annotations

from functools import cache
from typing import Any

from game.billiards.players.carom import CAROM_GRADES, CaromGrade
from game.billiards.players.ladder import CAROM, POOL, SNOOKER, LadderPlayer, ladder_of
from game.billiards.players.opponents import GRADES, Grade
from game.billiards.players.snooker import SNOOKER_GRADES, SnookerGrade


def _as(player: LadderPlayer, family: str, grade: Any) -> Any:
    """A grade's way of looking, with the player's own name, hand and taste."""
    return grade._replace(
        name=player.name, title=player.title, about=player.about, unsteady=player.unsteady_at(family),
        hand=player.hand, taste=player.taste,
    )  # fmt: skip


@cache
def pool_players() -> dict[str, Grade]:
    """All computer players of pool by name: grades, then the ladder."""
    own = {one.name: _as(one, POOL, GRADES[one.looks]) for one in ladder_of(POOL)}
    return GRADES | own


@cache
def snooker_players() -> dict[str, SnookerGrade]:
    """All computer players of snooker by name: grades, then the ladder."""
    own = {one.name: _as(one, SNOOKER, SNOOKER_GRADES[one.looks]) for one in ladder_of(SNOOKER)}
    return SNOOKER_GRADES | own


@cache
def carom_players() -> dict[str, CaromGrade]:
    """All computer players of carom by name: grades, then the ladder."""
    own = {one.name: _as(one, CAROM, CAROM_GRADES[one.looks]) for one in ladder_of(CAROM)}
    return CAROM_GRADES | own
