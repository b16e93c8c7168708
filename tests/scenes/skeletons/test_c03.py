"""C03: a chain picked, a target pulled, six methods at once."""

from __future__ import annotations

import math
from contextlib import contextmanager

import numpy as np
import pytest

from game.levels import Level, format_level, level_files, parse_level
from game.scenes.skeletons.cells import cell_at, cells_of
from game.scenes.skeletons.inverse_kinematics import InverseKinematics
from game.scenes.skeletons.level import FigureContent, bone_named
from game.scenes.skeletons.parameters import SHOWN
from game.scenes.skeletons.readouts import NAMES
from game.stage import Action, SetEffect, SetParameter, Stage, replay_scene
from tests.scenes.particle_stages import click, drag, move, open_level, press, readouts, release


def still(name="default", **declared):
    return open_level(InverseKinematics, name, motion=False, **declared)


def outside(stage, point, k=None):
    """The place in the picture of a point of a method's figure (the chosen one's)."""
    scene = stage.scene
    k = scene.parameters.master if k is None else k
    cell = cells_of(scene.model.bench.figure.view, scene.parameters.compare)[k]
    return (
        cell.out(np.array([point]))[0]
        if scene.parameters.compare
        else np.array(point) * 2.0 + (cell.x, cell.y)
    )


def middle_of(stage, name):
    skeleton = stage.scene.model.rig.skeleton
    bone = bone_named(stage.scene.model.rig.figure, name)
    return 0.5 * (skeleton.bases[bone] + skeleton.ends[bone])


def test_the_first_figure_has_fifteen_bones_and_all_methods_follow_its_target():
    """C03.1 and beyond: side by side, each with iterations, error and time."""
    stage = open_level(InverseKinematics, "default")
    assert stage.scene.model.rig.skeleton.count >= 15
    stage.run(60)
    assert stage.fault is None
    values = readouts(stage)
    for name in NAMES:
        assert values[name] < 0.3
        assert 0 <= values[f"{name} iterations"] <= 10
        assert values[f"{name} time"] > 0.0
    assert values["damped"] < 1e-5
    assert len({tuple(row) for row in stage.scene.model.methods.round(3).tolist()}) > 1


def test_start_and_end_of_the_chain_are_picked():
    """C03.2: two clicks, in either order."""
    stage = still(tool="chain")
    for first, second in (("left upper arm", "left hand"), ("left hand", "chest")):
        click(stage, outside(stage, middle_of(stage, first)))
        click(stage, outside(stage, middle_of(stage, second)))
        names = [stage.scene.model.rig.figure.bones[i].name for i in stage.scene.model.inside]
        assert names[-1] == "left hand"
        assert names[0] in (first, second)
    click(stage, outside(stage, middle_of(stage, "left hand")))
    click(stage, outside(stage, middle_of(stage, "right foot")))
    assert any("hang" in words for words in stage.scene.messages())
    stage.run(10)
    assert stage.fault is None


def test_bones_are_made_and_turned_as_in_c02():
    """C03.1, .3: by the same editor."""
    stage = still("draw")
    click(stage, outside(stage, middle_of(stage, "root")))
    click(stage, outside(stage, (0.5, 1.0)))
    click(stage, outside(stage, (0.9, 1.1)))
    assert stage.scene.model.rig.skeleton.parents.tolist() == [-1, 0, 1]
    stage.post(SetParameter("tool", "chain"))
    click(stage, outside(stage, middle_of(stage, "root")))
    click(stage, outside(stage, middle_of(stage, "bone 2")))
    assert stage.scene.model.inside.tolist() == [0, 1, 2]
    stage.post(SetParameter("tool", "pull"))
    press(stage, outside(stage, (0.2, 0.9)))
    release(stage, outside(stage, (0.2, 0.9)))
    stage.run(80)
    assert np.allclose(stage.scene.model.rig.skeleton.ends[2], (0.2, 0.9), rtol=0, atol=1e-5)
    stage.post(SetParameter("tool", "pose"))
    before = stage.scene.model.rig.skeleton.angles.copy()
    at = middle_of(stage, "bone 1")
    press(stage, outside(stage, at))
    move(stage, outside(stage, at + np.array((0.0, 0.1))))
    assert stage.scene.model.rig.skeleton.angles[1] != before[1]
    assert np.array_equal(stage.scene.model.methods, np.tile(stage.scene.model.methods[0], (6, 1)))


