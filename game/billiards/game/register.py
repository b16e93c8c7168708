"""The register of the games that two players play against each other, for all that lists or strings them.

A game is found here by its name, with the scene and the level that begin it. All their states answer alike
how a frame stands: see `Contest`.
"""

from __future__ import annotations

from typing import Literal, NamedTuple, Protocol

Family = Literal["billiards", "carom", "snooker"]  # the scene, too
Unit = Literal["rack", "game", "frame"]


class Contest(Protocol):
    """What every registered game's state answers, whatever its rules.

    over: the rack, game or frame has ended; winner: of it, by number, None too if it is drawn. won: racks,
    games or frames of each player so far.
    """

    @property
    def players(self) -> tuple[str, ...]:
        """Names, the first breaks first."""

    @property
    def turn(self) -> int:
        """Who plays, by number."""

    @property
    def over(self) -> bool:
        """True if the rack, game or frame has ended."""

    @property
    def winner(self) -> int | None:
        """Who has won it."""

    @property
    def won(self) -> tuple[int, ...]:
        """What each player has won so far."""


class Registered(NamedTuple):
    """One game. name: as level files say it in ``[content]``, ``game``; title: for people.

    family: the scene that plays it. level: stem of its level in ``levels/<family>``. unit: what is won. won:
    how, in words.
    """

    name: str
    title: str
    family: Family
    level: str
    unit: Unit
    won: str


REGISTER: dict[str, Registered] = {
    entry.name: entry
    for entry in (
        Registered("eight-ball", "8-ball", "billiards", "called-pockets", "rack", "the 8 after one's group"),
        Registered("nine-ball", "9-ball", "billiards", "nine-ball", "rack", "the 9, the lowest hit first"),
        Registered(
            "ten-ball", "10-ball", "billiards", "ten-ball", "rack", "the 10 as called, the lowest hit first"
        ),
        Registered("straight-pool", "Straight pool", "billiards", "straight-pool", "game", "points"),
        Registered("straight-rail", "Straight rail", "carom", "straight-rail", "game", "points"),
        Registered("one-cushion", "One-cushion", "carom", "one-cushion", "game", "points"),
        Registered("three-cushion", "Three-cushion", "carom", "default", "game", "points"),
        Registered("balkline-47-2", "Balkline 47/2", "carom", "balkline-47-2", "game", "points"),
        Registered("balkline-47-1", "Balkline 47/1", "carom", "balkline-47-1", "game", "points"),
        Registered("balkline-71-2", "Balkline 71/2", "carom", "balkline-71-2", "game", "points"),
        Registered("artistic", "Artistic billiards", "carom", "artistic", "game", "points of figures"),
        Registered("snooker", "Snooker", "snooker", "default", "frame", "more points"),
        Registered("six-red", "Six-red snooker", "snooker", "six-red", "frame", "more points"),
    )
}


def games_of(family: Family) -> tuple[Registered, ...]:
    """The games that a scene plays, in the order of the register."""
    return tuple(entry for entry in REGISTER.values() if entry.family == family)
