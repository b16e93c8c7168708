"""Chances of races, and the head start that makes one even.

A race to n is won by the player that wins n games first. Let p be the chance to win each of them (Bradley,
Terry 1952), and a and b the games still needed. The chance to be first is a sum of negative binomial terms:

    P = sum over k = 0 .. b - 1 of C(a - 1 + k, k) p^a (1 - p)^k
"""

from __future__ import annotations

import math

HALVINGS = 60


def race_chance(chance: float, mine: int, theirs: int) -> float:
    """Chance to win `mine` games before the other wins `theirs`, each game with a chance.

    ValueError for a chance outside 0 to 1, or a player that needs no game.
    """
    if not 0.0 <= chance <= 1.0:
        raise ValueError(f"chance: {chance} is none")
    if mine < 1 or theirs < 1:
        raise ValueError(f"race: {mine} and {theirs} games needed: expected 1 or more")
    term = 1.0
    for _ in range(mine):
        term *= chance
    total = 0.0
    for k in range(theirs):
        total += term
        term *= (1.0 - chance) * (mine + k) / (k + 1)
    return min(total, 1.0)


def fair_start(chance: float, race: int) -> int:
    """Games that the first player is given in a race so that it is as even as can be; below 0: the second.

    chance: of the first player to win a game. ValueError for a race to less than 1.
    """
    starts = range(1 - race, race)

    def unfair(start: int) -> tuple[float, int]:
        mine, theirs = race - max(start, 0), race - max(-start, 0)
        return abs(race_chance(chance, mine, theirs) - 0.5), abs(start)

    return min(starts, key=unfair)


def point_chance(game: float, target: int) -> float:
    """Chance of a point with which a race to `target` points is won with the chance of a whole game.

    ValueError as `race_chance`.
    """
    low, high = 0.0, 1.0
    for _ in range(HALVINGS):
        half = 0.5 * (low + high)
        low, high = (half, high) if race_chance(half, target, target) < game else (low, half)
    return 0.5 * (low + high)


def needed_of_best(best_of: int) -> int:
    """Frames that win a match of the best of so many. ValueError for an even number."""
    if best_of < 1 or best_of % 2 == 0:
        raise ValueError(f"best of {best_of}: expected an odd number")
    return math.floor(best_of / 2) + 1
