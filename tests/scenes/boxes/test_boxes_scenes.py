"""All broad-phase scenes: levels and hard cases, boxes by hand and by number, digests, pictures."""

from __future__ import annotations

import numpy as np
import pytest

from game.levels import LevelError, parse_level
from game.scenes import CATALOGUE
from game.scenes.boxes.model.arrays import BoxArrays
from game.stage import Action, ParameterError, Pointer, SetEffect, SetParameter, Stage
from tests.scenes.boxes.box_stages import (
    LEVELS,
    SCENES,
    brute_pairs,
    click,
    drag,
    level_id,
    middle_of,
    open_level,
    readouts,
    stage_of,
)

HARD = {"c05": range(1, 13), "c06": range(1, 9), "c07": range(1, 10), "broad-phase-race": range(0)}
SMALL = {"count": 60, "fill": 0.3}


def area_of(boxes: BoxArrays) -> float:
    """All boxes together, m²."""
    return float((boxes.uppers - boxes.lowers)[boxes.ids].prod(axis=1).sum())


def small(scene_type, **parameters) -> Stage:
    return Stage(scene_type, parameters={**SMALL, **parameters})


@pytest.mark.parametrize(("scene_type", "path"), LEVELS, ids=level_id)
def test_every_level_runs_and_all_its_methods_find_the_pairs_of_brute_force(scene_type, path):
    stage = stage_of(scene_type, path)
    many = len(stage.scene.model.boxes.ids) > 2000
    total = len(stage.scene.model.pairs)
    for part in (1, 4, 20) if not many else (2,):
        for _ in range(part):
            stage.run(1)
            total += stage.scene.model.begun - stage.scene.model.ended
        assert stage.fault is None
        assert readouts(stage)["answers differ"] == 0.0
        assert total == len(stage.scene.model.pairs)
        if not many:
            assert stage.scene.model.pairs.tolist() == brute_pairs(stage.scene)
    for phase in stage.scene.model.structures() if not many else ():
        phase.check()


@pytest.mark.parametrize("scene_type", SCENES, ids=level_id)
def test_every_hard_case_has_its_level(scene_type):
    found = [
        (path.stem, stage_of(scene_type, path).scene.level.hard_case)
        for scene, path in LEVELS
        if scene is scene_type and path.stem.startswith("hard-")
    ]
    wanted = [f"{scene_type.task} H{number}" for number in HARD[scene_type.name]]
    assert [case for _, case in found] == wanted
    assert [int(stem.split("-")[1]) for stem, _ in found] == list(HARD[scene_type.name])


# -- boxes by hand and by number --------------------------------------------------------------------


@pytest.mark.parametrize("scene_type", SCENES, ids=level_id)
def test_a_click_adds_a_box_a_drag_one_of_that_size_and_a_right_click_removes(scene_type):
    stage = Stage(scene_type, parameters={"count": 1, "workload": "equal"}, effects_off=("box-motion",))
    scene = stage.scene
    click(stage, middle_of(stage, 0), button=3)
    assert len(scene.model.boxes.ids) == 0 and len(scene.model.pairs) == 0
    drag(stage, (1.0, 2.0), (3.0, 2.5))
    drag(stage, (8.0, 7.0), (7.5, 6.0))
    assert scene.model.boxes.lowers[scene.model.boxes.ids].tolist() == [[1.0, 2.0], [7.5, 6.0]]
    assert scene.model.boxes.uppers[scene.model.boxes.ids].tolist() == [[3.0, 2.5], [8.0, 7.0]]
    click(stage, (5.0, 5.0))
    assert len(scene.model.boxes.ids) == 3
    assert np.allclose(scene.model.boxes.uppers[2] - scene.model.boxes.lowers[2], scene.model.size)
    stage.run(3)
    assert all(len(phase) == 3 for phase in scene.model.structures())
    drag(stage, (1.1, 2.1), (7.7, 6.1))
    stage.run(1)
    assert scene.model.pairs.tolist() == [[0, 1]]
    assert readouts(stage)["answers differ"] == 0.0
    click(stage, (7.9, 6.9), button=3)
    assert scene.model.boxes.ids.tolist() == [0, 2] and len(scene.model.pairs) == 0
    drag(stage, (0.5, 0.5), (0.9, 0.9))
    assert scene.model.boxes.ids.tolist() == [0, 1, 2]
    stage.run(2)
    assert scene.model.pairs.tolist() == brute_pairs(scene)


