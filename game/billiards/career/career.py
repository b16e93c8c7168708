"""What is kept of a player's career, and what follows from it: rating, records, what has been unlocked.

All of it is frozen structs of text and numbers. Every change makes a new career.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Annotated, Any, NamedTuple

import msgspec

from game.billiards.career.bracket import Knockout
from game.billiards.game.rating import Rating
from game.billiards.game.register import REGISTER
from game.billiards.game.strengths import Series, rating_against
from game.billiards.players.ladder import BY_NAME
from game.billiards.players.ladder_ratings import ladder_ratings

MOST_RESULTS = 5000
MOST_STROKES = 20_000
LONGEST_NAME = 16
Count = Annotated[int, msgspec.Meta(ge=0, le=10**6)]
Name = Annotated[str, msgspec.Meta(min_length=1, max_length=LONGEST_NAME)]
Word = Annotated[str, msgspec.Meta(max_length=40)]
Choices = Annotated[
    dict[Word, Annotated[dict[Word, Word], msgspec.Meta(max_length=40)]], msgspec.Meta(max_length=40)
]
When = Annotated[str, msgspec.Meta(pattern=r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d{1,6})?$")]


class Entry(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """Base of what is kept."""


class Match(Entry, frozen=True):
    """A match as it was agreed upon. game: of the register; opponent: of the ladder; cup: it is one of the
    running tournament. head_start: what the person begins with, below 0 the opponent.
    """

    game: Word
    opponent: Word
    head_start: int = 0
    cup: bool = False


class Result(Entry, frozen=True):
    """How a match ended. won, lost: racks, frames or games that were really played. highest: the person's
    highest break or longest run in it, 0 if the game counts none.
    """

    match: Match
    when: When
    won: Count
    lost: Count
    victory: bool
    highest: Count = 0


class CupResult(Entry, frozen=True):
    """How a tournament ended for the person. reached: 0 a quarter-final, to 3, the cup. newcomers: it was
    that of newcomers.
    """

    game: Word
    when: When
    reached: Annotated[int, msgspec.Meta(ge=0, le=3)]
    newcomers: bool = False


class RunningCup(Entry, frozen=True):
    """A tournament that goes on. seed: of the matches that others play. fair: its matches are played with
    fair head starts. newcomers: it is that of newcomers, of four and with short matches.
    """

    game: Word
    knockout: Knockout
    seed: Count
    fair: bool = False
    newcomers: bool = False


class Hand(Entry, frozen=True):
    """How far a person's strokes strayed from what was meant: standard deviations, rad, m/s; of how many."""

    azimuth: Annotated[float, msgspec.Meta(ge=0.0, le=4.0)]
    speed: Annotated[float, msgspec.Meta(ge=0.0, le=100.0)]
    strokes: Count


class Player(Entry, frozen=True):
    """One person's career. pending: the match that was begun last, until its result is in.
    unlocked: names of the prizes that were won. hand: as of the last match in which it was measured.
    choices: by scene and parameter, what the person has chosen for itself on the card before a game.
    """

    name: Name
    results: Annotated[tuple[Result, ...], msgspec.Meta(max_length=MOST_RESULTS)] = ()
    cups: Annotated[tuple[CupResult, ...], msgspec.Meta(max_length=MOST_RESULTS)] = ()
    cup: RunningCup | None = None
    pending: Match | None = None
    unlocked: Annotated[tuple[Word, ...], msgspec.Meta(max_length=100)] = ()
    hand: Hand | None = None
    choices: Choices = {}

    def replace(self, **changes: Any) -> Player:
        """The same with some fields changed."""
        return msgspec.structs.replace(self, **changes)


class Career(Entry, frozen=True):
    """All persons of this machine, and which of them plays now."""

    players: tuple[Player, ...] = ()
    current: Count = 0

    @property
    def player(self) -> Player | None:
        """Who plays now; None before anybody has a name."""
        return self.players[self.current] if self.current < len(self.players) else None

    def with_player(self, player: Player) -> Career:
        """With another state of the person who plays now. ValueError if none does."""
        if self.player is None:
            raise ValueError("career: there is no player")
        players = list(self.players)
        players[self.current] = player
        return Career(tuple(players), self.current)

    def named(self, name: str) -> Career:
        """With a person of a name at the table, a new one if there was none. ValueError for no name."""
        name = " ".join(name.split())[:LONGEST_NAME]
        if not name:
            raise ValueError("career: a name is needed")
        known = [player.name for player in self.players]
        if name in known:
            return Career(self.players, known.index(name))
        return Career((*self.players, Player(name)), len(self.players))

    def check(self) -> None:
        """ValueError for what contradicts itself."""
        names = [player.name for player in self.players]
        if len(set(names)) != len(names):
            raise ValueError("two players have one name")
        if self.players and self.current >= len(self.players):
            raise ValueError(f"current: there is no player {self.current}")


class Records(NamedTuple):
    """The best that was done: highest break or run by game, victories, best tournament (-1: none)."""

    highest: Mapping[str, int]
    played: int
    victories: int
    best_cup: int


def counted(results: Sequence[Result]) -> list[Series]:
    """Games that count for the rating, by opponents' ratings. A head start in points does not count."""
    found = []
    for one in results:
        entry = REGISTER.get(one.match.game)
        in_points = entry is not None and entry.unit == "game" and one.match.head_start != 0
        rating = strength_of(one.match.opponent, one.match.game)
        if entry is not None and rating is not None and not in_points:
            found.append(Series(rating, one.won, one.lost))
    return found


def strength_of(opponent: str, game: str) -> float | None:
    """The measured rating of a player of the ladder in a game's family; None for another player."""
    entry = REGISTER.get(game)
    if entry is None or opponent not in BY_NAME:
        return None
    found = ladder_ratings(entry.family).get(opponent) or ladder_ratings().get(opponent)
    return None if found is None else found.points


def rating_of(player: Player, family: str = "") -> Rating | None:
    """A person's rating by the games of a family, or by all; None before the first."""
    return rating_against(counted([one for one in player.results if family in ("", family_of(one))]))


def family_of(result: Result) -> str:
    """The family of a result's game; empty for a game that is not there any more."""
    entry = REGISTER.get(result.match.game)
    return "" if entry is None else entry.family


def rating_history(player: Player) -> list[Rating]:
    """The rating after each match that counted."""
    found = []
    games: list[Series] = []
    for one in player.results:
        more = counted([one])
        games += more
        rating = rating_against(games) if more else None
        if rating is not None:
            found.append(rating)
    return found


def records_of(player: Player) -> Records:
    """What a person has done best."""
    highest: dict[str, int] = {}
    for one in player.results:
        if one.highest > highest.get(one.match.game, 0):
            highest[one.match.game] = one.highest
    return Records(
        highest, len(player.results), sum(one.victory for one in player.results),
        max((cup.reached for cup in player.cups), default=-1),
    )  # fmt: skip
