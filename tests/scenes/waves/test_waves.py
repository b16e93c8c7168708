"""Water in a channel as a person meets it: levels are as they expect, the hand pours, pushes, builds."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.app.stagehand.headless import picture_of_stage
from game.levels import LevelError, level_files, load_level
from game.scenes.waves.level import WavesContent
from game.scenes.waves.scene import Waves
from game.stage import Action, Pointer, SetEffect, SetParameter, Stage
from game.worlds.expectations import captions_of
from tests.scenes.by_hand import drag, measured

LEVELS = level_files("waves")
HARD = [path for path in LEVELS if path.stem.startswith("hard-")]


def opened(name: str = "default", **parameters) -> Stage:
    path = next(path for path in LEVELS if path.stem == name)
    return Stage(Waves, level=load_level(path, "waves", WavesContent), parameters=parameters)


@pytest.mark.parametrize("path", HARD, ids=lambda path: path.stem)
def test_a_hard_level_comes_to_what_it_expects(path):
    stage = opened(path.stem)
    for _ in range(4):
        stage.run(240)
        expected = stage.scene.model.content.expected
        assert expected and all(caption.met for caption in captions_of(expected, stage.readouts()))


def test_a_dam_runs_beside_the_exact_one_until_it_meets_an_end():
    stage = opened()
    stage.run(240)
    assert measured(stage, "front") == pytest.approx(measured(stage, "exact front"), abs=0.2)
    assert measured(stage, "depth error") < 1e-3
    assert stage.scene.legend()
    stage.run(240)
    assert math.isnan(measured(stage, "depth error")) and not stage.scene.legend()


def test_constant_cells_are_farther_off():
    errors = []
    for method in ("constant", "linear"):
        stage = opened(method=method)
        stage.run(240)
        errors.append(measured(stage, "depth error"))
    assert errors[0] > 4.0 * errors[1]


def test_the_bowl_is_where_it_should_be_after_a_swing():
    stage = opened("bowl")
    stage.run(round(math.tau / stage.scene.model.theory.rate / stage.dt))
    assert measured(stage, "depth error") < 2e-3


def test_a_hump_comes_apart_where_waves_of_any_length_are_drawn():
    """Long waves hold together in both; the line's crest falls behind the bore of shallow water."""
    stage = opened("dispersion")
    assert measured(stage, "beside Airy") < 1e-9
    stage.run(480)
    model = stage.scene.model
    airy = model.expected()
    assert stage.scene.legend()[0][1].startswith("waves")
    assert 1e-4 < measured(stage, "beside Airy") < 0.02
    assert airy.mean() == pytest.approx(model.water.depth.mean(), rel=1e-12)
    assert np.sum(np.diff(np.sign(np.diff(airy))) < 0) > 3  # a train of crests
    stage.post(Pointer("down", 0.0, 6.0, 1))
    stage.run(2)
    assert math.isnan(measured(stage, "beside Airy"))


def test_the_hand_pours_as_much_as_it_says_and_takes_the_theory_away():
    stage = opened("islands")
    before = measured(stage, "volume")
    stage.post(Pointer("down", 0.0, 6.0, 1))
    stage.run(120)
    stage.post(Pointer("up", 0.0, 6.0, 1))
    stage.run(1)
    poured = measured(stage, "volume") - before
    assert poured == pytest.approx(120 * stage.dt * 1.0, rel=1e-9)
    assert measured(stage, "volume lost") < 1e-12
    stage.run(120)
    assert measured(stage, "volume") - before == pytest.approx(poured, rel=1e-9)
    dam = opened()
    drag(dam, (0.0, 5.0), (1.0, 5.0))
    assert math.isnan(measured(dam, "depth error"))


def test_water_that_vanishes_is_noticed():
    """What is lost is measured against what came through the ends, as rain and from the hand."""
    stage = opened("beach", rain=1000.0)
    stage.run(240)
    assert abs(measured(stage, "let in")) > 0.01 and measured(stage, "volume lost") < 1e-13
    stage.scene.model.water.depth[0, 100] -= 0.01
    stage.run(1)
    assert measured(stage, "volume lost") * measured(stage, "volume") == pytest.approx(0.01 * 0.05, rel=0.01)


def test_what_was_disturbed_once_has_no_theory_any_more():
    for name, value in (("gravity", 1.62), ("rain", 1000.0), ("roughness", 0.02)):
        stage = opened()
        before = stage.scene.values[name]
        stage.run(10)
        stage.post(SetParameter(name, value))
        stage.run(2)
        stage.post(SetParameter(name, before))
        stage.run(2)
        assert stage.scene.model.expected() is None and not stage.scene.legend()
    stage = opened()
    stage.post(SetParameter("courant", 0.9))
    stage.post(SetEffect("bed-friction", False))
    stage.run(2)
    assert stage.scene.model.expected() is not None


