"""The race: all solvers see the same bodies, and each pane tells its own numbers."""

from __future__ import annotations

import numpy as np
import pytest

from game.levels import level_files
from game.scenes.solids.race.scene import SolverRace
from game.stage import Action, SetParameter
from tests.scenes.particle_stages import open_level, readouts

LEVELS = [path.stem for path in level_files("solver-race")]


@pytest.mark.parametrize("name", LEVELS)
def test_all_begin_alike_and_are_finite_after_a_second(name):
    stage = open_level(SolverRace, name)
    first, *others = stage.scene.model.worlds
    assert others
    for other in others:
        assert np.array_equal(first.world.bodies.positions, other.world.bodies.positions)
    stage.run(60)
    stage.scene.check()
    assert stage.fault is None


def test_more_substeps_sink_less():
    sunk = {}
    for tier in ("play", "film"):
        stage = open_level(SolverRace, "default", tier=tier)
        stage.run(90)
        sunk[tier] = readouts(stage)["soft step: sinks"]
    assert 0.0 < sunk["film"] < 0.3 * sunk["play"]


def test_a_key_chooses_the_set_up_and_a_switch_the_solvers():
    stage = open_level(SolverRace, "default")
    stage.post(Action("ratios"))
    stage.run(2)
    assert len(stage.scene.model.worlds[0].movable()) == 10
    before = len(stage.scene.model.worlds)
    stage.post(SetParameter("with_soft_step", False))
    stage.run(2)
    assert len(stage.scene.model.worlds) == before - 1
    assert len(stage.scene.panel_table().rows) == before - 1
