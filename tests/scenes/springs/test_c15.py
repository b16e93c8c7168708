"""Soft springs, C15.3, C15.6 and beyond; the rest is in test_springs."""

from __future__ import annotations

import numpy as np
import pytest

from game.scenes.springs.soft_springs import Springs
from game.stage import SetEffect, SetParameter
from tests.scenes.particle_stages import click, move, open_level, press, readouts, release

G = 9.81


def stretches(stage):
    """Of the three springs that hang beside each other, m."""
    y = stage.scene.model.system.positions[:, 1]
    return y[0::2] - y[1::2] - 1.5


def test_stiffness_is_a_part_of_the_correction():
    """C15.3: rest stretch g dt² q / (1 - q) with q = (1 - k)^n, for three stiffnesses of their own."""
    stage = open_level(Springs, "three-springs", damping=20.0)
    stage.run(1500)
    q = (1.0 - np.array([0.002, 0.006, 1.0])) ** 4
    assert np.allclose(stretches(stage), G / 3600 * q / (1 - q), rtol=0, atol=1e-9)


@pytest.mark.parametrize(
    ("model", "by_sweeps", "by_step"),
    [("pbd", True, True), ("pbd-even", False, True), ("xpbd", False, False)],
)
def test_what_stiffness_depends_on(model, by_sweeps, by_step):
    """C15.6 and beyond: k on sweeps and step, k' on the step, compliance on neither."""
    rest = {}
    for sweeps, dt in ((4, 1 / 60), (16, 1 / 60), (4, 1 / 120)):
        stage = open_level(
            Springs, "three-springs", model=model, iterations=sweeps, step_length=dt, damping=20.0
        )
        stage.run(round(8 / dt))
        rest[sweeps, dt] = stretches(stage)[0]
    base = rest[4, 1 / 60]
    assert (abs(rest[16, 1 / 60] / base - 1) > 0.3) == by_sweeps
    assert (abs(rest[4, 1 / 120] / base - 1) > 0.3) == by_step


def test_the_three_models_agree_for_one_sweep_at_sixty_a_second():
    rest = []
    for model in ("pbd", "pbd-even", "xpbd"):
        stage = open_level(Springs, "three-springs", model=model, iterations=1, damping=20.0)
        stage.run(1500)
        rest.append(stretches(stage))
    assert np.allclose(rest[0], rest[1], rtol=0, atol=1e-9)
    assert np.allclose(rest[0], rest[2], rtol=0, atol=1e-9)


def test_a_spring_gets_a_stiffness_of_its_own():
    stage = open_level(Springs, "three-springs", damping=20.0)
    click(stage, stage.scene.model.system.positions[1])
    assert stage.scene.parameters.own_stiffness == 0.002
    stage.post(SetParameter("own_stiffness", 1.0))
    stage.run(600)
    assert stretches(stage)[0] == pytest.approx(0.0, abs=1e-9)
    assert stretches(stage)[1] > 5e-4
    assert stage.scene.save_content().links[0].stiffness == 1.0


def test_jelly_and_ring_keep_their_area_and_lose_it_without():
    stage = open_level(Springs, "default")
    stage.run(150)
    assert readouts(stage)["area kept"] == pytest.approx(1.0, abs=0.05)
    ring = stage.scene.model.system.areas()
    assert ring[0][-1] == pytest.approx(ring[1][-1], rel=0.1)
    stage.post(SetEffect("areas", False))
    stage.run(240)
    assert stage.scene.model.system.areas()[0][-1] < 0.5 * ring[1][-1]


def test_stiffness_one_is_rigid_and_zero_is_free():
    rigid = open_level(Springs, "hard-01-rigid")
    free = open_level(Springs, "hard-01-free")
    rigid.run(60)
    free.run(60)
    assert readouts(rigid)["worst"] < 0.05
    assert free.scene.model.system.positions[1:, 1].max() == 0.0


def test_series_and_side_by_side():
    """With compliance and a bead of a gram between: 1/k adds up in series, k side by side."""
    stage = open_level(Springs, "hard-06-series-and-parallel", damping=5.0, iterations=200)
    stage.run(900)
    places = stage.scene.model.system.positions
    k = 0.05 / 0.95 * 3600.0
    assert places[3, 1] - places[4, 1] - 1.0 == pytest.approx(G / (2 * k), rel=1e-3)
    assert places[0, 1] - places[2, 1] - 1.6 == pytest.approx((2 * G + 1e-3 * G) / k, rel=2e-2)


def test_stepping_back_undoes_a_stiffness_of_its_own():
    stage = open_level(Springs, "three-springs", damping=20.0)
    stage.run(60)
    click(stage, stage.scene.model.system.positions[3])
    stage.run(2)
    stage.post(SetParameter("own_stiffness", 1.0))
    stage.run(2)
    assert stage.scene.save_content().links[1].stiffness == 1.0
    while stage.step_number > 61:
        assert stage.step_back()
    assert stage.scene.save_content().links[1].stiffness == 0.006
    assert stage.scene.model.system.links.stiffness[1] == 0.006


def test_a_thrown_jelly_comes_back_and_does_not_pass_through_the_others():
    stage = open_level(Springs, "default")
    stage.run(120)
    system = stage.scene.model.system
    bodies = np.split(np.arange(system.count), (96, 168))
    start = system.positions[120]
    press(stage, start)
    for i in range(12):
        move(stage, start + i * np.array((0.6, 0.1)))
        stage.run(1)
    release(stage, start + np.array((6.6, 1.1)))
    for _ in range(200):
        stage.run(1)
        places = system.positions
        assert places[:, 0].min() >= -4.6 and places[:, 0].max() <= 4.6
        for a, b in ((0, 1), (1, 2), (0, 2)):
            gaps = places[bodies[a]][:, None] - places[bodies[b]][None]
            assert np.sqrt((gaps * gaps).sum(axis=2)).min() > 0.1
    assert stage.fault is None
    assert stage.scene.save_content().walls == (-4.6, 4.6)
