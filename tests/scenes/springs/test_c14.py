"""Rigid links, C14.3, C14.6 and beyond; the rest is in test_springs."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.scenes.springs.rigid_links import RigidLinks
from game.stage import SetEffect, SetParameter
from tests.scenes.particle_stages import drag, move, open_level, press, readouts


def test_links_keep_their_length_and_more_iterations_keep_it_better():
    """C14.3, C14.6"""
    worst = {}
    for iterations in (2, 20, 200):
        stage = open_level(RigidLinks, "long-rope", iterations=iterations, damping=5.0)
        stage.run(240)
        worst[iterations] = readouts(stage)["overall"]
    assert worst[2] > 3 * worst[20]
    assert worst[20] > 4 * worst[200] > 0.0


def test_the_same_work_in_substeps_is_far_better():
    stretch = {}
    for substeps, iterations in ((1, 20), (20, 1)):
        stage = open_level(RigidLinks, "long-rope", substeps=substeps, iterations=iterations, damping=5.0)
        stage.run(240)
        stretch[substeps] = readouts(stage)["overall"]
    assert stretch[20] < 0.1 * stretch[1]


def test_a_pendulum_keeps_its_energy_with_bdf2_only():
    left = {}
    for scheme in ("euler", "bdf2"):
        stage = open_level(RigidLinks, "pendulum", scheme=scheme)
        start = readouts(stage)["sum"]
        stage.run(600)
        left[scheme] = start - readouts(stage)["sum"]
    assert left["euler"] > 10.0
    assert left["bdf2"] < 0.6


def test_a_cradle_sends_one_ball_for_one():
    stage = open_level(RigidLinks, "cradle")
    start = readouts(stage)["sum"]
    most, least = np.full(5, -9.0), np.full(5, 9.0)
    for _ in range(110):
        stage.run(1)
        places = stage.scene.model.system.positions
        aside = places[5:, 0] - places[:5, 0]
        most, least = np.maximum(most, aside), np.minimum(least, aside)
    assert least[0] < -1.6 and most[4] > 1.6
    assert np.abs(most[1:4]).max() < 0.02 and np.abs(least[1:4]).max() < 0.02
    assert readouts(stage)["sum"] == pytest.approx(start, rel=1e-3)


def test_the_cloth_of_a_hundred_by_a_hundred_hangs_and_tears():
    stage = open_level(RigidLinks, "cloth")
    assert stage.scene.model.system.count == 10_000
    assert len(stage.scene.model.system.torn) == 19_800
    stage.run(6)
    assert readouts(stage)["torn"] == 0
    grabbed = stage.scene.model.system.positions[5050]
    press(stage, grabbed)
    for i in range(1, 15):
        move(stage, (grabbed[0] + 0.4 * i, grabbed[1] - 0.2 * i))
        stage.run(1)
    assert readouts(stage)["torn"] > 0
    assert any("torn" in words for words in stage.scene.messages())
    drag(stage, (-3.0, 2.0), (3.0, 2.0), button=3, steps=2, run=0)
    assert readouts(stage)["torn"] > 80
    assert stage.fault is None


def test_the_rope_between_pins_hangs_as_the_dashed_line_says():
    stage = open_level(RigidLinks, "catenary", solver="direct", iterations=2)
    stage.run(500)
    exact = np.array(stage.scene.model.content.reference)
    assert np.abs(stage.scene.model.system.positions - exact).max() < 1e-3


def test_direct_solver_for_a_heavy_end():
    worst = {}
    for solver in ("gauss-seidel", "direct"):
        stage = open_level(RigidLinks, "hard-04-heavy-end", solver=solver)
        stage.run(60)
        worst[solver] = readouts(stage)["worst"]
    assert worst["direct"] < 1e-8 < 1e-2 < worst["gauss-seidel"]


def test_long_attachments_hold_a_rope_of_four_hundred_links():
    stage = open_level(RigidLinks, "hard-10-many-links")
    reach = []
    for _ in range(3):
        stage.run(30)
        pin, places = stage.scene.model.system.positions[0], stage.scene.model.system.positions
        reach.append(np.linalg.norm(places - pin, axis=1).max())
    assert max(reach) <= 7.9 + 1e-6
    stage.post(SetEffect("attachments", False))
    stage.run(60)
    assert readouts(stage)["overall"] > 0.005


def test_compliance_makes_a_link_a_spring():
    stage = open_level(RigidLinks, "pendulum", model="xpbd", compliance=0.01, damping=20.0, iterations=4)
    stage.run(1200)
    assert math.dist(*stage.scene.model.system.positions) - 2.0 == pytest.approx(0.0981, abs=1e-6)
    stage.post(SetParameter("compliance", 0.001))
    stage.run(600)
    assert math.dist(*stage.scene.model.system.positions) - 2.0 == pytest.approx(0.00981, abs=1e-6)
