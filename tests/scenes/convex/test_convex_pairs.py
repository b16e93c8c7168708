"""What V-Clip and GJK share: two convex polygons clicked, read, moved, turned, measured, replayed."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.levels import Level, LevelError, format_level, level_files, parse_level
from game.physics.narrowphase import vclip
from game.scenes.convex.gjk import Gjk
from game.scenes.convex.level import PairContent
from game.scenes.convex.vclip import VClip
from game.stage import Action, Pointer, SetEffect, SetParameter, Stage, replay_scene
from tests.physics.narrowphase.exact_pair import exact_distance
from tests.scenes.particle_stages import click, drag, open_level, press, readouts, release, stage_of

SCENES = (VClip, Gjk)
LEVELS = [(scene, path) for scene in SCENES for path in level_files(scene.name)]
both = pytest.mark.parametrize("scene_type", SCENES, ids=lambda scene: scene.name)
each = pytest.mark.parametrize(("scene_type", "path"), LEVELS, ids=lambda v: getattr(v, "stem", None))
TRIANGLE = ((-3.0, 1.2), (-2.0, 0.4), (-1.2, 1.6))
STAR = [(2 + 0.9 * math.cos(0.8 * math.pi * k), 0.9 * math.sin(0.8 * math.pi * k)) for k in range(5)]


def still(scene_type, name="default", **declared):
    stage = open_level(scene_type, name, **declared)
    stage.post(SetEffect("shape-motion", False))
    return stage


def distance(stage):
    return readouts(stage)["distance"]


def draw(stage, points):
    stage.post(SetParameter("tool", "draw"))
    for point in points:
        click(stage, point)
    click(stage, points[0])


@pytest.mark.parametrize("missing", [(), (0,), (1,), (0, 1)])
def test_a_pair_is_ready_with_two_polygons_and_not_with_fewer(missing):
    model = still(VClip).scene.model
    model.shape = lambda index, whole=model.shape: None if index in missing else whole(index)
    assert model.ready == (not missing)
    assert (model.shapes() is None) == bool(missing)


@each
def test_every_level_steps_restores_and_steps_again(scene_type, path):
    stage = stage_of(scene_type, path)
    stage.run(10)
    for _ in range(4):
        assert stage.step_back()
    middle = stage.digest()
    again = stage_of(scene_type, path)
    again.run(6)
    assert again.digest() == middle
    assert stage.fault is None


@each
def test_every_level_is_measured_exactly(scene_type, path):
    """The hard cases of C10 and C11, in the scene: against exact arithmetic on the world's doubles."""
    stage = stage_of(scene_type, path)
    stage.run(1)
    scene = stage.scene
    if not scene.model.ready:
        assert "not-convex" in path.stem
        return
    a, b = scene.model.shape(0), scene.model.shape(1)
    extent = max(np.ptp(np.vstack((a.vertices, b.vertices)), axis=0).max(), 1e-300)
    if len(a) + len(b) < 40:
        assert scene.model.answer[0] == pytest.approx(
            exact_distance(a.vertices, b.vertices), abs=1e-12 * extent
        )
    assert scene.model.certificate() <= 1e-12
    assert readouts(stage)["distance"] == scene.model.answer[0]
    assert math.isfinite(readouts(stage)["query"])


@both
def test_a_polygon_is_clicked(scene_type):
    """C10.1, C11.1"""
    stage = still(scene_type)
    stage.pause()
    click(stage, stage.scene.model.board.outlines[0].position)
    draw(stage, TRIANGLE)
    scene = stage.scene
    assert len(scene.model.board.outlines) == 2 and len(scene.model.shape(0)) == 3
    assert np.allclose(sorted(scene.model.shape(0).vertices.tolist()), sorted(TRIANGLE), rtol=0, atol=1e-12)
    assert distance(stage) == vclip(scene.model.shape(0), scene.model.shape(1)).distance
    text = format_level(Level(scene=scene_type.name, content=scene.save_content()))
    back = scene_type(parse_level(text, scene_type.name, PairContent))
    assert back.model.answer[0] == pytest.approx(scene.model.answer[0], abs=1e-12)


