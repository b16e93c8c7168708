"""The cavity as a person meets it: levels come to what they expect, the hand stirs."""

from __future__ import annotations

import math

import pytest

from game.app.stagehand.headless import picture_of_stage
from game.lab.studies.gases.flows import cavity_trial, eddies_trial
from game.lab.study import Setting
from game.levels import level_files, load_level
from game.scenes.cavity.published import EXTREMES, GHIA_U, GHIA_V, HEIGHTS, PLACES
from game.scenes.cavity.scene import Cavity
from game.stage import Pointer, SetEffect, SetParameter, Stage
from game.worlds.expectations import captions_of
from tests.scenes.by_hand import measured

LEVELS = level_files("cavity")
HARD = [path for path in LEVELS if path.stem.startswith("hard-")]
SECONDS = {"hard-01-re-100": 15.0, "hard-03-nusselt": 40.0}


def opened(path) -> Stage:
    return Stage(Cavity, level=load_level(path, "cavity", Cavity.content_type))


@pytest.mark.parametrize("path", HARD, ids=lambda path: path.stem)
def test_a_hard_level_comes_to_what_it_expects(path):
    stage = opened(path)
    stage.run(math.ceil(SECONDS.get(path.stem, 4.0) / stage.dt))
    assert stage.scene.model.content.expected
    assert all(caption.met for caption in captions_of(stage.scene.model.content.expected, stage.readouts()))


def test_published_numbers_agree_with_one_another():
    """Ghia's extremes are grid values, at most 1.6 % low."""
    for number, (low, most, least) in EXTREMES.items():
        assert len(GHIA_U[number]) == len(HEIGHTS) and len(GHIA_V[number]) == len(PLACES)
        assert 0.97 < min(GHIA_U[number]) / low < 1.0
        assert 0.96 < max(GHIA_V[number]) / most < 1.0 and 0.96 < min(GHIA_V[number]) / least < 1.0


def test_the_lid_drives_it_and_the_hand_stirs():
    stage = opened(next(path for path in LEVELS if path.stem == "slow"))
    stage.run(60)
    driven = measured(stage, "energy")
    assert driven > 1e-4
    for event in (Pointer("down", 0.3, 0.3, 1), Pointer("move", 0.4, 0.4, 1), Pointer("up", 0.4, 0.4, 1)):
        stage.post(event)
    stage.run(1)
    assert measured(stage, "energy") > 1.5 * driven
    stage.post(SetParameter("lid", -1.0))
    stage.run(240)
    assert measured(stage, "least v") < 0.0 and stage.scene.model.profiles()[1][-1] == -1.0


def test_without_pressure_there_is_no_eddy():
    stage = opened(next(path for path in LEVELS if path.stem == "slow"))
    stage.post(SetEffect("pressure", False))
    stage.run(120)
    assert measured(stage, "most v") == 0.0 and measured(stage, "energy") > 0.0


def test_pictures_of_both_flows():
    for name in ("default", "heated"):
        stage = opened(next(path for path in LEVELS if path.stem == name))
        stage.run(30)
        picture = picture_of_stage(stage, (640, 360))
        assert picture is not None


def test_the_study_has_the_orders_that_it_names():
    settings = [Setting(name, n) for name in ("time-centred", "maccormack") for n in (32.0, 64.0)]
    errors = {}
    for setting in settings:
        trial = eddies_trial(setting)
        trial.reset()
        trial.run()
        errors[setting.method, setting.knob] = trial.outcome().error
    slopes = {m: math.log2(errors[m, 32.0] / errors[m, 64.0]) for m in ("time-centred", "maccormack")}
    assert slopes["time-centred"] > 1.8 and slopes["maccormack"] < 1.2
    trial = cavity_trial(Setting("time-centred", 8.0))
    trial.reset()
    trial.run()
    assert trial.outcome().error < 0.1


def test_the_error_is_that_of_what_is_published_of_the_flow():
    """Of the Nusselt number between a hot and a cold wall; none where nothing is published."""
    stage = Stage(Cavity, parameters={"flow": "heated", "rayleigh": 1_000.0, "cells": 16})
    stage.run(60)
    shown = {readout.name: readout.value for readout in stage.scene.readouts()}
    assert shown["Nusselt error"] == pytest.approx(100.0 * (shown["Nusselt"] / 1.1177897 - 1.0))
    assert shown["error"] == abs(shown["Nusselt error"]) > 0.0
    for changed in ({"flow": "heated", "rayleigh": 2_000.0}, {"number": 500.0}, {"lid": -1.0}):
        scene = Stage(Cavity, parameters={"cells": 16, **changed}).scene
        assert "error" not in [readout.name for readout in scene.readouts()]
