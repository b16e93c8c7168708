"""One shot played on the lecture's table, on a stepped one and on the exact one, and how far they part."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.billiards.shot import Shot
from game.billiards.simulation import simulate
from game.billiards.trajectory import Trajectory

MODELS = ("lecture", "stepped", "exact")
LONGEST_S = 60.0  # s that a shot is shown; without cloth it would never end
SAMPLES_HZ = 30.0  # of the difference, for the chart


class Steps(NamedTuple):
    """Lengths of the steps of the lecture's and of the stepped table, s, and the latter's passes."""

    lecture: float
    stepped: float
    passes: int


class PlayedShot:
    """What has come of a shot. ``moved``: the same, begun elsewhere, for a second exact table.

    tables: by model, "perturbed" the second exact one. pocketings: by model. event_times (k,) s of the exact
    one. end_s: when all balls lie.
    """

    def __init__(self, shot: Shot, moved: Shot | None, steps: Steps) -> None:
        until = LONGEST_S
        self.tables: dict[str, Trajectory] = {
            "lecture": simulate(shot, "lecture", dt=steps.lecture, until=until),
            "stepped": simulate(shot, "stepped", dt=steps.stepped, passes=steps.passes, until=until),
            "exact": simulate(shot, "exact", until=until),
        }
        if moved is not None:
            self.tables["perturbed"] = simulate(moved, "exact", until=until)
        self.pocketings = {
            name: [event for event in table.events if event.type == "ball-pocket"]
            for name, table in self.tables.items()
        }
        self.event_times = np.asarray(self.tables["exact"].times)
        self.end_s = min(max(table.end_time for table in self.tables.values()), until)
        self.differences = Differences(self.tables)


class Differences:
    """How far the balls of the other tables lie from those of the exact one.

    Computed as far as it is asked for: a stroke must not wait for the curves of a minute.
    """

    def __init__(self, tables: dict[str, Trajectory]) -> None:
        self._tables = tables
        self._curves: dict[str, list[float]] = {name: [] for name in tables if name != "exact"}

    def __len__(self) -> int:
        """Samples computed."""
        return min(len(curve) for curve in self._curves.values())

    def until(self, time: float) -> dict[str, list[float]]:
        """Largest distance of any ball to its place on the exact table, m, at SAMPLES_HZ up to a time (s)."""
        wanted = int(time * SAMPLES_HZ) + 1
        for i in range(len(self), wanted):
            exact = self._tables["exact"].state_at(i / SAMPLES_HZ).positions
            for name, curve in self._curves.items():
                apart = self._tables[name].state_at(i / SAMPLES_HZ).positions - exact
                curve.append(math.sqrt(float((apart * apart).sum(axis=1).max())))
        return {name: curve[:wanted] for name, curve in self._curves.items()}
