"""Hard cases of skeletons and skinning (C02 H1 to H9)."""

from __future__ import annotations

import cmath
import math

import msgspec
import numpy as np
import pytest

from game.levels import LevelError, level_files, load_level, parse_level
from game.physics.animation import (
    BLENDS,
    Skeleton,
    SkeletonError,
    WeightError,
    bind_given,
    bind_weights,
    chain_skeleton,
    skin,
)
from game.physics.animation.weights import invert_frames
from game.scenes.skeletons.level import FigureContent
from game.scenes.skeletons.skinning import Skinning
from game.stage import Action
from tests.scenes.particle_stages import open_level, stage_of

EPS = 2.0**-52
LEVELS = [path for path in level_files("c02") if path.stem.startswith("hard-")]


@pytest.mark.parametrize("path", LEVELS, ids=lambda path: path.stem)
def test_every_level_of_the_gallery_runs(path):
    stage = stage_of(Skinning, path)
    for blend in BLENDS:
        stage.scene.values["blend"] = blend
        stage.run(20)
        assert stage.fault is None
        stage.scene.model.rig.skeleton.check()
        if stage.scene.model.rig.binding is not None:
            stage.scene.model.rig.binding.check()


def test_beyond_every_threshold_the_nearest_bone_leads():
    skeleton = Skeleton([-1, 0], [1.0, 1.0])
    points = [(0.3, 5.0), (1.7, -5.0), (1.0, 4.0)]
    binding = bind_weights(skeleton, points, 0.1)
    assert binding.dense().tolist() == [[1.0, 0.0], [0.0, 1.0], [1.0, 0.0]]  # a tie goes to the lower index
    rig = open_level(Skinning, "hard-01-beyond-the-threshold").scene.model.rig
    assert set(np.unique(rig.weights[rig.outline(0)]).tolist()) == {0.0, 1.0}


def test_on_a_bone_or_a_joint_the_weight_is_finite():
    skeleton = Skeleton([-1, 0], [1.0, 1.0])
    weights = bind_weights(skeleton, [(0.5, 0.0), (1.0, 0.0), (2.0, 0.0)], 0.4).dense()
    assert weights.tolist() == [[1.0, 0.0], [0.5, 0.5], [0.0, 1.0]]
    rig = open_level(Skinning, "hard-02-on-the-bone").scene.model.rig
    assert np.abs(rig.weights.sum(axis=1) - 1.0).max() <= 4 * EPS


def test_a_bone_without_length_is_a_point():
    skeleton = Skeleton([-1, 0, 1], [1.0, 0.0, 1.0])
    weights = bind_weights(skeleton, [(1.0, 0.3)], 1.0, 2.0).dense()[0]
    assert np.allclose(weights, 1 / 3, rtol=0, atol=4 * EPS)
    skeleton.pose([0.2, 0.7, -0.4])
    assert np.array_equal(skeleton.bases[1], skeleton.ends[1])


def test_weights_are_cut_made_whole_or_refused():
    rig = open_level(Skinning, "hard-04-weights-given").scene.model.rig
    assert np.count_nonzero(rig.weights, axis=1).max() == 2
    text = next(p for p in LEVELS if "04" in p.stem).read_text()
    level = parse_level(text, "c02", FigureContent)
    (skin_entry,) = level.content.skins
    for wrong in (-1.0, 0.0):
        rows = (tuple(wrong for _ in skin_entry.weights[0]), *skin_entry.weights[1:])
        broken = msgspec.structs.replace(
            level, content=msgspec.structs.replace(
                level.content, skins=(msgspec.structs.replace(skin_entry, weights=rows),)
            ),
        )  # fmt: skip
        with pytest.raises(LevelError, match=r"content: weights"):
            Skinning(broken)
    with pytest.raises(LevelError, match="weights"):
        parse_level(text.replace("weights = [", "weights = [[nan, 1.0, 1.0, 1.0],", 1), "c02", FigureContent)
    with pytest.raises(WeightError, match="0 or more"):
        bind_given(chain_skeleton([1.0]), [(0.0, 0.0)], [[math.nan]])


@pytest.mark.parametrize("degrees", [179.9, 180.0])
def test_a_closed_joint_collapses_as_predicted_and_nothing_flips(degrees):
    skeleton = chain_skeleton([1.0, 1.0])
    binding = bind_given(skeleton, [(1.0, 0.2), (0.5, 0.2), (1.5, 0.2)], [[0.5, 0.5], [1.0, 0.0], [0.0, 1.0]])
    skeleton.turn(1, math.radians(degrees))
    linear, rotor = skin(skeleton, binding), skin(skeleton, binding, "rotor")
    factor = math.cos(math.radians(degrees) / 2)
    assert np.linalg.norm(linear[0] - (1.0, 0.0)) == pytest.approx(0.2 * factor, abs=1e-13)
    assert np.linalg.norm(rotor[0] - (1.0, 0.0)) == pytest.approx(0.2, abs=1e-13)
    for moved in (linear, rotor):
        assert np.allclose(moved[1], (0.5, 0.2), rtol=0, atol=1e-15)
        turned = cmath.exp(1j * math.radians(degrees)) * (0.5 + 0.2j) + 1.0
        assert np.allclose(moved[2], (turned.real, turned.imag), rtol=0, atol=1e-13)


