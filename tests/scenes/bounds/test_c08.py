"""Oriented boxes, C08.2 to C08.6 and beyond; the rest is in test_bounds_scenes."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.bounds import fit_obb, minimal_obb
from game.scenes.bounds.oriented_boxes import OrientedBoxes
from game.scenes.bounds.walk_words import caption
from game.stage import Action, SetParameter
from tests.scenes.particle_stages import open_level, readouts


def test_boxes_are_turned_degree_by_degree_and_halved():
    """C08.2, C08.3: each node has the box of its own segments, on a whole degree, and is halved."""
    scene = open_level(OrientedBoxes, "default").scene
    for tree in scene.model.pair.trees:
        for node in range(0, len(tree), 3):
            ends = tree.ends[tree.segments_of(node)]
            box = tree.volume(node)
            assert box.area == pytest.approx(fit_obb(ends.reshape(-1, 2)).area, rel=1e-12)
            degrees = np.degrees(np.arctan2(box.axis[1], box.axis[0])) % 90
            assert min(abs(degrees - round(degrees)), 1.0) < 1e-9
            child = int(tree.links[node, 0])
            if child >= 0:
                middles = 0.5 * (ends[:, :2] + ends[:, 2:])
                later = (middles - box.centre) @ box.axis >= 0.0
                assert later.sum() == len(tree.segments_of(child + 1))


def test_the_exact_box_is_the_reference():
    """Beyond: area above exact is nothing with calipers, more with a coarser step."""
    stage = open_level(OrientedBoxes, "default", angle_step=15.0)
    coarse = readouts(stage)["area above exact"]
    stage.post(SetParameter("angle_step", 1.0))
    fine = readouts(stage)["area above exact"]
    stage.post(SetParameter("fit", "exact"))
    assert 0.0 <= readouts(stage)["area above exact"] < 1e-12 < fine < coarse
    assert stage.scene.model.pair.trees[0].areas()[0] == pytest.approx(
        minimal_obb(stage.scene.model.pair.trees[0].points).area, rel=1e-12
    )


def test_tests_are_counted_against_axis_aligned_boxes():
    """Beyond: two arcs 2 cm apart."""
    stage = open_level(OrientedBoxes, "arcs")
    told = readouts(stage)
    assert told["crossings"] == 0 and told["gap"] == pytest.approx(0.02, rel=1e-3)
    assert told["axis-aligned"] > 8 * told["tests"]
    stage.post(SetParameter("compare", False))
    assert "axis-aligned" not in readouts(stage)


def test_identical_outlines_meet_everywhere_and_far_ones_need_one_test():
    """C08.4"""
    same = open_level(OrientedBoxes, "hard-08-identical")
    n = same.scene.model.pair.trees[0].segments
    assert readouts(same)["crossings"] == 3 * n  # itself and both neighbours
    assert readouts(open_level(OrientedBoxes, "hard-08-disjoint"))["tests"] == 1
    assert readouts(open_level(OrientedBoxes, "hard-08-touching-leaves"))["crossings"] >= 1
    inside = readouts(open_level(OrientedBoxes, "hard-08-inside"))
    assert inside["crossings"] == 0 and inside["gap"] > 0.3
    touching = readouts(open_level(OrientedBoxes, "hard-06-touching"))
    assert touching["crossings"] > 0 and touching["gap"] == 0.0


def test_scaled_levels_have_scaled_boxes():
    tiny, huge = (open_level(OrientedBoxes, f"hard-04-{name}").scene for name in ("tiny", "huge"))
    for a, b in zip(tiny.model.pair.trees, huge.model.pair.trees, strict=True):
        assert np.allclose(1e16 * a.areas() * 1e16, b.areas(), rtol=1e-9, atol=0)
    assert tiny.model.pair.query.volume_tests == huge.model.pair.query.volume_tests


def test_half_a_degree_off_walks_the_rectangle_and_shows_the_worst_ratio():
    """1 + (a + 1/a) sin(2 δ) / 2 with a = 10, δ = half a degree."""
    stage = open_level(OrientedBoxes, "hard-02-half-a-degree")
    scene = stage.scene
    hull = scene.walk.fit().hull
    sides = np.hypot(*(np.roll(hull, -1, axis=0) - hull).T)
    assert sides.max() / sides.min() == pytest.approx(10.0, rel=1e-6)
    assert scene.model.pair.trees[0].areas()[0] / scene.model.pair.exact_area(0) == pytest.approx(
        1.0881346525, rel=1e-6
    )
    for _ in range(scene.walk.length()):
        stage.post(Action("walk-on"))
    assert "1.0881 times the exact one" in caption(scene.walk)
    assert "1.0881" in stage.level.about
