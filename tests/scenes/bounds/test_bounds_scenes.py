"""What C08 and C09 share: outlines by file and by click, dragging, turning, walking, levels, replay."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.levels import Level, LevelError, format_level, level_files, load_level, parse_level
from game.physics.bounds import FITS, traversal
from game.physics.bounds.query import ANCESTOR, OVERLAPPING
from game.scenes.bounds.capsules import Capsules
from game.scenes.bounds.oriented_boxes import OrientedBoxes
from game.scenes.bounds.walk import fit_row
from game.scenes.bounds.walk_words import caption
from game.scenes.shared.outlines import shapes
from game.scenes.shared.outlines.level import OutlinesContent
from game.scenes.shared.outlines.outline import placed
from game.stage import Action, Recording, SetEffect, SetParameter, Stage, replay_scene
from tests.scenes.particle_stages import click, drag, move, open_level, press, readouts, release, stage_of

SCENES = (OrientedBoxes, Capsules)
LEVELS = [(scene, path) for scene in SCENES for path in level_files(scene.name)]
both = pytest.mark.parametrize("scene_type", SCENES, ids=lambda scene: scene.name)


def marks_of(stage):
    return stage.scene.model.pair.query.marks()


@both
def test_two_outlines_are_clicked_and_saved_and_read_back(scene_type):
    """C08.1, C09.1: also while it stands still; closed at the first corner, open by a key."""
    stage = open_level(scene_type, "draw")
    stage.pause()
    scene = stage.scene
    assert len(scene.model.outlines) == 0 and scene.model.pair.query is None
    for point in ((-3, -1), (-1, -1), (-2, 0), (-1, 1), (-3, 1), (-3, -1)):
        click(stage, point)
    for point in ((1, -1), (3, 0), (1, 1)):
        click(stage, point)
    stage.post(Action("finish"))
    assert [outline.closed for outline in scene.model.outlines] == [True, False]
    assert [len(tree.ends) for tree in scene.model.pair.trees] == [5, 2]
    assert readouts(stage)["gap"] == pytest.approx(2.0)
    text = format_level(Level(scene=scene_type.name, content=scene.save_content()))
    back = scene_type(parse_level(text, scene_type.name, OutlinesContent))
    for mine, theirs in zip(scene.model.outlines, back.model.outlines, strict=True):
        assert np.allclose(placed(mine), placed(theirs), rtol=0, atol=1e-12)
    stage.resume()
    stage.run(5)
    assert stage.fault is None
    scene.check()


@both
def test_outlines_are_dragged_and_their_volumes_follow_at_once(scene_type):
    """C08.5 to .7, C09.5, .7: red, green, and all grey when nothing overlaps; also while it stands still."""
    stage = open_level(scene_type, "default")
    stage.pause()
    scene = stage.scene
    at = scene.model.outlines[1].position
    drag(stage, at, (at[0] + 40.0, at[1]), run=0)
    assert scene.model.outlines[1].position[0] == pytest.approx(at[0] + 40.0)
    assert readouts(stage)["tests"] == 1 and scene.model.marked()[:2] == (0, 0)
    assert [words for _, words, count in scene.legend() if count == str(scene.model.marked()[2])]
    drag(stage, (at[0] + 40.0, at[1]), scene.model.outlines[0].position, run=0)
    red, green, rest = scene.model.marked()
    assert red > 0 and green > 0 and red + green + rest == sum(map(len, scene.model.pair.trees))
    for marks, tree in zip(marks_of(stage), scene.model.pair.trees, strict=True):
        for node in np.flatnonzero(marks == OVERLAPPING).tolist():
            assert tree.links[node, 0] < 0
            while (node := int(tree.links[node, 3])) >= 0:
                assert marks[node] == ANCESTOR
    scene.check()


@both
def test_outlines_are_turned_and_trees_turn_with_them(scene_type):
    stage = open_level(scene_type, "default")
    stage.pause()
    scene = stage.scene
    x, y = scene.model.outlines[0].position
    trees = list(scene.model.pair.trees)
    press(stage, (x + 0.5, y), shift=True)
    move(stage, (x, y + 0.5))
    release(stage, (x, y + 0.5))
    assert scene.model.outlines[0].angle == pytest.approx(math.pi / 2)
    assert scene.model.pair.trees[0] is trees[0]
    scene.check()
    stage.post(SetParameter("volume", "aabb"))
    assert scene.model.pair.trees[0].points[0] == pytest.approx(placed(scene.model.outlines[0])[0] - (x, y))
    scene.check()
    stage.post(Action("undo"))
    assert scene.model.outlines[0].angle == 0.0
    stage.post(Action("redo"))
    assert scene.model.outlines[0].angle == pytest.approx(math.pi / 2)


@both
def test_every_kind_of_tree_finds_the_same_crossings(scene_type):
    stage = open_level(scene_type, "default")
    stage.run(150)
    found = {}
    for volume in ("obb", "capsule", "aabb"):
        for fit in FITS:
            stage.post(SetParameter("volume", volume))
            stage.post(SetParameter("fit", fit))
            found[volume, fit] = {tuple(pair) for pair in stage.scene.model.pair.query.crossings.tolist()}
            stage.scene.check()
    assert len(set(map(frozenset, found.values()))) == 1 and found["obb", "search"]


@both
def test_coherence_keeps_the_answer_and_saves_tests(scene_type):
    """Front caching: fewer tests from step to step, the same crossings."""
    with_front = open_level(scene_type, "hands", sway=0.2)
    anew = open_level(scene_type, "hands", sway=0.2)
    with_front.post(SetEffect("coherence", True))
    kept = fresh = 0
    for _ in range(80):
        with_front.run(1)
        anew.run(1)
        kept += readouts(with_front)["tests"]
        fresh += readouts(anew)["tests"]
        a, b = (sorted(map(tuple, s.scene.model.pair.query.crossings.tolist())) for s in (with_front, anew))
        assert a == b
    assert kept < 0.8 * fresh


@both
def test_what_is_not_declared_is_not_computed(scene_type):
    stage = open_level(scene_type, "default")
    stage.run(150)
    assert readouts(stage)["segment tests"] > 0
    stage.post(SetEffect("exact-answer", False))
    assert readouts(stage)["segment tests"] == 0 and readouts(stage)["crossings"] == 0
    place = stage.scene.model.outlines[1].position
    stage.post(SetEffect("shape-motion", False))
    stage.run(20)
    assert stage.scene.model.outlines[1].position == place


@both
@pytest.mark.parametrize("name", ["fit", "build", "query"])
def test_a_walk_stands_at_its_start_and_goes_on_and_back_by_hand(scene_type, name):
    stage = open_level(scene_type, f"walk-{name}")
    stage.run(120)  # two seconds: nobody has asked it to go on
    scene = stage.scene
    assert scene.walk.cursor == 0 and "From the start" in caption(scene.walk)
    captions = []
    for i in range(1, 12):
        stage.post(Action("walk-on"))
        assert scene.walk.cursor == i
        captions.append(caption(scene.walk))
    assert len(set(captions)) == 11
    said = {"fit": ("so far",), "build": ("a leaf", "halved: "), "query": ("this branch ends", "overlap")}[
        name
    ]
    assert all(any(words in text for words in said) for text in captions)
    if name == "query":
        assert any("apart by " in text for text in captions)
    for i in range(10, 5, -1):
        stage.post(Action("walk-back"))
        assert scene.walk.cursor == i and caption(scene.walk) == captions[i - 1]
    stage.post(Action("walk-start"))
    stage.post(Action("walk-back"))
    assert scene.walk.cursor == 0 and "From the start" in caption(scene.walk)


@both
def test_a_walk_plays_three_to_four_steps_a_second_to_its_end(scene_type):
    stage = open_level(scene_type, "walk-build")
    stage.post(Action("walk-play"))
    stage.run(600)
    assert 30 <= stage.scene.walk.cursor <= 40
    at = stage.scene.walk.cursor
    for _ in range(60):
        assert stage.step_back()
    assert 3 <= at - stage.scene.walk.cursor <= 4
    for _ in range(60):
        stage.step()
    assert stage.scene.walk.cursor == at
    stage.post(Action("walk-on"))
    stage.run(120)
    assert stage.scene.walk.cursor == at + 1 and not stage.scene.parameters.playing
    stage.post(SetParameter("pace", 60.0))
    stage.post(Action("walk-play"))
    stage.run(600)
    assert stage.scene.walk.cursor == stage.scene.walk.length() and not stage.scene.parameters.playing
    stage.post(Action("walk-play"))
    assert stage.scene.walk.cursor == 0 and stage.scene.parameters.playing
    stage.post(Action("walk"))
    stage.run(60)
    assert stage.scene.walk.cursor == 0 and stage.scene.parameters.walked == "query"


def test_the_walk_through_the_fit_ends_at_the_box_of_the_tree():
    for scene_type in SCENES:
        stage = open_level(scene_type, "walk-fit")
        found = stage.scene.walk.fit()
        tree = stage.scene.model.pair.trees[0]
        assert found.areas.min() == pytest.approx(tree.areas()[0], rel=1e-6)
        assert found.exact <= found.areas.min() * (1 + 1e-9)
        best = float(found.angles[found.areas.argmin()])
        assert np.allclose(fit_row(found, best, tree.kind)[0], tree.volumes[0], rtol=0, atol=1e-6)


def test_the_walk_through_the_query_is_the_record():
    stage = open_level(OrientedBoxes, "walk-query")
    query = stage.scene.model.pair.query
    assert stage.scene.walk.length() == query.row_count == query.volume_tests
    for _ in range(query.row_count):
        stage.post(Action("walk-on"))
    verdict = int(query.rows[-1, traversal.VERDICT])
    words = {0: "apart", 1: "opened", 2: "leaves overlap"}[verdict]
    assert words in caption(stage.scene.walk)


@both
def test_corners_are_moved_and_the_tree_is_built_anew(scene_type):
    stage = open_level(scene_type, "default")
    stage.pause()
    stage.post(Action("points"))
    scene = stage.scene
    corner = placed(scene.model.outlines[0])[7]
    tree = scene.model.pair.trees[0]
    away = corner + np.array((0.0, 0.3))
    drag(stage, corner, away, run=0)
    assert scene.model.pair.trees[0] is not tree and scene.model.pair.trees[1].segments == 128
    assert np.allclose(placed(scene.model.outlines[0])[7], away, rtol=0, atol=1e-12)
    stage.post(Action("delete"))
    assert scene.model.pair.trees[0].segments == 119
    stage.post(Action("move"))
    click(stage, scene.model.outlines[1].position)
    stage.post(Action("delete"))
    assert len(scene.model.outlines) == 1 and scene.model.pair.query is None
    assert math.isnan(readouts(stage)["gap"])
    stage.resume()
    stage.run(3)
    assert stage.fault is None


@both
def test_keys_for_levels_and_hierarchy(scene_type):
    stage = open_level(scene_type, "default")
    stage.post(Action("level-up"))
    assert stage.scene.parameters.deepest == 5
    for _ in range(30):
        stage.post(Action("level-down"))
    assert stage.scene.parameters.deepest == 24
    stage.post(Action("hierarchy"))
    assert not stage.scene.parameters.hierarchy
    assert not any("rest" in words for _, words, _ in stage.scene.legend())
    stage.post(Action("close"))
    assert any("needs 3 points" in words for words in stage.scene.messages())


@pytest.mark.parametrize(("scene_type", "path"), LEVELS, ids=lambda value: getattr(value, "name", value))
def test_every_level_steps_restores_and_steps_again(scene_type, path):
    stage = stage_of(scene_type, path)
    stage.run(8)
    for _ in range(4):
        if stage.step_number:
            assert stage.step_back()
    middle = stage.digest()
    stage.run(4)
    again = stage_of(scene_type, path)
    again.run(4)
    assert again.digest() == middle
    again.run(4)
    assert again.digest() == stage.digest()
    assert stage.fault is None
    stage.scene.check()
    unknown = {r.name for r in stage.readouts() if not math.isfinite(r.value)}
    assert unknown <= (
        {"gap", "area above exact", "building"}
        if "draw" in path.stem
        else {"area above exact", *(("crossings",) if "walk-query" in path.stem else ())}
    )


@both
def test_a_recorded_session_with_edits_replays_exactly(scene_type):
    stage = open_level(scene_type, "default")
    stage.post(SetEffect("coherence", True))
    stage.run(5)
    drag(stage, stage.scene.model.outlines[1].position, (0.5, 0.3), steps=6)
    stage.post(SetParameter("leaf_size", 2))
    stage.post(Action("points"))
    corner = placed(stage.scene.model.outlines[0])[3]
    drag(stage, corner, corner + 0.2, steps=3)
    stage.post(Action("draw"))
    for point in ((-4, 2), (-3, 2), (-3, 1)):
        click(stage, point)
        stage.run(1)
    stage.post(Action("close"))
    stage.run(4)
    stage.post(Action("undo"))
    stage.post(SetParameter("walked", "query"))
    stage.post(Action("walk-play"))
    stage.run(30)
    assert replay_scene(stage.recording, scene_type).digest() == stage.digest()


@both
def test_stepping_back_undoes_edits(scene_type):
    stage = open_level(scene_type, "default")
    stage.run(4)
    before, places = stage.digest(), [outline.position for outline in stage.scene.model.outlines]
    drag(stage, stage.scene.model.outlines[0].position, (0.0, 1.0), steps=4)
    stage.post(Action("draw"))
    click(stage, (3.0, 2.0))
    stage.run(3)
    after = stage.digest()
    while stage.step_number > 4:
        assert stage.step_back()
    while stage.step_number < 11:
        stage.step()
    assert stage.digest() == after and stage.scene.model.board.drawn == ((3.0, 2.0),)
    while stage.step_number > 3:
        stage.step_back()
    stage.post(SetParameter("axes", True))  # another future
    stage.step()
    assert stage.digest() == before
    assert [outline.position for outline in stage.scene.model.outlines] == places


@pytest.mark.parametrize(
    ("text", "field"),
    [
        ('[[content.outlines]]\nshape = "blob"', "content.outlines[0].shape"),
        ("[[content.outlines]]\nposition = [0, 0]", "content.outlines[0].shape"),
        ('[[content.outlines]]\nshape = "points"\npoints = []', "content.outlines[0].points"),
        ('[[content.outlines]]\nshape = "points"\npoints = [[0, nan]]', "content.outlines[0].points[0][1]"),
        ('[[content.outlines]]\nshape = "coast"\nsegments = 2', "content.outlines[0].segments"),
        ('[[content.outlines]]\nshape = "gear"\nteeth = 200\nsteps = 10', "outlines"),
        ('[[content.outlines]]\nshape = "star"\n' * 3, "content.outlines"),
        ("[parameters]\nangle_step = 0.0", "parameters.angle_step"),
        ("[parameters]\nleaf_size = 1.5", "parameters.leaf_size"),
        ('[effects]\noff = ["gravity"]', "effects.off"),
    ],
)
def test_what_is_broken_in_a_level_is_named(text, field):
    with pytest.raises(LevelError) as caught:
        OrientedBoxes(parse_level(f'scene = "c08"\n{text}\n', "c08", OutlinesContent))
    assert field in str(caught.value)


def test_shapes_made_by_rule_are_what_they_are_called():
    coast = shapes.coast(3, 64, 1.5, 0.3, 0.02)
    assert len(coast) == 64 and np.array_equal(coast, shapes.coast(3, 64, 1.5, 0.3, 0.02))
    assert not np.array_equal(coast, shapes.coast(4, 64, 1.5, 0.3, 0.02))
    gear = shapes.gear(10, 2.0, 0.5, 2)
    radii = np.hypot(*gear.T)
    assert len(gear) == 60 and np.allclose(np.unique(radii.round(9)), (1.5, 2.0))
    hand = shapes.hand(2.0, False, 1.0, 8)
    mirrored = shapes.hand(2.0, True, 1.0, 8)
    assert np.array_equal(mirrored[::-1] * (-1, 1), hand)
    assert np.allclose(np.hypot(*shapes.arc(2.0, 10, 90, 5).T), 2.0)
    assert len(shapes.spiral(0.1, 1.0, 2, 30)) == 31 and len(shapes.star(5, 1.0, 0.5)) == 10
    comb = shapes.comb(4, 2.0, 1.0)
    assert np.ptp(comb[:, 0]) == pytest.approx(2.0) and np.ptp(comb[:, 1]) == pytest.approx(1.0)


@pytest.mark.parametrize(("scene_type", "now"), [(OrientedBoxes, "exact"), (Capsules, "thinnest")])
def test_the_fit_that_was_called_calipers_is_taken_by_its_present_name(scene_type, now, tmp_path):
    """For boxes it was the least area, for capsules the least radius."""
    text = f'scene = "{scene_type.name}"\n[parameters]\nfit = "calipers"\n'
    stage = Stage(scene_type, level=parse_level(text, scene_type.name, OutlinesContent))
    assert stage.scene.parameters.fit == now
    stage.post(SetParameter("fit", "search"))
    stage.post(SetParameter("fit", "calipers"))
    stage.run(3)
    assert stage.scene.parameters.fit == now
    assert stage.scene.model.pair.options.fit == now
    path = tmp_path / "older.json"
    stage.recording.save(path)
    path.write_text(path.read_text().replace(f'"{now}"', '"calipers"'))
    assert replay_scene(Recording.load(path), scene_type).digest() == stage.digest()


def test_crossings_are_told_when_a_walk_has_come_to_its_end():
    path = next(path for path in level_files("c08") if path.stem == "hard-06-touching")
    stage = Stage(OrientedBoxes, level=load_level(path, "c08", OrientedBoxes.content_type))

    def told() -> tuple[float, bool]:
        crossings = next(row.value for row in stage.readouts() if row.name == "crossings")
        return crossings, any(words == "crossing of segments" for _, words, _ in stage.scene.legend())

    assert told() == (3, True)
    stage.post(SetParameter("walked", "query"))
    assert math.isnan(told()[0]) and not told()[1]
    stage.scene.walk.stand_at(10_000)
    assert told() == (3, True)
