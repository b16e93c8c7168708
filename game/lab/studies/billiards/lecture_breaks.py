"""Studies of the lecture's table: hits missed, a rack pressed together, a break that should mirror."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from game.billiards.lecture.settings import LectureSettings, lecture_settings
from game.billiards.lecture.state import LECTURE_EFFECTS, POCKETS
from game.billiards.lecture.table import LectureTable
from game.billiards.table.rack import BALL_RADIUS, eight_ball_rack
from game.billiards.table.table import Table
from game.lab.references import missed_share
from game.lab.studies.billiards.missed_hits import HIT_SPEED, HitShots, missed_hits_of
from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload

LOSSLESS: dict[str, Any] = {"bounce": 1.0, "restitution": 1.0, "friction": 1.0, "minimum_speed": 0.0}
PAIRWISE = {"order": "pairwise", "substeps": 1}
STEP = Knob("step_length", "step", "s")
SHORTEST, LONGEST = 1.0 / 2000.0, 0.05  # s, steps that the scene allows


def step_in_scene(dt: float) -> float:
    """The step, or the nearest one that the scene allows, s."""
    return min(max(dt, SHORTEST), LONGEST)


def chosen(parameters: Mapping[str, Any]) -> dict[str, Any]:
    """How a scene with these parameters treats its contacts."""
    return {
        "order": str(parameters["order"]),
        "substeps": int(parameters["substeps"]),
        "passes": int(parameters["passes"]),
    }


def present_step(parameters: Mapping[str, Any]) -> Setting:
    """Where a scene with these parameters stands: its step and how it treats contacts."""
    return Setting("present", float(parameters["step_length"]), {}, chosen(parameters))


def present_hits(parameters: Mapping[str, Any]) -> Setting:
    """The same, by its name if it is one of the study's methods."""
    setting = present_step(parameters)
    name = next((name for name, one in HIT_SETTINGS.items() if one == setting.scene), setting.method)
    return replace(setting, method=name)


def present_order(parameters: Mapping[str, Any]) -> Setting:
    """Passes of the scene's order."""
    scene = chosen(parameters)
    return Setting(str(scene["order"]), float(scene["passes"]), {}, scene)


def present_symmetry(parameters: Mapping[str, Any]) -> Setting:
    """The scene's step, and its order where its substeps and passes are those of the study."""
    setting = present_step(parameters)
    usual = (setting.scene["substeps"], setting.scene["passes"]) == (1, 4)
    return replace(setting, method=str(setting.scene["order"])) if usual else setting


# -- hits missed

HIT_WAY = 0.4  # m from before the contact to behind it


class MissedHits(HitShots):
    """Shots on an open table of the lecture."""

    def __init__(self, dt: float, settings: LectureSettings) -> None:
        super().__init__(dt, HIT_WAY)
        self.table = LectureTable(Table.open(), [[0.0, 0.0], [0.0, 1.0]], settings=settings)

    def run(self) -> None:
        state = self.table.state
        for across, start in self.places:
            state.offsets[0] = 0.0, start
            state.offsets[1] = across, 0.5 * HIT_WAY
            state.velocities[0] = 0.0, HIT_SPEED
            state.velocities[1] = 0.0
            self.table.step(self.dt, self.steps)
            self.missed += not state.velocities[1].any()
            self.tests += self.table.counters["pair_tests"]


HIT_SETTINGS: dict[str, dict[str, Any]] = {
    "lecture": {**PAIRWISE, "passes": 1},
    "substeps": {"order": "pairwise", "substeps": 4, "passes": 1},
    "automatic": {"order": "joint", "substeps": 0, "passes": 1},
}


def _hit_settings() -> Sequence[Setting]:
    points = []
    for method, knobs in HIT_SETTINGS.items():
        for rate in np.geomspace(20.0, 2000.0, 13).tolist():
            dt = 1.0 / rate
            parts = int(knobs["substeps"]) or max(1, math.ceil(HIT_SPEED * dt / (0.5 * BALL_RADIUS)))
            scene = {"step_length": step_in_scene(dt), **knobs}
            others = {"formula": missed_share(HIT_SPEED, dt / parts, BALL_RADIUS)}
            points.append(Setting(method, dt, others, scene, 1.0 + 0.01 * rate))
    return points


missed_hits_study = missed_hits_of(
    "lecture-missed-hits",
    "Lecture table",
    STEP,
    (
        ("lecture", "as in the lecture"),
        ("substeps", "four substeps"),
        ("automatic", "automatic substeps, joint"),
    ),
    _hit_settings,
    lambda setting: MissedHits(
        setting.knob, lecture_settings(**LOSSLESS, **HIT_SETTINGS.get(setting.method, setting.scene))
    ),
    present_hits,
    "A test once a step overlooks grazing hits: a share that falls with the square of the step, and passes "
    "one half where a step is longer than three radii.",
    order_over="counter",
)

# -- a rack pressed together