def test_on_the_moon_a_dam_has_the_theory_of_the_moon():
    stage = opened(gravity=1.62)
    stage.run(480)
    assert measured(stage, "front") == pytest.approx(measured(stage, "exact front"), abs=0.2)
    assert measured(stage, "depth error") < 1e-3


def test_the_hand_pushes():
    stage = opened("islands")
    stage.post(SetParameter("tool", "push"))
    drag(stage, (2.0, 2.0), (2.1, 2.0), (2.2, 2.0), (2.3, 2.0))
    assert measured(stage, "fastest") > 0.3
    assert measured(stage, "volume lost") < 1e-12


def test_the_hand_draws_the_bed_and_the_water_goes_up_with_it():
    stage = opened("islands")
    stretch = stage.scene.model.content.stretch
    x = stage.scene.model.x
    depth = stage.scene.model.water.depth[0].copy()
    stage.post(Action("tool-bed"))
    drag(stage, (2.0, 0.6 * stretch), (4.0, 0.6 * stretch))
    bed = stage.scene.model.water.bed[0]
    assert bed[(x > 2.1) & (x < 3.9)] == pytest.approx(0.6)
    assert bed[(x > 5.0) | (x < 1.0)] == pytest.approx(
        np.interp(x, *zip(*stage.scene.model.content.bed, strict=True))[(x > 5.0) | (x < 1.0)]
    )
    stage.run(60)
    assert measured(stage, "fastest") > 0.05 and measured(stage, "volume lost") < 1e-12
    assert np.max(np.abs(stage.scene.model.water.depth[0] - depth)) > 0.05


def test_a_swell_is_as_high_as_it_says():
    stage = opened("beach", swell=0.02)
    levels = []
    for _ in range(36):
        stage.run(20)
        levels.append(measured(stage, "level in the middle"))
    assert max(levels[20:]) - min(levels[20:]) < 0.04
    surface = stage.scene.model.water.depth[0, :300] - 1.5
    assert np.ptp(surface) == pytest.approx(0.02, rel=0.1)


def test_a_swell_comes_in_and_is_shut_out_again():
    stage = opened("beach")
    stage.run(600)
    assert measured(stage, "deepest") > 1.55
    stage.post(SetParameter("swell", 0.0))
    stage.run(1)
    assert stage.scene.model.water.values[0] == 0.0
    stage.run(120)
    assert measured(stage, "volume lost") < 1e-12


def test_the_bed_rubs_and_rain_falls_only_while_they_are_on():
    rough = opened("default", roughness=0.05)
    rough.run(120)
    smooth = opened("default", roughness=0.05)
    smooth.post(SetEffect("bed-friction", False))
    smooth.run(120)
    assert measured(rough, "front") < measured(smooth, "front") - 0.5
    wet = opened("default", rain=3600.0)
    wet.run(120)
    assert measured(wet, "volume") == pytest.approx(20.0 + 120 * wet.dt * 1e-3 * 40.0, rel=1e-9)
    wet.post(SetEffect("rain", False))
    wet.run(60)
    assert measured(wet, "volume") == pytest.approx(20.0 + 120 * wet.dt * 1e-3 * 40.0, rel=1e-9)


def test_without_gravity_nothing_moves_and_nothing_is_divided_by_nothing():
    stage = opened()
    stage.post(SetEffect("gravity", False))
    stage.run(60)
    assert measured(stage, "fastest") == 0.0 and measured(stage, "Froude number") == 0.0


@pytest.mark.parametrize("theme", ["dark", "light"])
@pytest.mark.parametrize("path", LEVELS, ids=lambda path: path.stem)
def test_the_water_is_seen(path, theme):
    """Blue below the surface, sand below the bed, in the middle of the picture's columns."""
    stage = opened(path.stem)
    stage.run(2)
    picture = picture_of_stage(stage, (640, 360), theme)
    colors = [tuple(picture.get_at((x, y)))[:3] for x in range(20, 620, 10) for y in range(0, 360, 4)]
    assert (
        sum(b > r + 25 and b > 40 and g > 0.5 * b for r, g, b in colors) > 40 or path.stem == "hard-05-rain"
    )
    assert sum(r > b + 25 for r, g, b in colors) > 40


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("dam = { left = -1.0 }", "dam"),
        ("water = [{ level = nan }]", "level"),
        ("ends = ['sea', 'wall']", "ends"),
        ("bed = [[0.0, inf]]", "bed"),
    ],
)
def test_nonsense_is_refused_in_a_line(tmp_path, content, words):
    file = tmp_path / "bad.toml"
    file.write_text(f'scene = "waves"\ntitle = "Bad"\n\n[content]\n{content}\n')
    with pytest.raises(LevelError, match=words) as caught:
        load_level(file, "waves", WavesContent)
    assert "\n" not in str(caught.value)
