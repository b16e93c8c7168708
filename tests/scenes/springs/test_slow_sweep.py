"""A sweep slowed down link by link."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.scenes.springs.rigid_links import RigidLinks
from game.scenes.springs.slow_sweep import STEPS_A_LINK, predicted, sweep_now
from game.stage import SetParameter
from tests.scenes.labels import labels_of
from tests.scenes.particle_stages import open_level


def length_of(stage, places, link):
    a, b = stage.scene.model.system.links.pairs[link].tolist()
    return math.dist(places[a].tolist(), places[b].tolist())


def test_time_stands_still_while_each_link_is_put_right():
    stage = open_level(RigidLinks, "link-by-link")
    system = stage.scene.model.system
    before, rest = system.positions.copy(), system.links.rest
    fallen = predicted(stage.scene.model)
    assert fallen[1:, 1] == pytest.approx(before[1:, 1] - 9.81 * 0.01, abs=1e-12)
    assert np.array_equal(fallen[0], before[0])
    for link in range(6):
        shown = sweep_now(stage.scene.model)
        assert (shown.sweep, shown.link) == (0, link)
        assert shown.excess == pytest.approx(length_of(stage, shown.places, link) - rest[link])
        stage.run(STEPS_A_LINK)
        assert length_of(stage, sweep_now(stage.scene.model).places, link) == pytest.approx(
            rest[link], abs=1e-12
        )
    assert sweep_now(stage.scene.model).sweep == 1
    assert np.array_equal(system.positions, before)


def test_a_substep_of_the_solver_comes_to_the_same():
    """Links in the order given, four sweeps: bit for bit but for rounding what the scene itself does."""
    stage = open_level(RigidLinks, "link-by-link", order="natural")
    stage.run(24 * STEPS_A_LINK - 1)
    shown = sweep_now(stage.scene.model)
    assert (shown.sweep, shown.link) == (3, 5)
    alone = open_level(RigidLinks, "link-by-link", order="natural", slow_sweep=False)
    alone.run(1)
    a, b = stage.scene.model.system.links.pairs[5].tolist()
    others = np.setdiff1d(np.arange(stage.scene.model.system.count), (a, b))
    assert np.abs(shown.places[others] - alone.scene.model.system.positions[others]).max() < 1e-9


def test_it_begins_again_and_ends_when_switched_off():
    stage = open_level(RigidLinks, "link-by-link")
    stage.run(24 * STEPS_A_LINK)
    assert (sweep_now(stage.scene.model).sweep, sweep_now(stage.scene.model).link) == (0, 0)
    canvas = labels_of(stage)
    stage.scene.draw(canvas, 1.0)
    assert any(words.startswith("sweep 1, link 1 of 6") for words in canvas.drawn)
    before = stage.scene.model.system.positions.copy()
    stage.post(SetParameter("slow_sweep", False))
    stage.run(5)
    assert not np.array_equal(stage.scene.model.system.positions, before)
