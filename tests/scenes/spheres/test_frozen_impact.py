"""Time stands still at an impact; balls of a cradle are lifted; the window is turned over."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.scenes.spheres.frozen_impact import impact_of
from game.scenes.spheres.scene import SphereCollisions
from game.stage import Action, SetParameter
from tests.scenes.labels import labels_of
from tests.scenes.particle_stages import open_level


def frozen(name, **parameters):
    stage = open_level(SphereCollisions, name, freeze=True, **parameters)
    for _ in range(2_000):
        stage.run(1)
        if stage.scene.model.frozen:
            return stage
    raise AssertionError("no impact")


def test_it_stands_still_at_an_impact_and_goes_on():
    stage = frozen("two-spheres")
    before = stage.scene.model.world.bodies.state.positions.copy()
    stage.run(30)
    assert np.array_equal(stage.scene.model.world.bodies.state.positions, before)
    stage.post(Action("go-on"))
    stage.run(30)
    assert stage.scene.model.frozen == 0
    assert not np.array_equal(stage.scene.model.world.bodies.state.positions, before)
    stage.post(SetParameter("freeze", False))
    stage.run(600)
    assert stage.scene.model.frozen == 0


def test_normal_impulse_and_friction_are_those_of_the_laws():
    """Spheres with spin: j = -(1 + e) v_n m_n, and friction within its cone, at its edge while it slides."""
    stage = frozen("hard-10-spin", friction=0.1)
    impact, bodies = impact_of(stage.scene.model), stage.scene.model.world.bodies
    mass = bodies.composition.masses[0]
    assert np.hypot(*impact.normal) == pytest.approx(1.0)
    assert abs(impact.normal[0]) == pytest.approx(1.0, abs=1e-6) and impact.friction == 0.1
    assert impact.along == pytest.approx(-1.5 * impact.before * 0.5 * mass, rel=1e-6)
    assert impact.after == pytest.approx(-0.5 * impact.before, rel=1e-6)
    assert impact.across == pytest.approx(0.1 * impact.along, rel=1e-6)


def test_the_numbers_stand_beside_the_contact():
    stage = frozen("two-spheres")
    canvas, point = labels_of(stage), tuple(impact_of(stage.scene.model).point)
    stage.scene.draw(canvas, 1.0)
    assert canvas.drawn["G goes on"][0] == point
    assert any(words.startswith("v_n") for words in canvas.drawn)


def test_several_impacts_of_one_moment_come_one_by_one():
    stage = frozen("hard-10-spin")
    first, most = stage.scene.model.frozen, stage.scene.model.world.collisions
    assert most == first + 1
    stage.post(Action("go-on"))
    assert stage.scene.model.frozen == most
    stage.post(Action("go-on"))
    assert stage.scene.model.frozen == 0


@pytest.mark.parametrize("lifted", [1, 2, 3])
def test_so_many_balls_as_are_lifted_leave_at_the_other_end(lifted):
    stage = open_level(SphereCollisions, "cradle", lifted=lifted)
    places = stage.scene.model.world.bodies.state.positions
    assert int((places[:, 1] > places[-1, 1] + 0.1).sum()) == lifted
    period = 2.0 * math.pi * math.sqrt(3.0 / 9.81)
    stage.run(round(0.5 * period / stage.dt))
    places = stage.scene.model.world.bodies.state.positions
    high = places[:, 1] > places[:, 1].min() + 0.1
    assert high.tolist() == [False] * (5 - lifted) + [True] * lifted


def test_without_a_cradle_there_is_nothing_to_lift():
    assert open_level(SphereCollisions, "pile").scene.why_idle("lifted")
    assert open_level(SphereCollisions, "cradle").scene.why_idle("lifted") == ""


def test_turned_over_everything_falls_the_other_way():
    stage = open_level(SphereCollisions, "draw")
    stage.post(Action("turn"))
    stage.run(240)
    bodies = stage.scene.model.world.bodies
    assert stage.scene.parameters.gravity == -9.81
    assert bodies.state.positions[0, 1] > 1.0
    stage.post(Action("turn"))
    assert stage.scene.parameters.gravity == 9.81


def test_at_a_wall_the_normal_points_to_it_and_the_friction_is_the_walls():
    stage = open_level(SphereCollisions, "hard-11-restitution", freeze=True, friction=0.1, wall_friction=0.3)
    model, seen = stage.scene.model, 0
    for _ in range(3_000):
        stage.run(1)
        if model.frozen:
            impact = impact_of(model)
            at_wall = bool(abs(abs(impact.point[0]) - 4.2) < 0.05)
            assert impact.friction == (0.3 if at_wall else 0.1)
            seen |= 1 << at_wall
            if at_wall:
                assert impact.normal == pytest.approx((math.copysign(1.0, impact.point[0]), 0.0), abs=1e-6)
            stage.post(Action("go-on"))
    assert seen == 3
