"""Capsules, C09.2 to C09.5 and beyond; the rest is in test_bounds_scenes."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.bounds import fit_capsule, minimal_capsule
from game.scenes.bounds.capsules import Capsules
from game.stage import SetParameter
from tests.scenes.particle_stages import drag, open_level, readouts

HELD = {
    "skew": 2.0, "parallel-overlapping": 1.0, "collinear-disjoint": 1.0, "crossing": 0.0,
    "point-point": 5.0, "point-segment": 1.0, "end-end": 1.11803398874989,
}  # fmt: skip


def test_every_node_has_the_capsule_of_its_segments():
    """C09.2, C09.3"""
    for tree in open_level(Capsules, "default").scene.model.pair.trees:
        for node in range(0, len(tree), 5):
            points = tree.ends[tree.segments_of(node)].reshape(-1, 2)
            assert tree.volume(node).area == pytest.approx(fit_capsule(points).area, rel=1e-9)


@pytest.mark.parametrize("name", HELD)
def test_cores_at_known_distances(name):
    told = readouts(open_level(Capsules, f"hard-02-{name}"))
    assert told["gap"] == pytest.approx(HELD[name], rel=0, abs=1e-13)
    assert told["crossings"] == (HELD[name] == 0.0)


def test_the_least_capsule_of_a_square_is_no_circle():
    """Beyond: the exact one as a reference."""
    stage = open_level(Capsules, "square")
    tree = stage.scene.model.pair.trees[0]
    least = minimal_capsule(tree.points)
    assert least.area < 0.98 * tree.areas()[0]
    assert stage.scene.model.pair.exact_area(0) == pytest.approx(least.area, rel=1e-6)
    assert readouts(stage)["area above exact"] > 0.02
    stage.post(SetParameter("fit", "thinnest"))
    assert readouts(stage)["area above exact"] > 0.05
    stage.post(SetParameter("fit", "exact"))
    assert 0.0 <= readouts(stage)["area above exact"] <= 1e-3
    fit = Capsules.parameter("fit")
    labels = dict(zip(fit.options, fit.labels, strict=True))
    assert labels["thinnest"] == "Least radius" and labels["exact"] == "Exact"


def test_capsules_and_boxes_side_by_side():
    """Beyond: two panes, each with its own trees; the hand works in both."""
    stage = open_level(Capsules, "side-by-side")
    stage.pause()
    scene = stage.scene
    left, right = scene.hand.panes()
    assert (left.pair.options.kind, right.pair.options.kind) == ("capsule", "obb")
    assert right.pair.query.volume_tests == readouts(stage)["with boxes"]
    for pane in (left, right):
        x, y = scene.model.outlines[0].position
        start = pane.point((x, y))
        drag(stage, start, (start[0], start[1] + 0.1), run=0)
        assert scene.model.outlines[0].position == pytest.approx((x, y + 0.2))
    stage.post(SetParameter("side_by_side", False))
    assert len(scene.hand.panes()) == 1


def test_touching_capsules_overlap():
    assert readouts(open_level(Capsules, "hard-04-touching"))["leaf pairs"] >= 1


def test_degenerate_fits():
    row = open_level(Capsules, "hard-06-fits").scene.model.pair
    assert all(tree.volume(0).radius <= 1e-12 for tree in row.trees[1:])
    tree = open_level(Capsules, "hard-06-circle-of-points").scene.model.pair.trees[0]
    circle = tree.volume(0)
    assert circle.length < 0.02 * circle.radius
    assert np.all(circle.outside(tree.points) < 1e-12)