class PressedRack:
    """A rack pressed together by a tenth, one step; error: deepest overlap left / 2 R."""

    simulated_s = 1.0 / 60.0

    def __init__(self, settings: LectureSettings) -> None:
        rack = eight_ball_rack(Table.pool())[1:]
        middle = rack.mean(axis=0)
        bare = Table.bare(1.27, 2.54)
        self.table = LectureTable(bare, middle + 0.9 * (rack - middle), settings=settings)
        self.start = self.table.state.offsets.copy()

    def reset(self) -> None:
        self.table.state.offsets[...] = self.start

    def run(self) -> None:
        self.table.step(self.simulated_s)

    def outcome(self) -> Outcome:
        overlap = self.table.deepest_overlap / (2.0 * BALL_RADIUS)
        return Outcome(
            overlap,
            self.table.counters["pair_tests"],
            "balls stay inside each other" if overlap > 0.05 else "",
        )


def _rack_settings() -> Sequence[Setting]:
    return [
        Setting(order, passes, {}, {"passes": passes, "order": order, "substeps": 1}, 1.0)
        for order in ("pairwise", "joint")
        for passes in (1, 2, 3, 5, 7, 10, 14, 20, 30, 40, 50)
    ]


rack_study = Study(
    name="lecture-pressed-rack",
    title="Lecture table: a rack pressed together by a tenth",
    error="deepest overlap left, of two radii",
    error_unit="",
    counter="pair tests",
    knob=Knob("passes", "passes", parts=True),
    order_over="counter",
    methods=(
        Method("pairwise", "pair by pair", None),
        Method("joint", "jointly", None),
    ),
    settings=_rack_settings,
    short="Pressed rack",
    trial=lambda setting: PressedRack(
        lecture_settings(**LOSSLESS, order=str(setting.scene["order"]), substeps=1, passes=int(setting.knob))
    ),
    present=present_order,
    workload=Workload("a rack pressed together"),
    reference="no overlap at all.",
    expectation="Pair by pair the overlap falls by a constant factor a pass; all contacts together need one.",
)

# -- a break that should mirror

BREAK_SPEED = 8.0  # m/s
BREAK_TIME = 1.0  # s


class LectureRun:
    """So many steps of a table, again and again from the same start."""

    def __init__(self, table: LectureTable, seconds: float, steps: int) -> None:
        self.table, self.simulated_s = table, seconds
        self.start = [array.copy() for array in table.state]
        self.dt, self.steps = seconds / steps, steps

    def reset(self) -> None:
        for array, then in zip(self.table.state, self.start, strict=True):
            array[...] = then

    def run(self) -> None:
        self.table.step(self.dt, self.steps)


class MirroredBreak(LectureRun):
    """A straight break of a symmetric rack; error: farthest ball from its partner's mirror image."""

    def __init__(self, dt: float, settings: LectureSettings) -> None:
        pool = Table.pool()
        table = LectureTable(
            pool, eight_ball_rack(pool), effects=LECTURE_EFFECTS.without(POCKETS), settings=settings
        )
        offsets = table.state.offsets
        mirrored = offsets * [-1.0, 1.0]
        apart = np.abs(offsets[:, None, :] - mirrored[None, :, :]).sum(axis=2)
        self.partner = apart.argmin(axis=1)
        table.strike(0, (0.0, BREAK_SPEED))
        super().__init__(table, BREAK_TIME, round(BREAK_TIME / dt))

    def outcome(self) -> Outcome:
        offsets = self.table.state.offsets
        error = float(np.abs(offsets[self.partner] - offsets * [-1.0, 1.0]).max())
        return Outcome(error, self.table.counters["pair_tests"], "not symmetric" if error > 0.1 else "")


def _break_settings() -> Sequence[Setting]:
    points = []
    for method in ("pairwise", "joint"):
        for rate in (60, 120, 240, 480, 1000, 2000, 4000):
            scene = {"step_length": step_in_scene(1.0 / rate), "order": method, "substeps": 1, "passes": 4}
            points.append(Setting(method, 1.0 / rate, {}, scene, float(rate)))
    return points


symmetry_study = Study(
    name="lecture-symmetric-break",
    title="Lecture table: does a symmetric break stay symmetric?",
    error="farthest ball from its partner's mirror image, after 1 s",
    error_unit="m",
    counter="pair tests",
    knob=STEP,
    methods=(
        Method("pairwise", "pair by pair", None),
        Method("joint", "jointly", None),
    ),
    settings=_break_settings,
    short="Symmetry",
    trial=lambda setting: MirroredBreak(
        setting.knob,
        lecture_settings(
            **LOSSLESS, **{name: setting.scene[name] for name in ("order", "substeps", "passes")}
        ),
    ),
    present=present_symmetry,
    workload=Workload("a straight break"),
    reference="the mirror image.",
    expectation="Pair by pair the numbering of the balls decides, at any step. Jointly the two halves are "
    "equal to the last bit.",
)
