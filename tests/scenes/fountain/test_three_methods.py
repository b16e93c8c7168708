"""Explicit Euler, midpoint and Verlet side by side."""

from __future__ import annotations

import numpy as np
import pytest

from game.scenes.fountain.panes import panes_of
from game.scenes.fountain.scene import Fountain
from game.stage import Action
from tests.scenes.labels import labels_of
from tests.scenes.particle_stages import drag, open_level, readouts


def test_only_euler_rises_and_wins_energy():
    stage = open_level(Fountain, "three-methods")
    stage.run(30)
    measured = readouts(stage)
    assert measured["Euler highest"] > measured["exact"] + 0.1
    for name in ("midpoint highest", "highest"):
        assert measured[name] == pytest.approx(measured["exact"], abs=0.02)
    assert measured["Euler total"] > 1.03 * measured["total"]
    assert measured["midpoint total"] == pytest.approx(measured["total"], rel=0.02)


def test_without_a_hand_each_is_bit_for_bit_as_alone():
    together = open_level(Fountain, "three-methods")
    together.run(40)
    for system, method in zip(together.scene.model.systems, together.scene.model.methods, strict=True):
        alone = open_level(Fountain, "three-methods", split=False, method=method)
        alone.run(40)
        assert np.array_equal(system.fields, alone.scene.model.system.fields)


def test_the_hand_works_in_each_pane_and_moves_the_stones_of_all():
    for pane in range(3):
        stage = open_level(Fountain, "three-methods")
        shift = panes_of(stage.scene.model)[pane].shift
        drag(stage, (0.2 + shift, 2.42), (0.5 + shift, 2.0), steps=20, run=2)
        stage.run(5)
        for system in stage.scene.model.systems:
            assert system.solids.centres[0] == pytest.approx((0.5, 2.0), abs=1e-6)


def test_they_go_back_together_and_are_cleared_together():
    stage = open_level(Fountain, "three-methods")
    stage.run(20)
    digest = stage.digest()
    stage.run(10)
    while stage.step_number > 20:
        assert stage.step_back()
    assert stage.digest() == digest
    stage.post(Action("clear"))
    assert [len(system) for system in stage.scene.model.systems] == [0, 0, 0]


def test_each_pane_is_named_and_the_method_cannot_be_chosen():
    stage = open_level(Fountain, "three-methods")
    stage.run(5)
    canvas = labels_of(stage)
    stage.scene.draw(canvas, 1.0)
    assert {"Explicit Euler", "Midpoint", "Verlet"} <= set(canvas.drawn)
    assert stage.scene.why_idle("method")
    assert not open_level(Fountain, "default").scene.why_idle("method")


def test_each_pane_has_the_nozzle_in_its_middle():
    stage = open_level(Fountain, "three-methods")
    stage.scene.model.place_nozzle(0, (0.8, 0.0))
    for pane in panes_of(stage.scene.model):
        assert 0.8 + pane.shift == pytest.approx(0.5 * (pane.left + pane.right))
