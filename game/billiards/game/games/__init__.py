"""The games that can be played on the table, one module each."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from game.billiards.game.games.combination import CombinationMatch
from game.billiards.game.games.drill import Drill
from game.billiards.game.games.eight_ball import EightBall
from game.billiards.game.games.ghost import BALLS as GHOST_BALLS
from game.billiards.game.games.ghost import Ghost
from game.billiards.game.games.nine_ball import NineBall
from game.billiards.game.games.practice import Practice
from game.billiards.game.games.run_drill import RunDrill
from game.billiards.game.games.straight_pool import StraightPool
from game.billiards.game.games.ten_ball import TenBall

AnyGame = (
    EightBall | NineBall | TenBall | StraightPool | CombinationMatch | Practice | Drill | RunDrill | Ghost
)  # for msgspec, which reads it by its tag

GAMES: dict[str, Callable[..., AnyGame]] = {
    "eight-ball": EightBall,
    "nine-ball": NineBall,
    "ten-ball": TenBall,
    "straight-pool": StraightPool,
    "combination": CombinationMatch,
    "practice": Practice,
    "drill": Drill,
    "run-drill": RunDrill,
    **{
        f"ghost-{kind}": partial(Ghost, discipline=kind, on_table=balls)
        for kind, balls in GHOST_BALLS.items()
    },
}

__all__ = [
    "GAMES", "AnyGame", "CombinationMatch", "Drill", "EightBall", "Ghost", "NineBall", "Practice",
    "RunDrill", "StraightPool", "TenBall",
]  # fmt: skip
