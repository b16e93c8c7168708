"""Liquids of particles as a person meets them: levels, the tap, the hand, heat, laws, pictures."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.app.stagehand.headless import picture_of_stage
from game.levels import LevelError, level_files, load_level
from game.physics.particle_fluids import LAWS, SEARCHES
from game.scenes.honey.level import HoneyContent
from game.scenes.honey.scene import Honey
from game.scenes.honey.view import part_in_box
from game.stage import Action, SetEffect, SetParameter, Stage
from game.worlds.expectations import captions_of
from tests.scenes.by_hand import drag, measured

LEVELS = level_files("honey")
HARD = [path for path in LEVELS if path.stem.startswith("hard-")]


def opened(name: str = "default", **parameters) -> Stage:
    path = next(path for path in LEVELS if path.stem == name)
    return Stage(Honey, level=load_level(path, "honey", HoneyContent), parameters=parameters)


def written(text: str, folder, **parameters) -> Stage:
    """A stage of a level's [content]."""
    path = folder / "a.toml"
    path.write_text(f'scene = "honey"\ntitle = "a"\n[content]\n{text}\n')
    return Stage(Honey, level=load_level(path, "honey", HoneyContent), parameters=parameters)


@pytest.mark.parametrize("path", HARD, ids=lambda path: path.stem)
def test_a_hard_level_comes_to_what_it_expects(path):
    stage = opened(path.stem)
    stage.run(300)
    expected = stage.scene.model.content.expected
    captions = captions_of(expected, stage.readouts())
    assert expected and all(caption.met for caption in captions), captions


@pytest.mark.parametrize("path", LEVELS, ids=lambda path: path.stem)
def test_every_level_goes_on_and_misses_no_particle(path):
    stage = opened(path.stem)
    stage.run(60)
    fluid = stage.scene.model.fluid
    assert measured(stage, "particles missing") == 0.0
    assert np.isfinite(fluid.place).all() and np.isfinite(fluid.velocity).all()
    if path.stem != "hard-03-one-spot":  # six in each place have far to go
        assert measured(stage, "mean error") < 0.12


@pytest.mark.parametrize("speed", [0.5, 1.7, 6.0])
def test_a_tap_lets_out_what_its_speed_asks_for_without_gaps(speed, tmp_path):
    stage = written(f"taps = [{{ at = [0.0, 1.5], width = 0.1, speed = {speed}, most = 2000 }}]", tmp_path)
    stage.post(SetEffect("gravity", False))
    stage.run(round(24 / min(speed, 1.0) ** 0.5))
    fluid, time = stage.scene.model.fluid, stage.scene.model.time
    rows = measured(stage, "particles") / 4.0
    assert rows == pytest.approx(speed * time / fluid.spacing, abs=1.0)
    middle = fluid.place[np.abs(fluid.place[:, 0]) < 0.6 * fluid.spacing]
    heights = np.sort(np.unique(np.round(middle[middle[:, 1] > 0.3, 1], 6)))
    assert len(heights) > 4
    assert np.diff(heights) == pytest.approx(fluid.spacing, rel=0.1)


def test_each_tap_runs_until_it_has_let_out_its_own_share(tmp_path):
    taps = ", ".join(f"{{ at = [{x}, 1.5], width = 0.1, speed = 2.0, most = {most} }}" for x, most in
                     ((-0.5, 20), (0.5, 60)))  # fmt: skip
    stage = written(f"taps = [{taps}]", tmp_path)
    stage.run(90)
    assert stage.scene.model.run.tolist() == [20.0, 60.0]
    assert measured(stage, "particles") == 80


def test_the_hand_pours_stirs_and_scoops():
    stage = opened("hard-01-rest")
    before = measured(stage, "particles")
    drag(stage, (0.0, 1.2), (0.0, 1.2), button=3, steps=40)
    poured = measured(stage, "particles") - before
    assert 0.6 * 8 / 0.04 * 81 / 120 < poured <= 8 / 0.04 * 83 / 120 + 8
    stage.run(20)
    assert measured(stage, "particles") == before + poured, "the button is up"
    stage.post(Action("tool-stir"))
    drag(stage, (-0.3, 0.4), (-0.25, 0.4), (-0.2, 0.4), steps=1)
    assert measured(stage, "fastest") > 0.3
    stage.post(Action("tool-scoop"))
    drag(stage, (0.0, 0.3), (0.0, 0.3), steps=2)
    gone = before + poured - measured(stage, "particles")
    assert gone >= 0.7 * math.pi * 4.0**2
    assert measured(stage, "particles missing") == 0.0


def test_honey_stands_higher_than_water_and_stays():
    stages = [opened(thickness=thickness) for thickness in (1.0, 0.01)]
    for stage in stages:
        stage.run(150)
    thick, thin = (measured(stage, "mean height") for stage in stages)
    assert thick > 1.2 * thin


@pytest.mark.parametrize("law", LAWS)
def test_a_pool_at_rest_stays_by_every_law(law):
    stage = opened("hard-01-rest", law=law, softness=20.0)
    stage.run(90)
    assert measured(stage, "mean height") == pytest.approx(0.4, abs=0.03)
    assert measured(stage, "particles missing") == 0.0


@pytest.mark.parametrize("search", SEARCHES)
def test_every_search_finds_the_same_fluid(search):
    stage, other = opened("drops", search=search), opened("drops")
    for one in (stage, other):
        one.run(20)
    assert measured(stage, "mean height") == pytest.approx(measured(other, "mean height"), rel=1e-6)


