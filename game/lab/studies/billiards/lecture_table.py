"""What accuracy costs on the lecture's table: a carom shot against its exact solution.

Three balls, two cushions, no loss. The lecture's scheme finds each contact up to one step late. So its error
falls with the first power of the step, saw-toothed by where in the step the contact lies. Points where a ball
passes through another, or hits one that it should pass, are marked as failed.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np

from game.arrays import Floats
from game.billiards.lecture.settings import LectureSettings, lecture_settings
from game.billiards.lecture.state import BALL_COLLISIONS, WALLS
from game.billiards.lecture.table import LectureTable
from game.billiards.table.table import Table
from game.lab.ranges import counts_between
from game.lab.references import CAROM, two_balls
from game.lab.studies.billiards.lecture_breaks import (
    LectureRun,
    missed_hits_study,
    rack_study,
    step_in_scene,
    symmetry_study,
)
from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload

LOSSLESS: dict[str, Any] = {
    "bounce": 1.0,
    "restitution": 1.0,
    "friction": 1.0,
    "minimum_speed": 0.0,
    "rule": "conserving",
}
METHODS = (
    Method("lecture", "as in the lecture", 1.0, "pair by pair, one substep, balls put on the wall"),
    Method(
        "exact-walls", "walls exact in time", 1.0, "the same, balls where a timely turn would have put them"
    ),
    Method("substeps", "four substeps", 1.0, "the same in four substeps"),
    Method("automatic", "automatic substeps, joint", 1.0, "at most half a radius a substep"),
    Method("events", "event by event", None, "the exact table: no step at all"),
)
SETTINGS: dict[str, dict[str, Any]] = {
    "lecture": {"order": "pairwise", "substeps": 1, "repositioning": "clamp", "walls_again": False},
    "exact-walls": {"order": "pairwise", "substeps": 1, "repositioning": "exact"},
    "substeps": {"order": "pairwise", "substeps": 4, "repositioning": "exact"},
    "automatic": {"order": "joint", "substeps": 0, "repositioning": "exact"},
}
LECTURE_FRAME = 1.0 / 30.0  # s, of the lecture's main loop
FEWEST = 8  # steps to the end of a shot


class SteppedShot(LectureRun):
    """A shot on a bare table, stepped `steps` times to its end; error: farthest ball from its exact place."""

    def __init__(
        self,
        table: Table,
        start: Floats,
        velocities: Floats,
        end: Floats,
        time: float,
        steps: int,
        settings: LectureSettings,
    ) -> None:
        balls = LectureTable(table, start, CAROM.radius, 1.0, velocities, WALLS | BALL_COLLISIONS, settings)
        super().__init__(balls, time, steps)
        self.end = end

    def outcome(self) -> Outcome:
        off = self.table.positions - self.end
        error = math.sqrt(float((off * off).sum(axis=1).max()))
        hits = sum(event.kind == "ball-ball" for event in self.table.events)
        failure = "" if hits == 1 else "hits a ball that it should pass" if hits else "passes through a ball"
        return Outcome(error, self.table.counters["pair_tests"], failure)


class ExactShot:
    """The same shot on the exact table; its counter is the number of events."""

    def __init__(self, table: Table, start: Floats, velocities: Floats, end: Floats, time: float) -> None:
        # the exact table's kernels are many: loaded when a study runs, not with the scene
        from game.billiards.shot.physics import FRICTIONLESS
        from game.billiards.shot.shot import make_shot
        from game.billiards.simulation import simulate

        self.simulated_s = time
        self.simulate = simulate
        self.shot = make_shot(table, start, velocities, radii=CAROM.radius, masses=1.0, physics=FRICTIONLESS)
        self.end = end

    def reset(self) -> None:
        pass

    def run(self) -> None:
        self.trajectory = self.simulate(self.shot, until=self.simulated_s)

    def outcome(self) -> Outcome:
        off = self.trajectory.end[:, :2] - self.end
        return Outcome(math.sqrt(float((off * off).sum(axis=1).max())), len(self.trajectory.times))


def settings_of(method: str, passes: int = 1) -> LectureSettings:
    """The table's settings of one of the stepped METHODS, without loss."""
    return lecture_settings(**{**LOSSLESS, **SETTINGS[method], "passes": passes})


def _scene(method: str, dt: float, passes: int) -> dict[str, Any]:
    """The scene's parameters at a point."""
    chosen = {name: value for name, value in SETTINGS[method].items() if name != "walls_again"}
    return {"step_length": step_in_scene(dt), "passes": passes, **LOSSLESS, **chosen}


