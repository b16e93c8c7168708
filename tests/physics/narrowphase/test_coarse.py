"""Coarse outlines: V-Clip begun afresh takes few steps, and says what it says from anywhere else."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.lab.studies.narrowphase.support import pebbles
from game.physics.narrowphase import ConvexPolygon, PolygonSet, vclip, vclip_batch
from game.physics.narrowphase.coarse import RATIO, SMALL, coarse_outlines
from tests.physics.narrowphase.hard_pairs import PAIRS

SIZES = (3, 8, SMALL, SMALL + 1, 64, 65, 130, 512, 1000)


def mixed_pairs(seed, near, far, count=300):
    """Pebbles of all sizes in random pairs and poses: (shapes, pairs, poses)."""
    random = np.random.default_rng(seed)
    shapes = [pebbles(size, 1, size)[0] + random.normal(0.0, 3.0, 2) for size in SIZES]
    shapes += [np.array([[0.5, 0.25]]), np.array([[0.0, 0.0], [1.0, 0.5], [1.0, 0.5]])]
    pairs = random.integers(0, len(shapes), (count, 2))
    first, second = PolygonSet([shapes[k] for k in pairs[:, 0]]), PolygonSet([shapes[k] for k in pairs[:, 1]])
    angles, around = random.uniform(0.0, 2.0 * math.pi, (3, count))[:2], random.uniform(0.0, 6.0, count)
    places = np.column_stack((np.cos(around), np.sin(around))) * random.uniform(near, far, count)[:, None]
    poses = []
    for side, angle, place in ((first, angles[0], 0.0 * places), (second, angles[1], places)):
        c, s = np.cos(angle), np.sin(angle)
        x, y = (side.anchors + side.centres).T
        poses.append(np.column_stack((place - np.column_stack((c * x - s * y, s * x + c * y)), c, s)))
    return first, second, poses


@pytest.mark.parametrize(("near", "far"), [(2.05, 4.0), (0.0, 2.5)], ids=["apart", "overlaps"])
def test_the_answer_is_that_of_a_walk_from_anywhere(near, far):
    first, second, poses = mixed_pairs(1, near, far)
    afresh = vclip_batch(first, second, None, *poses)
    assert (afresh.distance <= 0.0).any() == (near == 0.0) and (afresh.distance > 0.0).any()
    random = np.random.default_rng(2)
    for _ in range(3):
        starts = random.integers(0, 2 * np.column_stack((np.diff(first.first), np.diff(second.first))))
        found = vclip_batch(first, second, None, *poses, starts)
        for name in ("distance", "point_a", "point_b", "normal", "feature_a", "feature_b"):
            assert np.array_equal(getattr(found, name), getattr(afresh, name)), name


@pytest.mark.parametrize("name", PAIRS)
def test_hard_pairs_afresh(name):
    a, b, _ = PAIRS[name]
    assert vclip_batch([a], [b]).distance[0] == pytest.approx(vclip(a, b).distance, rel=1e-14, abs=1e-300)


@pytest.mark.parametrize("size", [64, 513])
@pytest.mark.parametrize(
    "place", [(0.0, 0.0), (2.0, 0.0), (2.0 + 1e-12, 0.0), (0.0, 2.5), (1e6, 1.0), (1e-9, 0.0)]
)
def test_coins_on_touching_and_beside_each_other(size, place):
    """The same coin twice: edges run against each other, corners lie on corners."""
    turns = np.arange(size) * (2.0 * math.pi / size)
    coin = ConvexPolygon(np.column_stack((np.cos(turns), np.sin(turns))))
    other = coin.moved(*place, math.pi)
    expected, found = vclip(coin, other), vclip_batch([coin], [other])
    assert found.distance[0] == expected.distance
    if expected.distance > 0.0:
        assert (found.feature_a[0], found.feature_b[0]) == (expected.feature_a.code, expected.feature_b.code)


def row_of_pebbles(size, other):
    """Forty pebbles of one size in pairs with forty of another, none overlapping: (shapes, poses, pairs)."""
    random = np.random.default_rng(size + other)
    shapes = PolygonSet(pebbles(size, 40, size) + pebbles(other, 40, other))
    angles, along = random.uniform(0.0, 2.0 * math.pi, 80), 4.0 * np.arange(80)
    poses = np.column_stack((along, np.sin(along), np.cos(angles), np.sin(angles)))
    return shapes, poses, random.integers((0, 40), (40, 80), (500, 2))


@pytest.mark.parametrize(
    ("size", "other", "outlines", "most"),
    [
        (8, 8, 1, 11.0),
        (64, 64, 2, 11.0),
        (512, 512, 3, 20.0),
        (1000, 1000, 3, 20.0),
        (1000, SMALL, 3, 12.5),
        (SMALL, 1000, 3, 12.5),
        (5, 512, 3, 12.5),
    ],
)
def test_steps_do_not_grow_with_the_vertices(size, other, outlines, most):
    """A few on every outline; from the first vertices the walk passes half of all."""
    shapes, poses, pairs = row_of_pebbles(size, other)
    found = vclip_batch(shapes, shapes, pairs, poses, poses)
    walked = vclip_batch(shapes, shapes, pairs, poses, poses, np.zeros_like(pairs))
    assert np.array_equal(found.distance, walked.distance)
    assert found.iterations.min() >= outlines
    assert found.iterations.mean() < most
    if outlines > 1:
        assert walked.iterations.mean() > 0.4 * (size + other)


def test_a_polygon_finds_its_own_outlines_among_others():
    """The walk, step for step, is that of the pair in sets of its own."""
    first, second, poses = mixed_pairs(3, 2.05, 4.0, 60)
    together = vclip_batch(first, second, None, *poses)
    for k in range(60):
        alone = []
        for side in (first, second):
            own = side.vertices[side.first[k] : side.first[k + 1]] + side.anchors[k]
            alone.append(PolygonSet([own]))
        found = vclip_batch(*alone, None, *(pose[k : k + 1] for pose in poses))
        assert found.iterations[0] == together.iterations[k]
        assert found.distance[0] == pytest.approx(together.distance[k], rel=1e-12, abs=1e-14)


@pytest.mark.parametrize("size", SIZES)
def test_an_outline_is_every_eighth_vertex(size):
    outline = pebbles(size, 1, size)[0]
    coarser = coarse_outlines(outline)
    assert all(len(one) <= SMALL for one in coarser[-1:]) and bool(coarser) == (size > SMALL)
    for level, one in enumerate(coarser, start=1):
        assert np.array_equal(one, outline[:: RATIO**level]) and len(one) >= 3
    assert len(PolygonSet([outline] * 3).outlines) <= 3 * (size / 7.0 + len(coarser))
