"""Drag against air that stands still or moves."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.fields import DRAG, WIND
from game.physics.solids import Disc, SolidSettings, SolidWorld
from game.physics.solids.effects import SLEEP, USUAL
from game.physics.surfaces.sample_fields import ConstantField, FunctionField
from tests.physics.solids.setups import run

AIRY = USUAL.without(SLEEP) | DRAG | WIND


def falling(effects=AIRY, air=None, **settings):
    """A disc without ground, and its world."""
    world = SolidWorld(SolidSettings(effects=effects, **settings))
    world.set_air(air)
    return world, world.add_body(Disc(0.5))


def test_terminal_speed_is_gravity_over_drag():
    world, body = falling(drag=0.5)
    run(world, 40.0)
    assert world.bodies.velocities[body] == pytest.approx([0.0, -9.81 / 0.5], rel=1e-6)


def test_drag_is_solved_implicitly_for_every_size():
    world, body = falling(drag=1e5)
    run(world, 1.0)
    assert world.bodies.velocities[body, 1] == pytest.approx(-9.81 / 1e5, rel=1e-6)


def test_a_spin_decays():
    world, body = falling(spin_drag=2.0, substeps=64)
    world.set_velocity(body, (0.0, 0.0), 3.0)
    run(world, 1.0)
    assert world.bodies.spins[body] == pytest.approx(3.0 * np.exp(-2.0), rel=2e-3)


def test_wind_carries_and_only_while_its_effect_and_drag_are_on():
    wind = ConstantField((4.0, 0.0))
    carried, body = falling(air=wind, drag=1.0, gravity=(0.0, 0.0))
    run(carried, 20.0)
    assert carried.bodies.velocities[body] == pytest.approx([4.0, 0.0], abs=1e-6)
    carried.set_air(None)
    run(carried, 20.0)
    assert carried.bodies.velocities[body] == pytest.approx([0.0, 0.0], abs=1e-6)
    for effects in (AIRY.without(WIND), AIRY.without(DRAG)):
        world, body = falling(effects, wind, drag=1.0, gravity=(0.0, 0.0))
        run(world, 2.0)
        assert world.bodies.velocities[body] == pytest.approx([0.0, 0.0], abs=1e-12)


def test_wind_is_sampled_where_each_body_is():
    shear = FunctionField(lambda points, time: np.stack([points[:, 1], 0.0 * points[:, 0]], axis=1))
    world = SolidWorld(SolidSettings(effects=AIRY, drag=5.0, gravity=(0.0, 0.0)))
    world.set_air(shear)
    bodies = [world.add_body(Disc(0.1), (0.0, float(y))) for y in (-2, 0, 3)]
    run(world, 4.0)
    assert world.bodies.velocities[bodies, 0] == pytest.approx([-2.0, 0.0, 3.0], abs=1e-6)


def test_air_that_is_not_finite_is_refused():
    world, _ = falling(air=FunctionField(lambda points, time: np.full(points.shape, np.nan)), drag=1.0)
    with pytest.raises(ValueError, match="finite"):
        world.step(1.0 / 60.0)