@both
def test_one_that_is_not_convex_is_refused_and_its_hull_offered(scene_type):
    """C10.1, C11.1: clicked or read; one key accepts, and it can be taken back."""
    stage = still(scene_type)
    stage.run(2)
    before = stage.scene.model.answer.copy()
    click(stage, stage.scene.model.board.outlines[1].position)
    draw(stage, STAR)
    scene = stage.scene
    assert not scene.model.ready and len(scene.model.refusal(1).hull) == 5
    assert any("not convex at corner" in words and "H" in words for words in scene.messages())
    stage.run(2)
    assert np.array_equal(scene.model.answer, before)
    assert any(words == "hull offered" for _, words, _ in scene.legend())
    stage.post(Action("hull"))
    assert scene.model.ready and len(scene.model.shape(1)) == 5
    assert distance(stage) == vclip(scene.model.shape(0), scene.model.shape(1)).distance
    stage.post(Action("undo"))
    assert not scene.model.ready
    stage.post(Action("redo"))
    assert scene.model.ready
    read = open_level(scene_type, "hard-26-not-convex")
    assert [len(read.scene.model.refusal(k).hull) for k in (0, 1)] == [5, 5]
    read.post(Action("hull"))
    assert read.scene.model.ready and distance(read) > 0.0


@both
def test_dragged_and_turned(scene_type):
    """C10.4, C11.3: by the body, by shift, by the handle's key; also while it stands still."""
    stage = still(scene_type)
    stage.pause()
    scene = stage.scene
    x, y = scene.model.board.outlines[1].position
    far = distance(stage)
    drag(stage, (x, y), (x + 1.0, y), run=0)
    assert distance(stage) == pytest.approx(far + 1.0, abs=0.2)
    angle = scene.model.board.outlines[1].angle
    press(stage, (x + 1.0, y + 0.3), shift=True)
    stage.post(Pointer("move", x + 0.7, y, button=1))
    release(stage, (x + 0.7, y))
    assert scene.model.board.outlines[1].angle - angle == pytest.approx(0.5 * math.pi)
    stage.post(Action("turn-right"))
    assert scene.model.board.outlines[1].angle - angle == pytest.approx(0.5 * math.pi - math.radians(5))
    drag(stage, scene.model.board.outlines[1].position, scene.model.board.outlines[0].position, run=0)
    assert distance(stage) < -0.5
    for _ in range(4):
        stage.post(Action("undo"))
    assert distance(stage) == pytest.approx(far, abs=1e-12)


@both
def test_closest_points_and_features_are_found(scene_type):
    """C10.5, C11.4"""
    stage = still(scene_type)
    stage.run(1)
    scene = stage.scene
    found = scene.model.present()
    assert math.dist(found.point_a, found.point_b) == pytest.approx(found.distance, abs=1e-12)
    for k, feature in ((0, found.feature_a), (1, found.feature_b)):
        assert 0 <= feature.index < len(scene.model.shape(k))
    assert found == vclip(scene.model.shape(0), scene.model.shape(1))._replace(iterations=found.iterations)


@both
def test_a_corner_is_dragged_added_and_taken_away(scene_type):
    stage = still(scene_type)
    scene = stage.scene
    stage.post(SetParameter("tool", "points"))
    corner = scene.model.drawn_corners(0)[3]
    drag(stage, corner, np.add(corner, (0.2, 0.0)), run=0)
    assert np.allclose(scene.model.drawn_corners(0)[3], np.add(corner, (0.2, 0.0)), rtol=0, atol=1e-12)
    count = len(scene.model.shape(0))
    stage.post(Action("delete"))
    assert len(scene.model.shape(0)) == count - 1


@both
def test_one_polygon_alone_and_none_can_be_looked_at_and_acted_on(scene_type):
    stage = still(scene_type)
    for left in (1, 0):
        click(stage, stage.scene.model.drawn_corners(0).mean(axis=0))
        stage.post(Action("delete"))
        assert len(stage.scene.model.board.outlines) == left
        for action in scene_type.actions:
            if action.name not in ("delete", "undo", "redo"):
                stage.post(Action(action.name))
        stage.post(SetParameter("start_b", 3))
        stage.run(2)
        assert stage.fault is None and math.isnan(readouts(stage)["query"])


@both
def test_coherence_begins_at_the_last_answer(scene_type):
    warm, cold = open_level(scene_type, "coins"), open_level(scene_type, "coins")
    cold.post(SetEffect("coherence", False))
    for stage in (warm, cold):
        stage.run(120)
    assert np.array_equal(warm.scene.state().places, cold.scene.state().places)
    assert distance(warm) == pytest.approx(distance(cold), abs=1e-14)
    assert readouts(warm)["mean steps"] < 0.5 * readouts(cold)["mean steps"]


