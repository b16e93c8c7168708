"""Dust: puffs that spring up where something strikes, slow down in the air, spread, settle.

Their velocity goes over to that of the air at a rate, implicitly. A puff grows as the square root of its age,
as what mixes does. They show the dust; where its mass counts, it is elsewhere.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.kernels import linear
from game.worlds.world import Member

# of a puff: place m, velocity m/s, age and life s, radius m
DX, DY, DVX, DVY, AGE, LIFE, SIZE = range(7)
PLACE, VELOCITY, DUST_WIDTH = slice(DX, DY + 1), slice(DVX, DVY + 1), 7
MOST = 900
DRAG = 1.1  # 1/s
SINK = 0.12  # m/s


def puffs(places: Floats, speeds: Floats, size: float, life: float, random: np.random.Generator) -> Floats:
    """New ones at places (n, 2) m with velocities (n, 2) m/s, each a little different."""
    count = len(places)
    found = np.zeros((count, DUST_WIDTH))
    found[:, PLACE] = places
    found[:, VELOCITY] = speeds * linear.uniform(random, 0.3, 1.0, (count, 1)) + linear.uniform(
        random, -0.6, 0.6, (count, 2)
    )
    found[:, LIFE] = life * linear.uniform(random, 0.6, 1.3, count)
    found[:, SIZE] = size * linear.uniform(random, 0.6, 1.5, count)
    return found


class Dusty(NamedTuple):
    """How blows raise dust. each: N s for a puff; most: of one blow; quick: m/s of the quickest; size: m;
    life: s.
    """

    each: float
    most: int
    quick: float
    size: float
    life: float


def advance_dust(dust: Floats, dt: float, wind: Callable[[Floats], Floats] | None = None) -> Floats:
    """All of them a step later; those that have settled are gone, and the oldest if there are too many.

    wind: velocity (n, 2) m/s of the air at places (n, 2) m.
    """
    if not len(dust):
        return dust
    now = dust.copy()
    if wind is not None:
        now[:, VELOCITY] += DRAG * dt * wind(dust[:, PLACE])
    now[:, VELOCITY] /= 1.0 + DRAG * dt
    now[:, DVY] -= DRAG * SINK * dt
    now[:, PLACE] += dt * now[:, VELOCITY]
    now[:, DY] = np.maximum(now[:, DY], 0.3)
    now[:, AGE] += dt
    return now[now[:, AGE] < now[:, LIFE]][-MOST:]


class Dust(Member):
    """``rows`` (n, DUST_WIDTH) of puffs."""

    kept = ("rows",)

    def __init__(self) -> None:
        self.rows: Floats = np.zeros((0, DUST_WIDTH))

    def add(
        self, places: Floats, speeds: Floats, size: float, life: float, random: np.random.Generator
    ) -> None:
        """New ones, see `puffs`."""
        self.rows = np.concatenate([self.rows, puffs(places, speeds, size, life, random)])

    def rise(self, blows: Floats, up: Any, dusty: Dusty, random: np.random.Generator) -> None:
        """What strikes hard raises dust, the more the greater its impulse; where ``up`` it goes upwards.

        blows (n, 4 or more): place m, impulse N s, speed m/s of each, as `impacts` finds them; up: (n,).
        """
        counts = np.minimum(blows[:, 2] / dusty.each, dusty.most).astype(np.int64)
        rows, rises = np.repeat(blows, counts, axis=0), np.repeat(up, counts)
        aim = linear.uniform(random, -1.0, 1.0, (len(rows), 2)) * np.minimum(rows[:, 3:4], dusty.quick)
        aim[:, 1] = np.where(rises, np.abs(aim[:, 1]), 0.5 * aim[:, 1])
        if len(rows):
            self.add(rows[:, :2] + 0.1 * aim, aim, dusty.size, dusty.life, random)


def as_seen(dust: Floats) -> tuple[Floats, Floats, Floats]:
    """Of puffs (n, DUST_WIDTH): places (n, 2) m, shares of their life that are over and radii m, (n,)."""
    radii = dust[:, SIZE] * (0.6 + 1.5 * np.sqrt(dust[:, AGE]))
    return dust[:, PLACE], dust[:, AGE] / dust[:, LIFE], radii