@pytest.mark.parametrize("scene_type", SCENES, ids=level_id)
def test_a_held_box_stays_in_the_hand_and_goes_on_when_let_go(scene_type):
    stage = small(scene_type)
    scene = stage.scene
    box = 5
    middle = middle_of(stage, box)
    held = scene.hand.box_at(middle)
    velocity = scene.model.boxes.velocities[held].copy()
    drag(stage, middle, (6.0, 4.0), release=False)
    stage.run(5)
    assert scene.model.held == held
    assert (scene.model.boxes.lowers[held] <= (6.0, 4.0)).all() and (
        scene.model.boxes.uppers[held] >= (6.0, 4.0)
    ).all()
    stage.post(Pointer("cancel", 6.0, 4.0))
    assert scene.model.held == -1
    assert np.array_equal(scene.model.boxes.velocities[held], velocity)
    before = scene.model.boxes.lowers[held].copy()
    stage.run(1)
    assert np.allclose(scene.model.boxes.lowers[held] - before, velocity * stage.dt)


@pytest.mark.parametrize("scene_type", SCENES, ids=level_id)
def test_boxes_are_added_and_removed_by_number_while_the_others_go_on(scene_type):
    stage = small(scene_type)
    scene = stage.scene
    area = float(
        ((scene.model.boxes.uppers - scene.model.boxes.lowers)[scene.model.boxes.ids]).prod(axis=1).sum()
    )
    stage.post(Action("more"))
    assert len(scene.model.boxes.ids) == scene.parameters.count == 110
    stage.post(SetParameter("count", 300))
    assert len(scene.model.boxes.ids) == 300
    if scene.parameters.workload == "equal":
        now = float(
            ((scene.model.boxes.uppers - scene.model.boxes.lowers)[scene.model.boxes.ids]).prod(axis=1).sum()
        )
        assert now == pytest.approx(area, rel=1e-9)
    stage.run(3)
    assert scene.model.pairs.tolist() == brute_pairs(scene)
    stage.post(Action("fewer"))
    stage.post(SetParameter("count", 7))
    assert len(scene.model.boxes.ids) == 7
    for _ in range(3):
        stage.post(Action("fewer"))
    assert len(scene.model.boxes.ids) == 1
    stage.run(3)
    assert len(scene.model.pairs) == 0
    with pytest.raises(ParameterError):
        stage.post(SetParameter("count", 0))
    with pytest.raises(ParameterError):
        stage.post(SetParameter("count", 100_001))


@pytest.mark.parametrize("scene_type", SCENES, ids=level_id)
def test_boxes_move_by_explicit_euler_and_turn_at_the_boundary(scene_type):
    stage = small(scene_type, speed=20.0)
    scene = stage.scene
    before, velocity = scene.model.boxes.lowers.copy(), scene.model.boxes.velocities.copy()
    stage.run(1)
    assert np.array_equal(scene.model.boxes.lowers, before + velocity * stage.dt)
    stage.run(300)
    outside = np.maximum(-scene.model.boxes.lowers, scene.model.boxes.uppers - (11.2, 8.0)).max()
    assert 0.0 < outside <= 20.0 * stage.dt * 1.000001
    assert np.allclose(np.abs(scene.model.boxes.velocities), np.abs(velocity))
    stage.post(SetEffect("boundary", False))
    stage.run(120)
    assert (scene.model.boxes.lowers.max() > 20.0) or (scene.model.boxes.lowers.min() < -10.0)
    stage.post(SetEffect("box-motion", False))
    still = scene.model.boxes.lowers.copy()
    stage.run(5)
    assert np.array_equal(scene.model.boxes.lowers, still)
    assert scene.model.pairs.tolist() == brute_pairs(scene)


