"""How matches of a career are played: their length, a fair head start, opponents, and tournaments."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import msgspec
import numpy as np

from game.billiards.career.bracket import EIGHT, FOUR, draw, play_on
from game.billiards.career.career import CupResult, Match, Player, Result, RunningCup, rating_of, strength_of
from game.billiards.career.handicap import fair_start, needed_of_best, point_chance, race_chance
from game.billiards.career.prizes import with_prizes
from game.billiards.game.register import REGISTER, Registered
from game.billiards.game.strengths import chance_of
from game.billiards.players.ladder import LadderPlayer, ladder_of

WON = 3  # of `CupResult.reached`
FRAMES, RACKS, POINTS = 3, 3, 10  # of a match
SHORT_POINTS = 3  # of a match of the newcomers' cup, which else is one rack or frame
# Games of an hour and more have a shorter one in their place in the newcomers' cup.
SHORTER = {
    "snooker": "six-red", "straight-pool": "nine-ball", "artistic": "straight-rail",
    "balkline-47-1": "straight-rail", "balkline-47-2": "straight-rail", "balkline-71-2": "straight-rail",
    "three-cushion": "one-cushion",
}  # fmt: skip


class Length(NamedTuple):
    """How long a match is. parameter, value: of the scene; needed: racks or frames that win it, 1 for one
    game; points: of that game, 0 if it sets them itself.
    """

    parameter: str
    value: object
    needed: int
    points: int = 0


def length_of(entry: Registered, short: bool = False) -> Length:
    """How long a match of a game is; short: one of the newcomers' cup."""
    if entry.unit == "rack":
        return Length("race", "1", 1) if short else Length("race", str(RACKS), RACKS)
    if entry.unit == "frame":
        frames = 1 if short else FRAMES
        return Length("best_of", str(frames), needed_of_best(frames))
    if entry.family == "carom":
        points = SHORT_POINTS if short else POINTS
        return Length("target", float(points), 1, points)
    return Length("race", "1", 1)


def own_strength(player: Player, game: str) -> float:
    """A person's rating in a game's family, else in all games, else that of a beginner."""
    rating = rating_of(player, REGISTER[game].family) or rating_of(player)
    return beginners_strength(game) if rating is None else rating.points


def beginners_strength(game: str) -> float:
    """The rating of who has none yet: as measured, that of the ladder's weakest at a game."""
    return min(_strengths_of(ladder_of(REGISTER[game].family), game).values())


def _strengths_of(players: Iterable[LadderPlayer], game: str) -> dict[str, float]:
    """Measured ratings by name."""
    found = {one.name: strength_of(one.name, game) for one in players}
    return {name: points for name, points in found.items() if points is not None}


def fair_head_start(player: Player, opponent: str, game: str, short: bool = False) -> int:
    """Racks, frames or points that the person is given so that the match is even; below 0 the opponent.
    short: as of `length_of`.
    """
    length = length_of(REGISTER[game], short)
    other = strength_of(opponent, game)
    if other is None or (length.needed == 1 and not length.points):
        return 0
    chance = chance_of(own_strength(player, game) - other)
    if length.points:
        return fair_start(point_chance(chance, length.points), length.points)
    return fair_start(chance, length.needed)


def opponents_at(game: str) -> tuple[LadderPlayer, ...]:
    """Who of the ladder plays a game, the weakest first as measured."""
    found = ladder_of(REGISTER[game].family)
    return tuple(sorted(found, key=lambda one: strength_of(one.name, game) or 0.0))


def next_opponent(player: Player, game: str) -> LadderPlayer:
    """The weakest of the ladder that the person has not beaten without being given a start; else the last."""
    beaten = {
        one.match.opponent for one in player.results
        if one.victory and one.match.game == game and one.match.head_start <= 0
    }  # fmt: skip
    ladder = opponents_at(game)
    return next((one for one in ladder if one.name not in beaten), ladder[-1])


# -- tournaments ------------------------------------------------------------------------------------


def is_newcomer(player: Player) -> bool:
    """Whether a person has won no cup yet: the newcomers' cup is then offered first."""
    return not any(cup.reached == WON for cup in player.cups)


def new_cup(player: Player, game: str, seed: int, newcomers: bool = False) -> Player:
    """A tournament begins: the person, and the seven strongest of the ladder. The newcomers' cup has its
    three weakest, short matches, and a shorter game if need be. ValueError while one goes on.
    """
    if player.cup is not None:
        raise ValueError("tournament: one goes on")
    game = SHORTER.get(game, game) if newcomers else game
    ladder = opponents_at(game)
    others = ladder[: FOUR - 1] if newcomers else ladder[1 - EIGHT :]
    field = {**_strengths_of(others, game), player.name: own_strength(player, game)}
    begun = RunningCup(game, draw(field), seed, newcomers=newcomers)
    return _played_on(player.replace(cup=begun))


def cup_match(player: Player) -> Match | None:
    """The person's next match of the running tournament; None if there is none."""
    if player.cup is None or player.cup.knockout.next_pair is None:
        return None
    pair = player.cup.knockout.next_pair
    if player.name not in pair:
        return None
    other = pair[1] if pair[0] == player.name else pair[0]
    cup = player.cup
    start = fair_head_start(player, other, cup.game, cup.newcomers) if cup.fair else 0
    return Match(player.cup.game, other, start, cup=True)


def _played_on(player: Player) -> Player:
    """The matches of others are played until the person is at turn, or the tournament has ended."""
    cup = player.cup
    assert cup is not None
    entry = REGISTER[cup.game]
    needed = length_of(entry, cup.newcomers).needed
    points = _strengths_of(ladder_of(entry.family), cup.game)

    def decide(a: str, b: str, match: int) -> str:
        chance = race_chance(chance_of(points[a] - points[b]), needed, needed)
        return a if np.random.default_rng((cup.seed, match)).random() < chance else b

    knockout = play_on(cup.knockout, player.name, decide)
    return player.replace(cup=msgspec.structs.replace(cup, knockout=knockout))


def with_result(player: Player, result: Result) -> Player:
    """A match has ended: kept with what it unlocks, and the tournament goes on if it was one of it."""
    return with_prizes(_with_result(player, result))


def _with_result(player: Player, result: Result) -> Player:
    after = player.replace(results=(*player.results, result), pending=None)
    if not result.match.cup or after.cup is None or cup_match(after) is None:
        return after
    winner = player.name if result.victory else result.match.opponent
    cup = after.cup
    knockout = cup.knockout.with_winner(winner)
    after = _played_on(after.replace(cup=msgspec.structs.replace(cup, knockout=knockout)))
    assert after.cup is not None
    if after.cup.knockout.champion:
        reached = after.cup.knockout.reached(player.name)
        ended = CupResult(cup.game, result.when, reached, cup.newcomers)
        after = after.replace(cup=None, cups=(*after.cups, ended))
    return after
