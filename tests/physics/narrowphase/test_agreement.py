"""V-Clip, GJK, EPA and separating axes say the same as shapely, and what must not matter does not."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.physics.narrowphase import (
    ConvexPolygon,
    Feature,
    PolygonSet,
    certify,
    convex_hull,
    epa,
    gjk,
    gjk_batch,
    gjk_trace,
    vclip,
    vclip_batch,
)
from game.physics.narrowphase.proximity import extent_of
from tests.physics.narrowphase.exact_pair import exact_distance
from tests.physics.narrowphase.random_pairs import lattice_polygon, random_polygon

MANY = 5_000
MAKERS = {"lattice": lattice_polygon, "random": random_polygon}


def least_overlap(a, b):
    """Depth by all normals, with numpy: a twin of the separating axes."""
    normals = np.vstack((a.normals(), b.normals()))
    normals = np.vstack((normals, -normals))
    low, high = (b.local + b.anchor - a.anchor) @ normals.T, a.local @ normals.T
    return (low.min(axis=0) - high.max(axis=0)).max()


@pytest.mark.compiled
@pytest.mark.parametrize("kind", MAKERS)
def test_five_thousand_pairs_by_all_methods(kind):
    shapely = pytest.importorskip("shapely")
    random = np.random.default_rng(20)
    first, second = ([MAKERS[kind](random) for _ in range(MANY)] for _ in range(2))
    sets = PolygonSet(first), PolygonSet(second)
    starts = np.column_stack([random.integers(0, 2 * np.diff(shapes.first)) for shapes in sets])
    answers = [batch(*sets) for batch in (gjk_batch, vclip_batch)]
    answers += [batch(*sets, features=starts.copy()) for batch in (gjk_batch, vclip_batch)]
    peers = [
        np.array([shapely.MultiPoint(p.vertices).convex_hull for p in polygons], dtype=object)
        for polygons in (first, second)
    ]
    apart = shapely.distance(*peers)
    extents = np.array([extent_of(a, b) or 1.0 for a, b in zip(first, second, strict=True)])
    overlapping = np.flatnonzero(apart == 0.0)
    assert 0.3 < len(overlapping) / MANY < 0.7  # the sample has enough of both
    expected = apart
    for k in overlapping:
        depth = least_overlap(first[k], second[k])
        expected[k] = min(depth, 0.0)
        assert epa(first[k], second[k]).distance == pytest.approx(expected[k], rel=0, abs=1e-12 * extents[k])
    for found in answers:
        assert np.abs(found.distance - expected).max() <= 1e-12 * extents.max()
        assert (np.abs(found.distance - expected) / extents).max() <= 1e-12
    for k in range(0, MANY, 25):
        found = vclip(first[k], second[k])
        assert (found.distance, found.feature_a.code) == (answers[1].distance[k], answers[1].feature_a[k])
        certify(first[k], second[k], found)
        certify(first[k], second[k], gjk(first[k], second[k]))


def test_lattice_pairs_against_exact_arithmetic():
    random = np.random.default_rng(3)
    for _ in range(150):
        a, b = lattice_polygon(random), lattice_polygon(random)
        expected = exact_distance(a.vertices, b.vertices)
        for measure in (vclip, gjk, epa):
            assert measure(a, b).distance == pytest.approx(expected, rel=0, abs=1e-14)


def test_walks_are_short_and_never_circle():
    """Cold ones bounded by the features, warm ones after a small motion by a few."""
    random = np.random.default_rng(9)
    first, second = ([random_polygon(random) for _ in range(400)] for _ in range(2))
    cold = vclip_batch(first, second)
    counts = np.array([len(a) + len(b) for a, b in zip(first, second, strict=True)])
    assert (cold.iterations <= 4 * counts).all()
    features = np.column_stack((cold.feature_a, cold.feature_b))
    turned = [b.moved(*(1e-3 * random.normal(0.0, b.extent, 2))) for b in second]
    warm = vclip_batch(first, turned, features=features)
    apart = warm.distance > 0.0
    assert warm.iterations[apart].mean() < 1.3
    assert gjk_batch(first, second).iterations.max() <= 10


lattice_points = st.lists(st.tuples(st.integers(0, 6), st.integers(0, 6)), min_size=1, max_size=7)
shifts = st.tuples(st.integers(-8, 8), st.integers(-8, 8))
pairs = st.builds(
    lambda a, b, by: (convex_hull(a), convex_hull(np.array(b) + by)), lattice_points, lattice_points, shifts
)
quick = settings(max_examples=60, deadline=None, derandomize=True)


def answers(a, b):
    return [measure(a, b) for measure in (vclip, gjk)]


@quick
@given(pairs, st.integers(-40, 40))
def test_scaling_by_a_power_of_two_scales_every_bit(pair, power):
    a, b = pair
    scale = 2.0**power
    for found, scaled in zip(
        answers(a, b),
        answers(ConvexPolygon(a.vertices * scale), ConvexPolygon(b.vertices * scale)),
        strict=True,
    ):
        assert scaled.distance == found.distance * scale
        assert scaled.point_a == tuple(x * scale for x in found.point_a)
        assert scaled[3:] == found[3:]


@quick
@given(pairs)
def test_a_mirror_changes_no_bit_of_the_distance(pair):
    a, b = pair
    mirrored = [ConvexPolygon(p.vertices * (-1.0, 1.0)) for p in (a, b)]
    assert [f.distance for f in answers(a, b)] == [f.distance for f in answers(*mirrored)]
    turned = [ConvexPolygon(p.vertices[:, ::-1]) for p in (a, b)]
    assert [f.distance for f in answers(a, b)] == [f.distance for f in answers(*turned)]


@quick
@given(pairs, st.integers(0, 100), st.integers(0, 100))
def test_neither_order_nor_start_nor_method_matters(pair, i, j):
    a, b = pair
    extent = extent_of(a, b) or 1.0
    start = Feature.of(i % (2 * len(a))), Feature.of(j % (2 * len(b)))
    distances = [
        *(found.distance for found in answers(a, b)),
        *(found.distance for found in answers(b, a)),
        vclip(a, b, start).distance,
        gjk(a, b, start).distance,
        gjk(a, b, method="scan").distance,
        epa(a, b, start).distance,
    ]
    assert np.ptp(distances) <= 4.0 * 2.0**-52 * extent


@quick
@given(pairs, st.floats(-3.1, 3.1), st.floats(-50.0, 50.0), st.floats(-50.0, 50.0))
def test_rigid_motion_does_not_matter(pair, angle, x, y):
    a, b = pair
    extent = 100.0 + (extent_of(a, b) or 1.0)
    moved = answers(a.moved(x, y, angle), b.moved(x, y, angle))
    for before, after in zip(answers(a, b), moved, strict=True):
        assert after.distance == pytest.approx(before.distance, rel=0, abs=1e-13 * extent)
    c, s = math.cos(angle), math.sin(angle)
    pose = np.array([[x, y, c, s]])
    posed = gjk_batch([a], [b], poses_a=pose, poses_b=pose)
    assert posed.distance[0] == pytest.approx(gjk(a, b).distance, rel=0, abs=1e-13 * extent)


@quick
@given(pairs)
def test_gjk_comes_nearer_with_every_step(pair):
    found, steps = gjk_trace(*pair)
    distances = [step.distance for step in steps]
    assert all(later <= before for before, later in pairwise(distances))
    assert all(step.bound <= found.distance + 1e-12 for step in steps if found.distance > 0.0)
