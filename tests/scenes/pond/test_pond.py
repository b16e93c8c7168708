"""A pond of wave particles as a person meets it: levels, stones, the boat, floats, theory that is drawn."""

from __future__ import annotations

import math

import pytest

from game.app.stagehand.headless import picture_of_stage
from game.levels import LevelError, level_files, load_level
from game.physics.waves.floats import FX, FY
from game.scenes.pond.level import MOST_FLOATS, PondContent
from game.scenes.pond.scene import Pond
from game.stage import Action, Pointer, SetEffect, SetParameter, Stage
from game.stage.states.state import copy_state, digest_of
from game.worlds.expectations import captions_of
from tests.scenes.by_hand import drag, measured

LEVELS = level_files("p15")
HARD = [path for path in LEVELS if path.stem.startswith("hard-")]


def opened(name: str = "default", **parameters) -> Stage:
    path = next(path for path in LEVELS if path.stem == name)
    return Stage(Pond, level=load_level(path, "p15", PondContent), parameters=parameters)


@pytest.mark.parametrize("path", HARD, ids=lambda path: path.stem)
def test_a_hard_level_comes_to_what_it_expects(path):
    stage = opened(path.stem)
    for _ in range(3):
        stage.run(90)
        expected = stage.scene.model.content.expected
        assert expected and all(caption.met for caption in captions_of(expected, stage.readouts()))


@pytest.mark.parametrize("name", ["ring", "as-printed"])
def test_a_ring_is_where_and_as_high_as_theory_has_it(name):
    stage = opened(name)
    for _ in range(4):
        stage.run(40)
        assert measured(stage, "ring") == pytest.approx(measured(stage, "ring by law"), abs=0.06)
        assert measured(stage, "crest") == pytest.approx(measured(stage, "crest by law"), rel=0.12)
    assert stage.scene.legend()
    stage.run(200)
    assert math.isnan(measured(stage, "ring")), "it has met the bank"


def test_the_wedge_is_machs_until_a_hand_takes_the_boat():
    stage = opened("wedge")
    stage.run(360)
    assert measured(stage, "wedge by law") == pytest.approx(30.0, abs=0.1)
    assert measured(stage, "wedge") == pytest.approx(measured(stage, "wedge by law"), abs=1.0)
    assert stage.scene.legend()
    stage.post(Action("tool-boat"))
    drag(stage, (10.0, 3.0), (11.0, 3.0), steps=2)
    assert math.isnan(measured(stage, "wedge")) and not stage.scene.legend()


def test_stones_are_dropped_by_click_and_in_a_row():
    stage = opened("hard-01-at-rest")
    stage.post(Pointer("down", 4.0, 4.0, 1))
    stage.post(Pointer("up", 4.0, 4.0, 1))
    stage.run(2)
    first = measured(stage, "put")
    assert first > 30
    drag(stage, (6.0, 2.0), (6.6, 2.0), (6.7, 2.0), (7.4, 2.0), steps=2)
    assert measured(stage, "put") >= 4 * first
    drag(stage, (9.0, 5.0), (9.0, 5.0), button=3, steps=2)
    assert measured(stage, "put") >= 5 * first


def test_the_boat_comes_after_the_hand_and_lies_still_after_it():
    stage = opened()
    stage.post(Action("tool-boat"))
    drag(stage, (6.0, 4.5), (8.0, 4.5), steps=40)
    pose = stage.scene.model.boat.pose
    assert pose[0] > 5.0 and pose[4] > 0.9
    stage.run(30)
    at = pose[0]
    stage.run(30)
    assert pose[0] == at and measured(stage, "boat speed") == 0.0


def test_a_pond_without_a_boat_gets_one_where_it_is_wanted():
    stage = opened("ring")
    assert math.isnan(measured(stage, "boat speed"))
    stage.post(Action("tool-boat"))
    drag(stage, (6.0, 4.5), (6.5, 4.5), steps=2)
    assert stage.scene.model.boat.pose[0] == pytest.approx(6.0, abs=0.3)


def test_floats_are_put_pulled_and_no_more_than_there_is_place_for():
    stage = opened("ring")
    stage.post(Action("tool-float"))
    drag(stage, (4.0, 4.0), (4.0, 4.0), steps=2)
    assert measured(stage, "floats") == 1
    drag(stage, (4.0, 4.0), (4.5, 4.0), (5.0, 4.0), steps=10)
    rows = stage.scene.model.floats.rows
    assert rows[0, FX] > 4.4 and abs(rows[0, FY] - 4.0) < 0.2 and measured(stage, "floats") == 1
    model = stage.scene.model
    while len(model.floats) < MOST_FLOATS:
        model.floats.add((1.0, 1.0), 0.05, 0.05, 0.5)
    assert "already" in model.put_float((8.0, 2.0)) and len(model.floats) == MOST_FLOATS


