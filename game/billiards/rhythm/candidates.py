"""Candidates of the search as plain numbers, and what each costs by all its impacts, however quiet.

A candidate of n balls is a row of 4 + 2 n numbers: speed (m/s) and azimuth (rad) of the stroke, tip left and
up (ball radii), then x and y (m) of each ball, the cue ball first.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.exact.play import play_shots
from game.billiards.laws import state as s
from game.billiards.laws.batch import Batch
from game.billiards.laws.lean import lean_kernel
from game.billiards.rhythm.hearing import TOGETHER
from game.billiards.search.strokes import LARGEST_TIP, SPEED, strike_all
from game.billiards.shot.cue import CUE_END_MASS, CUE_MASS
from game.billiards.shot.physics import Physics
from game.billiards.shot.shot import Shot, batch_of, make_shot
from game.billiards.simulation import log_for, workspace_for
from game.billiards.table.table import Table
from game.physics.kernels import elementary, elementwise

STROKE = 4  # numbers before the places
FARTHEST_MISS = 0.3  # s; a beat missed by more counts as missed by this
EXTRA = 0.02  # s, for an impact that no beat asks for
MAX_EVENTS = 600


class Candidates:
    """Rows of candidates of so many balls on a table."""

    def __init__(self, table: Table, physics: Physics, balls: int) -> None:
        self.table, self.physics, self.balls = table, physics, balls
        spread = np.linspace(0.1, 0.9, balls)
        places = np.stack([np.full(balls, 0.5 * table.width), spread * table.length], axis=1)
        self._one = batch_of([make_shot(table, places, physics=physics)])
        # a kernel counts from the middle of the table
        self._to_kernel = self._one.balls[0, 0, s.IN_X : s.IN_Y + 1] - places[0]
        self.radius = float(self._one.balls[0, 0, s.IN_RADIUS])

    def shot(self, row: Floats) -> Shot:
        """One candidate as a shot; ShotError if it can be none."""
        balls, places = self._batch(row[None]).balls[0], row[STROKE:].reshape(-1, 2)
        return make_shot(self.table, places, balls[:, 2:4], balls[:, 4:7], physics=self.physics)

    def rough_costs(self, rows: Floats, beats: Floats) -> Floats:
        """Cost (s) of each row (m, 4 + 2 n) by all impacts; infinite for balls in one another or outside."""
        batch = self._batch(rows)
        x, y, r = rows[:, STROKE::2], rows[:, STROKE + 1 :: 2], self.radius
        inside = (x > r) & (x < self.table.width - r) & (y > r) & (y < self.table.length - r)
        sound = np.all(inside, axis=1) & are_apart(x, y, 2.0 * r * (1.0 + 1e-9))
        costs = np.full(len(rows), math.inf)
        capacity, first, kept = 64 * len(rows), 0, np.flatnonzero(sound)
        some = Batch(batch.balls[kept], batch.constants[kept], batch.elements, batch.ranges[kept])
        found = np.full(len(kept), math.inf)
        while first < len(kept):
            log = log_for(len(kept), self.balls, capacity, paths=False)
            workspace = workspace_for(self.balls)
            end = int(play_shots(*workspace, *some, *log, first, float(beats[-1]) + TOGETHER, MAX_EVENTS))
            if end == first:
                capacity *= 4
                continue
            rate_shots(log.events, log.ends, (first, end), beats, found)
            first = end
        costs[kept] = found
        return costs

    def _batch(self, rows: Floats) -> Batch:
        """Candidates as the kernel takes them."""
        m, one = len(rows), self._one
        balls, strokes = np.empty((m, *one.balls.shape[1:])), np.zeros((m, 5))
        strokes[:, SPEED], strokes[:, 1], strokes[:, 3:] = rows[:, 0], rows[:, 1], rows[:, 2:STROKE]
        strokes[:, 3:] *= (LARGEST_TIP / np.maximum(elementwise.hypot(rows[:, 2], rows[:, 3]), LARGEST_TIP))[
            :, None
        ]
        strike_all(strokes, one.balls[0], 0, CUE_END_MASS, CUE_MASS, balls)
        balls[:, :, s.IN_X : s.IN_Y + 1] = rows[:, STROKE:].reshape(m, self.balls, 2) + self._to_kernel
        balls[:, :, s.IN_CLEAR] = 0.0
        constants, ranges = np.repeat(one.constants, m, axis=0), np.repeat(one.ranges, m, axis=0)
        return Batch(balls, constants, one.elements, ranges)


def are_apart(x: Floats, y: Floats, least: float) -> NDArray[np.bool_]:
    """Which of some layouts (m, n) m have all their balls at least so far (m) from one another."""
    squared = elementary.square(x[:, :, None] - x[:, None, :]) + elementary.square(
        y[:, :, None] - y[:, None, :]
    )
    own = np.arange(x.shape[1])
    squared[:, own, own] = math.inf
    found: NDArray[np.bool_] = np.min(squared, axis=(1, 2), initial=math.inf) > least * least
    return found


@lean_kernel
def rate_shots(events, ends, rows, beats, costs):
    """Write the cost (s) of shots ``rows`` (first, end) of a log: events (e, 4), ends (m, 6).

    The root mean square of how far the nearest impact misses each beat (k,). Added is EXTRA for each impact
    more than beats, those within TOGETHER taken as one. The first beat is the stroke.
    """
    for shot in range(rows[0], rows[1]):
        if ends[shot, s.STATUS] != s.FINISHED and ends[shot, s.END_TIME] < beats[-1]:
            continue
        begin, end = int(ends[shot, s.EVENTS_START]), int(ends[shot, s.EVENTS_END])
        total = 0.0
        for k in range(1, beats.shape[0]):
            miss = FARTHEST_MISS
            for e in range(begin, end):
                if events[e, 1] <= s.BALL_POCKET:
                    miss = min(miss, abs(events[e, 0] - beats[k]))
            total += miss * miss
        extras = 1 - beats.shape[0]
        before = 0.0
        for e in range(begin, end):
            time = events[e, 0]
            if events[e, 1] <= s.BALL_POCKET and time <= beats[-1] + TOGETHER and time - before >= TOGETHER:
                extras += 1
                before = time
        costs[shot] = math.sqrt(total / beats.shape[0]) + EXTRA * max(extras, 0)
