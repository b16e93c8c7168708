"""Skeletons: frames against complex numbers, trees in any order, edits, and what is refused."""

from __future__ import annotations

import cmath
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.physics.animation.skeleton import Skeleton, SkeletonError, chain_skeleton
from game.physics.animation.skeleton_editing import NOWHERE, bone_at

EPS = 2.0**-52
turns = st.floats(-10.0, 10.0)


def ends_by_complex_numbers(skeleton):
    """Naive twin: each bone from its parent's frame, in complex numbers."""
    frames = {}

    def frame(i):
        if i not in frames:
            parent = int(skeleton.parents[i])
            place, turn = frame(parent) if parent >= 0 else (0.0, 1.0)
            here = place + turn * complex(*skeleton.offsets[i])
            frames[i] = (here, turn * cmath.exp(1j * float(skeleton.angles[i])))
        return frames[i]

    ends = [frame(i)[0] + frame(i)[1] * float(skeleton.lengths[i]) for i in range(skeleton.count)]
    return np.array([(z.real, z.imag) for z in ends])


def test_three_bones_end_where_they_must():
    """30, -45, 60 degrees on bones of 1, 0.75, 0.5: to 15 figures from 30-digit arithmetic."""
    skeleton = chain_skeleton([1.0, 0.75, 0.5], np.radians([30.0, -45.0, 60.0]))
    assert np.allclose(skeleton.ends[2], (1.94402316409451, 0.659439106766383), rtol=0, atol=1e-13)
    skeleton.check()


@given(st.lists(st.tuples(turns, st.floats(0.0, 2.0)), min_size=1, max_size=12), st.randoms())
def test_any_tree_is_as_complex_numbers_have_it(bones, random):
    parents = [random.randrange(-1, i) for i in range(len(bones))]
    offsets = [(random.uniform(-1, 1), random.uniform(-1, 1)) for _ in bones]
    skeleton = Skeleton(parents, [b for _, b in bones], [a for a, _ in bones], offsets)
    size = 4.0 * len(bones)
    assert np.allclose(skeleton.ends, ends_by_complex_numbers(skeleton), rtol=0, atol=32 * EPS * size)
    skeleton.check()


@given(st.permutations(range(6)), st.lists(turns, min_size=6, max_size=6))
def test_the_order_of_bones_does_not_matter(order, angles):
    parents, lengths = [-1, 0, 1, 1, 3, 0], [1.0, 0.5, 0.4, 0.7, 0.2, 0.9]
    plain = Skeleton(parents, lengths, angles)
    place = np.argsort(order)
    mixed = Skeleton(
        [place[parents[i]] if parents[i] >= 0 else -1 for i in order],
        [lengths[i] for i in order],
        [angles[i] for i in order],
    )
    assert np.array_equal(mixed.world[place], plain.world)


def test_the_last_row_of_a_frame_is_that_of_a_3x3_transform():
    skeleton = chain_skeleton([1.0, 1.0], [0.3, 0.4])
    assert np.array_equal(skeleton.world[:, 2], np.tile((0.0, 0.0, 1.0), (2, 1)))
    point = skeleton.world[1] @ (1.0, 0.0, 1.0)
    assert np.allclose(point[:2], skeleton.ends[1], rtol=0, atol=4 * EPS)


def test_children_follow_their_parent():
    """A turn of the root turns every end about its base; ends keep their distances."""
    skeleton = Skeleton([-1, 0, 1, 1, 0], [1.0, 0.5, 0.3, 0.3, 0.4], [0.1, 0.2, 0.5, -0.5, -1.0])
    before = skeleton.ends.copy()
    skeleton.turn(0, 0.1 + 0.7)
    turn = np.array([[math.cos(0.7), -math.sin(0.7)], [math.sin(0.7), math.cos(0.7)]])
    assert np.allclose(skeleton.ends, before @ turn.T, rtol=0, atol=16 * EPS)
    assert skeleton.children(1) == [2, 3]
    assert skeleton.path(0, 3) == [0, 1, 3]


def test_many_frames_at_once_are_those_one_by_one():
    skeleton = Skeleton([-1, 0, 1, 0], [1.0, 0.5, 0.3, 0.4])
    angles = np.random.default_rng(3).uniform(-3, 3, (5, 4))
    worlds = skeleton.frames(angles)
    assert not skeleton.angles.any()
    for row, world in zip(angles, worlds, strict=True):
        assert np.array_equal(skeleton.pose(row), world)


def test_limits_hold_a_turn_but_not_a_pose():
    skeleton = Skeleton([-1, 0], [1.0, 1.0], lower=[-np.inf, 0.0], upper=[np.inf, 2.0])
    skeleton.turn(1, -1.0)
    assert skeleton.angles[1] == 0.0
    skeleton.turn(1, 9.0)
    assert skeleton.angles[1] == 2.0
    skeleton.turn(1, 9.0, limited=False)
    assert skeleton.angles[1] == 9.0


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"parents": []}, "at least one"),
        ({"parents": [-1, 2]}, "indices"),
        ({"parents": [1, 0]}, "hangs on itself"),
        ({"parents": [0, 0]}, "hangs on itself"),
        ({"parents": [-1, 0.5]}, "whole numbers"),
        ({"lengths": [1.0]}, "lengths"),
        ({"lengths": [1.0, -1.0]}, "lengths"),
        ({"lengths": [1.0, math.nan]}, "lengths"),
        ({"angles": [0.0, math.inf]}, "angles"),
        ({"offsets": [0.0, 1.0]}, "offsets"),
        ({"lower": [0.0, math.nan]}, "lower"),
        ({"lower": [0.0, 1.0], "upper": [1.0, 0.0]}, "bone 1"),
    ],
)
def test_what_is_no_skeleton_is_refused(change, words):
    given = {"parents": [-1, 0], "lengths": [1.0, 1.0], **change}
    with pytest.raises(SkeletonError, match=words):
        Skeleton(**given)


def test_what_is_not_there_is_refused():
    skeleton = Skeleton([-1, 0, 0], [1.0, 1.0, 1.0])
    with pytest.raises(SkeletonError, match="bone 3"):
        skeleton.turn(3, 0.0)
    with pytest.raises(SkeletonError, match="does not hang"):
        skeleton.path(1, 2)
    with pytest.raises(SkeletonError, match="angle"):
        skeleton.turn(0, math.nan)
    with pytest.raises(SkeletonError, match="angles"):
        skeleton.frames([[0.0, 1.0]])
    skeleton.angles[0] = 1.0
    with pytest.raises(SkeletonError, match="present angles"):
        skeleton.check()


# -- by hand --------------------------------------------------------------------------------------------


def test_the_bone_at_a_point():
    skeleton = Skeleton([-1, 0, 0], [1.0, 1.0, 1.0], [0.0, 0.5, -0.5])
    assert bone_at(skeleton, (0.5, 0.02), 0.1) == 0
    assert bone_at(skeleton, skeleton.ends[1], 0.1) == 1
    assert bone_at(skeleton, skeleton.ends[2], 0.1) == 2
    assert bone_at(skeleton, (0.5, 2.0), 0.1) == NOWHERE