@pytest.mark.parametrize("scene_type", SCENES, ids=level_id)
def test_leaps_and_replacements_are_the_same_every_time(scene_type):
    digests = set()
    for _ in range(2):
        stage = small(scene_type, leaps=0.3, turnover=6)
        stage.run(20)
        assert stage.scene.model.pairs.tolist() == brute_pairs(stage.scene)
        assert len(stage.scene.model.boxes.ids) == 60
        digests.add(stage.digest())
    assert len(digests) == 1


@pytest.mark.parametrize("scene_type", SCENES, ids=level_id)
def test_swept_boxes_are_what_was_covered_in_the_step(scene_type):
    stage = small(scene_type, speed=30.0, swept=True)
    scene = stage.scene
    before = scene.model.boxes.lowers.copy(), scene.model.boxes.uppers.copy()
    stage.run(1)
    assert np.array_equal(scene.model.boxes.swept_lowers, np.minimum(before[0], scene.model.boxes.lowers))
    assert np.array_equal(scene.model.boxes.swept_uppers, np.maximum(before[1], scene.model.boxes.uppers))
    assert scene.model.pairs.tolist() == brute_pairs(scene)
    swept = len(scene.model.pairs)
    stage.post(SetParameter("swept", False))
    assert scene.model.pairs.tolist() == brute_pairs(scene)
    assert len(scene.model.pairs) < swept


# -- digests, stepping back, files, pictures ----------------------------------------------------------


@pytest.mark.parametrize("scene_type", SCENES, ids=level_id)
def test_stepping_back_and_forth_repeats_hand_numbers_and_pairs(scene_type):
    stage = small(scene_type)

    def seen():
        model = stage.scene.model
        counts = model.begun, model.ended, len(model.boxes), model.held
        return stage.digest(), model.pairs.tolist(), counts

    trail = []
    for step in range(30):
        if step == 5:
            click(stage, (3.0, 3.0))
        if step == 9:
            drag(stage, (3.0, 3.0), (4.0, 3.5))
        if step == 12:
            click(
                stage,
                middle_of(stage, 3),
                button=3,
            )
        if step == 15:
            stage.post(SetParameter("count", 80))
        trail.append(seen())
        stage.run(1)
    for step in range(29, 3, -1):
        assert stage.step_back()
        assert seen() == trail[step]
    for step in range(5, 30):
        stage.step()
        assert seen() == trail[step]


@pytest.mark.parametrize("scene_type", SCENES, ids=level_id)
def test_a_scene_saved_and_opened_again_has_the_same_boxes(scene_type):
    stage = small(scene_type)
    stage.run(10)
    content = stage.scene.save_content()
    assert len(content.boxes) == 60
    again = parse_level(f'scene = "{scene_type.name}"\n', scene_type.name, scene_type.content_type)
    copy = Stage(scene_type, level=type(again)(scene=scene_type.name, content=content))
    assert np.array_equal(copy.scene.model.boxes.lowers, stage.scene.model.boxes.lowers)
    assert copy.scene.model.pairs.tolist() == stage.scene.model.pairs.tolist()


@pytest.mark.parametrize(
    ("content", "field"),
    [
        ("boxes = [{ lower = [0, 0], upper = [nan, 1] }]", "upper"),
        ("boxes = [{ lower = [2.0, 0.0], upper = [1.0, 1.0] }]", "content"),
        ("boxes = [{ lower = [0.0, 0.0] }]", "boxes"),
        ("boxes = [{ lower = [0.0], upper = [1.0, 1.0] }]", "lower"),
        ("boxes = [{ lower = [0.0, 0.0], upper = [1.0, 1.0], velocity = [inf, 0.0] }]", "velocity"),
        ("boxes = [{ lower = [inf, 0.0], upper = [inf, 1.0] }]", "content"),
        ("boxen = []", "boxen"),
    ],
)
def test_what_is_wrong_in_a_level_is_named(content, field):
    scene_type = SCENES[0]
    with pytest.raises(LevelError) as error:
        level = parse_level(f'scene = "c05"\n[content]\n{content}\n', "c05", scene_type.content_type)
        Stage(scene_type, level=level)
    assert field in str(error.value) and "\n" not in str(error.value)


