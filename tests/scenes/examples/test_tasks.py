"""The tasks of the example levels: what their questions call right is what the scene does."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.levels import load_level
from game.scenes import CATALOGUE
from game.stage import Pointer, Stage
from tests.paths import ROOT


def stage_of(scene: str, task: str) -> Stage:
    scene_type = CATALOGUE[scene].load()
    path = ROOT / "levels" / scene / f"{task}.toml"
    return Stage(scene_type, level=load_level(path, scene, scene_type.content_type))


def judged(stage: Stage, answers: list[str]) -> list[bool]:
    readouts = {one.name: one.value for one in stage.readouts()}
    questions = stage.level.teaching.questions
    return [question.is_right(answer, readouts) for question, answer in zip(questions, answers, strict=True)]


def test_the_ball_keeps_as_much_of_its_speed_as_the_task_says():
    stage = stage_of("bouncing-ball", "task-restitution")
    heights = []
    for _ in range(round(1.6 / stage.dt)):
        stage.run(1)
        heights.append(stage.readouts()[0].value)
    landed = next(i for i, one in enumerate(heights) if one < 0.01)
    rise = max(heights[landed:])
    lost = 1.0 - rise
    assert 0.4 < lost < 0.5
    assert judged(stage, [f"{rise:.3f}", f"{math.sqrt(rise):.3f}", "2"]) == [True, True, True]
    assert judged(stage, ["0.5", "0.8", "1"]) == [False, False, False]


def test_ten_swings_last_as_long_as_the_task_says():
    stage = stage_of("pendulum", "task-period")
    crossings, before = [], stage.scene.swing[0]
    while len(crossings) < 21:
        stage.run(1)
        now = stage.scene.swing[0]
        if before > 0.0 >= now or before < 0.0 <= now:
            crossings.append(stage.time_s - stage.dt * now / (now - before))
        before = now
    ten = crossings[20] - crossings[0]
    length = 9.81 * (ten / 10.0 / math.tau) ** 2
    lowest = stage.scene.frame()
    assert judged(stage, [f"{ten:.2f}", f"{length:.3f}", "", "3"])[:2] == [True, True]
    assert not judged(stage, [f"{ten / 2:.2f}", "0.6", "", "1"])[2]
    stage.post(Pointer("down", 0.5, 0.0, 1))
    stage.post(Pointer("up", 0.5, 0.0, 1))
    assert judged(stage, ["", "", "", "3"])[2:] == [True, True] and lowest.bottom < -0.5


def test_the_jet_rises_as_high_as_its_speed_says():
    stage = stage_of("c04", "task-speed")
    stage.run(round(3.0 / stage.dt))
    readouts = {one.name: one.value for one in stage.readouts()}
    speed = math.sqrt(2.0 * 9.81 * readouts["highest"])
    born = 8000.0 * 2.4
    assert judged(stage, [f"{speed:.2f}", f"{born:.0f}", "2"]) == [True, True, True]
    assert np.isclose(readouts["particles"], born, rtol=0.05)


@pytest.mark.parametrize(
    ("scene", "task"),
    [("bouncing-ball", "task-restitution"), ("pendulum", "task-period"), ("c04", "task-speed")],
)
def test_what_is_asked_for_cannot_be_read_off(scene, task):
    stage = stage_of(scene, task)
    teaching = stage.level.teaching
    assert teaching.hidden_parameters and teaching.fixed >= set(teaching.hidden_parameters)
    for question in teaching.questions:
        if getattr(question, "value", None) is not None:
            shown = set(stage.scene.values) - set(teaching.hidden_parameters)
            assert question.value not in [stage.scene.values[name] for name in shown if name != "length"]
