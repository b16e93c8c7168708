"""The games that can be played on the table, one module each."""

from __future__ import annotations

from game.billiards.game.games.combination import CombinationMatch
from game.billiards.game.games.drill import Drill
from game.billiards.game.games.eight_ball import EightBall
from game.billiards.game.games.nine_ball import NineBall
from game.billiards.game.games.practice import Practice

AnyGame = EightBall | NineBall | CombinationMatch | Practice | Drill  # for msgspec, which reads it by its tag

GAMES = {
    "eight-ball": EightBall,
    "nine-ball": NineBall,
    "combination": CombinationMatch,
    "practice": Practice,
    "drill": Drill,
}

__all__ = [
    "GAMES", "AnyGame", "CombinationMatch", "Drill", "EightBall", "NineBall", "Practice",
]  # fmt: skip
