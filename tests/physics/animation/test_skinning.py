"""Skinning: reference values, naive twins, equivariance, collapse and what rotors do about it."""

from __future__ import annotations

import cmath
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.physics.animation.skeleton import Skeleton, chain_skeleton
from game.physics.animation.skinning import BLENDS, Skinner, skin
from game.physics.animation.weights import WeightError, bind_given, bind_weights

EPS = 2.0**-52
turns = st.floats(-3.0, 3.0)
COLLAPSE = {30: 0.965925826289068, 60: 0.866025403784439, 90: 0.707106781186548, 120: 0.5,
            150: 0.258819045102521, 179: 0.00872653549837393}  # fmt: skip


def figure():
    return Skeleton([-1, 0, 1, 0], [1.0, 0.8, 0.5, 0.9], [0.3, 0.5, -0.7, -1.0])


def cloud(count=40):
    return np.random.default_rng(5).uniform(-0.5, 1.8, (count, 2))


def test_a_vertex_lands_where_it_must():
    """Two bones, 20 and 50 degrees, weights 0.35 and 0.65: from 30-digit arithmetic."""
    skeleton = chain_skeleton([2.0, 1.0])
    binding = bind_given(skeleton, [(2.25, 0.3)], [[0.35, 0.65]])
    skeleton.pose(np.radians([20.0, 50.0]))
    assert np.allclose(skin(skeleton, binding), [(1.79803444307856, 1.03202875320107)], rtol=0, atol=1e-13)


@pytest.mark.parametrize("blend", BLENDS)
def test_nothing_moves_in_the_pose_of_binding(blend):
    skeleton = figure()
    points = cloud()
    binding = bind_weights(skeleton, points, 0.8)
    assert np.abs(skin(skeleton, binding, blend) - points).max() <= 8 * EPS * 4 * 3


@given(st.lists(turns, min_size=4, max_size=4))
def test_linear_is_the_weighted_sum_of_rigid_images(angles):
    """The naive twin; so a point lies within the hull of its images."""
    skeleton = figure()
    points = cloud(12)
    binding = bind_weights(skeleton, points, 2.0, 2.0, 4)
    rest = skeleton.world.copy()
    skeleton.pose(angles)
    homogeneous = np.column_stack([points, np.ones(len(points))])
    images = np.array(
        [homogeneous @ (w @ np.linalg.inv(r)).T for w, r in zip(skeleton.world, rest, strict=True)]
    )
    expected = np.einsum("vn,nvk->vk", binding.dense(), images)[:, :2]
    assert np.allclose(skin(skeleton, binding), expected, rtol=0, atol=64 * EPS * 4)


@given(st.lists(turns, min_size=4, max_size=4))
def test_rotors_are_blended_as_complex_pairs(angles):
    """The naive twin: p = exp(i angle / 2), q = t conj(p) / 2, on the side of the heaviest."""
    skeleton = figure()
    points = cloud(12)
    binding = bind_weights(skeleton, points, 2.0, 2.0, 4)
    rest = skeleton.world.copy()
    skeleton.pose(angles)
    motions = skeleton.world @ np.linalg.inv(rest)
    expected = []
    for point, bones, weights in zip(points, binding.bones, binding.weights, strict=True):
        pairs = []
        for i in bones:
            p = cmath.exp(0.5j * math.atan2(motions[i, 1, 0], motions[i, 0, 0]))
            pairs.append((p, complex(*motions[i, :2, 2]) * p.conjugate() / 2))
        signs = [1 if (p * pairs[0][0].conjugate()).real >= 0 else -1 for p, _ in pairs]
        p = sum(s * w * a for s, w, (a, _) in zip(signs, weights, pairs, strict=True))
        q = sum(s * w * b for s, w, (_, b) in zip(signs, weights, pairs, strict=True))
        z = (p * p * complex(*point) + 2 * q * p) / abs(p) ** 2
        expected.append((z.real, z.imag))
    assert np.allclose(skin(skeleton, binding, "rotor"), expected, rtol=0, atol=1e-9)


@pytest.mark.parametrize("blend", BLENDS)
@given(angle=turns, x=st.floats(-5, 5), y=st.floats(-5, 5), bends=st.lists(turns, min_size=4, max_size=4))
def test_a_motion_of_the_root_moves_all_skin_alike(blend, angle, x, y, bends):
    skeleton = figure()
    binding = bind_weights(skeleton, cloud(12), 1.0)
    skeleton.pose(bends)
    before = skin(skeleton, binding, blend)
    moved = Skeleton(
        skeleton.parents,
        skeleton.lengths,
        skeleton.angles + np.array([angle, 0, 0, 0]),
        [(x, y), *skeleton.offsets[1:].tolist()],
    )
    c, s = math.cos(angle), math.sin(angle)
    expected = before @ np.array([[c, s], [-s, c]]) + (x, y)
    assert np.allclose(skin(moved, binding, blend), expected, rtol=0, atol=1e-12)


@pytest.mark.parametrize("degrees", COLLAPSE)
def test_halves_collapse_by_cos_half_the_bend_and_rotors_do_not(degrees):
    skeleton = chain_skeleton([1.0, 1.0])
    binding = bind_given(skeleton, [(1.0, 0.25), (1.0, -0.1)], [[0.5, 0.5]] * 2)
    skeleton.turn(1, math.radians(degrees))
    off = {blend: np.linalg.norm(skin(skeleton, binding, blend) - (1.0, 0.0), axis=1) for blend in BLENDS}
    assert np.allclose(off["linear"], COLLAPSE[degrees] * np.array([0.25, 0.1]), rtol=0, atol=1e-13)
    assert np.allclose(off["rotor"], (0.25, 0.1), rtol=0, atol=1e-13)


@pytest.mark.parametrize("blend", BLENDS)
def test_one_bone_alone_moves_its_skin_rigidly(blend):
    skeleton = figure()
    points = cloud()
    binding = bind_weights(skeleton, points, 0.8, influences=1)
    skeleton.pose([1.0, 2.0, -1.5, 0.4])
    after = skin(skeleton, binding, blend)
    for bone in range(4):
        own = binding.bones[:, 0] == bone
        before = np.linalg.norm(points[own][:, None] - points[own][None], axis=-1)
        now = np.linalg.norm(after[own][:, None] - after[own][None], axis=-1)
        assert np.allclose(before, now, rtol=0, atol=64 * EPS)


@pytest.mark.parametrize("blend", BLENDS)
def test_many_poses_at_once_are_those_one_by_one(blend):
    skeleton = figure()
    binding = bind_weights(skeleton, cloud(), 0.8)
    skinner = Skinner(binding)
    angles = np.random.default_rng(2).uniform(-2, 2, (3, 4))
    together = skin(skeleton, binding, blend, angles)
    for row, expected in zip(angles, together, strict=True):
        assert np.array_equal(skinner(skeleton.pose(row), blend), expected)
        assert np.array_equal(skin(skeleton, binding, blend), expected)


def test_what_does_not_fit_is_refused():
    binding = bind_weights(chain_skeleton([1.0, 1.0]), [(0.0, 0.0)])
    with pytest.raises(WeightError, match="3"):
        skin(chain_skeleton([1.0] * 3), binding)
    with pytest.raises(WeightError, match="blend"):
        skin(chain_skeleton([1.0, 1.0]), binding, "cubic")
