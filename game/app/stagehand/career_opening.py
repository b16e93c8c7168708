"""How a match of a career is begun at its table: with its names, its length and its head start."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

from game.app.stagehand.career_file import keep_career
from game.app.stagehand.opening import Opening
from game.billiards.career.career import Career, Match
from game.billiards.career.matches import length_of
from game.billiards.game.register import REGISTER
from game.billiards.players.ladder import BY_NAME
from game.levels import level_files


class Begun(NamedTuple):
    """A match that is about to be played. scene, opening: its table; complaint: why the career was not kept,
    empty if it was.
    """

    career: Career
    scene: str
    opening: Opening
    complaint: str


def begin_match(career: Career, match: Match, own: Mapping[str, str] | None = None) -> Begun:
    """Keep a match as the one that is played now, and say how its table is opened. ValueError without
    a player. own: parameters that the person has chosen, as of `start_choices.own_choices`.
    """
    player = career.player
    if player is None:
        raise ValueError("career: there is no player")
    career = career.with_player(player.replace(pending=match))
    complaint = keep_career(career)
    entry = REGISTER[match.game]
    short = match.cup and player.cup is not None and player.cup.newcomers
    length = length_of(entry, short)
    opponent = BY_NAME[match.opponent].title if match.opponent in BY_NAME else match.opponent
    parameters: dict[str, Any] = {
        **(own or {}), "first_player": "person", "second_player": match.opponent,
        "head_start": float(match.head_start), length.parameter: length.value,
    }  # fmt: skip
    level = next((path for path in level_files(entry.family) if path.stem == entry.level), None)
    cup = player.cup.knockout.round_name if match.cup and player.cup is not None else ""
    opening = Opening(level=level, parameters=parameters, players=(player.name, opponent), cup=cup)
    return Begun(career, entry.family, opening, complaint)
