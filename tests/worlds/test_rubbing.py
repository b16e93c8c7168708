"""Rolling and sliding: their power is normal force times speed, by closed forms on a slope."""

import math

import pytest

from game.physics.solids import Disc, Material, SolidSettings, SolidWorld, box
from game.worlds.rubbing import QUIETEST, SILENT, rubbing

DT, SUBSTEPS, G = 1.0 / 120.0, 8, 9.81


def world_of(shape, friction: float, velocity: float, spin: float = 0.0) -> SolidWorld:
    """One body on level ground, that moves to the right."""
    world = SolidWorld(SolidSettings(substeps=SUBSTEPS, gravity=(0.0, -G)))
    material = Material(friction=friction, restitution=0.0)
    world.add_body(box(40.0, 1.0, material=material), position=(0.0, -0.5), kind="fixed")
    world.add_body(shape(material), position=(2.0, 0.5), velocity=(velocity, 0.0), spin=spin)
    for _ in range(30):
        world.step(DT)
    return world


def test_a_box_that_slides_rubs_with_its_weight_times_its_speed():
    world = world_of(lambda material: box(1.0, 1.0, material=material), 0.2, 3.0)
    rolling, sliding = rubbing(world, DT / SUBSTEPS)
    speed = float(world.bodies.velocities[1, 0])
    mass = 1.0 / float(world.bodies.inverse_masses[1])
    assert speed == pytest.approx(3.0 - 0.2 * G * 30 * DT, rel=0.02)
    assert sliding.power == pytest.approx(mass * G * speed, rel=0.02)
    assert sliding.speed == pytest.approx(speed, rel=1e-9)
    assert sliding.x == pytest.approx(float(world.bodies.positions[1, 0]), abs=0.5)
    assert rolling == SILENT


def test_a_disc_that_rolls_rubs_by_rolling_alone():
    world = world_of(lambda material: Disc(0.5, material=material), 0.8, 2.0, spin=-4.0)
    rolling, sliding = rubbing(world, DT / SUBSTEPS)
    mass = 1.0 / float(world.bodies.inverse_masses[1])
    assert rolling.power == pytest.approx(mass * G * 2.0, rel=0.02)
    assert rolling.speed == pytest.approx(2.0, rel=0.01)
    assert sliding.power < 0.02 * rolling.power


def test_what_stands_still_is_silent():
    world = world_of(lambda material: box(1.0, 1.0, material=material), 0.5, 0.0)
    assert rubbing(world, DT / SUBSTEPS) == (SILENT, SILENT)


def test_it_is_heard_as_the_root_of_its_power_and_on_its_side():
    world = world_of(lambda material: box(1.0, 1.0, material=material), 0.2, 3.0)
    _, sliding = rubbing(world, DT / SUBSTEPS)
    (loud,) = sliding.heard("sliding", 4.0 * sliding.power, 10.0, 0.0)
    (louder,) = sliding.heard("sliding", sliding.power, 10.0, 0.0)
    assert louder.level == pytest.approx(2.0 * loud.level)
    assert loud.pan == pytest.approx(sliding.x / 10.0) and 0.0 < loud.bright < 1.0
    assert SILENT.heard("sliding", 1.0, 1.0, 0.0) == []
    assert math.isfinite(QUIETEST)
