"""GJK's scene: simplexes, polytopes, tolerance; the rest is in test_convex_pairs."""

from __future__ import annotations

import numpy as np
import pytest

from game.app.stagehand.headless import picture_of_stage
from game.physics.narrowphase.minkowski import minkowski_difference
from game.physics.narrowphase.queries import PolytopeStep, SimplexStep
from game.scenes.convex.gjk import Gjk
from game.scenes.convex.view.gjk import frame_of, inset_for, words_of
from game.stage import SetEffect, SetParameter
from game.ui.canvas.canvas import Canvas
from tests.scenes.particle_stages import open_level, readouts


def test_same_answer_as_vclip_to_rounding():
    stage = open_level(Gjk, "crystals")
    depths = 0
    for _ in range(60):
        stage.run(10)
        row = readouts(stage)
        assert row["distance"] == pytest.approx(row["V-Clip"], rel=0, abs=1e-14)
        depths += row["distance"] < 0.0
    assert 5 < depths < 55


def test_an_overlap_is_walked_by_simplexes_and_then_by_polytopes():
    stage = open_level(Gjk, "hard-11-inside")
    stage.run(1)
    trace = stage.scene.model.trace()
    kinds = [type(step) for step in trace]
    assert kinds == sorted(kinds, key=[SimplexStep, PolytopeStep].index)
    assert kinds[-1] is PolytopeStep and not trace[-1].grows
    assert len(trace) == readouts(stage)["steps"]
    assert all(words_of(step) for step in trace)


def test_a_loose_tolerance_ends_early_with_too_much():
    stage = open_level(Gjk, "coins")
    stage.post(SetEffect("shape-motion", False))
    stage.post(SetEffect("coherence", False))
    exact = readouts(stage)
    stage.post(SetParameter("exponent", -1.0))
    loose = readouts(stage)
    assert exact["distance"] < loose["distance"] < 1.12 * exact["distance"]
    assert loose["steps"] < exact["steps"]


def test_climbing_and_scanning_agree():
    stage = open_level(Gjk, "coins")
    stage.run(5)
    climbed = readouts(stage)["distance"]
    stage.post(SetParameter("method", "scan"))
    assert readouts(stage)["distance"] == pytest.approx(climbed, rel=0, abs=1e-15)


def test_the_difference_and_the_origin_fit_beside_the_polygons():
    stage = open_level(Gjk, "default")
    stage.run(1)
    scene = stage.scene
    seen, frame = scene.model.content.view, frame_of(scene.model.content.view)
    for shift in (0.0, 3.0):
        a, b = scene.model.drawn_corners(0), np.add(scene.model.drawn_corners(1), (shift, 0.0))
        difference = minkowski_difference(a, b)
        inset = inset_for(seen, difference)
        placed = np.vstack((inset.place(difference), [(inset.x, inset.y)]))
        assert (placed >= (seen.right, frame.bottom)).all()
        assert (placed <= (frame.right, frame.top)).all()
    stage.post(SetParameter("minkowski", False))
    assert scene.frame().right == seen.right


def test_corners_are_named_and_the_bounds_are_circles_about_the_origin(monkeypatch):
    """In every step of a walk: a_i - b_j at the simplex, w by its name, |v| and v·w / |v| as radii."""
    stage = open_level(Gjk, "default")
    stage.post(SetEffect("coherence", False))
    stage.post(SetParameter("start_a", 9))
    stage.post(SetParameter("start_b", 6))
    scene, drawn, words = stage.scene, [], []
    monkeypatch.setattr(Canvas, "polyline", lambda self, points, *more: drawn.append(np.asarray(points)))
    monkeypatch.setattr(Canvas, "label", lambda self, place, text, *more, **options: words.append(text))
    difference = minkowski_difference(scene.model.drawn_corners(0), scene.model.drawn_corners(1))
    inset = inset_for(scene.model.content.view, difference)
    trace = scene.model.trace()
    assert len(trace) > 2
    for index, step in enumerate(trace):
        scene.hand.shown = index
        drawn.clear()
        words.clear()
        picture_of_stage(stage, (640, 360))
        assert {f"a{i + 1} − b{j + 1}" for i, j in step.corners} <= set(words)
        if step.support not in step.corners:
            assert f"w = a{step.support[0] + 1} − b{step.support[1] + 1}" in words
        radii = [
            float(lengths[0]) for points in drawn if len(points) == 181
            if np.ptp(lengths := np.hypot(*(points - (inset.x, inset.y)).T)) < 1e-9
        ]  # fmt: skip
        wanted = [d * inset.scale / scene.model.content.scale for d in (step.distance, step.bound) if d > 0.0]
        assert radii == pytest.approx(wanted) and step.bound <= scene.model.answer[0] <= step.distance + 1e-12
