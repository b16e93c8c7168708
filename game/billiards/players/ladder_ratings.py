"""Ratings of the ladder, by the games that its players have played each other (assets/ladder.json).

The file holds counts and the command that made them; ratings are computed from it, on FargoRate's scale. All
players of the ladder are at 500 in the mean, for the scale has no zero of its own.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import NamedTuple

import msgspec

from game.billiards.game.rating import Rating
from game.billiards.game.strengths import bradley_terry
from game.files import read_text
from game.folders import data_folder

FILE_NAME = "ladder.json"
LARGEST_BYTES = 1 << 20
MEAN = 500.0  # points


class Count(NamedTuple):
    """Games of two players in a family of games: how many each has won."""

    family: str
    players: tuple[str, str]
    won: tuple[int, int]


class LadderGames(NamedTuple):
    """All counts, and the command that made them."""

    command: str
    counts: tuple[Count, ...]


class _File(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    command: str
    counts: tuple[Count, ...]


def read_games(path: Path) -> LadderGames:
    """The counts in a file. FileProblem or ValueError if it cannot be read."""
    found = msgspec.json.decode(read_text(path, LARGEST_BYTES), type=_File)
    return LadderGames(found.command, found.counts)


def ratings_of(counts: tuple[Count, ...], family: str = "") -> dict[str, Rating]:
    """Ratings by name from the games of a family, or of all. ValueError if not all are connected."""
    won: dict[tuple[str, str], int] = {}
    for one in counts:
        if family in ("", one.family):
            for pair, number in zip((one.players, one.players[::-1]), one.won, strict=True):
                won[pair] = won.get(pair, 0) + number
    return bradley_terry(won, MEAN)


@cache
def ladder_ratings(family: str = "") -> dict[str, Rating]:
    """Measured ratings of the ladder in a family of games, or in all of them together."""
    return ratings_of(read_games(data_folder("assets") / FILE_NAME).counts, family)
