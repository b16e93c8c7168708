"""C02: skeletons made, skinned and posed by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.levels import Level, format_level, level_files, parse_level
from game.scenes.skeletons.level import FigureContent, bone_named
from game.scenes.skeletons.skinning import Skinning
from game.stage import Action, Pointer, SetEffect, SetParameter, Stage, replay_scene
from tests.scenes.particle_stages import click, drag, move, open_level, press, readouts, release


def still(name="default", **declared):
    return open_level(Skinning, name, motion=False, **declared)


def end_of(stage, name):
    rig = stage.scene.model.rig
    return rig.skeleton.ends[bone_named(rig.figure, name)].copy()


def middle_of(stage, name):
    skeleton = stage.scene.model.rig.skeleton
    bone = bone_named(stage.scene.model.rig.figure, name)
    return 0.5 * (skeleton.bases[bone] + skeleton.ends[bone])


def test_the_first_figure_has_fifteen_bones_and_a_skin_and_moves():
    """C02.1: what one sees first invites."""
    stage = open_level(Skinning, "default")
    assert stage.scene.model.rig.skeleton.count >= 15
    assert len(stage.scene.model.bench.figure.skins) >= 5
    hand = end_of(stage, "left hand")
    stage.run(20)
    assert np.linalg.norm(end_of(stage, "left hand") - hand) > 0.05
    assert stage.fault is None


def test_a_bone_is_made_by_clicking_its_parent_and_then_its_end():
    """C02.2, .3: also while it stands still; a bone may have several children."""
    stage = still("draw")
    stage.pause()
    stage.post(SetParameter("tool", "bone"))
    click(stage, (0.0, 0.8))
    assert stage.scene.model.bench.chosen == 0
    click(stage, (0.4, 1.3))
    assert np.allclose(end_of(stage, "bone 1"), (0.4, 1.3), rtol=0, atol=1e-12)
    click(stage, (0.0, 0.8))
    click(stage, (-0.4, 1.3))
    click(stage, (-0.7, 1.6))
    skeleton = stage.scene.model.rig.skeleton
    assert skeleton.parents.tolist() == [-1, 0, 0, 2]
    assert skeleton.children(0) == [1, 2]
    assert np.allclose(skeleton.ends[3], (-0.7, 1.6), rtol=0, atol=1e-12)
    stage.post(Action("delete"))
    stage.post(Action("pose"))
    click(stage, middle_of(stage, "bone 2"))
    stage.post(Action("delete"))
    assert stage.scene.model.rig.skeleton.parents.tolist() == [-1, 0]


def test_a_bone_without_a_parent_clicked_is_not_made():
    stage = still("draw", tool="bone")
    click(stage, (0.9, 1.8))
    assert stage.scene.model.rig.skeleton.count == 1
    assert any("parent" in words for words in stage.scene.messages())


def test_bones_hold_place_angle_and_length():
    """C02.4: the end is computed."""
    stage = still()
    skeleton = stage.scene.model.rig.skeleton
    off = skeleton.ends - skeleton.bases
    assert np.allclose(np.sqrt((off * off).sum(axis=1)), skeleton.lengths, rtol=0, atol=1e-14)
    assert np.allclose(
        np.arctan2(off[:, 1], off[:, 0]), [skeleton.world_angle(i) for i in range(skeleton.count)]
    )


def test_a_skin_is_drawn_by_clicking_around_and_follows():
    """C02.5, .6, .7: closed by a click on its first corner; no weights beyond the threshold."""
    stage = still("bent-bar", threshold=0.5)
    stage.post(SetParameter("tool", "skin"))
    corners = [(-1.1, -0.3), (0.0, -0.35), (1.1, -0.3), (1.1, 0.3), (0.0, 0.35), (-1.1, 0.3)]
    for corner in corners:
        click(stage, corner)
    assert len(stage.scene.model.bench.drawn) == 6
    click(stage, corners[0])
    assert not stage.scene.model.bench.drawn
    rig = stage.scene.model.rig
    assert len(rig.figure.skins) == 2
    points = rig.binding.points[rig.outline(1)]
    weights = rig.weights[rig.outline(1)]
    right = points[:, 0] > 0.6
    assert np.all(weights[right, 0] == 0.0)
    stage.post(SetParameter("tool", "pose"))
    drag(stage, (0.8, 0.0), (0.0, 0.8), steps=6)
    stage.run(1)
    moved = stage.scene.model.rig.skinned[stage.scene.model.rig.outline(1)]
    assert np.allclose(
        moved[right], np.column_stack([-points[right, 1], points[right, 0]]), rtol=0, atol=0.05
    )


def test_a_skin_can_be_given_up_finished_and_taken_away():
    stage = still("bent-bar", tool="skin")
    for corner in ((-1.1, -0.3), (1.1, -0.3)):
        click(stage, corner)
    stage.post(Action("finish"))
    assert any("three" in words for words in stage.scene.messages())
    click(stage, (0.0, 0.5))
    stage.post(Action("finish"))
    assert len(stage.scene.model.rig.figure.skins) == 2
    click(stage, (0.0, 0.5))
    stage.post(Pointer("cancel", 0.0, 0.0))
    assert not stage.scene.model.bench.drawn
    stage.post(Action("delete"))
    assert len(stage.scene.model.rig.figure.skins) == 1
    stage.post(Action("undo"))
    assert len(stage.scene.model.rig.figure.skins) == 2


def test_a_bone_is_dragged_and_its_children_come_along():
    """C02.8, .9: forward kinematics by 3 x 3 matrices."""
    stage = still()
    arm = bone_named(stage.scene.model.rig.figure, "right upper arm")
    before = stage.scene.model.rig.skeleton.world.copy()
    base = stage.scene.model.rig.skeleton.bases[arm].copy()
    drag(stage, middle_of(stage, "right upper arm"), base + np.array((-0.02, 0.14)), steps=12)
    skeleton = stage.scene.model.rig.skeleton
    assert stage.scene.model.bench.chosen == arm
    turn = skeleton.world[arm] @ np.linalg.inv(before[arm])
    for name in ("right forearm", "right hand"):
        bone = bone_named(stage.scene.model.rig.figure, name)
        assert np.allclose(skeleton.world[bone], turn @ before[bone], rtol=0, atol=1e-12)
    other = bone_named(stage.scene.model.rig.figure, "left hand")
    assert np.array_equal(skeleton.world[other], before[other])


def test_joint_limits_hold_a_drag_and_can_be_switched_off():
    stage = still()
    shin = bone_named(stage.scene.model.rig.figure, "left shin")
    rig = stage.scene.model.rig
    press(stage, middle_of(stage, "left shin"))
    for k in range(1, 20):
        base = stage.scene.model.rig.skeleton.bases[shin]
        turn = rig.skeleton.world_angle(bone_named(rig.figure, "left thigh")) + 0.15 * k
        move(stage, base + 0.2 * np.array((math.cos(turn), math.sin(turn))))
    release(stage, (0.0, 0.0))
    assert stage.scene.model.rig.skeleton.angles[shin] == rig.skeleton.upper[shin]
    stage.post(SetEffect("joint-limits", False))
    press(stage, middle_of(stage, "left shin"))
    base = stage.scene.model.rig.skeleton.bases[shin]
    move(stage, base + np.array((0.2, 0.1)))
    assert stage.scene.model.rig.skeleton.angles[shin] > rig.skeleton.upper[shin] + 0.1


def test_the_root_is_dragged():
    stage = still()
    before = stage.scene.model.rig.skeleton.ends.copy()
    root = stage.scene.model.rig.skeleton.bases[0]
    drag(stage, root, root + np.array((0.2, -0.1)), steps=4)
    assert np.allclose(
        stage.scene.model.rig.skeleton.ends, before + np.array((0.2, -0.1)), rtol=0, atol=1e-12
    )


def test_every_edit_is_undone_and_done_again():
    stage = still("bent-bar")
    scene = stage.scene
    states = [scene.save_content()]
    stage.post(SetParameter("tool", "bone"))
    click(stage, scene.model.rig.skeleton.ends[1] * 0.5 + scene.model.rig.skeleton.bases[1] * 0.5)
    click(stage, (1.0, 1.0))
    states.append(scene.save_content())
    stage.post(SetParameter("tool", "pose"))
    drag(
        stage,
        scene.model.rig.skeleton.ends[1] * 0.5 + scene.model.rig.skeleton.bases[1] * 0.5,
        (0.3, -0.4),
        steps=3,
    )
    states.append(scene.save_content())
    stage.post(Action("stand"))
    states.append(scene.save_content())
    for state in states[-2::-1]:
        stage.post(Action("undo"))
        assert same(scene.save_content(), state)
    stage.post(Action("undo"))
    assert any("nothing to undo" in words for words in scene.messages())
    for state in states[1:]:
        stage.post(Action("redo"))
        assert same(scene.save_content(), state)


def same(a, b):
    """Equal figures, but for rounding in the turns."""
    if len(a.bones) != len(b.bones) or a.skins != b.skins:
        return False
    return all(
        p.name == q.name and abs(p.turn - q.turn) < 1e-9 and abs(p.angle - q.angle) < 1e-9
        for p, q in zip(a.bones, b.bones, strict=True)
    )


def test_saved_and_read_back():
    stage = still()
    drag(
        stage, middle_of(stage, "left forearm"), middle_of(stage, "left forearm") + np.array((0.05, 0.02)), 3
    )
    text = format_level(Level(scene="c02", content=stage.scene.save_content()))
    back = Stage(Skinning, level=parse_level(text, "c02", FigureContent), parameters={"motion": False})
    assert np.allclose(
        back.scene.model.rig.skeleton.ends, stage.scene.model.rig.skeleton.ends, rtol=0, atol=1e-9
    )


def test_weights_follow_their_parameters():
    """Beyond: falloff and influences; weights as colours are of the same numbers."""
    stage = still("bent-bar", smooth=False)
    soft = stage.scene.model.rig.weights.copy()
    stage.post(SetParameter("falloff", 1.0))
    assert np.abs(stage.scene.model.rig.weights - soft).max() > 0.1
    stage.post(SetParameter("influences", 1))
    assert np.count_nonzero(stage.scene.model.rig.weights, axis=1).max() == 1
    stage.post(Action("show-weights"))
    assert stage.scene.parameters.weights


def test_matrices_lose_area_and_rotors_keep_it():
    """Beyond: area loss measured, both blends beside each other."""
    stage = still("bent-bar")
    stage.run(2)
    values = readouts(stage)
    assert values["linear"] < 98.5
    assert abs(values["rotor"] - 100.0) < 0.5
    assert values["apart"] > 0.03
    assert values["area kept"] == values["linear"]
    stage.post(SetParameter("blend", "rotor"))
    stage.run(1)
    assert readouts(stage)["area kept"] == pytest.approx(readouts(stage)["rotor"])


def test_without_the_effect_the_skin_stays():
    stage = open_level(Skinning, "default")
    stage.post(SetEffect("skinning", False))
    stage.run(1)
    before = stage.scene.model.rig.skinned.copy()
    stage.run(30)
    assert np.array_equal(stage.scene.model.rig.skinned, before)


def test_stepping_back_undoes_edits_and_replays_exactly():
    stage = still("bent-bar")
    stage.run(3)
    digest = stage.digest()
    bone = 0.5 * (stage.scene.model.rig.skeleton.bases[1] + stage.scene.model.rig.skeleton.ends[1])
    stage.post(SetParameter("tool", "bone"))
    click(stage, bone)
    click(stage, (1.2, 1.1))
    stage.run(2)
    assert stage.scene.model.rig.skeleton.count == 3
    stage.step_back()
    stage.step_back()
    stage.step_back()
    assert stage.scene.model.rig.skeleton.count == 2
    stage.step()
    stage.step()
    stage.step()
    assert stage.scene.model.rig.skeleton.count == 3
    assert stage.digest() != digest
    again = replay_scene(stage.recording, Skinning)
    assert again.digest() == stage.digest()


def test_all_levels_but_the_hard_ones_run():
    for path in level_files("c02"):
        if not path.stem.startswith("hard-"):
            stage = open_level(Skinning, path.stem)
            stage.run(30)
            assert stage.fault is None
            assert stage.scene.legend()


def test_a_child_bone_begins_where_its_parent_is_clicked_with_shift():
    stage = open_level(Skinning, "draw")
    rig = stage.scene.model.rig
    base, end = rig.skeleton.bases[0].copy(), rig.skeleton.ends[0].copy()
    click(stage, base + 0.25 * (end - base), shift=True)
    click(stage, (0.5, 0.9))
    skeleton = stage.scene.model.rig.skeleton
    assert np.allclose(skeleton.bases[1], base + 0.25 * (end - base), rtol=0, atol=1e-12)
    assert np.allclose(skeleton.ends[1], (0.5, 0.9), rtol=0, atol=1e-12)
    click(stage, (0.8, 0.9))  # the next one hangs on the end of this one again
    skeleton = stage.scene.model.rig.skeleton
    assert np.allclose(skeleton.bases[2], (0.5, 0.9), rtol=0, atol=1e-12)
    again = open_level(Skinning, "draw")
    click(again, base + 0.25 * (end - base))
    click(again, (0.5, 0.9))
    assert np.allclose(again.scene.model.rig.skeleton.bases[1], end, rtol=0, atol=1e-12)


def test_the_guide_ticks_off_what_is_done():
    stage = open_level(Skinning, "draw")

    def done():
        return [caption.met for caption in stage.scene.guide()]

    assert done() == [False, False, False]
    for i in range(14):
        if i == 0:
            click(stage, stage.scene.model.rig.skeleton.ends[0] - (0.0, 0.05))
        click(stage, (0.1 * (i % 2), 1.0 + 0.05 * (i + 1)))
    assert done() == [True, False, False]
    stage.post(Action("skin"))
    for corner in ((-0.3, 0.5), (0.4, 0.5), (0.4, 1.9), (-0.3, 1.9)):
        click(stage, corner)
    stage.post(Action("finish"))
    assert done() == [True, True, False]
    stage.post(Action("pose"))
    skeleton = stage.scene.model.rig.skeleton
    middle = 0.5 * (skeleton.bases[0] + skeleton.ends[0])
    drag(stage, middle, (middle[0] + 0.3, middle[1] + 0.1))
    assert done() == [True, True, True]


def test_the_last_bones_end_is_compared_with_a_sum_of_its_own():
    stage = open_level(Skinning, "hard-07-thousand-bones")
    assert readouts(stage)["forward error"] < 1e-12
    skeleton = stage.scene.model.rig.skeleton
    skeleton.ends[-1] += (0.0, 1e-6)
    assert readouts(stage)["forward error"] == pytest.approx(1e-6, rel=1e-6)


def test_on_a_bone_that_lies_the_new_one_begins_where_it_was_clicked():
    stage = open_level(Skinning, "bent-bar", motion=False, tool="bone")
    skeleton = stage.scene.model.rig.skeleton
    base, end = skeleton.bases[0].copy(), skeleton.ends[0].copy()
    assert abs(end[0] - base[0]) > 0.5
    click(stage, base + 0.25 * (end - base), shift=True)
    click(stage, (float(base[0]), float(base[1]) - 0.45))
    assert np.allclose(
        stage.scene.model.rig.skeleton.bases[-1], base + 0.25 * (end - base), rtol=0, atol=1e-9
    )
    assert np.allclose(stage.scene.model.rig.skeleton.ends[-1], (base[0], base[1] - 0.45), rtol=0, atol=1e-9)