def test_rain_falls_as_often_as_it_should_and_alike_each_time():
    counts = []
    for _ in range(2):
        stage = opened("hard-01-at-rest", rain=12.0)
        stage.run(120)
        assert measured(stage, "rain drops") in (23, 24)
        counts.append(stage.session.digest() if hasattr(stage, "session") else measured(stage, "wave energy"))
    assert counts[0] == counts[1]


@pytest.mark.parametrize("effect", ["splitting", "wave-fading", "floats", "boat", "gravity"])
def test_an_effect_that_is_off_does_nothing(effect):
    on, off = opened("three-hundred", rain=0.0), opened("three-hundred", rain=0.0)
    off.post(SetEffect(effect, False))
    on.run(60)
    off.run(60)
    if effect == "splitting":
        assert measured(off, "divided") == 0 < measured(on, "divided")
    elif effect == "boat":
        assert measured(off, "boat speed") == 0.0 < measured(on, "boat speed")
    elif effect == "gravity":
        assert measured(off, "wave speed") == 0.0
    elif effect == "floats":
        assert measured(off, "drift") == 0.0 < measured(on, "drift")
    else:
        assert measured(off, "wave energy") > measured(on, "wave energy")


def test_floats_give_the_water_no_more_than_they_took():
    stages = [opened("three-hundred", rain=0.0), opened("three-hundred", rain=0.0)]
    stages[1].post(SetEffect("floats", False))
    for stage in stages:
        stage.post(SetEffect("boat", False))
        stage.run(1)
        stage.scene.model.water.drop((8.0, 4.5), 0.1, 1)
    for _ in range(5):
        for stage in stages:
            stage.run(60)
        assert measured(stages[0], "wave energy") < 1.02 * measured(stages[1], "wave energy")
    assert measured(stages[0], "drift") > 0.0


def test_what_is_saved_opens_again_with_floats_and_boat_where_they_were():
    stage = opened()
    stage.post(Action("tool-boat"))
    drag(stage, (6.0, 4.5), (8.0, 4.5), steps=20)
    content = stage.scene.save_content()
    assert len(content.floats) == 5 and content.boat.x == pytest.approx(stage.scene.model.boat.pose[0])
    assert content.floats[0].x == pytest.approx(stage.scene.model.floats.rows[0, FX])


def test_a_picture_shows_water_particles_and_law():
    stage = opened("wedge")
    stage.run(240)
    plain = picture_of_stage(stage, (320, 180)).copy()
    stage.post(SetParameter("dots", True))
    stage.run(1)
    dotted = picture_of_stage(stage, (320, 180))
    stage.post(SetParameter("law", False))
    colors = {tuple(plain.get_at((x, y)))[:3] for x in range(40, 280, 5) for y in range(30, 150, 5)}
    assert len(colors) > 60
    assert any(plain.get_at((x, 90)) != dotted.get_at((x, 90)) for x in range(320))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("width = 0.1", "width"), ("drops = [{ x = 1.0, y = nan }]", "y"), ("strewn = 4000", "strewn"),
        ("floats = [{ x = 1.0, y = 1.0, density = 0.0 }]", "density"), ("boats = 3", "boats"),
    ],
)  # fmt: skip
def test_a_level_that_makes_no_sense_is_one_line(text, said, tmp_path):
    path = tmp_path / "a.toml"
    path.write_text(f'scene = "p15"\ntitle = "a"\n[content]\n{text}\n')
    with pytest.raises(LevelError) as caught:
        load_level(path, "p15", PondContent)
    assert said in str(caught.value) and "\n" not in str(caught.value)


def test_stepping_back_takes_boat_and_theory_back():
    stage = opened("ring")
    stage.run(20)
    stage.post(Action("tool-boat"))
    drag(stage, (6.0, 4.5), (6.5, 4.5), steps=2)
    model = stage.scene.model
    assert model.has_boat and model.touched
    for _ in range(8):
        stage.step_back()
    assert not model.has_boat and not model.touched
    assert math.isfinite(measured(stage, "ring"))


def test_a_state_goes_on_alike_after_a_stone_that_was_not_stepped_yet():
    """Floats take the heights of the particles there are, whoever put them there and when."""
    stages = [opened("three-hundred", rain=0.0) for _ in range(2)]
    for stage in stages:
        stage.run(10)
        stage.scene.model.drop((8.0, 4.5))
    stages[1].scene.restore(copy_state(stages[0].scene.state()))
    for stage in stages:
        stage.scene.advance(stage.dt)
    assert digest_of(stages[0].scene.state(), 0) == digest_of(stages[1].scene.state(), 0)
