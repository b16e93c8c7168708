"""What a model of the table costs, and how far it is off a shot that was made on a table that is known.

The shot is made by the exact table with the cushions of Han 2005 and its track has no noise. Each model of
the cushions gets the stroke that suits it best, and the tables that step get the true one.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any

import numpy as np

from game.billiards.fitting.errors import Goal
from game.billiards.fitting.fitting import FittedShot, FittedStroke, computed_shot
from game.billiards.fitting.made import MadeShot, make_tracks
from game.billiards.fitting.strokes import EVERYTHING, PLAIN, Bench
from game.billiards.fitting.tables import START_OF_CAROM, FittedTable, target_of
from game.billiards.fitting.tracks import TableSize
from game.billiards.simulation import simulate
from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.physics.kernels import elementary

EXACT = {"han": "han-2005", "mathavan": "mathavan-2010", "stronge": "stronge-2000"}
STEPS = {"stepped": (1 / 200, 1 / 500, 1 / 1000, 1 / 2000, 1 / 5000), "lecture": (1 / 100, 1 / 200, 1 / 500)}
SEED = 3
DOWNHILL = 300


@lru_cache(maxsize=1)
def known_shot() -> tuple[FittedTable, MadeShot]:
    """The table and the shot that everything is compared with."""
    table = FittedTable(TableSize(), START_OF_CAROM)
    return table, make_tracks(table, 1, SEED, noise=0.0)[0]


class Shown(Trial):
    """The shot under one model."""

    def __init__(self, setting: Setting) -> None:
        table, made = known_shot()
        stroke = made.stroke
        if setting.method in EXACT:
            table = table._replace(physics=table.physics._replace(cushion=EXACT[setting.method]))
            bench = Bench(target_of(made.tracked, table))
            start = np.array([stroke])
            best = bench.downhill(table.ground, start, Goal(EVERYTHING, PLAIN), DOWNHILL)[0]
            stroke = FittedStroke(*best.stroke.tolist())
        fitted = FittedShot("1", stroke, 0.0, 0.0, held_out=True)
        self.start = stroke.start
        self.shot = computed_shot(made.tracked, fitted, table)
        self.track = made.tracked.tracks[0]
        self.model = "exact" if setting.method in EXACT else setting.method
        self.options: dict[str, Any] = {} if self.model == "exact" else {"dt": setting.knob}
        self.simulated_s = made.tracked.end_time

    def reset(self) -> None:
        pass

    def run(self) -> None:
        self.played = simulate(self.shot, self.model, until=self.simulated_s, **self.options)

    def outcome(self) -> Outcome:
        places = [self.played.state_at(time - self.start).positions[0] for time in self.track.times.tolist()]
        off = (elementary.square(np.array(places) - self.track.places)).sum(axis=1)
        return Outcome(math.sqrt(float(off.mean())), len(self.played.times))


def _settings() -> Sequence[Setting]:
    least = STEPS["stepped"][-1]
    exact = [Setting(name, least, {}, {"stepped_step": least}) for name in EXACT]
    stepped = [Setting("stepped", dt, {}, {"stepped_step": dt}, 0.01 / dt) for dt in STEPS["stepped"]]
    return [*exact, *stepped, *(Setting("lecture", dt, {}, {}, 0.05 / dt) for dt in STEPS["lecture"])]


def present_setting(parameters: Mapping[str, Any]) -> Setting:
    """Where a scene with these parameters stands: the step of its stepped table."""
    dt = float(parameters["stepped_step"])
    return Setting("stepped", dt, {}, {"stepped_step": dt}, 0.01 / dt)


real_table_study = Study(
    name="real-table",
    title="The real table: one shot under each model",
    error="root mean square of the cue ball off its track",
    error_unit="m",
    counter="events",
    knob=Knob("step", "step", "s"),
    methods=(
        Method("han", "exact, Han 2005", None, "the model that the shot was made with", "chalk"),
        Method("mathavan", "exact, Mathavan 2010", None, "the impact followed step by step", "green"),
        Method("stronge", "exact, Stronge 2000", None, "a compliant nose", "violet"),
        Method("stepped", "stepped, Han 2005", None, "contacts found up to a step late", "yellow"),
        Method("lecture", "as in the lecture", None, "no spin: another game at any step", "pink"),
    ),
    settings=_settings,
    trial=Shown,
    reference="the track of a shot that the program made with Han's cushions, without noise.",
    present=present_setting,
    workload=Workload("one made shot with three balls"),
    floor=1e-9,
    expectation="The model that made the shot is right to rounding. Other cushions leave a residual though "
    "the stroke is their own best one; a stepped table comes nearer with shorter steps, the lecture's not.",
)
