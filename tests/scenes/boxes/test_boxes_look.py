"""Looking into a box of the broad-phase scenes: what is told is what was done, and nothing changes."""

from __future__ import annotations

import numpy as np
import pytest

from game.app.stagehand.headless import picture_of_stage, prepare
from game.scenes.boxes.hierarchical_grids import HierarchicalGridScene
from game.scenes.boxes.model.names import apart_on, listed_names, name_of, outcomes, result_of
from game.scenes.boxes.model.sweep_and_prune import MOST_KEPT
from game.scenes.boxes.sheets import sheet_at, sheets_of
from game.scenes.boxes.sweep_and_prune import SweepAndPruneScene
from game.scenes.boxes.uniform_grid import UniformGridScene
from game.scenes.boxes.view import grid_look as c05_look
from game.scenes.boxes.view import levels_look as c06_look
from game.scenes.boxes.view.column import Column
from game.stage import Pointer, SetParameter, Stage
from tests.scenes.boxes.box_stages import (
    SCENES,
    brute_pairs,
    click,
    drag,
    level_id,
    middle_of,
    open_level,
)

SMALL = [
    (UniformGridScene, "look-into-one-cell"),
    (UniformGridScene, "look-into-covered-cells"),
    (HierarchicalGridScene, "look-up"),
    (HierarchicalGridScene, "run-over"),
    (SweepAndPruneScene, "swap-by-swap"),
    (SweepAndPruneScene, "swap-by-swap-apart"),
]


def written(stage: Stage, monkeypatch, size=(960, 540)) -> list[tuple[str, str]]:
    """Rows, heads and sentences of the column."""
    prepare()
    rows: list[tuple[str, str]] = []
    for name in ("head", "row"):
        monkeypatch.setattr(Column, name, lambda self, words, value="", color="": rows.append((words, value)))
    monkeypatch.setattr(Column, "words", lambda self, text, color="": rows.append((text, color)))
    picture_of_stage(stage, size, "dark")
    return rows


@pytest.mark.parametrize("scene_type", SCENES, ids=level_id)
def test_pointing_shows_a_box_clicking_keeps_it_and_neither_changes_the_state(scene_type):
    stage = Stage(scene_type, parameters={"count": 12, "fill": 0.4, "workload": "equal"})
    plain = Stage(scene_type, parameters={"count": 12, "fill": 0.4, "workload": "equal"})
    scene = stage.scene
    middle = middle_of(stage, 7)
    assert scene.hand.looked == -1
    stage.post(Pointer("move", *middle))
    box = scene.hand.looked
    assert (
        box >= 0
        and (scene.model.boxes.lowers[box] <= middle).all()
        and (scene.model.boxes.uppers[box] >= middle).all()
    )
    stage.post(Pointer("move", -3.0, 1.0))
    assert scene.hand.looked == -1
    click(stage, middle)
    stage.post(Pointer("move", -3.0, 1.0))
    assert scene.hand.looked == scene.model.chosen == box
    for both in (stage, plain):
        both.run(20)
    assert scene.hand.looked == box and stage.digest() == plain.digest()
    again = middle_of(stage, box)
    if scene.hand.box_at(again) == box:
        click(stage, again)
        assert scene.model.chosen == -1
    drag(stage, again, (3.0, 3.0))
    assert scene.model.chosen == -1  # a drag is no click


@pytest.mark.parametrize("scene_type", SCENES, ids=level_id)
def test_a_chosen_box_that_goes_is_looked_into_no_more(scene_type):
    stage = Stage(scene_type, parameters={"count": 12, "workload": "equal"})
    stage.scene.model.chosen = 11
    stage.post(SetParameter("count", 11))
    assert stage.scene.hand.looked == stage.scene.model.chosen == -1
    stage.scene.model.chosen = 3
    stage.scene.model.remove(np.array([3]))
    assert stage.scene.model.chosen == -1


@pytest.mark.parametrize(("scene_type", "level"), SMALL, ids=[level for _, level in SMALL])
def test_small_levels_have_few_boxes_with_letters_and_every_one_can_be_looked_into(scene_type, level):
    prepare()
    stage = open_level(scene_type, level)
    assert 6 <= len(stage.scene.model.boxes.ids) <= 12
    begun = ended = 0
    for _ in range(300):
        stage.run(1)
        begun, ended = begun + stage.scene.model.begun, ended + stage.scene.model.ended
    assert begun + ended > 0 and stage.scene.model.pairs.tolist() == brute_pairs(stage.scene)
    plain = picture_of_stage(stage, (480, 270), "dark").get_buffer().raw
    pictures = {plain}
    for box in stage.scene.model.boxes.ids.tolist():
        stage.scene.model.chosen = box
        pictures.add(picture_of_stage(stage, (480, 270), "dark").get_buffer().raw)
    assert len(pictures) == 1 + len(stage.scene.model.boxes.ids)


def test_the_grid_tells_cells_tests_and_places_of_a_box(monkeypatch):
    stage = open_level(UniformGridScene, "look-into-one-cell")
    stage.scene.model.chosen = 0
    rows = dict(written(stage, monkeypatch))
    assert rows["Box A"] == "1 pair, 0 rejected" and rows["Looks in"] == "4 cells, 1 test"
    assert rows["Pair AB at"].startswith("k = 0, h = ")
    stage.scene.model.chosen = 1
    rows = dict(written(stage, monkeypatch))
    assert rows["Found from the other side"] == "A" and "rejected" in rows["Box B"]
    seen = c05_look.look_into(stage.scene.model, 1)
    assert seen.stands[0] in seen.looks and seen.partners == [0]