@pytest.mark.parametrize("k", range(6))
def test_the_end_is_dragged_and_the_chain_follows(k):
    """C03.4: in any of the figures; the target is the same for all."""
    stage = still(iterations=200)
    end = stage.scene.model.rig.skeleton.ends[stage.scene.model.inside[-1]]
    drag(stage, outside(stage, end, k), outside(stage, (0.55, 1.25), k), steps=20)
    assert stage.scene.parameters.method == SHOWN[k]
    assert np.allclose(stage.scene.model.target, (0.55, 1.25), rtol=0, atol=1e-12)
    stage.run(20)
    assert stage.scene.model.measured[k].error < 5e-3
    assert not stage.scene.parameters.motion


def test_alone_and_side_by_side():
    stage = still()
    stage.post(Action("compare-all"))
    assert not stage.scene.parameters.compare
    place = outside(stage, (0.5, 1.2))
    press(stage, place)
    assert np.allclose(stage.scene.model.target, (0.5, 1.2), rtol=0, atol=1e-12)
    release(stage, place)
    frame = stage.scene.frame()
    middles = [(frame.right * (c + 0.5) / 3, frame.top * (1.5 - r) / 2) for r in (0, 1) for c in range(3)]
    assert [cell_at(x, y, frame) for x, y in middles] == [0, 1, 2, 3, 4, 5]


def test_out_of_reach_nobody_shakes():
    stage = still("hard-01-out-of-reach", iterations=50)
    stage.run(120)
    before = stage.scene.model.methods.copy()
    stage.run(60)
    assert np.abs(stage.scene.model.methods - before).max() < 2e-3
    for name in NAMES:
        assert readouts(stage)[name] == pytest.approx(1.20555127546399, abs=1e-5)
    stage.post(SetParameter("adaptive", False))
    stage.post(SetParameter("damping", 0.01))
    turns = []
    for _ in range(20):
        stage.run(1)
        turns.append(stage.scene.model.methods[3].copy())
    assert np.abs(np.diff(turns, axis=0)).max() > 0.3


def test_joint_limits_hold_every_method():
    stage = open_level(InverseKinematics, "default")
    skeleton = stage.scene.model.rig.skeleton
    inside = stage.scene.model.inside
    for _ in range(10):
        stage.run(30)
        angles = stage.scene.model.methods[:, inside]
        assert np.all(angles >= skeleton.lower[inside] - 1e-12)
        assert np.all(angles <= skeleton.upper[inside] + 1e-12)
    stage.post(SetEffect("joint-limits", False))
    stage.run(120)
    assert readouts(stage)["FABRIK"] < 1e-3


def test_a_step_above_two_swings():
    errors = {}
    for step in (1.0, 3.5):
        stage = still("hard-04-full-reach", gradient_step=step)
        stage.run(100)
        errors[step] = readouts(stage)["gradient"]
    assert errors[3.5] > 3 * errors[1.0]


def test_the_dead_point_is_seen_and_left():
    stage = still("hard-03-dead-point")
    assert stage.scene.model.measured[0].error == pytest.approx(1.4)
    stage.run(400)
    assert max(readouts(stage)[name] for name in NAMES) < 0.05


def test_pulls_and_picks_are_undone():
    stage = still()
    stage.run(60)  # until the chain has its target
    before, target = stage.scene.model.rig.now, stage.scene.model.target.copy()
    drag(stage, outside(stage, (0.6, 1.4)), outside(stage, (0.3, 0.9)), steps=5)
    stage.run(30)
    assert np.abs(stage.scene.model.rig.now - before).max() > 0.05
    pulled = stage.scene.model.target.copy()
    stage.post(Action("undo"))
    assert np.allclose(stage.scene.model.rig.now, before, rtol=0, atol=1e-12)
    assert (stage.scene.model.target == target).all()  # else the chain would run back at once
    stage.run(30)
    assert np.abs(stage.scene.model.rig.now - before).max() < 0.02
    stage.post(Action("redo"))
    assert (stage.scene.model.target == pulled).all()
    stage.post(Action("undo"))
    stage.post(SetParameter("tool", "chain"))
    chain = stage.scene.model.rig.figure.chain
    click(stage, outside(stage, middle_of(stage, "left thigh")))
    click(stage, outside(stage, middle_of(stage, "left foot")))
    assert stage.scene.model.rig.figure.chain.end == "left foot"
    stage.post(Action("undo"))
    assert stage.scene.model.rig.figure.chain == chain
    stage.post(Action("redo"))
    assert stage.scene.model.rig.figure.chain.end == "left foot"


