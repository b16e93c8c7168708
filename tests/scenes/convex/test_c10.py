"""V-Clip's scene: its walk, its regions; the rest is in test_convex_pairs."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.narrowphase import ConvexPolygon, Feature
from game.scenes.convex.vclip import VClip
from game.scenes.convex.view.vclip import region
from game.scenes.convex.view.vclip_words import WORDS, caption_of, case_of, distance_of, function_of
from game.stage import SetEffect, SetParameter
from tests.scenes.particle_stages import open_level, readouts


def test_clip_vertex_and_clip_edge_take_the_steps():
    """C10.2, C10.3: the walk passes all kinds of pairs: two vertices, vertex and edge, two edges."""
    stage = open_level(VClip, "default")
    stage.post(SetEffect("coherence", False))
    kinds = set()
    for i in range(18):
        stage.post(SetParameter("start_a", i))
        stage.post(SetParameter("start_b", (5 * i) % 14))
        for step in stage.scene.model.trace():
            kinds.add(step.feature_a.kind[0] + step.feature_b.kind[0])
            assert step.verdict in WORDS
    assert kinds == {"vv", "ve", "ev", "ee"}


def test_local_minimum_is_shown_being_repaired():
    stage = open_level(VClip, "hard-23-local-minimum")
    stage.run(1)
    assert any(step.verdict.startswith("repair") for step in stage.scene.model.trace())
    assert readouts(stage)["distance"] == 7.0


def test_regions_hold_what_is_closest():
    """A point of a drawn region is closest to its feature."""
    polygon = ConvexPolygon([(0, 0), (3, 0), (4, 2), (1, 3)])
    corners, normals = polygon.vertices, polygon.normals()
    for code in range(8):
        feature = Feature.of(code)
        area = region(corners, normals, feature, 5.0)
        inside = area.mean(axis=0)
        a, b = corners, np.roll(corners, -1, axis=0)
        part = np.clip(((inside - a) * (b - a)).sum(axis=1) / ((b - a) ** 2).sum(axis=1), 0.0, 1.0)
        distances = np.sqrt(((a + part[:, None] * (b - a) - inside) ** 2).sum(axis=1))
        nearest = int(distances.argmin())
        if feature.kind == "edge":
            assert nearest == feature.index and 0.0 < part[nearest] < 1.0
        else:
            closest = (a + part[:, None] * (b - a))[nearest]
            assert np.allclose(closest, corners[feature.index], rtol=0, atol=1e-12)


def test_penetration_is_answered():
    stage = open_level(VClip, "hard-11-inside")
    stage.run(1)
    assert readouts(stage)["distance"] == pytest.approx(-0.915845593067914, rel=0, abs=2e-12)
    assert ("arrow:vermilion", "depth", "") in stage.scene.legend()


def test_captions_name_case_function_border_and_distance():
    """For walks from many pairs of features: the border lies between the features of two steps."""
    stage = open_level(VClip, "default")
    stage.post(SetEffect("coherence", False))
    scene, seen = stage.scene, set()
    for i in range(40):
        stage.post(SetParameter("start_a", i % 14))
        stage.post(SetParameter("start_b", (3 * i) % 10))
        trace = scene.model.trace()
        shapes = [scene.model.drawn_corners(k) for k in (0, 1)]
        for k, step in enumerate(trace):
            first, second = caption_of(trace, k, shapes, scene.model.content.scale)
            assert f", {case_of(step)}: " in first and " m apart" in first.replace(" mm", " m")
            assert second.startswith(function_of(step))
            seen.add((case_of(step), function_of(step)))
            if step.verdict.startswith("moved"):
                name = "feature_" + step.verdict[-1].lower()
                here, there = getattr(step, name), getattr(trace[k + 1], name)
                assert f"border of {here} and {there}: on to {there}" in second and here != there
                assert distance_of(shapes, trace[k + 1]) <= distance_of(shapes, step) + 1e-12
        apart = distance_of(shapes, trace[-1]) * scene.model.content.scale
        assert apart == pytest.approx(readouts(stage)["distance"], rel=1e-12)
    assert {("VV", "clip_vertex"), ("VE", "clip_vertex"), ("VE", "clip_edge"), ("EE", "clip_edge")} <= seen
