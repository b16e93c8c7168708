"""Rain and spray: drops in the wind, in places beside the boat."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementwise, linear
from game.worlds.world import Member

DX, DY, DZ, DVX, DVY, DVZ, DAGE, DSIZE = range(8)  # columns of a drop: m, m/s, s, m
MOST_SPRAY, MOST_RAIN = 1200, 700
PER_JOULE, MOST_OF_ONE, JET = 0.6, 40, 3.4  # drops; times the blow's speed that a jet has (Wagner 1932)
RAIN_FALLS = 8.0  # m/s, of drops of 3 mm (Gunn and Kinzer 1949)
SPRAY_FALLS = 5.0  # m/s, of drops of 1.5 mm (the same)
BOX = np.array(((-22.0, -0.5, -8.0), (22.0, 15.0, 34.0)))  # m in which it rains
HARD = 50.0  # mm/h of rain in which all drops fall


def blown(velocities: Floats, wind: tuple[float, float], falls: float, gravity: float, dt: float) -> Floats:
    """Velocities (n, 3) a step later: quadratic drag towards the wind (m/s along x, z), so that a drop falls
    at ``falls`` m/s where nothing else moves it.
    """
    off = np.array((wind[0], 0.0, wind[1])) - velocities
    rate = gravity / (falls * falls) * np.sqrt(np.sum(off * off, axis=1))[:, None]
    share = rate * dt / (1.0 + rate * dt)
    found = velocities + share * off
    found[:, 1] -= gravity * dt / (1.0 + rate[:, 0] * dt)
    return np.asarray(found)


class Rain(Member):
    """``drops`` (MOST_RAIN, 6): place from the boat and velocity, m, m/s; ``falling``: how many of them."""

    kept = ("drops",)

    def __init__(self, seed: int):
        random = np.random.default_rng((seed, 31))
        self.drops: Floats = np.zeros((MOST_RAIN, 6))
        self.drops[:, :3] = linear.uniform(random, BOX[0], BOX[1], (MOST_RAIN, 3))
        self.drops[:, 4] = -RAIN_FALLS
        self.falling = 0

    def go(self, hard: float, wind: tuple[float, float], speed: float, gravity: float, dt: float) -> None:
        """Fall for dt (s), ``hard`` mm/h of it, beside a boat at a speed (m/s)."""
        self.falling = min(int(MOST_RAIN * hard / HARD), MOST_RAIN)
        if not self.falling:
            return
        self.drops[:, 3:] = blown(self.drops[:, 3:], wind, RAIN_FALLS, gravity, dt)
        self.drops[:, :3] += dt * (self.drops[:, 3:] - (speed, 0.0, 0.0))
        size = BOX[1] - BOX[0]
        self.drops[:, :3] = BOX[0] + np.remainder(self.drops[:, :3] - BOX[0], size)

    def slant(self) -> float:
        """° from the upright at which it falls, to where the wind blows; NaN: there is none."""
        if not self.falling:
            return math.nan
        vx, vy, vz = self.drops[: self.falling, 3:].mean(axis=0).tolist()
        return math.degrees(float(elementwise.arctan2(math.sqrt(vx * vx + vz * vz), -vy)))


class Spray(Member):
    """``drops`` (n, 8), see DX; ``flung``: how many there were."""

    kept = ("drops", "flung")

    def __init__(self) -> None:
        self.drops: Floats = np.zeros((0, 8))
        self.flung: Floats = np.zeros(2)

    def fling(self, places: Floats, breadths: Floats, energies: Floats, fast: Floats, random: Any) -> None:
        """Drops where sections (n, 3) m were struck with energies (n,) J, as fast (n,) m/s."""
        counts = np.minimum(PER_JOULE * energies + random.random(len(energies)), MOST_OF_ONE).astype(np.int64)
        k = np.repeat(np.arange(len(counts)), counts)
        if not len(k):
            return
        many = len(k)
        side = np.where(random.random(many) < 0.5, -1.0, 1.0)
        drops = np.zeros((many, 8))
        drops[:, :3] = places[k] + linear.uniform(random, -0.15, 0.15, (many, 3))
        drops[:, DZ] += 0.5 * side * breadths[k]
        pace = fast[k] * linear.uniform(random, 0.8, JET, many)
        drops[:, DVX] = linear.uniform(random, -0.1, 0.6, many) * pace
        drops[:, DVY] = linear.uniform(random, 0.5, 1.3, many) * pace
        drops[:, DVZ] = side * linear.uniform(random, 0.2, 0.8, many) * pace
        drops[:, DSIZE] = linear.uniform(random, 0.012, 0.045, many)
        self.drops = np.concatenate([self.drops, drops])[-MOST_SPRAY:]
        self.flung[0] += many

    def go(self, wind: tuple[float, float], speed: float, gravity: float, dt: float) -> None:
        """Fly for dt (s) beside a boat at a speed (m/s)."""
        rows = self.drops
        if len(rows):
            rows[:, DVX : DVZ + 1] = blown(rows[:, DVX : DVZ + 1], wind, SPRAY_FALLS, gravity, dt)
            rows[:, :3] += dt * (rows[:, 3:6] - (speed, 0.0, 0.0))
            rows[:, DAGE] += dt

    def land(self, levels: Floats) -> None:
        """Drops under levels (n,) m are water again."""
        self.drops = self.drops[(self.drops[:, DY] > levels) | (self.drops[:, DAGE] < 0.15)]