def test_what_has_no_size_cannot_be_bound():
    frames = np.tile(np.eye(3), (2, 1, 1))
    frames[1, :2, :2] = 0.0
    with pytest.raises(WeightError, match="bone 1"):
        invert_frames(frames)
    frames[1, :2, :2] = ((1.0, 1.0), (1.0, 1.0))
    with pytest.raises(WeightError, match="bone 1"):
        invert_frames(frames)
    small, plain = open_level(Skinning, "hard-06-tiny"), open_level(Skinning, "bent-bar")
    assert np.allclose(small.scene.model.rig.skeleton.lengths * 1e3, plain.scene.model.rig.skeleton.lengths)
    small.run(2)
    assert small.scene.model.skin_areas["rotor"] > 0.9


def test_a_thousand_bones():
    skeleton = chain_skeleton(np.full(1000, 0.01), np.full(1000, math.radians(0.37)))
    turn, end, step = 1.0 + 0.0j, 0.0 + 0.0j, cmath.exp(1j * math.radians(0.37))
    for _ in range(1000):
        turn *= step
        end += 0.01 * turn
    off = abs(complex(*skeleton.ends[-1]) - end)
    assert off <= 1000 * 8 * EPS * 10.0


def test_binding_again_and_any_order_give_the_same():
    stage = open_level(Skinning, "hard-08-scrambled")
    stage.run(1)
    rig = stage.scene.model.rig
    before, ends = rig.move("linear")[rig.outline(0)].copy(), rig.skeleton.ends.copy()
    stage.post(Action("rebind"))
    stage.run(1)
    rig = stage.scene.model.rig
    assert np.allclose(rig.skeleton.ends, ends, rtol=0, atol=1e-12)
    again = rig.skinned[rig.outline(0)]
    assert all(np.abs(again - point).sum(axis=1).min() < 1e-12 for point in before)
    skeleton = Skeleton([-1, 0, 1], [1.0, 1.0, 1.0], [0.1, 0.2, 0.3])
    first = bind_weights(skeleton, [(1.0, 0.3)], 2.0)
    skeleton.pose([0.7, -0.5, 1.0])
    skeleton.pose([0.1, 0.2, 0.3])
    assert np.array_equal(bind_weights(skeleton, [(1.0, 0.3)], 2.0).weights, first.weights)
    with pytest.raises(SkeletonError, match="hangs on itself"):
        Skeleton([2, 0, 1], [1.0, 1.0, 1.0])


def test_weights_do_not_change_while_a_bone_moves():
    """Points on the threshold of two bones: the skin moves without a jump."""
    stage = open_level(Skinning, "hard-09-at-the-threshold")
    weights = stage.scene.model.rig.weights.copy()
    before, largest = stage.scene.model.rig.skinned.copy(), 0.0
    for _ in range(200):
        stage.run(1)
        now = stage.scene.model.rig.skinned
        largest = max(largest, float(np.abs(now - before).max()))
        before = now.copy()
    assert np.array_equal(stage.scene.model.rig.weights, weights)
    bone = 40.0 * math.pi / 180.0 * 2 * math.pi * 0.3 / 60.0  # rad that the bone turns in a step, at most
    assert largest < 1.3 * bone * 1.3


def test_a_circle_of_bones_in_a_file_is_refused_by_name():
    text = """scene = "c02"
[content]
bones = [
    { name = "a", parent = "b", length = 1.0 },
    { name = "b", parent = "a", length = 1.0 },
]
"""
    with pytest.raises(LevelError, match=r"content: parents: bone 0 hangs on itself"):
        Skinning(parse_level(text, "c02", FigureContent))
    for change, words in (
        ('parent = "b"', "the parent 'c'"),
        ('name = "b"', "named 'a'"),
    ):
        other = {"parent": 'parent = "c"', "name": 'name = "a"'}[change.split(" ")[0]]
        with pytest.raises(LevelError, match=words):
            Skinning(parse_level(text.replace(change, other), "c02", FigureContent))


def test_every_level_says_which_case_it_is():
    for path in LEVELS:
        level = load_level(path, "c02", FigureContent)
        assert level.hard_case == f"C02.H{int(path.stem.split('-')[1])}"
    assert {int(path.stem.split("-")[1]) for path in LEVELS} == set(range(1, 10))
