"""Why a stroke failed: the table is asked once more with one of its parts put right, the others as they were.

Where a hand strayed from what was meant, and the meant stroke works, right is what was meant. Else it is the
smallest change that works.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.game.arrangement import Stroke
from game.billiards.search.strokes import (
    AZIMUTH,
    LARGEST_TIP,
    LEAST_SPEED,
    SPEED,
    TIP_LEFT,
    TIP_UP,
    Noise,
)
from game.physics.kernels import elementwise

AIM, PACE, SPIN, THROW = CAUSES = ("aim", "speed", "spin", "throw")
PARTS = {AIM: (AZIMUTH,), PACE: (SPEED,), SPIN: (TIP_LEFT, TIP_UP)}  # columns of a stroke
TURNS: Floats = math.radians(0.02) * elementwise.power(1.22, np.arange(31.0))  # rad, up to 8 degrees
PACES: Floats = 0.03 * np.arange(1.0, 17.0)  # shares of the speed
SPINS: Floats = 0.04 * np.arange(1.0, 16.0)  # ball radii

Works = Callable[[Floats], NDArray[np.bool_]]  # which of strokes (m, 5) do what was wanted (m,)


class Hand(NamedTuple):
    """How a hand strays, and the radius of the ball it strikes, m."""

    noise: Noise
    radius: float


class Cause(NamedTuple):
    """A part of a stroke that, put right alone, lets it work: its name, of CAUSES.

    change: what is to be added: rad to the left, m/s of the cue, or ball radii, to the left or up. It is 0 of
    throw. up: of spin, whether the change is up. size: times the noise of the hand.
    """

    name: str
    change: float
    size: float
    up: bool = False


def causes_of(works: Works, meant: Stroke, done: Stroke, hand: Hand) -> tuple[bool, tuple[Cause, ...]]:
    """Whether the hand strayed from a stroke that works, and why the one that was done does not; the smallest
    cause first.
    """
    strayed = meant != done and bool(works(rows([meant]))[0])
    found = _put_back(works, meant, done, hand) if strayed else ()
    found = found or _changed(works, done, hand)
    return strayed, tuple(sorted(found, key=lambda one: one.size))


def rows(strokes: list[Stroke]) -> Floats:
    """Strokes as an array (m, 5)."""
    return np.array(strokes, dtype=np.float64)


def changed(stroke: Stroke, column: int, changes: Floats) -> Floats:
    """The stroke (m, 5) with one of its numbers changed by each of (m,)."""
    strokes = np.repeat(rows([stroke]), len(changes), axis=0)
    strokes[:, column] += changes
    return strokes


def _put_back(works: Works, meant: Stroke, done: Stroke, hand: Hand) -> tuple[Cause, ...]:
    """Parts with which it works as soon as they are what was meant, the others as the hand did them."""
    found = []
    for name, columns in PARTS.items():
        stroke = list(done)
        for column in columns:
            stroke[column] = meant[column]
        if works(rows([Stroke(*stroke)]))[0]:
            column = max(columns, key=lambda one: abs(meant[one] - done[one]))
            found.append(_cause(name, column, meant[column] - done[column], hand))
    return tuple(found)


def _changed(works: Works, done: Stroke, hand: Hand) -> tuple[Cause, ...]:
    """The smallest change of each part with which it works."""
    found = []
    for name, columns in PARTS.items():
        causes = []
        for column in columns:
            steps = {AIM: TURNS, PACE: PACES * done.cue_speed, SPIN: SPINS}[name]
            changes = np.stack([steps, -steps], axis=1).ravel()
            strokes = changed(done, column, changes)
            able = strokes[:, SPEED] > LEAST_SPEED
            tips = strokes[:, TIP_LEFT : TIP_UP + 1]
            able &= (tips * tips).sum(axis=1) < LARGEST_TIP * LARGEST_TIP
            strokes, changes = strokes[able], changes[able]
            good = np.flatnonzero(works(strokes)).tolist() if len(strokes) else []
            if good:
                causes.append(_cause(name, column, float(changes[good[0]]), hand))
        found += sorted(causes, key=lambda one: one.size)[:1]
    return tuple(found)


def _cause(name: str, column: int, change: float, hand: Hand) -> Cause:
    noise = hand.noise
    sigma = {AIM: noise.azimuth, PACE: noise.speed, SPIN: noise.tip / hand.radius}[name]
    if name == AIM:
        change = math.remainder(change, math.tau)
    return Cause(name, change, abs(change) / max(sigma, 1e-12), column == TIP_UP)
