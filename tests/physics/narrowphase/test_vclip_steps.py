"""V-Clip's parts: where a vertex or an edge lies as a Voronoi region sees it, and the walk step by step."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from game.physics.narrowphase import ConvexPolygon, Feature, certify, epa_trace, vclip, vclip_trace
from game.physics.narrowphase.features import Frame, Pair, Polygon
from game.physics.narrowphase.vclip import BEHIND, CROSSING, clip_edge, clip_vertex, closest_features
from tests.physics.narrowphase.hard_pairs import PAIRS, SQUARE, box

LOCAL = ConvexPolygon(SQUARE).local  # (0, 0) to (2, 2); edge 1 at the foot, 3 right, 5 top, 7 left


@pytest.mark.parametrize(
    ("feature", "point", "seen"),
    [
        (0, (-1, -1), 0),
        (0, (0, -1), 0),  # on the border
        (0, (1, -1), 1),
        (0, (-1, 1), 7),
        (1, (1, -1), 1),
        (1, (0, -1), 1),
        (1, (-0.5, -1), 0),
        (1, (2.5, -1), 2),
        (1, (1, 1), BEHIND),
        (1, (1, 0), BEHIND),
        (5, (1, -3), BEHIND),
    ],
)
def test_clip_vertex(feature, point, seen):
    for scale in (1.0, 2.0**-100, 2.0**100):
        assert clip_vertex(Polygon(LOCAL * scale, 0, 4), feature, *(scale * x for x in point)) == seen


@pytest.mark.parametrize(
    ("feature", "edge", "seen"),
    [
        (0, ((1, -4), (-1, 2)), 0),  # across the corner
        (2, ((3, 3), (5, -1)), 3),  # the foot is beyond the border to edge 3
        (2, ((4, -2), (1, -1)), 1),
        (3, ((3, 1), (4, 2)), 3),  # an end is nearest
        (3, ((3, 2), (3, 0)), 3),  # parallel
        (3, ((3, 4), (4, 3)), 4),  # all beyond the strip
        (3, ((3, -4), (4, -3)), 2),
        (3, ((4, 1), (2.5, 3)), 4),  # nearer and nearer until it leaves the strip
        (3, ((1, 1), (4, 1)), CROSSING),
        (3, ((2, 1), (4, 1)), CROSSING),  # it touches
        (3, ((0.5, 1), (1.5, 1)), BEHIND),
    ],
)
def test_clip_edge(feature, edge, seen):
    for scale in (1.0, 2.0**-100, 2.0**100):
        flat = [scale * value for point in edge for value in point]
        assert clip_edge(Polygon(LOCAL * scale, 0, 4), feature, *flat) == seen


def test_a_point_has_no_other_features():
    point = Polygon(np.zeros((1, 2)), 0, 1)
    assert clip_vertex(point, 0, 3.0, 4.0) == 0
    assert clip_edge(point, 0, 3.0, 4.0, 5.0, 6.0) == 0


def test_local_minimum_is_left_by_repair():
    """The start lies in the strip of the top edge, far behind it; the other body is below."""
    below = box(-0.5, -9.0, 1.0, 1.0)
    found, steps = vclip_trace(SQUARE, below, (Feature("edge", 2), Feature("vertex", 2)))
    assert found.distance == 7.0
    assert any(step.verdict.startswith("repair") for step in steps)
    assert steps[-1].verdict == "closest"


@pytest.mark.parametrize("name", PAIRS)
def test_the_walk_is_told_step_by_step(name):
    a, b, _ = PAIRS[name]
    found, steps = vclip_trace(a, b)
    assert len(steps) == found.iterations
    assert steps[-1].verdict in ("closest", "overlap")
    assert (steps[-1].verdict == "overlap") <= found.overlapping
    changes = [
        (one.feature_a != two.feature_a) + (one.feature_b != two.feature_b) for one, two in pairwise(steps)
    ]
    for step, changed in zip(steps, changes, strict=False):
        assert changed == 1 or step.verdict.startswith("repair")


@pytest.mark.parametrize("name", [name for name in PAIRS if len(PAIRS[name][0]) < 20])
def test_looking_at_all_features_is_right(name):
    """What a walk falls back on if rounding should lead it in a circle."""
    a, b = (ConvexPolygon(points) for points in PAIRS[name][:2])
    expected = vclip(a, b)
    frame = Frame(1.0, 0.0, *(b.anchor - a.anchor).tolist())
    codes = closest_features(Pair(Polygon(a.local, 0, len(a)), Polygon(b.local, 0, len(b)), frame))
    if expected.distance > 0.0:
        again = vclip(a, b, tuple(map(Feature.of, codes)))
        assert again.distance == expected.distance
        assert again.iterations <= 2


def test_coherent_motion_takes_hardly_a_step():
    a, b = ConvexPolygon(SQUARE), ConvexPolygon(box(2.0, -0.5))
    found = vclip(a, b)
    total = 0
    for k in range(1, 400):
        found = vclip(a, b.moved(0.5 * np.cos(0.02 * k), np.sin(0.02 * k), 0.02 * k), found)
        total += found.iterations
    assert total / 399 < 1.4


def test_overlap_without_depth_is_told_all_the_same():
    found = vclip(SQUARE, box(0.0, 0.0), deep=False)
    assert found.overlapping and found.distance == 0.0 and found.normal == (0.0, 0.0)
    assert vclip(SQUARE, box(2.0, 0.0), deep=False).distance == 1.0


def test_a_wrong_answer_is_not_certified():
    found = vclip(SQUARE, box(2.0, -0.5))
    certify(SQUARE, box(2.0, -0.5), found)
    for wrong in (
        found._replace(distance=found.distance + 1e-9),
        found._replace(point_b=(2.0, 5.0)),
        found._replace(normal=(0.6, 0.8)),
    ):
        with pytest.raises(ValueError, match="proximity"):
            certify(SQUARE, box(2.0, -0.5), wrong)


def test_epa_grows_from_the_triangle_to_the_border():
    found, steps, growth = epa_trace(SQUARE, box(0.4, -0.7))
    assert steps[-1].kept == "inside"
    assert growth[-1].height == pytest.approx(-found.distance)
    assert not growth[-1].grows and all(step.grows for step in growth[:-1])
    assert [len(step.corners) for step in growth] == list(range(3, 3 + len(growth)))
    heights = [step.height for step in growth]
    assert heights == sorted(heights)
