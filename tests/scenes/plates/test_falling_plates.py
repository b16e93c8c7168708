"""Falling plates as a person meets them: levels come to what they expect, regimes, hand and actions."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.app.stagehand.headless import picture_of_stage, prepare
from game.levels import level_files, load_level
from game.physics.plates.regimes import THICKEST
from game.physics.plates.watch import CHAOS, FLUTTER, GLIDE, TUMBLE
from game.scenes.plates.model import CEILING, FLOOR, LEFT, RIGHT
from game.scenes.plates.scene import FallingPlates
from game.scenes.plates.view import BANDS, MAP_HIGH, MAP_LOW, TOP
from game.stage import Action, ParameterError, Pointer, SetParameter, Stage
from game.worlds.expectations import captions_of
from tests.scenes.labels import labels_of

LEVELS = {path.stem: path for path in level_files("falling-plates")}
HARD = [name for name in LEVELS if name.startswith("hard-")]


def opened(name: str) -> Stage:
    return Stage(FallingPlates, level=load_level(LEVELS[name], "falling-plates", FallingPlates.content_type))


def measured(stage: Stage) -> dict[str, float]:
    return {readout.name: readout.value for readout in stage.readouts()}


def click(stage: Stage, at: tuple[float, float], button: int = 1) -> None:
    stage.post(Pointer("down", *at, button=button))
    stage.post(Pointer("up", *at, button=button))


@pytest.mark.parametrize("name", HARD)
def test_a_hard_level_comes_to_what_it_expects(name):
    stage = opened(name)
    scene = stage.scene
    assert scene.content_type and scene.model.content.expected
    stage.run(math.ceil(6.0 / stage.dt))
    captions = captions_of(scene.model.content.expected, stage.readouts())
    assert all(caption.met for caption in captions), captions


def test_the_row_of_eight_does_what_the_map_says_and_meets_the_references():
    stage = opened("default")
    stage.run(round(9.0 / stage.dt))
    model = stage.scene.model
    regimes = [model.course(i).regime for i in range(8)]
    assert regimes[:2] == [FLUTTER, FLUTTER] and regimes[3:5] == [TUMBLE, TUMBLE]
    assert regimes[5] == CHAOS and regimes[7] == FLUTTER
    seen = measured(stage)
    assert seen["descent"] == pytest.approx(seen["descent, reference"], rel=2e-3)
    assert seen["period"] == pytest.approx(seen["period, reference"], rel=1e-3)
    for _ in range(4):
        stage.post(Action("next"))
    stage.run(round(6.0 / stage.dt))
    seen = measured(stage)
    assert seen["inertia"] == pytest.approx(1.4)
    assert seen["spin"] == pytest.approx(seen["spin, reference"], rel=5e-3)
    assert seen["descent"] == pytest.approx(seen["descent, reference"], rel=5e-3)


def test_gliders_glide_and_twins_part():
    stage = opened("gliders")
    stage.run(round(8.0 / stage.dt))
    assert [stage.scene.model.course(i).regime for i in range(3)] == [GLIDE] * 3
    stage = opened("twins")
    stage.run(60)
    spread = np.ptp(stage.scene.model.plates.positions[:, 0])
    stage.run(round(8.0 / stage.dt))
    assert spread < 1e-6 and np.ptp(stage.scene.model.plates.positions[:, 0]) > 0.05


def test_leaves_lie_in_their_tray():
    stage = opened("litter")
    stage.run(round(8.0 / stage.dt))
    places = stage.scene.model.plates.positions
    assert np.count_nonzero(np.abs(places[:, 0]) < 0.4) >= 20
    assert np.all(places[:, 1] > FLOOR - 2e-3)


def test_gusts_take_leaves_off_the_ground():
    stage = opened("gusts")
    stage.run(round(0.9 / stage.dt))
    before = stage.scene.model.plates.positions
    assert np.max(before[:, 1]) < FLOOR + 0.03
    highest = 0.0
    for _ in range(70):
        stage.run(20)
        highest = max(highest, float(np.max(stage.scene.model.plates.positions[:, 1])) - FLOOR)
    assert highest > 0.15
    assert np.mean(stage.scene.model.plates.positions[:, 0] - before[:, 0]) > 0.2


def test_click_drops_drag_throws_and_the_other_button_takes_away():
    stage = Stage(FallingPlates)
    stage.post(Action("clear"))
    click(stage, (0.3, 0.2))
    model = stage.scene.model
    assert len(model.plates) == 1 and model.plates.positions[0] == pytest.approx((0.3, 0.2))
    stage.post(Pointer("down", -0.4, 0.0, button=1))
    stage.post(Pointer("move", -0.2, 0.1, button=1))
    stage.post(Pointer("up", -0.2, 0.1, button=1))
    assert model.plates.velocities[1] == pytest.approx((0.8, 0.4))
    click(stage, (0.3, 0.2))  # chooses, and drops none
    assert len(model.plates) == 2 and model.chosen == 0
    click(stage, (0.3, 0.2), button=3)
    assert len(model.plates) == 1
    stage.post(Action("row"))
    assert len(model.plates) == 8


def test_parameters_change_the_chosen_plate_and_nonsense_is_refused():
    stage = Stage(FallingPlates)
    stage.post(SetParameter("inertia", 2.5))
    assert stage.scene.model.numbers_of(0)[0] == pytest.approx(2.5)
    assert stage.scene.model.numbers_of(1)[0] == pytest.approx(0.8)
    with pytest.raises((ParameterError, ValueError), match="drag"):
        stage.post(SetParameter("drag_turn", 3.0))
    with pytest.raises((ParameterError, ValueError), match="inertia"):
        stage.post(SetParameter("inertia", 0.01))


def test_what_falls_out_of_the_tank_is_drawn_in_it():
    stage = opened("default")
    stage.run(round(5.0 / stage.dt))
    model = stage.scene.model
    assert np.min(model.plates.positions[:, 1]) < FLOOR
    shown = model.shown(model.plates.positions)
    assert np.all((shown > (LEFT, FLOOR)) & (shown < (RIGHT, CEILING)))


def test_a_step_back_and_on_again_is_equal():
    stage = opened("litter")
    stage.run(500)
    here = stage.digest()
    stage.run(30)
    there = stage.digest()
    for _ in range(30):
        stage.step_back()
    assert stage.digest() == here
    stage.run(30)
    assert stage.digest() == there


def test_the_picture_is_drawn_in_both_themes():
    prepare()
    stage = opened("gusts")
    stage.run(400)
    pictures = {
        np.asarray(picture_of_stage(stage, (480, 270), theme).get_buffer()).tobytes()
        for theme in ("light", "dark")
    }
    assert len(pictures) == 2


def test_the_map_has_borders_only_where_they_hold():
    stage = opened("default")
    drawn, tops = labels_of(stage), []
    drawn.polygon = lambda points, *_, **options: tops.append(float(np.asarray(points)[:, 1].max()))
    stage.scene.view.draw(drawn, None, 1.0)
    assert tops[-len(BANDS) :] == pytest.approx(
        [MAP_LOW + (MAP_HIGH - MAP_LOW) * THICKEST / TOP] * len(BANDS)
    )
    assert f"borders as measured up to β = {THICKEST:g}" in drawn.drawn
