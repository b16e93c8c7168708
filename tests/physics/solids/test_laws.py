"""Closed forms of solids in contact: slopes, rolling, impacts, and what a soft contact sinks."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.solids import Disc, Material, box
from game.physics.solids.effects import SLEEP, USUAL
from tests.physics.solids.setups import G, column, floor_world, run


@pytest.mark.parametrize(("degrees", "mu", "seconds"), [(30.0, 0.3, 1.0), (20.0, 0.1, 2.0)])
def test_a_box_slides_down_a_slope(degrees, mu, seconds):
    """g t² (sin - mu cos)/2; semi-implicit Euler makes it exactly a h² n(n+1)/2."""
    world, _ = floor_world(Material(friction=mu), degrees)
    body = world.add_body(box(1.0, 1.0, material=Material(friction=mu)), (0.0, 0.5))
    run(world, seconds)
    pull = G * (math.sin(math.radians(degrees)) - mu * math.cos(math.radians(degrees)))
    n = round(seconds * 240)
    assert world.bodies.positions[body, 0] == pytest.approx(pull / 240**2 * n * (n + 1) / 2, rel=1e-3)


def test_a_disc_rolls_down_a_slope_without_slip():
    world, _ = floor_world(Material(friction=0.6), 20.0, substeps=16)
    body = world.add_body(Disc(0.3, material=Material(friction=0.6)), (0.0, 0.3))
    run(world, 2.0)
    assert world.bodies.positions[body, 0] == pytest.approx(4.473623, rel=2e-3)
    assert world.bodies.velocities[body, 0] == pytest.approx(-0.3 * world.bodies.spins[body], rel=1e-3)


def test_a_disc_slips_on_a_steep_slope():
    world, _ = floor_world(Material(friction=0.2), 45.0, substeps=16)
    body = world.add_body(Disc(0.3, material=Material(friction=0.2)), (0.0, 0.3))
    run(world, 1.0)
    assert world.bodies.positions[body, 0] == pytest.approx(2.774687, rel=2e-3)
    assert -world.bodies.spins[body] == pytest.approx(9.248957, rel=2e-3)


@pytest.mark.parametrize(
    ("velocity", "spin", "e", "mu", "after"),
    [
        ((1.0, -4.0), 5.0, 0.6, 0.5, (1.0 / 3.0, 2.4, -5.0 / 3.0)),
        ((6.0, -1.0), 0.0, 0.5, 0.1, (5.85, 0.5, -1.5)),
    ],
)
def test_a_disc_bounces_obliquely(velocity, spin, e, mu, after):
    """Tangential impulse min(mu (1 + e) |vy|, slip/3), Routh 1905."""
    material = Material(friction=mu, restitution=e)
    world, _ = floor_world(material, gravity=(0.0, 0.0))
    body = world.add_body(Disc(0.2, material=material), (0.0, 0.25), velocity=velocity, spin=spin)
    run(world, 0.2)
    found = [*world.bodies.velocities[body], world.bodies.spins[body]]
    assert found == pytest.approx(after, rel=1e-9)


@pytest.mark.parametrize(("hertz", "sink"), [(30.0, 0.5418466923972897), (60.0, 0.13546167309932242)])
def test_a_column_sinks_by_the_law_of_soft_contacts(hertz, sink):
    """24.525/w² (n(n-1)/2 + n/8) for n = 40."""
    world, _ = floor_world(contact_hertz=hertz, effects=USUAL.without(SLEEP))
    top = column(world, 40)[-1]
    run(world, 10.0)
    assert 39.5 - world.bodies.positions[top, 1] == pytest.approx(sink, rel=1e-3)
    assert abs(world.bodies.positions[top, 0]) < 0.01


def test_slide_to_roll_with_backspin_comes_back():
    """t = (v0 + r w0)/(3 mu g), v = (2 v0 - r w0)/3."""
    world, _ = floor_world(Material(friction=0.3), substeps=16)
    body = world.add_body(
        Disc(0.2, material=Material(friction=0.3)), (0.0, 0.2), velocity=(2.0, 0.0), spin=40.0
    )
    run(world, 1.5)
    assert world.bodies.velocities[body, 0] == pytest.approx(-4.0 / 3.0, rel=2e-3)


def test_state_and_restore_give_equal_bits():
    world, _ = floor_world()
    rng = np.random.default_rng(3)
    for k in range(30):
        world.add_body(box(0.5, 0.5), (0.4 * (k % 6), 1.0 + 0.7 * (k // 6)), float(rng.uniform(0, 3)))
    run(world, 0.5)
    before = world.state()
    run(world, 1.0)
    after = world.state()
    world.restore(before)
    run(world, 1.0)
    for name, array in world.state().bodies._asdict().items():
        assert np.array_equal(array, getattr(after.bodies, name)), name