def test_light_liquid_rises_and_the_heavy_one_sinks():
    stage = opened("two-liquids")
    first = measured(stage, "first's height")
    stage.run(240)
    assert measured(stage, "first's height") > first + 0.15


def test_warm_wax_rises_and_heat_can_be_left_out():
    stages = [opened("lava-lamp"), opened("lava-lamp")]
    stages[1].post(SetEffect("liquid-heat", False))
    tops = []
    for stage in stages:
        stage.run(600)
        fluid = stage.scene.model.fluid
        tops.append(float(np.max(fluid.place[fluid.kind == 1, 1])))
    assert tops[0] > tops[1] + 0.15
    assert measured(stages[0], "warmest") > 320.0 > measured(stages[1], "warmest")


def test_a_pot_boils_only_where_it_is_heated():
    stage, cold = opened("boiling"), opened("boiling")
    cold.post(SetEffect("liquid-heat", False))
    for one in (stage, cold):
        one.run(150)
    assert measured(stage, "vapour") > 0.02 and measured(cold, "vapour") == 0.0


def test_slime_is_held_by_springs_until_they_are_left_out():
    stages = [opened("slime"), opened("slime")]
    stages[1].post(SetEffect("liquid-springs", False))
    for one in stages:
        one.run(80)
    assert measured(stages[0], "springs") > 500 and measured(stages[1], "springs") == 0
    assert measured(stages[0], "mean height") > measured(stages[1], "mean height") + 0.01


def test_air_is_made_where_a_wave_closes_and_no_more_without_the_effect():
    stages = [opened("trapped-air"), opened("trapped-air")]
    stages[1].post(SetEffect("trapped-air", False))
    for one in stages:
        one.run(120)
    assert measured(stages[0], "air made") > 0 == measured(stages[1], "air made")


def test_a_state_goes_on_as_it_would_have():
    stages = [opened(), opened()]
    stages[0].run(30)
    stages[1].run(20)
    stages[1].readouts()
    stages[1].run(10)
    assert stages[0].digest() == stages[1].digest()


@pytest.mark.parametrize("theme", ["dark", "light"])
def test_a_body_and_its_particles_are_seen(theme):
    stage = opened("hard-01-rest")
    stage.run(2)
    body = picture_of_stage(stage, (320, 180), theme).copy()
    stage.post(SetParameter("dots", True))
    stage.run(1)
    dots = picture_of_stage(stage, (320, 180), theme)
    inside = [(x, y) for x in range(120, 200, 4) for y in range(110, 150, 4)]
    blue = [tuple(body.get_at(at))[:3] for at in inside]
    assert all(b > r + 40 for r, g, b in blue), "a whole body without holes"
    assert len({tuple(dots.get_at(at)) for at in inside}) > len(set(blue))


@pytest.mark.parametrize("colours", ["temperature", "density", "speed", "order"])
def test_what_is_measured_is_shown_as_colours(colours):
    stage = opened("boiling")
    stage.run(40)
    plain = picture_of_stage(stage, (320, 180)).copy()
    stage.post(SetParameter("colours", colours))
    stage.run(1)
    shown = picture_of_stage(stage, (320, 180))
    assert stage.scene.legend()
    changed = sum(plain.get_at((x, 130)) != shown.get_at((x, 130)) for x in range(90, 230))
    assert changed > 60


def test_a_heater_is_drawn_within_its_vessel_only():
    lamp = np.array(((-0.5, 0.0), (0.5, 0.0), (0.25, 1.0), (-0.25, 1.0)))
    part = part_in_box(lamp, (-0.6, 0.8), (0.6, 2.0))
    assert np.max(part[:, 0]) == pytest.approx(0.3) and np.min(part[:, 0]) == pytest.approx(-0.3)
    assert np.min(part[:, 1]) == pytest.approx(0.8) and np.max(part[:, 1]) == pytest.approx(1.0)
    x, y = part.T
    area = 0.5 * abs(float(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))))
    assert area == pytest.approx(0.2 * (0.6 + 0.5) / 2.0)
    assert len(part_in_box(lamp, (2.0, 0.0), (3.0, 1.0))) == 0


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("spacing = 0.0", "spacing"), ("liquids = []", "liquids"),
        ("liquids = [{ density = nan }]", "density"),
        ("pools = [{ left = 0.0, bottom = inf, right = 1.0, top = 1.0 }]", "bottom"),
        ("taps = [{ at = [0.0, 1.0], speed = -1.0 }]", "speed"), ("heater = 3", "heater"),
        ("heaters = [{ left = 0.0, bottom = 0.0, right = 1.0, top = 1.0, heat = -3.0 }]", "heat"),
    ],
)  # fmt: skip
def test_a_level_that_makes_no_sense_is_one_line(text, said, tmp_path):
    path = tmp_path / "a.toml"
    path.write_text(f'scene = "honey"\ntitle = "a"\n[content]\n{text}\n')
    with pytest.raises(LevelError) as caught:
        load_level(path, "honey", HoneyContent)
    assert said in str(caught.value) and "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("pools = [{ left = 0.0, bottom = 0.0, right = 0.5, top = 0.5, kind = 3 }]", "kind 3"),
        ("taps = [{ at = [0.0, 1.0], kind = 2 }]", "taps"), ("liquids = [{ vapour = 4 }]", "vapour"),
        ("spacing = 0.002\npools = [{ left = -1.0, bottom = 0.0, right = 1.0, top = 1.0 }]", "particles"),
    ],
)  # fmt: skip
def test_what_does_not_fit_together_is_said(text, said, tmp_path):
    with pytest.raises((LevelError, ValueError), match=said):
        written(text, tmp_path)
