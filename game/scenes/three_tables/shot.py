"""One shot played on the lecture's table, on a stepped one and on the exact one, and how far they diverge."""

from __future__ import annotations

import math
from collections import OrderedDict
from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from game.billiards.growing import GrowingTrajectory, grow_lecture, grow_stepped
from game.billiards.shot.shot import Shot
from game.billiards.shot.trajectory import Trajectory
from game.billiards.simulation import simulate

MODELS = ("lecture", "stepped", "exact")
LONGEST_S = 60.0  # s that a shot is shown; without cloth it would never end
SAMPLES_HZ = 30.0  # of the difference, for the chart
MOST_STEPS = 2_000  # of the stepped table computed at once: some 2 ms
MOST_LECTURE_STEPS = 1_000
MOST_S = 1.0  # computed at once: a sample costs more than a step
SHOTS_KEPT = 3


class Steps(NamedTuple):
    """Lengths of the steps of the lecture's and of the stepped table, s, and the latter's passes."""

    lecture: float
    stepped: float
    passes: int

    @property
    def slice_s(self) -> float:
        """How much of a shot can be computed without holding up a picture, s of simulated time."""
        return min(MOST_S, MOST_LECTURE_STEPS * self.lecture, MOST_STEPS * self.stepped)


class PlayedShot:
    """What has come of a shot so far. ``moved``: the same, begun elsewhere, for a second exact table.

    The exact tables are computed at once, those that step as far as `compute` is told to. What is known of a
    moment does not depend on that. tables: by model, "perturbed" the second exact one. event_times (k,) s of
    the exact one.
    """

    def __init__(self, shot: Shot, moved: Shot | None, steps: Steps) -> None:
        self.steps = steps
        self.stepping: tuple[GrowingTrajectory, ...] = (
            grow_lecture(shot, steps.lecture, LONGEST_S),
            grow_stepped(shot, steps.stepped, steps.passes, LONGEST_S),
        )
        self.exact: tuple[Trajectory, ...] = (simulate(shot, "exact", until=LONGEST_S),)
        self.tables: dict[str, Trajectory] = dict(zip(MODELS, (*self.stepping, *self.exact), strict=True))
        if moved is not None:
            self.tables["perturbed"] = simulate(moved, "exact", until=LONGEST_S)
            self.exact = (*self.exact, self.tables["perturbed"])
        self.event_times = np.asarray(self.tables["exact"].times)
        self.differences = Differences(self.tables)

    @property
    def reached_s(self) -> float:
        """Up to where all tables are known, s."""
        return min((table.end_time for table in self.stepping if not table.complete), default=math.inf)

    @property
    def least_end_s(self) -> float:
        """When all balls are at rest, as far as is known, s: the shot lasts at least so long."""
        return max(table.end_time for table in self.tables.values())

    def compute(self, time: float) -> None:
        """Compute all tables up to a time, s, or to the end."""
        for table in self.stepping:
            table.compute(time)

    def is_over(self, time: float) -> bool:
        """True if nothing moves on any table at a time, s, up to which they are known."""
        return self.reached_s == math.inf and time >= self.least_end_s


class ShotShelf:
    """The last few shots, by what they were played with, for the clock that is turned back and forth."""

    def __init__(self) -> None:
        self._shots: OrderedDict[object, PlayedShot] = OrderedDict()
        self.latest: PlayedShot | None = None

    def get(self, key: object, play: Callable[[], PlayedShot]) -> PlayedShot:
        """The shot of that key; if it is not there, it is played."""
        if key not in self._shots:
            self._shots[key] = play()
        self._shots.move_to_end(key)
        while len(self._shots) > SHOTS_KEPT:
            self._shots.popitem(last=False)
        self.latest = self._shots[key]
        return self.latest


class Differences:
    """How far the balls of the other tables are from those of the exact one, as far as it is asked for."""

    def __init__(self, tables: dict[str, Trajectory]) -> None:
        self._tables = tables
        self._curves: dict[str, list[float]] = {name: [] for name in tables if name != "exact"}

    def __len__(self) -> int:
        """Samples computed."""
        return min(len(curve) for curve in self._curves.values())

    def until(self, time: float) -> dict[str, list[float]]:
        """Largest distance of any ball to its place on the exact table, m, at SAMPLES_HZ up to a time (s)."""
        count = int(time * SAMPLES_HZ) + 1
        for i in range(len(self), count):
            exact = self._tables["exact"].state_at(i / SAMPLES_HZ).positions
            for name, curve in self._curves.items():
                apart = self._tables[name].state_at(i / SAMPLES_HZ).positions - exact
                curve.append(math.sqrt(float((apart * apart).sum(axis=1).max())))
        return {name: curve[:count] for name, curve in self._curves.items()}
