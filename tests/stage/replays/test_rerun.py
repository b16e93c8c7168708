"""The last part of a session gone through once more: from any kept step, to the same digest, beside it."""

from __future__ import annotations

import pytest

from game.stage import Pointer, SetEffect, SetParameter, Stage
from game.stage.replays.rerun import Rerun
from game.stage.states.snapshots import INTERVAL
from tests.stage.example_scene import KICK, BouncingBall

TO_THE_END = 10**9


def stage_with_a_past() -> Stage:
    """Events between kept states, and at the very steps of some; a parameter that builds the scene again."""
    stage = Stage(BouncingBall)
    stage.run(3 * INTERVAL)
    stage.post(SetParameter("height", 3.0))  # at the step of a snapshot
    stage.run(INTERVAL // 2)
    stage.post(SetEffect("test-ground", False))
    stage.run(INTERVAL // 2)
    stage.post(KICK)  # at the step of a snapshot
    stage.run(INTERVAL)
    stage.post(Pointer("down", 0.5, 1.0, 1))
    stage.run(5)
    stage.post(Pointer("up", 0.5, 1.0, 1))
    stage.run(7)
    stage.post(SetParameter("gravity", 3.0))  # at the last step
    return stage


STEPS = (
    0,
    1,
    3 * INTERVAL,
    3 * INTERVAL + 1,
    4 * INTERVAL,
    5 * INTERVAL,
    5 * INTERVAL + 5,
    5 * INTERVAL + 12,
)


@pytest.mark.parametrize("step", STEPS)
def test_it_comes_to_the_same_digest_from_any_step(step):
    stage = stage_with_a_past()
    rerun = Rerun(stage.kept_from(step))
    assert rerun.step == step and rerun.scene is not stage.scene
    rerun.advance_to(TO_THE_END)
    assert rerun.finished and rerun.same and rerun.step == stage.step_number
    assert rerun.scene.values == stage.scene.values and rerun.scene.active == stage.scene.active


def test_the_session_goes_on_as_if_nothing_were():
    stage, twin = stage_with_a_past(), stage_with_a_past()
    rerun = Rerun(stage.kept_from(INTERVAL))
    for _ in range(200):
        stage.run(1)
        rerun.advance_to(rerun.step + 1)
    twin.run(200)
    assert stage.digest() == twin.digest() and rerun.same


def test_what_is_out_of_reach_begins_at_the_first_step_that_is_kept():
    stage = Stage(BouncingBall, snapshot_bytes=8_000)
    stage.run(2000)
    kept = stage.kept_from(0)
    assert kept.first == stage.first_step > 0
    rerun = Rerun(kept)
    rerun.advance_to(TO_THE_END)
    assert rerun.same


def test_another_way_is_not_the_same():
    stage = stage_with_a_past()
    kept = stage.kept_from(INTERVAL)
    kick = next(one for one in kept.events if one.event == KICK)
    rerun = Rerun(kept._replace(events=tuple(one for one in kept.events if one is not kick)))
    rerun.advance_to(TO_THE_END)
    assert rerun.step == kept.last and not rerun.same


def test_it_is_of_the_sessions_own_kind():
    """The view is made by the class: another one would draw and hear something else."""
    stage = stage_with_a_past()
    rerun = Rerun(stage.kept_from(INTERVAL))
    assert rerun.scene_type is BouncingBall is type(rerun.scene) and rerun.dt == stage.dt
