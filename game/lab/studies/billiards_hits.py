"""Contacts of the stepped tables: hits missed, and how deep balls sink into each other in a break."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from game.billiards.rack import BALL_RADIUS, eight_ball_rack
from game.billiards.sampled import SAMPLE_VX, SAMPLE_VY, SampledTrajectory
from game.billiards.shot import FRICTIONLESS, Physics, Shot, make_shot
from game.billiards.simulation import simulate
from game.billiards.table import Table
from game.lab.references import missed_share
from game.lab.study import Knob, Method, Outcome, Setting, Study

STEP = Knob("step", "step", "s")
HIT_SPEED = 3.0  # m/s
HIT_SHOTS = 400
HIT_WAY = 0.6  # m from before the contact to behind it
BREAK_SPEED = 8.0  # m/s
BREAK_TIME = 0.4  # s; the rack is struck after 0.15 s
PASSES = (1, 4, 20)


def scene_of(model: str, dt: float, passes: int = 4) -> dict[str, Any]:
    """The scene's parameters for a step of one of its tables."""
    return {"stepped_step": dt, "passes": passes} if model == "stepped" else {"lecture_step": dt}


class MissedHits:
    """Shots at a resting ball, impact parameters even over [0, 2 R]; error: share of hits not noticed."""

    def __init__(self, model: str, dt: float) -> None:
        self.model = model
        self.dt = dt
        self.until = (math.ceil(HIT_WAY / (HIT_SPEED * dt)) + 1) * dt
        self.simulated_s = HIT_SHOTS * self.until
        rng = np.random.default_rng(1)
        places = np.arange(HIT_SHOTS)
        across = 2.0 * BALL_RADIUS * (places + rng.random(HIT_SHOTS)) / HIT_SHOTS
        phases = rng.random(HIT_SHOTS)
        self.shots = [self._shot(*numbers) for numbers in zip(across.tolist(), phases.tolist(), strict=True)]
        self.missed = 0
        self.tests = 0

    def _shot(self, across: float, phase: float) -> Shot:
        places = [[0.0, phase * HIT_SPEED * self.dt], [across, 0.5 * HIT_WAY]]
        return make_shot(Table.open(), places, [[0.0, HIT_SPEED], [0.0, 0.0]], physics=FRICTIONLESS)

    def reset(self) -> None:
        self.missed = 0
        self.tests = 0

    def run(self) -> None:
        for shot in self.shots:
            played = simulate(shot, self.model, dt=self.dt, until=self.until)
            assert isinstance(played, SampledTrajectory)
            self.missed += not played.end[1, 2:4].any()
            self.tests += played.counts["pair_tests"]

    def outcome(self) -> Outcome:
        share = self.missed / HIT_SHOTS
        return Outcome(share, self.tests, "misses every other hit" if share >= 0.5 else "")


def _hit_settings() -> Sequence[Setting]:
    points = []
    for model in ("stepped", "lecture"):
        for rate in np.geomspace(20.0, 500.0, 11).tolist():
            dt = 1.0 / rate
            others = {"formula": missed_share(HIT_SPEED, dt, BALL_RADIUS)}
            points.append(Setting(model, dt, others, scene_of(model, dt), 1.0 + 0.01 * rate))
    return points


missed_hits_study = Study(
    name="three-tables-missed-hits",
    title="Three tables: hits missed at 3 m/s",
    error="share of hits not noticed",
    error_unit="",
    counter="pair tests",
    knob=STEP,
    floor=2.0 / HIT_SHOTS,
    methods=(
        Method("stepped", "stepped, full physics", 2.0),
        Method("lecture", "as in the lecture", 2.0),
    ),
    settings=_hit_settings,
    short="Missed hits",
    trial=lambda setting: MissedHits(setting.method, setting.knob),
    present=lambda parameters: Setting("stepped", float(parameters["stepped_step"])),
    reference="P = 1 - b0/(2 D) - D/(2 c) acos(b0/D), D = 2 R, c = v h, b0^2 = D^2 - c^2; column formula.",
    expectation="Whatever physics a contact has, a test once a step overlooks grazing hits: a share that "
    "falls with the square of the step. Event by event none is missed.",
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
    reference="no overlap at all, as on the exact table.",
    expectation="Moving one pair apart pushes the next together: one pass leaves a tightly packed rack "
    "overlapping by what a ball moves in a step, and more passes, or shorter steps, buy that off.",
)