def test_a_bone_of_the_chain_is_not_deleted():
    stage = still(tool="pose")
    click(stage, outside(stage, middle_of(stage, "left forearm")))
    stage.post(Action("delete"))
    assert any("chain" in words for words in stage.scene.messages())
    assert stage.scene.model.rig.skeleton.count >= 15


def test_saved_and_read_back_with_its_target():
    stage = still()
    drag(stage, outside(stage, (0.6, 1.4)), outside(stage, (0.4, 1.1)), steps=5)
    stage.run(30)
    text = format_level(Level(scene="c03", content=stage.scene.save_content()))
    back = Stage(
        InverseKinematics, level=parse_level(text, "c03", FigureContent), parameters={"motion": False}
    )
    assert np.allclose(back.scene.model.target, stage.scene.model.target, rtol=0, atol=1e-12)
    assert np.allclose(back.scene.model.rig.now, stage.scene.model.rig.now, rtol=0, atol=1e-9)


def test_stepping_back_and_replaying():
    stage = open_level(InverseKinematics, "default")
    stage.run(10)
    drag(stage, outside(stage, (0.6, 1.4)), outside(stage, (0.4, 1.1)), steps=5)
    stage.run(5)
    digest = stage.digest()
    for _ in range(8):
        stage.step_back()
    for _ in range(8):
        stage.step()
    assert stage.digest() == digest
    assert replay_scene(stage.recording, InverseKinematics).digest() == digest


def test_all_levels_but_the_hard_ones_run():
    for path in level_files("c03"):
        if not path.stem.startswith("hard-"):
            stage = open_level(InverseKinematics, path.stem)
            stage.run(30)
            assert stage.fault is None
            assert math.isfinite(readouts(stage)["error"])


def test_no_method_is_timed_on_cold_caches(monkeypatch):
    """A solve that is not timed comes before those that are, and each method has its turn to be the first.

    The first solve after a picture takes two to five times as long as the same solve among others.
    """
    stage = still()
    calls, timed = [], []
    solve = stage.scene.model.solver.solve

    def noted(target, method, *arguments, **options):
        calls.append((method, bool(timed)))
        return solve(target, method, *arguments, **options)

    @contextmanager
    def watched(name):
        timed.append(name)
        yield
        timed.pop()

    monkeypatch.setattr(stage.scene.model.solver, "solve", noted)
    monkeypatch.setattr(stage.scene.model.watch, "time", watched)
    begun = []
    for _ in SHOWN:
        calls.clear()
        stage.run(1)
        assert [inside for _, inside in calls] == [False] + [True] * len(SHOWN)
        assert sorted(method for method, inside in calls if inside) == sorted(SHOWN)
        begun.append(calls[1][0])
    assert sorted(begun) == sorted(SHOWN)


def test_the_solve_that_is_not_timed_leaves_nothing_behind():
    """Whichever method begins, all come to the same poses."""
    first, second = still(), still()
    for k in range(12):
        first.scene.model.solve_all(first=k % len(SHOWN))
        second.scene.model.solve_all(first=0)
    assert first.digest() == second.digest()


def test_time_is_steps_times_their_length():
    """Not a sum of as many roundings; also after a state was put back."""
    stage = still(compare=False)
    dt = stage.scene.dt
    stage.run(1_000)
    assert stage.scene.model.time == 1_000 * dt != sum([dt] * 1_000)
    kept = stage.scene.state()
    stage.run(7)
    stage.scene.restore(kept)
    stage.scene.advance(dt)
    assert stage.scene.model.time == 1_001 * dt