@pytest.mark.parametrize("scene_type", SCENES, ids=level_id)
def test_pictures_are_drawn_in_both_themes_whatever_there_is_to_see(scene_type):
    from game.app.stagehand.headless import picture_of_stage, prepare

    prepare()
    stage = small(scene_type)
    stage.run(3)
    plain = picture_of_stage(stage, (640, 360), "dark")
    drag(stage, (1.0, 1.0), (2.0, 2.0), release=False)
    begun = picture_of_stage(stage, (640, 360), "dark")
    assert plain.get_buffer().raw != begun.get_buffer().raw
    stage.post(Pointer("cancel", 2.0, 2.0))
    light = picture_of_stage(stage, (320, 240), "light")
    assert light.get_size() == (320, 240)
    for name, value in (("count", 3000), ("count", 1)):
        stage.post(SetParameter(name, value))
        stage.run(1)
        picture_of_stage(stage, (200, 150), "light")


@pytest.mark.parametrize("scene_type", SCENES, ids=level_id)
def test_what_a_scene_says_of_itself(scene_type):
    stage = small(scene_type)
    stage.run(2)
    names = list(readouts(stage))
    assert names[:2] == ["boxes", "pairs"]
    assert all(name in names for strip in scene_type.strips for name in strip.series)
    assert scene_type.study is not None and scene_type.equations and scene_type.try_this and scene_type.hints
    overlapping = ("box:vermilion", "overlapping", str(len(np.unique(stage.scene.model.pairs))))
    # The race writes its counts above its plot, whose place a legend would take.
    assert list(stage.scene.legend()[:1]) == ([] if scene_type.name == "broad-phase-race" else [overlapping])
    assert list(stage.scene.messages()) == []


def test_a_box_beyond_the_most_is_not_taken():
    stage = Stage(SCENES[0], parameters={"count": 100_000, "cell": 1.0}, effects_off=("matrix-pairs",))
    click(stage, (0.001, 0.001))
    assert len(stage.scene.model.boxes.ids) in (99_999, 100_000)
    assert stage.scene.parameters.count <= 100_000
    stage.run(1)
    assert stage.fault is None
    assert open_level(SCENES[0], "default").scene.parameters.count == 500


@pytest.mark.parametrize("name", ["c05", "c06", "c07", "broad-phase-race"])
def test_so_many_boxes_that_all_of_them_overlap_are_refused_at_once(name: str):
    scene_type = CATALOGUE[name].load()
    wide = ", ".join("{lower = [0.0, 0.0], upper = [9.0, 7.0]}" for _ in range(3))
    level = parse_level(f'scene = "{name}"\n[content]\nboxes = [{wide}]\n', name, scene_type.content_type)
    stage = Stage(scene_type, level=level)
    stage.run(2)
    before = stage.digest()
    with pytest.raises(ParameterError, match="too many pairs"):
        stage.post(SetParameter("count", 2000))
    assert stage.digest() == before and stage.fault is None
    assert stage.run(2) == 2


@pytest.mark.parametrize("scene_type", SCENES)
def test_times_of_many_other_boxes_are_forgotten(scene_type):
    stage = small(scene_type)
    stage.run(10)
    measured = {r.name for r in stage.readouts() if r.unit == "s" and np.isfinite(r.value)}
    assert measured
    stage.post(SetParameter("count", SMALL["count"] + 1))
    assert measured <= {r.name for r in stage.readouts() if r.unit == "s" and np.isfinite(r.value)}
    stage.post(SetParameter("count", 3 * SMALL["count"]))
    assert not any(np.isfinite(r.value) for r in stage.readouts() if r.name in measured)


@pytest.mark.parametrize(
    "sizes", ([1.7e308, 1.6e308], [5e-324, 5e-324], [0.2, 0.1, 0.4], [3.0], [0.1, 0.7, 0.3, 0.2])
)
def test_the_typical_size_is_the_median_even_of_the_largest_and_least(sizes):
    uppers = np.repeat(np.array(sizes)[:, None], 2, axis=1)
    boxes = BoxArrays(np.zeros_like(uppers), uppers, np.zeros_like(uppers), np.zeros(len(sizes)))
    wanted = float(np.median(np.array(sizes, dtype=np.longdouble)))
    assert boxes.typical_size() == wanted
