"""Ratings on FargoRate's scale, from games won and lost: a player that is 100 points ahead wins two of three.

The chance of a player rated r against one rated s is

    p = 1 / (1 + 2^((s - r) / 100))

(Bradley, Terry 1952; Elo 1978 with another base). The scale has no zero of its own: `bradley_terry` puts the
mean of all players at a given rating. `rating_against` adds half a game won and half a game lost against the
mean opponent, so that it is finite, and with one opponent equal to `rating.rating_of` (Haldane, Anscombe
1956). Errors are standard errors by Fisher's information.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from game.billiards.game.rating import HALF, POINTS, Rating
from game.physics.kernels import elementary, linear

SCALE = POINTS / elementary.log(2.0)  # points of a natural unit
ROUNDS = 200  # of Newton's method; it ends by itself
CLOSE = 1e-9  # points


class Series(NamedTuple):
    """Games against an opponent of a rating: won and lost."""

    rating: float
    won: float
    lost: float


def chance_of(ahead: float) -> float:
    """Chance to win a game for a player that is so many points ahead."""
    return 1.0 / (1.0 + elementary.exp(-ahead / SCALE))


def rating_against(games: Sequence[Series]) -> Rating | None:
    """The rating of a player by games against rated opponents; None without any. ValueError below 0 games."""
    if any(one.won < 0 or one.lost < 0 for one in games):
        raise ValueError("rating: fewer games than none")
    played = sum(one.won + one.lost for one in games)
    if played <= 0:
        return None
    middle = sum(one.rating * (one.won + one.lost) for one in games) / played
    every = [*games, Series(middle, HALF, HALF)]
    low, high = min(one.rating for one in every) - 4000.0, max(one.rating for one in every) + 4000.0
    while high - low > CLOSE:
        half = 0.5 * (low + high)
        if half in (low, high):
            break
        won = sum(one.won - (one.won + one.lost) * chance_of(half - one.rating) for one in every)
        low, high = (half, high) if won > 0.0 else (low, half)
    rating = 0.5 * (low + high)
    known = sum((one.won + one.lost) * (p := chance_of(rating - one.rating)) * (1.0 - p) for one in every)
    return Rating(rating, SCALE / math.sqrt(known))


def bradley_terry(won: Mapping[tuple[str, str], int], mean: float) -> dict[str, Rating]:
    """Ratings of all players by Newton's method. won[a, b]: games that a has won against b.

    mean: of all ratings. Each pair that has met is given half a game more on both sides, so that no player is
    infinitely strong. ValueError if the players fall into parts that never met.
    """
    names = sorted({name for pair in won for name in pair})
    count = len(names)
    if not count:
        return {}
    games = np.zeros((count, count))
    for (a, b), number in won.items():
        games[names.index(a), names.index(b)] += number
    met = (games + games.T) > 0.0
    _check_connected(met, names)
    games = games + HALF * met
    strengths = np.zeros(count)
    for _ in range(ROUNDS):
        slope, known = _slopes(games, strengths)
        change = np.array(linear.solve(known + 1.0, slope))
        strengths += np.clip(change, -1.0, 1.0)
        if float(np.abs(change).max()) * SCALE < CLOSE:
            break
    _, known = _slopes(games, strengths)
    strengths -= strengths.mean()
    # the mean is held: the information plus one in that direction, which is taken away again
    inverse = np.array([linear.solve(known + 1.0, row) for row in np.eye(count)]) - 1.0 / (count * count)
    return {
        name: Rating(mean + SCALE * float(strengths[k]), SCALE * math.sqrt(max(float(inverse[k, k]), 0.0)))
        for k, name in enumerate(names)
    }


def _slopes(games: np.ndarray, strengths: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Slope of the logarithm of the likelihood (n,), and its information (n, n)."""
    both = games + games.T
    count = len(strengths)
    chances = np.array([[1.0 / (1.0 + elementary.exp(float(b - a))) for b in strengths] for a in strengths])
    slope = (games - both * chances).sum(axis=1)
    weights = both * chances * (1.0 - chances)
    known = -weights
    known[np.arange(count), np.arange(count)] += weights.sum(axis=1)
    return slope, known


def _check_connected(met: np.ndarray, names: Sequence[str]) -> None:
    """ValueError if not all have met, by way of others."""
    reached, grown = {0} if names else set(), True
    while grown:
        more = {int(j) for i in reached for j in np.flatnonzero(met[i])}
        grown = not more <= reached
        reached |= more
    if len(reached) < len(names):
        raise ValueError(
            f"ratings: {names[min(set(range(len(names))) - reached)]} has met none of the others"
        )
