"""The small scenes: right beside their exact motion, dragged and let go, back again."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from game.scenes import examples
from game.stage import Pointer, SetEffect, Stage
from tests.paths import ROOT

FILES = {entry.name: ROOT / (entry.module.replace(".", "/") + ".py") for entry in examples.ENTRIES}


def measured(stage):
    return {readout.name: readout.value for readout in stage.scene.readouts()}


def played(name, seconds, **parameters):
    stage = Stage(
        next(entry for entry in examples.ENTRIES if entry.name == name).load(), parameters=parameters
    )
    stage.run(round(seconds / stage.dt))
    assert stage.fault is None
    return stage


@pytest.mark.parametrize("path", FILES.values(), ids=FILES)
def test_a_small_scene_is_small(path: Path):
    assert len(path.read_text(encoding="utf-8").splitlines()) <= 100


@pytest.mark.parametrize(
    ("name", "parameters", "most"),
    [
        ("pendulum", {"method": "rk4"}, 1e-4),
        ("pendulum", {"method": "verlet"}, 0.3),
        ("bouncing-ball", {"impact": "root"}, 1e-12),
        ("spring-chain", {"method": "rk4"}, 1e-3),
        ("spring-chain", {"method": "verlet", "mode": 3}, 2e-2),
    ],
)
def test_they_stay_beside_their_exact_motion(name, parameters, most):
    assert measured(played(name, 2.0, **parameters))["error"] < most


def test_explicit_euler_feeds_energy_to_both():
    for name in ("pendulum", "spring-chain"):
        stage = played(name, 0.0, method="explicit-euler")
        before = measured(stage)["energy"]
        stage.run(240)
        assert measured(stage)["energy"] > 1.05 * before


@pytest.mark.parametrize(("name", "x", "y"), [("pendulum", 0.8, -0.6), ("spring-chain", 1.0, 0.5)])
def test_what_is_dragged_and_let_go_has_an_exact_motion_of_its_own(name, x, y):
    stage = played(name, 0.5, method="rk4")
    stage.post(Pointer("down", x, y, button=1))
    stage.run(20)
    assert measured(stage)["error"] == pytest.approx(0.0, abs=1e-9)
    stage.post(Pointer("up", x, y))
    stage.run(100)
    assert abs(measured(stage)["error"]) < 2e-3


@pytest.mark.parametrize(("name", "effect"), [("pendulum", "gravity"), ("spring-chain", "links")])
def test_an_effect_switched_off_ends_the_comparison(name, effect):
    stage = played(name, 0.3)
    stage.post(SetEffect(effect, False))
    assert math.isnan(measured(stage)["error"])
    while stage.step_back():
        pass
    assert math.isfinite(measured(stage)["error"])


def test_a_ball_that_is_thrown_has_no_exact_twin_and_does_not_pass_the_ground():
    stage = played("bouncing-ball", 1.0)
    stage.post(Pointer("down", 0.0, 0.7, button=1))
    stage.post(Pointer("up", 0.0, 0.7))
    assert measured(stage)["height"] == pytest.approx(0.62) and math.isnan(measured(stage)["exact"])
    for _ in range(200):
        stage.run(1)
        assert measured(stage)["height"] >= 0.0
    stage.post(SetEffect("ground", False))
    stage.run(300)
    assert measured(stage)["height"] < -1.0