def test_the_hierarchy_tells_of_looks_up_and_runs_over(monkeypatch):
    up, over = (open_level(HierarchicalGridScene, name) for name in ("look-up", "run-over"))
    up.scene.model.chosen, over.scene.model.chosen = 6, 0
    words = [row[0] for row in written(up, monkeypatch)]
    assert any(w.startswith("Looks up") and w.endswith("4.00 m") for w in words)
    words = [row[0] for row in written(over, monkeypatch)]
    assert any(w.startswith("Runs over") for w in words)
    over.scene.model.chosen = -1
    small = c06_look.look_into(over.scene.model, 4)
    assert {visit.way for visit in small.visits} == {"own"} and 0 in small.partners


def test_swaps_are_told_in_words_with_the_reason():
    stage = open_level(SweepAndPruneScene, "swap-by-swap")
    told, begun = [], 0
    for _ in range(400):
        stage.run(1)
        told += (
            stage.scene.model.story[len(stage.scene.model.story) - stage.scene.model.fresh :]
            if stage.scene.model.fresh
            else []
        )
        begun += stage.scene.model.begun
        assert stage.scene.model.fresh == stage.scene.model.swaps
        assert len(stage.scene.model.story) <= MOST_KEPT
    assert "A's maximum passes B's minimum on x; on y they overlap too: pair begins." in told
    assert sum("pair begins" in sentence for sentence in told) == begun > 0
    assert any("they are apart: no pair" in sentence for sentence in told)


def test_a_pair_ends_with_the_first_axis_on_which_the_boxes_part():
    stage = open_level(SweepAndPruneScene, "swap-by-swap-apart")
    told, ended = [], 0
    for _ in range(300):
        stage.run(1)
        told += (
            stage.scene.model.story[len(stage.scene.model.story) - stage.scene.model.fresh :]
            if stage.scene.model.fresh
            else []
        )
        ended += stage.scene.model.ended
    assert sum("pair ends" in sentence for sentence in told) == ended > 3
    assert any(sentence.endswith("so they separate: they were no pair.") for sentence in told)


def test_going_back_takes_the_words_back_too():
    stage = open_level(SweepAndPruneScene, "swap-by-swap")
    trail = []
    for _ in range(170):
        trail.append(list(stage.scene.model.story))
        stage.run(1)
    assert trail[-1]
    for story in trail[:-6:-1]:
        assert stage.step_back()
        assert stage.scene.model.story == story


def test_a_place_on_a_tilted_sheet_is_one_in_the_world_and_boxes_of_its_level_are_meant():
    stage = open_level(HierarchicalGridScene, "look-up")
    scene = stage.scene
    sheets = sheets_of(scene.model)
    assert [sheet.level for sheet in sheets] == [level for level, _ in scene.model.grid.levels()]
    for box in scene.model.boxes.ids.tolist():
        sheet = next(s for s in sheets if s.level == scene.model.grid.level(box))
        middle = 0.5 * (scene.model.boxes.lowers[box] + scene.model.boxes.uppers[box])
        place = sheet.place(*middle)
        assert sheet.back(*place) == pytest.approx(tuple(middle))
        assert sheet_at(sheets, *place) == sheet
        stage.post(Pointer("move", *place))
        assert scene.hand.looked == box
    stage.post(Pointer("move", 9.0, 4.0))
    assert scene.hand.looked == -1  # beside the sheets
    drag(
        stage,
        sheets[0].place(*middle_of(stage, 6)),
        sheets[0].place(9.0, 7.0),
    )
    assert np.allclose(middle_of(stage, 6), (9.0, 7.0))
    stage.post(Pointer("down", 9.0, 4.0, button=1))
    stage.post(Pointer("up", 9.0, 4.0, button=1))
    assert len(scene.model.boxes.ids) == 10  # no box is drawn beside the sheets
    stage.post(SetParameter("stack", False))
    stage.post(Pointer("move", 9.0, 7.0))
    assert scene.hand.looked == 6


def test_why_a_test_fails():
    boxes = open_level(UniformGridScene, "look-into-one-cell").scene.model.boxes
    assert apart_on(boxes, 0, 1) == "" and apart_on(boxes, 1, 3) == "y" and apart_on(boxes, 0, 4) == "x and y"
    assert outcomes(boxes, 1, [3, 0, 3]) == ([0], [3]) and result_of([0], [3]) == "1 pair, 1 rejected"
    assert name_of(boxes, 2) == "C" and listed_names(boxes, [0, 1, 2, 3, 4, 5]) == "A, B, C, D and 2 more"
    many = Stage(UniformGridScene, parameters={"count": 40}).scene
    assert name_of(many.model.boxes, 2) == "#3" and len(many.model.boxes.ids) == 40


@pytest.mark.parametrize("scene_type", SCENES[:3], ids=level_id)
def test_boxes_without_end_and_large_scenes_can_be_looked_into(scene_type, monkeypatch):
    prepare()
    for level in ("hard-04-larger-than-the-grid", "hard-02-beyond-all-levels", "hard-09-floor-without-end"):
        try:
            stage = open_level(scene_type, level)
        except StopIteration:
            continue
        for box in stage.scene.model.boxes.ids.tolist():
            stage.scene.model.chosen = box
            told = written(stage, monkeypatch, (320, 180))
            assert any(name_of(stage.scene.model.boxes, box) in words for words, _ in told)
    stage = Stage(scene_type, parameters={"count": 2000})
    stage.scene.model.chosen = 1999
    stage.run(1)
    assert any("#2000" in words for words, _ in written(stage, monkeypatch, (320, 180)))