def _settings(time: float, most: int, number: int, passes_tried: tuple[int, ...]) -> Sequence[Setting]:
    """All methods at so many counts of steps; every eighth first, so that a run soon shows the whole."""
    counts = counts_between(FEWEST, most, number)
    points = []
    for method in METHODS[:-1]:
        for steps in counts:
            for passes in passes_tried if method.name == "lecture" else passes_tried[:1]:
                dt = time / steps
                scene = _scene(method.name, dt, passes)
                points.append(
                    Setting(method.name, dt, {"passes": passes, "steps": steps}, scene, 100.0 + steps)
                )
    points.sort(key=lambda setting: counts.index(int(setting.others["steps"])) % 8 != 0)
    return [*points, Setting("events", time / most, {}, {}, 100.0)]


def _trial(
    table: Table, start: Floats, velocities: Floats, end: Floats, time: float, setting: Setting
) -> Trial:
    if setting.method == "events":
        return ExactShot(table, start, velocities, end, time)
    if setting.method == "present":
        settings = lecture_settings(**{**setting.scene, **LOSSLESS})
    else:
        settings = settings_of(setting.method, int(setting.others["passes"]))
    steps = max(1, round(time / setting.knob))
    return SteppedShot(table, start, velocities, end, time, steps, settings)


def present_setting(parameters: Mapping[str, Any]) -> Setting:
    """Where a scene with these parameters stands: its step, order, substeps, passes, repositioning.

    Loss and friction are left out, as the exact solution has none.
    """
    names = set(LectureSettings._fields) - set(LOSSLESS)
    chosen = {name: value for name, value in parameters.items() if name in names}
    if "substeps" in chosen:
        chosen["substeps"] = int(chosen["substeps"])
    if "passes" in chosen:
        chosen["passes"] = int(chosen["passes"])
    step = float(parameters["step_length"])
    for name, one in SETTINGS.items():
        if all(chosen.get(key, value) == value for key, value in one.items()):
            return Setting(name, step, {"passes": chosen["passes"]}, chosen)
    return Setting("present", step, {}, chosen)


def _study(
    name: str,
    title: str,
    reference: str,
    settings: Callable[[], Sequence[Setting]],
    trial: Callable[[Setting], Trial],
    words: str,
    **more: Any,
) -> Study:
    return Study(
        name=name,
        title=title,
        error="farthest ball from its exact place",
        error_unit="m",
        counter="pair tests (event by event: events)",
        knob=Knob("step_length", "step", "s"),
        methods=METHODS,
        settings=settings,
        trial=trial,
        reference=reference,
        order_over="counter",
        envelope=True,
        floor=1e-11,
        present=present_setting,
        workload=Workload(words),
        **more,
    )


# one oblique hit, no wall: the closed form of two balls
TWO_START = np.array([[0.3, 0.4], [0.75, 0.42]])
TWO_VELOCITIES = np.array([[1.5, 0.0], [0.0, 0.0]])
TWO_TIME = 0.7

two_ball_study = _study(
    "lecture-two-balls",
    "Lecture table: two balls, one oblique hit",
    "time of contact from a quadratic, exchange of the normal parts.",
    partial(_settings, TWO_TIME, 12_000, 60, (1,)),
    partial(
        _trial,
        Table.bare(CAROM.width, CAROM.length),
        TWO_START,
        TWO_VELOCITIES,
        two_balls(TWO_START, TWO_VELOCITIES, CAROM.radius, TWO_TIME),
        TWO_TIME,
    ),
    "two balls on a bare table",
    short="Two balls",
    expectation="One collision, found up to a step late: order 1. Substeps shorten the step at full price.",
)

# the lecture's program has no step to choose: a point opens it without loss
one_collision_study = replace(
    two_ball_study,
    name="lecture-balls",
    title="Two balls: one oblique hit, found up to a step late",
    settings=lambda: [replace(setting, scene=LOSSLESS) for setting in two_ball_study.settings()],
    present=lambda parameters: Setting(
        "lecture", LECTURE_FRAME, {"passes": 1}, {"order": "pairwise", "substeps": 1, "passes": 1}
    ),
)

lecture_table_study = _study(
    "lecture-table",
    "Lecture table: a carom over two cushions",
    "three balls, exact roots of contact, to 30 digits.",
    partial(_settings, CAROM.time, 48_000, 200, (1, 20)),
    partial(
        _trial,
        Table.bare(CAROM.width, CAROM.length),
        CAROM.start,
        CAROM.velocities,
        CAROM.end,
        CAROM.time,
    ),
    "three balls on a bare table, without loss",
    short="Carom",
    ceiling=4.2e-3,  # m; so near the struck ball passes the third one
    expectation="Order 1 for every stepped method, with a large constant: the struck ball passes the third "
    "by 4.2 mm, and too long a step makes it hit. More passes cost pair tests and mend nothing here. Event "
    "by event is exact, and cheaper.",
    related=(two_ball_study, missed_hits_study, rack_study, symmetry_study),
)
