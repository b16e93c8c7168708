"""What a career unlocks: colours of the cloth for matches and cups, tables for the ladder and for breaks.

A prize is an option of a parameter. The start card offers it once it is won. It stays won
whatever becomes of the results that led to it: `Player.unlocked` keeps its name.
"""

from __future__ import annotations

from typing import Literal, NamedTuple

from game.billiards.career.career import Player, family_of

Kind = Literal["match", "ladder", "break", "cup"]
REACHED_FINAL, WON_CUP = 2, 3


class Prize(NamedTuple):
    """One of them. parameter, value: the option that it unlocks. families: whose tables have it.

    kind, needed: matches won; players of the ladder beaten without a start; points of a break; round of a
    cup of eight.
    """

    name: str
    title: str
    parameter: str
    value: str
    families: tuple[str, ...]
    kind: Kind
    needed: int
    words: str


ALL = ("billiards", "carom", "snooker")
PRIZES = (
    Prize("blue cloth", "Blue cloth", "felt", "blue", ("billiards", "snooker"), "match", 1, "win a match"),
    Prize("fast pool", "Fast pool cloth", "table", "fast", ("billiards",), "ladder", 2,
          "beat two of the pool ladder without a start"),
    Prize("fast snooker", "Fast snooker cloth", "table", "fast", ("snooker",), "break", 20,
          "make a break of 20"),
    Prize("olive cloth", "Olive cloth", "felt", "olive", ALL, "cup", REACHED_FINAL, "reach a final"),
    Prize("tight pool", "Tight pool pockets", "table", "tight", ("billiards",), "ladder", 5,
          "beat five of the pool ladder without a start"),
    Prize("tight snooker", "Tight snooker pockets", "table", "tight", ("snooker",), "break", 50,
          "make a break of 50"),
    Prize("slate cloth", "Slate cloth", "felt", "slate", ALL, "cup", WON_CUP, "win a tournament"),
)  # fmt: skip


def progress(player: Player, prize: Prize) -> int:
    """How far a person has come on the way to a prize: it is won at `prize.needed`."""
    if prize.kind == "match":
        return sum(one.victory for one in player.results)
    if prize.kind == "cup":
        return max((cup.reached for cup in player.cups if not cup.newcomers), default=0)
    own = [one for one in player.results if family_of(one) in prize.families]
    if prize.kind == "break":
        return max((one.highest for one in own), default=0)
    return len({one.match.opponent for one in own if one.victory and one.match.head_start <= 0})


def unlocked_of(player: Player | None) -> frozenset[str]:
    """Names of the prizes that a person has: kept ones, and those that the results are worth."""
    if player is None:
        return frozenset()
    earned = (one.name for one in PRIZES if progress(player, one) >= one.needed)
    return frozenset((*player.unlocked, *earned))


def with_prizes(player: Player) -> Player:
    """The person with all prizes kept that have been won."""
    won = unlocked_of(player)
    return player.replace(unlocked=tuple(sorted(won)))


def next_prize(player: Player) -> Prize | None:
    """The first prize, in their order, that a person has not won; None if there is no more."""
    won = unlocked_of(player)
    return next((one for one in PRIZES if one.name not in won), None)


def locked(player: Player | None, family: str) -> dict[tuple[str, str], Prize]:
    """Options (parameter, value) that a family's tables do not offer a person yet, and what unlocks each."""
    won = unlocked_of(player)
    return {
        (one.parameter, one.value): one for one in PRIZES if family in one.families and one.name not in won
    }
