"""The playground of floating bodies: levels are as they expect, and the hand draws, sets down and loads."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.levels import level_files, load_level
from game.physics.hydrostatics import exact
from game.scenes.floating.level import FloatingContent
from game.scenes.floating.scene import Floating
from game.stage import Action, Pointer, SetParameter, Stage
from game.worlds.expectations import captions_of
from tests.scenes.by_hand import drag, measured

LEVELS = level_files("floating")
HARD = [path for path in LEVELS if path.stem.startswith("hard-")]


def opened(name: str = "default", **parameters) -> Stage:
    path = next(path for path in LEVELS if path.stem == name)
    return Stage(Floating, level=load_level(path, "floating", FloatingContent), parameters=parameters)


@pytest.mark.parametrize("path", HARD, ids=lambda path: path.stem)
def test_a_hard_level_comes_to_what_it_expects(path):
    stage = Stage(Floating, level=load_level(path, "floating", FloatingContent))
    for _ in range(2):
        stage.run(60)
        expected = stage.scene.model.content.expected
        captions = captions_of(expected, stage.readouts())
        assert expected and all(caption.met for caption in captions), captions


def test_both_ways_a_hull_rights_itself_and_displaces_its_mass():
    stage = opened(tilt=20.0)
    stage.run(240)
    found = []
    for _ in range(6):
        stage.run(20)
        found.append([measured(stage, name) for name in ("angle", "angle, liquid", "displaced, liquid")])
    law, liquid, displaced = np.mean(found, axis=0)
    assert abs(law) < 2.0 and abs(liquid) < 6.0
    assert measured(stage, "displaced") == pytest.approx(measured(stage, "at rest"), rel=0.05)
    assert displaced == pytest.approx(measured(stage, "at rest"), rel=0.08)


def test_the_level_answers_in_both_tanks():
    stage = opened("hard-04-slam", both=True)
    stage.run(1)
    assert measured(stage, "level") == pytest.approx(0.52, abs=1e-6)
    stage.run(60)
    area = measured(stage, "displaced")
    assert measured(stage, "level") == pytest.approx(0.52 + area / 1.7, abs=0.003)
    assert measured(stage, "level, liquid") == pytest.approx(
        0.52 + measured(stage, "displaced, liquid") / 1.7, abs=0.012
    )


def test_a_roll_is_as_long_as_reckoned_and_longer_with_water_that_moves_along():
    free = opened("log", shape="beam", weight=0.5, tilt=4.0, both=False, added="none", waves=0.0, drag=0.0)
    free.run(240)
    assert measured(free, "roll period") == pytest.approx(exact.roll_period(0.6, 0.24, 0.5), rel=0.02)
    wet = opened("log", shape="beam", weight=0.5, tilt=4.0, both=True, waves=0.0, drag=0.0)
    wet.run(240)
    assert measured(wet, "roll period") == pytest.approx(measured(wet, "roll, reckoned"), rel=0.02)
    assert measured(wet, "roll, liquid") > 1.05 * measured(free, "roll period")


def test_a_click_in_the_curve_sets_it_down_at_that_angle():
    stage = opened()
    left, low, right, high = stage.scene.model.content.chart
    stage.post(Pointer("down", left + 0.75 * (right - left), 0.5 * (low + high), 1))
    stage.post(Pointer("up", left + 0.75 * (right - left), 0.5 * (low + high), 1))
    stage.run(1)
    assert measured(stage, "angle") == pytest.approx(90.0, abs=1.0)
    assert measured(stage, "angle, liquid") == pytest.approx(90.0, abs=1.0)
    stage.post(Action("upright"))
    stage.run(1)
    assert measured(stage, "angle") == pytest.approx(0.0, abs=0.5)


def test_what_is_drawn_floats_in_both_tanks():
    stage = opened(tool="draw")
    drag(stage, (0.3, 0.7), (0.3, 0.4), (0.7, 0.4), (0.7, 0.5), (0.4, 0.5), (0.4, 0.7))
    model = stage.scene.model
    assert stage.scene.parameters.shape == "drawn" and model.floater.area == pytest.approx(0.06, rel=0.02)
    inverse, _, _ = model.solids.world.inverse_mass(model.body)
    assert 1.0 / inverse == pytest.approx(model.floater.mass, rel=1e-9)
    stage.run(60)
    assert measured(stage, "displaced") > 0.5 * measured(stage, "at rest")


@pytest.mark.parametrize(
    "path", [((0.3, 0.5), (0.31, 0.5)), ((0.3, 0.3), (0.6, 0.6), (0.6, 0.3), (0.3, 0.6))]
)
def test_no_body_of_a_dash_or_a_crossed_line(path):
    stage = opened(tool="draw")
    before = stage.scene.model.floater.area
    drag(stage, *path)
    assert stage.scene.messages() or stage.scene.model.floater.area == before


def test_lead_is_put_where_one_clicks_and_lowers_the_centre():
    stage = opened(tool="ballast", tilt=0.0)
    model = stage.scene.model
    x = float(model.law.body.pose[0])
    low = float(model.law.body.corners()[:, 1].min())
    before = measured(stage, "GM")
    drag(stage, (x, low + 0.05))
    assert stage.scene.parameters.ballast > 0.0 and measured(stage, "GM") > before + 0.005
    inverse, inertia, _ = model.solids.world.inverse_mass(model.body)
    assert (1.0 / inverse, 1.0 / inertia) == pytest.approx(
        (model.floater.mass, model.floater.inertia), rel=1e-9
    )


def test_a_hand_pulls_it_in_either_tank():
    stage = opened(tilt=0.0)
    model = stage.scene.model
    x, y = model.law.body.pose[:2].tolist()
    drag(stage, (x, y), (x, y + 0.2), (x, y + 0.3), steps=20)
    assert model.law.body.pose[1] > y + 0.1
    (x, y), _ = model.liquid_pose()
    drag(stage, (x, y), (x, y + 0.2), (x, y + 0.3), steps=20)
    assert model.liquid_pose()[0][1] > y + 0.1


def test_a_step_back_brings_the_body_before_back():
    stage = opened(both=False)
    stage.run(20)
    kept, area = stage.digest(), stage.scene.model.floater.area
    stage.run(10)
    stage.post(SetParameter("shape", "square"))
    stage.run(10)
    assert stage.scene.model.floater.area != area
    while stage.step_number > 20:
        assert stage.step_back()
    assert stage.digest() == kept and stage.scene.model.floater.area == area


def test_a_plank_leans_on_its_hinge():
    stage = opened("plank", both=False, waves=0.5)
    stage.run(900)
    assert measured(stage, "angle") == pytest.approx(measured(stage, "stable angle"), abs=1.0)
    assert math.isfinite(measured(stage, "stable angle"))
