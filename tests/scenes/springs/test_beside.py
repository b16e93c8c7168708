"""A network solved in several ways side by side, and a pendulum beside where it should be."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.scenes.springs.exact_bob import exact_bob
from game.scenes.springs.rigid_links import RigidLinks
from game.scenes.springs.soft_springs import Springs
from game.stage import Action, SetEffect, SetParameter
from tests.scenes.labels import labels_of
from tests.scenes.particle_stages import click, open_level, readouts


def stretches(stage):
    """Greatest stretch of the network and of those beside it."""
    measured = readouts(stage)
    return [measured["worst"], *(measured[f"{entry.label} worst"] for entry in stage.level.content.beside)]


def test_the_same_budget_is_spent_in_three_ways():
    """The whole rope by the closed form for one sweep a substep; more sweeps in fewer substeps: far more."""
    stage = open_level(RigidLinks, "one-budget")
    stage.run(round(30.0 / stage.dt))
    one, five, twenty = stretches(stage)
    assert one > 3.0 * five > 6.0 * twenty
    n, h = 60, 1.0 / 60.0 / 20.0
    last = stage.scene.model.beside[1].positions
    longer = math.dist(last[0].tolist(), last[-1].tolist()) - 2.0
    assert longer == pytest.approx((n - 1) * (1.0 + 0.5 * (n - 2)) * 9.81 * h * h, rel=0.2)
    assert twenty < one / 10.0


def test_only_k_stiffens_with_the_sweeps_and_only_compliance_stays_with_another_step():
    def settled(**parameters):
        stage = open_level(Springs, "three-ways", **parameters)
        stage.run(round(20.0 / stage.dt))
        return stretches(stage)

    once = settled()
    assert once[1] == pytest.approx(once[0], rel=1e-6) and once[2] == pytest.approx(once[0], rel=1e-3)
    often = settled(iterations=8)
    assert often[0] < 0.2 * once[0]
    assert often[1:] == pytest.approx(once[1:], rel=0.02)
    finer = settled(step_length=1.0 / 120.0)
    assert finer[1] < 0.3 * once[1] and finer[2] == pytest.approx(once[2], rel=0.02)


def test_each_network_alone_goes_the_same_way():
    together = open_level(Springs, "three-ways")
    alone = open_level(Springs, "three-ways", model="xpbd")
    for stage in (together, alone):
        stage.run(90)
    assert np.array_equal(together.scene.model.beside[1].positions, alone.scene.model.system.positions)


@pytest.mark.parametrize(("scene_type", "name"), [(RigidLinks, "one-budget"), (Springs, "three-ways")])
def test_all_of_them_go_back_and_are_named(scene_type, name):
    stage = open_level(scene_type, name)
    stage.run(40)
    digest, places = stage.digest(), stage.scene.model.beside[0].positions.copy()
    stage.run(25)
    while stage.step_number > 40:
        assert stage.step_back()
    assert stage.digest() == digest
    assert np.array_equal(stage.scene.model.beside[0].positions, places)
    canvas = labels_of(stage)
    stage.scene.draw(canvas, 1.0)
    assert {stage.level.content.label, *(entry.label for entry in stage.level.content.beside)} <= set(
        canvas.drawn
    )


def test_who_edits_goes_on_with_one_and_a_step_back_brings_all_back():
    stage = open_level(Springs, "three-ways", tool="particle")
    stage.run(5)
    click(stage, (0.0, 1.0))
    stage.run(5)
    assert stage.scene.model.beside == [] and stage.scene.save_content().beside == ()
    for _ in range(6):
        stage.step_back()
    assert len(stage.scene.model.beside) == 2


def test_the_exact_bob_swings_for_ever():
    stage = open_level(RigidLinks, "pendulum", scheme="bdf2", substeps=20)
    assert exact_bob(stage.scene.model) == pytest.approx((2.0, 3.0))
    stage.run(round(1.0 / stage.dt))
    assert math.dist(exact_bob(stage.scene.model), stage.scene.model.system.positions[1]) < 0.01
    for name, value in (("damping", 0.1), ("gravity", 5.0)):
        stage.post(SetParameter(name, value))
        assert exact_bob(stage.scene.model) is None


def test_no_bob_is_claimed_once_a_hand_has_pulled():
    stage = open_level(RigidLinks, "pendulum")
    stage.post(SetEffect("gravity", False))
    assert exact_bob(stage.scene.model) is None
    stage.post(SetEffect("gravity", True))
    stage.post(Action("pin"))
    click(stage, (0.0, 3.0))
    assert exact_bob(stage.scene.model) is None
