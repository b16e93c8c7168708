"""Contacts of the stepped tables: hits missed, and how deep balls sink into each other in a break."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from game.billiards.shot.physics import FRICTIONLESS, Physics
from game.billiards.shot.sampled import SAMPLE_VX, SAMPLE_VY, SampledTrajectory
from game.billiards.shot.shot import make_shot
from game.billiards.simulation import simulate
from game.billiards.table.rack import BALL_RADIUS, eight_ball_rack
from game.billiards.table.table import Table
from game.lab.references import missed_share
from game.lab.studies.billiards.missed_hits import HIT_SHOTS, HIT_SPEED, HitShots, missed_hits_of
from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload

STEP = Knob("step", "step", "s")
HIT_WAY = 0.6  # m from before the contact to behind it
BREAK_SPEED = 8.0  # m/s
BREAK_TIME = 0.4  # s; the rack is struck after 0.15 s
PASSES = (1, 4, 20)


def scene_of(model: str, dt: float, passes: int = 4) -> dict[str, Any]:
    """The scene's parameters for a step of one of its tables."""
    return {"stepped_step": dt, "passes": passes} if model == "stepped" else {"lecture_step": dt}


class MissedHits(HitShots):
    """Shots on one of the scene's stepped tables."""

    def __init__(self, model: str, dt: float) -> None:
        super().__init__(dt, HIT_WAY)
        self.model = model
        self.shots = [
            make_shot(
                Table.open(), [[0.0, start], [across, 0.5 * HIT_WAY]], [[0.0, HIT_SPEED], [0.0, 0.0]],
                physics=FRICTIONLESS,
            )
            for across, start in self.places
        ]  # fmt: skip

    def run(self) -> None:
        for shot in self.shots:
            played = simulate(shot, self.model, dt=self.dt, until=self.steps * self.dt)
            assert isinstance(played, SampledTrajectory)
            self.missed += not played.end[1, 2:4].any()
            self.tests += played.counts["pair_tests"]


def _hit_settings() -> Sequence[Setting]:
    points = []
    for model in ("stepped", "lecture"):
        for rate in np.geomspace(20.0, 500.0, 11).tolist():
            dt = 1.0 / rate
            others = {"formula": missed_share(HIT_SPEED, dt, BALL_RADIUS)}
            points.append(Setting(model, dt, others, scene_of(model, dt), 1.0 + 0.01 * rate))
    return points


missed_hits_study = missed_hits_of(
    "three-tables-missed-hits",
    "Three tables",
    STEP,
    (("stepped", "stepped, full physics"), ("lecture", "as in the lecture")),
    _hit_settings,
    lambda setting: MissedHits(setting.method, setting.knob),
    lambda parameters: Setting("stepped", float(parameters["stepped_step"])),
    "Whatever physics a contact has, a test once a step overlooks grazing hits: a share that falls with the "
    "square of the step. Event by event none is missed.",
    floor=2.0 / HIT_SHOTS,
)


class BreakOverlap:
    """A break at 8 m/s; error: deepest overlap of two balls at the end of any step, of two radii."""

    simulated_s = BREAK_TIME

    def __init__(self, dt: float, passes: int) -> None:
        table = Table.bare(1.27, 2.54)
        self.shot = make_shot(table, eight_ball_rack(table), physics=Physics()).struck(0, (0.0, BREAK_SPEED))
        self.dt = dt
        self.passes = passes

    def reset(self) -> None:
        pass

    def run(self) -> None:
        played = simulate(self.shot, "stepped", dt=self.dt, passes=self.passes, until=BREAK_TIME)
        assert isinstance(played, SampledTrajectory)
        self.played = played

    def outcome(self) -> Outcome:
        deepest = 0.0
        first, second = np.triu_indices(16, 1)
        for sample in self.played.samples:
            apart = sample[first, :2] - sample[second, :2]
            nearest = math.sqrt(float((apart * apart).sum(axis=1).min()))
            deepest = max(deepest, 1.0 - nearest / (2.0 * BALL_RADIUS))
        struck = self.played.samples[-1, 1:, SAMPLE_VX : SAMPLE_VY + 1].any()
        return Outcome(deepest, self.played.counts["pair_tests"], "" if struck else "passes through the rack")


def _overlap_settings() -> Sequence[Setting]:
    return [
        Setting(f"passes-{passes}", 1.0 / rate, {}, scene_of("stepped", 1.0 / rate, passes), float(rate))
        for passes in PASSES
        for rate in (60, 120, 240, 480, 1000, 2000, 4000, 8000, 16000)
    ]


overlap_study = Study(
    name="three-tables-overlap",
    title="Three tables: how deep balls sink into each other in a break",
    error="deepest overlap left at the end of a step, of two radii",
    error_unit="",
    counter="pair tests",
    knob=STEP,
    methods=tuple(Method(f"passes-{passes}", f"passes: {passes}", None) for passes in PASSES),
    settings=_overlap_settings,
    short="Overlap",
    trial=lambda setting: BreakOverlap(setting.knob, int(setting.method.split("-")[1])),
    present=lambda parameters: Setting(
        f"passes-{int(parameters['passes'])}", float(parameters["stepped_step"])
    ),
    workload=Workload("a break at 8 m/s"),
    reference="no overlap at all, as on the exact table.",
    expectation="Moving one pair apart pushes the next together: one pass leaves a tightly packed rack "
    "overlapping by what a ball moves in a step, and more passes, or shorter steps, buy that off.",
)
