"""What accuracy costs for a sea of waves: its height by so many of them, beside the spectrum's integral."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from game.arrays import Floats
from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload
from game.physics.waves.sea import Sea, full_height

WIND = 10.0  # m/s
LENGTHS = (0.02, 20_000.0)  # m: beyond it there is nothing of the sea
COUNTS = (32, 45, 64, 91, 128)
POINTS = 400


class SeaTrial:
    """The height of a full sea by waves of so many lengths; its work: the level at POINTS places."""

    simulated_s = 1.0

    def __init__(self, setting: Setting):
        self.sea = Sea(round(1.0 / setting.knob), lengths=LENGTHS)
        self.points: Floats = np.stack([np.linspace(0.0, 200.0, POINTS), np.zeros(POINTS)], axis=1)

    def reset(self) -> None:
        """Still water."""
        self.sea.rows[:, 0] = 0.0

    def run(self) -> None:
        """The sea, and its level once."""
        self.sea.rows[:, 0] = self.sea.goals("pierson-moskowitz", WIND, 1.0)
        self.sea.at(self.points)

    def outcome(self) -> Outcome:
        """Relative error of the significant height."""
        law = full_height(WIND)
        return Outcome(abs(self.sea.significant() / law - 1.0), len(self.sea.rows) - 1)


def _settings() -> list[Setting]:
    return [Setting("midpoint", 1.0 / n, {}, {"waves": n, "tier": "own"}, float(n)) for n in COUNTS]


def _present(parameters: Mapping[str, Any]) -> Setting:
    return Setting("midpoint", 1.0 / min(max(int(parameters["waves"]), COUNTS[0]), COUNTS[-1]), {})


sea_study = Study(
    name="a15",
    title="The height of a full sea by waves of many lengths",
    error="relative error of the significant height",
    error_unit="",
    counter="waves",
    knob=Knob("spacing", "one over the number of waves", ""),
    methods=(Method("midpoint", "lengths in even steps of their logarithm", 2.0),),
    settings=_settings,
    trial=SeaTrial,
    reference="the integral of Pierson's and Moskowitz' spectrum (1964), in closed form",
    expectation="A sum in the middle of cells is of order two.",
    present=_present,
    workload=Workload("a sea of 10 m/s of wind"),
)
