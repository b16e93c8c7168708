"""What a stroke costs on three tables: stepped with full physics, stepped as in the lecture, and exact.

The reference is the exact table itself, which is right to rounding with the cushions of Han 2005. A stepped
table finds each contact up to a step late. So its error falls with the first power of the step, saw-toothed
by where in the step the contact lies. Points that make other contacts than the exact table are marked as
failed.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from game.billiards.laws.state import BALL_JAW
from game.billiards.shot.physics import FRICTIONLESS, Physics
from game.billiards.shot.shot import Shot, make_shot
from game.billiards.shot.trajectory import Trajectory
from game.billiards.simulation import simulate
from game.billiards.table.table import Table
from game.lab.ranges import counts_between
from game.lab.studies.billiards.effects import effects_study
from game.lab.studies.billiards.hits import missed_hits_study, overlap_study
from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.physics.kernels import elementary

STEPS_PER_S = {"stepped": (20.0, 20_000.0), "lecture": (20.0, 2_000.0)}  # the range of the scene's knobs
PLACES = [[0.35, 0.5], [0.75, 1.25], [0.95, 2.1]]  # m
AIM = 1.069  # rad; a fairly full hit on ball 1
SPEED = 2.4  # m/s
SPIN = (-27.0, 14.8, -35.0)  # rad/s; some follow, and side
CAROM_TIME = 3.2  # s; ball 0 meets ball 1, then a cushion, then ball 2
LOSSLESS_TIME = 1.2  # s; ball 0 meets ball 1, which meets two cushions


def three_ball_shot(physics: Physics, spin: tuple[float, float, float]) -> Shot:
    """Three balls on a bare table, the first one struck."""
    shot = make_shot(Table.bare(1.27, 2.54), PLACES, physics=physics)
    return shot.struck(0, (SPEED * elementary.cos(AIM), SPEED * elementary.sin(AIM)), spin)


def contacts_of(trajectory: Trajectory) -> list[tuple[int, ...]]:
    """The contacts with balls, cushions and jaws in order: type, ball, ball or element."""
    return [tuple(row) for row in trajectory.rows[:, 1:].astype(np.int64).tolist() if row[0] <= BALL_JAW]


class Stroke:
    """A shot played by a model to a fixed time; error: farthest ball from its place on the exact table."""

    def __init__(self, shot: Shot, time: float, model: str, options: Mapping[str, Any]) -> None:
        self.simulated_s = time
        self.shot = shot
        self.model = model
        self.options = dict(options)
        self.exact = simulate(shot, "exact", until=time)

    def reset(self) -> None:
        pass

    def run(self) -> None:
        self.played = simulate(self.shot, self.model, until=self.simulated_s, **self.options)

    def outcome(self) -> Outcome:
        apart = self.played.state_at(self.simulated_s).positions
        apart = apart - self.exact.state_at(self.simulated_s).positions
        error = math.sqrt(float((apart * apart).sum(axis=1).max()))
        if self.model == "exact":
            return Outcome(error, len(self.played.times))
        same = contacts_of(self.played) == contacts_of(self.exact)
        tests = getattr(self.played, "counts")["pair_tests"]  # noqa: B009  (both stepped models count)
        return Outcome(error, tests, "" if same else "makes other contacts")


def options_of(setting: Setting) -> dict[str, Any]:
    """What `simulate` is to be given at a setting."""
    if setting.method == "exact":
        return {}
    if setting.method == "lecture":
        return {"dt": setting.knob}
    return {"dt": setting.knob, "passes": int(setting.others["passes"])}


def stepped_setting(dt: float, passes: int) -> Setting:
    """A point of the stepped table, and where it is in the scene."""
    scene = {"stepped_step": max(dt, 1.0 / STEPS_PER_S["stepped"][1]), "passes": passes}
    return Setting("stepped", dt, {"passes": passes}, scene, 1.0 + 0.001 / dt)


def lecture_setting(dt: float) -> Setting:
    """A point of the lecture's table, and where it is in the scene."""
    return Setting("lecture", dt, {}, {"lecture_step": dt}, 1.0 + 0.01 / dt)


def _settings(time: float, number: int, passes_tried: tuple[int, ...]) -> Sequence[Setting]:
    """All models at so many steps; every eighth first, so that a run soon shows the whole."""
    points = []
    for model, (fewest, most) in STEPS_PER_S.items():
        counts = counts_between(math.ceil(fewest * time), math.floor(most * time), number)
        for place, steps in enumerate(counts):
            dt = time / steps
            tried = (
                [stepped_setting(dt, p) for p in passes_tried]
                if model == "stepped"
                else [lecture_setting(dt)]
            )
            points += [(place % 8 != 0, setting) for setting in tried]
    points.sort(key=lambda point: point[0])
    return [*(setting for _, setting in points), Setting("exact", 1.0 / STEPS_PER_S["stepped"][1])]


def _trial(shot: Callable[[], Shot], time: float, setting: Setting) -> Trial:
    return Stroke(shot(), time, setting.method, options_of(setting))


def present_setting(parameters: Mapping[str, Any]) -> Setting:
    """Where a scene with these parameters stands: the step and the passes of its stepped table."""
    return stepped_setting(float(parameters["stepped_step"]), int(parameters["passes"]))


def _study(name: str, title: str, time: float, number: int, passes: tuple[int, ...], **more: Any) -> Study:
    return Study(
        name=name,
        title=title,
        error="farthest ball from its place on the exact table",
        error_unit="m",
        counter="pair tests (exact: events)",
        knob=Knob("step", "step", "s"),
        settings=partial(_settings, time, number, passes),
        reference="the exact table: closed forms between events, right to rounding with Han's cushion.",
        envelope=True,
        floor=1e-10,
        present=present_setting,
        workload=Workload("three balls on a bare table"),
        **more,
    )


STEPPED = Method("stepped", "stepped, full physics", 1.0, "the same contact models, found up to a step late")
EXACT = Method("exact", "event by event", None, "the exact table: no step at all")

lossless_study = _study(
    "three-tables-lossless",
    "Three tables: one hit and two cushions, without friction or loss",
    LOSSLESS_TIME,
    100,
    (4,),
    methods=(
        STEPPED,
        Method("lecture", "as in the lecture", 1.0, "one substep, balls put on the wall"),
        EXACT,
    ),
    trial=partial(_trial, lambda: three_ball_shot(FRICTIONLESS, (0.0, 0.0, 0.0)), LOSSLESS_TIME),
    short="No friction",
    expectation="Without friction all tables play the same game, and both stepped ones come nearer with the "
    "first power of the step. The lecture's dear points are the price of a call from Python for each step.",
)

billiards_study = _study(
    "three-tables",
    "Three tables: a carom with side spin",
    CAROM_TIME,
    100,
    (1, 4),
    methods=(
        STEPPED,
        Method("lecture", "as in the lecture", None, "no spin, no throw: another game at any step"),
        EXACT,
    ),
    trial=partial(_trial, lambda: three_ball_shot(Physics(), SPIN), CAROM_TIME),
    short="Carom",
    expectation="Order 1 for the stepped table where its steps are short enough to make the right contacts; "
    "passes mend nothing where balls are few. The lecture's ball knows no spin: it never meets ball 2, "
    "however short the step. Event by event is exact, and cheaper than any of them.",
    related=(lossless_study, missed_hits_study, overlap_study, effects_study),
)
