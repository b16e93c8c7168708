"""How a match stands that a person plays against a computer player, to be kept with its career."""

from __future__ import annotations

from typing import NamedTuple


class HandMeasured(NamedTuple):
    """Standard deviations of a person's strokes from what was meant: azimuth rad, speed m/s; of how many."""

    azimuth: float
    speed: float
    strokes: int


class Contested(NamedTuple):
    """A match between two players.

    game: as of the register of games. person: name of the person, who is the first player; opponent: the
    second, as the parameter says it. head_start: of the first, below 0 of the second. won: racks, frames or
    games that both have really won. over: the match has ended. victory: the person has won it. highest: the
    person's highest break or run so far. strokes: that have been played to their end. hand: the person's,
    once the match is over; None if too few strokes strayed from what was meant.
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
    hand: HandMeasured | None = None


class StrokeMeasured(NamedTuple):
    """The last stroke of a person: of which kind, and what was measured of it; see `career.strokes`."""

    kind: str
    distance: float
    cut: float
    made: bool
    chance: float
    stray: float | None
    cushions: int
    speed: float
