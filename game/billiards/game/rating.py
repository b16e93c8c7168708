"""A rating from racks won and lost against the ghost.

    rating = 100 log2((won + 1/2) / (lost + 1/2))

A hundred points double the odds of winning a rack, as FargoRate has it; 0 is a player who wins every second
rack from the ghost. The halves keep it finite and nearly without bias for few racks (Haldane 1956, Anscombe
1956). Its standard error, by the same authors, is

    100 / ln 2 sqrt(1 / (won + 1/2) + 1 / (lost + 1/2))
"""

from __future__ import annotations

import math
from typing import NamedTuple

from game.physics.kernels import elementary

POINTS = 100.0  # that double the odds
HALF = 0.5


class Rating(NamedTuple):
    """Points, and their standard error."""

    points: float
    error: float


def rating_of(won: int, lost: int) -> Rating:
    """The rating of so many racks. ValueError for fewer than none."""
    if won < 0 or lost < 0:
        raise ValueError(f"rating: {won} won, {lost} lost: expected 0 or more")
    mine, theirs = won + HALF, lost + HALF
    return Rating(
        POINTS * elementary.log2(mine / theirs),
        POINTS / elementary.log(2.0) * math.sqrt(1.0 / mine + 1.0 / theirs),
    )
