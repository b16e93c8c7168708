"""How a match stands that a person plays against a computer player, to be kept with its career."""

from __future__ import annotations

from typing import NamedTuple


class Contested(NamedTuple):
    """A match between two players.

    game: as of the register of games. person: name of the person, who is the first player; opponent: the
    second, as the parameter says it. head_start: of the first, below 0 of the second. won: racks, frames or
    games that both have really won. over: the match has ended. victory: the person has won it. highest: the
    person's highest break or run so far. strokes: that have been played to their end.
    """

    game: str
    person: str
    opponent: str
    head_start: int
    won: tuple[int, int]
    over: bool
    victory: bool
    highest: int
    strokes: int = 0


class StrokeMeasured(NamedTuple):
    """The last stroke of a person: of which kind, and what was measured of it; see `career.strokes`."""

    opening: bool
    distance: float
    cut: float
    made: bool
    chance: float
    stray: float | None
    speed: float
