"""Every hard pair by every method from every start feature; expected values by exact arithmetic."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.narrowphase import (
    ConvexPolygon,
    Feature,
    PolygonSet,
    certify,
    epa,
    gjk,
    gjk_batch,
    sat,
    vclip,
    vclip_batch,
)
from game.physics.narrowphase.proximity import extent_of
from tests.physics.narrowphase.exact_pair import exact_distance
from tests.physics.narrowphase.hard_pairs import PAIRS, gon

METHODS = {"vclip": vclip, "gjk": gjk, "epa": epa}


def polygons(name):
    a, b, expected = PAIRS[name]
    if expected is None or len(a) > 20:
        computed = exact_distance(a, b)
        assert expected is None or computed == pytest.approx(expected, rel=1e-12)
        expected = computed
    first, second = ConvexPolygon(a), ConvexPolygon(b)
    return first, second, expected, 1e-12 * (extent_of(first, second) or 1.0)


@pytest.mark.parametrize("name", PAIRS)
def test_distance_depth_and_certificate(name):
    a, b, expected, tolerance = polygons(name)
    for measure in METHODS.values():
        found = measure(a, b)
        assert found.distance == pytest.approx(expected, rel=0, abs=tolerance)
        certify(a, b, found)
        back = measure(b, a)
        assert back.distance == pytest.approx(found.distance, rel=0, abs=1e-3 * tolerance)
    if expected <= 0.0 and len(a) + len(b) > 2:
        assert sat(a, b).distance == pytest.approx(expected, rel=0, abs=tolerance)


@pytest.mark.parametrize("name", [name for name in PAIRS if name != "64 corners"])
def test_from_every_start_feature(name):
    """No start gives another answer, and V-Clip takes at most 4 (n_A + n_B) steps."""
    a, b, expected, tolerance = polygons(name)
    starts = np.array([(i, j) for i in range(2 * len(a)) for j in range(2 * len(b))])
    pairs = np.zeros_like(starts)
    for batch in (vclip_batch, gjk_batch):
        found = batch(PolygonSet([a]), PolygonSet([b]), pairs, features=starts.copy())
        assert np.abs(found.distance - expected).max() <= tolerance
        assert np.ptp(found.distance) <= 1e-3 * tolerance
        if batch is vclip_batch:
            assert found.iterations.max() <= 4 * (len(a) + len(b))


@pytest.mark.compiled
def test_64_corners_from_every_start_feature():
    a, b, expected, tolerance = polygons("64 corners")
    starts = np.array([(i, j) for i in range(128) for j in range(128)])
    for batch in (vclip_batch, gjk_batch):
        found = batch(PolygonSet([a]), PolygonSet([b]), np.zeros_like(starts), features=starts.copy())
        assert np.abs(found.distance - expected).max() <= tolerance
        assert found.iterations.max() <= 4 * 128


def test_a_thousand_corners_nearly_touching():
    a, b = ConvexPolygon(gon(1000)), ConvexPolygon(gon(1000, 0.001, 2.000001))
    for measure in METHODS.values():
        found = measure(a, b)
        assert found.distance == pytest.approx(3.6415871782714275e-6, rel=0, abs=4e-12)
        certify(a, b, found)
    assert gjk(a, b).iterations <= 12
    again = vclip(a, b, vclip(a, b))
    assert again.iterations == 1


def test_plank_of_short_edges_is_not_touched():
    """C11.H7: Box2D's 3.2 mm thick plank and a point 5 mm before it."""
    a, b, _, _ = polygons("a short edge")
    for measure in METHODS.values():
        assert not measure(a, b).overlapping


def test_reference_values():
    square = PAIRS["apart"][0]
    assert sat(square, PAIRS["the same twice"][1]).distance == -2.0
    for dx, depth in ((1.5, 0.5), (0.0, 2.0)):
        other = [(x + dx, y) for x, y in square]
        for measure in (vclip, gjk, epa):
            assert measure(square, other).distance == -depth
    diamond = [(1.0, 0.0), (2.0, -1.0), (3.0, 0.0), (2.0, 1.0)]
    shifted = [(x - 0.5857864376269049, y) for x, y in diamond]
    assert gjk(square, shifted).distance == pytest.approx(-0.5857864376269049, abs=1e-15)


def test_features_that_a_polygon_does_not_have_begin_anew():
    """C11.H8"""
    a, b, expected, tolerance = polygons("apart")
    for start in ((Feature("vertex", 99), Feature("edge", 3)), (Feature("edge", -1), Feature("vertex", 0))):
        for measure in METHODS.values():
            assert measure(a, b, start).distance == pytest.approx(expected, rel=0, abs=tolerance)
