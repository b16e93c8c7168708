"""Means of measured coefficients over a time, once the flow has settled: spread, drift, the wake's beat."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats

(TIME, COUNT, HALF_COUNT, LEVEL, LEVEL_COUNT, BEFORE, FIRST, LAST, BEATS) = range(9)
WALL, SQUARES, BOOK, HALF, LATER = 9, 12, 15, 18, 21  # three sums each
ROW = 24
STEADY = 0.005  # a spread of the lift below which it does not beat


class Mean(NamedTuple):
    """wall: mean of drag, lift and moment by pressure and friction; spread: their deviations in time;
    book: means by the momentum book; drift: half of how far the drag's mean of the first half of the time
    lies from that of the second; strouhal: beats of the lift, times chord over wind, 0 where fewer than two
    whole ones were seen, or it hardly swings; seconds: that were averaged.
    """

    wall: tuple[float, float, float]
    spread: tuple[float, float, float]
    book: tuple[float, float, float]
    drift: float
    strouhal: float
    seconds: float


class Average:
    """Sums over time. settle, window: s that are waited for, and that a whole measurement takes.

    ``row`` (ROW,) is all of its state.
    """

    def __init__(self, settle: float, window: float):
        self.row: Floats = np.zeros(ROW)
        self.settle, self.window = settle, window

    def clear(self) -> None:
        """Begin again."""
        self.row[:] = 0.0

    def take(self, reading: Floats, dt: float) -> None:
        """One more step of dt (s): reading (9,) as of `Tunnel`."""
        row = self.row
        row[TIME] += dt
        lift = float(reading[1] + reading[4])
        if row[TIME] <= self.settle:
            if row[TIME] > 0.5 * self.settle:
                row[LEVEL] += lift
                row[LEVEL_COUNT] += 1.0
            row[BEFORE] = lift
            return
        wall = reading[0:3] + reading[3:6]
        row[COUNT] += 1.0
        row[WALL : WALL + 3] += wall
        row[SQUARES : SQUARES + 3] += wall * wall
        row[BOOK : BOOK + 3] += reading[6:9]
        if row[TIME] <= self.settle + 0.5 * self.window:
            row[HALF_COUNT] += 1.0
            row[HALF : HALF + 3] += wall
        else:
            row[LATER : LATER + 3] += wall
        self._look_for_a_beat(lift, dt)

    def _look_for_a_beat(self, lift: float, dt: float) -> None:
        """When the lift rises through its level of before."""
        row = self.row
        level = row[LEVEL] / max(row[LEVEL_COUNT], 1.0)
        before, now = row[BEFORE] - level, lift - level
        if before < 0.0 <= now:
            when = row[TIME] - dt * now / (now - before)
            if row[BEATS] == 0.0:
                row[FIRST] = when
            row[LAST] = when
            row[BEATS] += 1.0
        row[BEFORE] = lift

    @property
    def settled(self) -> bool:
        """Whether there is something to tell."""
        return bool(self.row[COUNT] >= 1.0)

    @property
    def done(self) -> bool:
        """Whether the whole window has been measured."""
        return bool(self.row[TIME] >= self.settle + self.window and self.settled)

    @property
    def progress(self) -> float:
        """0 to 1 of settling and window."""
        return min(1.0, float(self.row[TIME]) / max(self.settle + self.window, 1e-300))

    def mean(self, unit: float = 1.0) -> Mean:
        """What was found so far; unit: s, chord over wind. All 0 before it has settled."""
        row = self.row
        n = max(float(row[COUNT]), 1.0)
        wall, book = row[WALL : WALL + 3] / n, row[BOOK : BOOK + 3] / n
        spread = np.sqrt(np.maximum(row[SQUARES : SQUARES + 3] / n - wall * wall, 0.0))
        early, late = float(row[HALF_COUNT]), float(row[COUNT] - row[HALF_COUNT])
        drift = 0.0
        if early >= 1.0 and late >= 1.0:
            drift = 0.5 * abs(float(row[HALF]) / early - float(row[LATER]) / late)
        span = float(row[LAST] - row[FIRST])
        beats = row[BEATS] >= 3.0 and span > 0.0 and spread[1] > STEADY
        beat = (float(row[BEATS]) - 1.0) / span * unit if beats else 0.0
        seconds = max(0.0, float(row[TIME]) - self.settle) if self.settled else 0.0
        return Mean(_three(wall), _three(spread), _three(book), drift, beat, seconds)


def _three(values: Floats) -> tuple[float, float, float]:
    a, b, c = values.tolist()
    assert math.isfinite(a + b + c)
    return a, b, c