@both
def test_depth_is_left_out_when_it_is_switched_off(scene_type):
    stage = open_level(scene_type, "hard-10-identical")
    stage.run(1)
    assert distance(stage) == -2.0
    stage.post(SetEffect("exact-answer", False))
    stage.run(1)
    assert distance(stage) == 0.0
    assert stage.scene.model.present().overlapping


@both
def test_the_walk_is_stepped_forward_and_backward(scene_type):
    stage = still(scene_type)
    stage.post(SetEffect("coherence", False))
    scene = stage.scene
    stage.post(SetParameter("start_a", 11))
    stage.post(SetParameter("start_b", 7))
    length = scene.model.trace_length()
    assert length > 2 and scene.hand.shown == -1
    digest = stage.digest()
    for k in range(length - 2, -1, -1):
        stage.post(Action("earlier"))
        assert scene.hand.shown == k
    stage.post(Action("earlier"))
    assert scene.hand.shown == 0
    stage.post(Action("later"))
    assert scene.hand.shown == 1
    for _ in range(length):
        stage.post(Action("later"))
    assert scene.hand.shown == -1
    assert stage.digest() == digest
    starts = set()
    for _ in range(20):
        stage.post(Action("start"))
        starts.add((scene.parameters.start_a, scene.parameters.start_b))
        assert scene.model.answer[0] == pytest.approx(
            vclip(scene.model.shape(0), scene.model.shape(1)).distance, abs=1e-12
        )
    assert len(starts) == 20


@both
def test_shapes_turn_back_at_the_border(scene_type):
    stage = open_level(scene_type, "crystals")
    view = stage.scene.model.content.view
    places = []
    for _ in range(90):
        stage.run(20)
        places.append(stage.scene.model.board.outlines[1].position[0])
    assert view.left - 0.2 < min(places) < view.left + 0.5
    assert view.right - 0.5 < max(places) < view.right + 0.2
    assert stage.fault is None


@both
def test_a_recorded_session_replays_exactly(scene_type):
    stage = open_level(scene_type, "default")
    stage.run(5)
    drag(stage, stage.scene.model.board.outlines[1].position, (0.0, 0.4), steps=6)
    draw(stage, STAR)
    stage.run(3)
    stage.post(Action("hull"))
    stage.post(SetEffect("coherence", False))
    stage.post(SetParameter("start_b", 3))
    stage.post(Action("later"))
    stage.run(10)
    twin = replay_scene(stage.recording, scene_type)
    assert twin.digest() == stage.digest()
    assert stage.fault is None


@both
def test_stepping_back_undoes_a_drag(scene_type):
    stage = open_level(scene_type, "default")
    stage.run(4)
    before = stage.digest()
    drag(stage, stage.scene.model.board.outlines[0].position, (-1.0, 0.5), steps=4)
    assert stage.digest() != before
    while stage.step_number > 3:
        assert stage.step_back()
    stage.post(Action("move"))
    stage.step()
    assert stage.digest() == before


@pytest.mark.parametrize(
    ("text", "field"),
    [
        ("[content]\nb = { points = [[0, 0]] }", "content"),
        (
            "[content]\na = { points = [[0, 0]] }\nb = { position = [1, 1] }",
            "b: expected either points",
        ),
        ("[content]\na = { corners = 2 }\nb = { corners = 5 }", "content.a.corners"),
        ("[content]\na = { points = [[0, nan]] }\nb = { corners = 5 }", "content.a.points[0][1]"),
        ("[content]\na = { corners = 5, radius = 0.0 }\nb = { corners = 5 }", "content.a.radius"),
        ("[content]\nscale = -1.0\na = { corners = 5 }\nb = { corners = 5 }", "content.scale"),
        ("[content]\norigin = [1e15, 0.0]\na = { corners = 5 }\nb = { corners = 5 }", "origin"),
        ("[content]\nc = 1\na = { corners = 5 }\nb = { corners = 5 }", "content.c"),
        ("[parameters]\nstart_a = -1", "parameters.start_a"),
    ],
)
def test_what_is_broken_in_a_level_is_named(text, field):
    with pytest.raises(LevelError) as caught:
        VClip(parse_level(f'scene = "c10"\n{text}\n', "c10", PairContent))
    assert field in str(caught.value)


def test_a_slider_of_features_spans_those_that_there_are():
    scene = Stage(VClip).scene
    counts = [len(outline.points) for outline in scene.model.board.outlines]
    assert [scene.slider_range(name) for name in ("start_a", "start_b")] == [
        (0.0, 2.0 * n - 1.0) for n in counts
    ]
    assert scene.slider_range("tool") is None
