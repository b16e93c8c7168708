"""A body's material is changed while it moves: mass, inertia, friction and restitution are as if made so."""

import numpy as np
import pytest

from game.physics.solids import Disc, Material, SolidSettings, SolidWorld, box

STEP = 1.0 / 60.0


def pair(density: float) -> tuple[SolidWorld, int]:
    """A body of a box and a disc that turns as it flies."""
    world, material = SolidWorld(SolidSettings()), Material(density, 0.3, 0.2)
    shapes = [box(1.0, 0.5, material=material), Disc(0.3, (0.9, 0.0), material)]
    return world, world.add_body(shapes, (0.0, 5.0), 0.4, (1.0, 2.0), 3.0)


def test_another_density_is_as_if_made_so():
    (changed, body), (made, other) = pair(1.0), pair(7.0)
    changed.set_material(body, density=7.0)
    assert changed.bodies.inverse_masses[body] == pytest.approx(made.bodies.inverse_masses[other], rel=1e-14)
    assert changed.bodies.inverse_inertias[body] == pytest.approx(
        made.bodies.inverse_inertias[other], rel=1e-14
    )
    assert changed.bodies.velocities[body].tolist() == [1.0, 2.0] and changed.bodies.spins[body] == 3.0
    assert changed.shapes.densities[changed.shapes_of(body)].tolist() == [7.0, 7.0]


def test_a_density_stays_when_a_body_is_fixed_and_set_free_again():
    world, body = pair(1.0)
    mass = 1.0 / float(world.bodies.inverse_masses[body])
    world.set_kind(body, "fixed")
    world.set_material(body, density=4.0)
    assert world.bodies.inverse_masses[body] == 0.0
    world.set_kind(body, "dynamic")
    assert 1.0 / world.bodies.inverse_masses[body] == pytest.approx(4.0 * mass, rel=1e-14)


def test_friction_decides_whether_a_sleeping_box_slides():
    """On a slope of 20 degrees a box stays with 0.6, and slides with 0.05 at g (sin - mu cos)."""
    turn = np.radians(20.0)
    world = SolidWorld(SolidSettings())
    world.add_body(box(40.0, 1.0, material=Material(1.0, 0.6)), (0.0, 0.0), turn, kind="fixed")
    normal, along = np.array([-np.sin(turn), np.cos(turn)]), np.array([np.cos(turn), np.sin(turn)])
    body = world.add_body(box(1.0, 1.0, material=Material(1.0, 0.6)), normal, turn)
    for _ in range(180):
        world.step(STEP)
    assert abs(world.bodies.velocities[body] @ along) < 1e-3
    world.set_material(body, friction=0.05**2 / 0.6)  # of a pair: the geometric mean
    for _ in range(60):
        world.step(STEP)
    expected = 9.81 * (np.sin(turn) - 0.05 * np.cos(turn))
    assert -world.bodies.velocities[body] @ along == pytest.approx(expected, rel=0.03)


def test_restitution_says_how_high_a_ball_comes_back():
    world = SolidWorld(SolidSettings())
    world.add_body(box(40.0, 1.0, material=Material(1.0, 0.5)), (0.0, -0.5), kind="fixed")
    body = world.add_body(Disc(0.25, material=Material(1.0, 0.5, 0.0)), (0.0, 2.25))
    world.set_material(body, restitution=0.5)
    heights, fell = [], False
    for _ in range(90):
        world.step(STEP)
        fell = fell or world.bodies.velocities[body, 1] > 0.0
        heights.append(float(world.bodies.positions[body, 1]) if fell else 0.0)
    assert max(heights) - 0.25 == pytest.approx(0.25 * 2.0, rel=0.05)  # e^2 h


@pytest.mark.parametrize(
    "given", [{"density": 0.0}, {"density": np.nan}, {"friction": -1.0}, {"restitution": 1.5}]
)
def test_nonsense_is_refused_and_changes_nothing(given):
    world, body = pair(2.0)
    before = world.bodies.inverse_masses[body], world.shapes.densities.tolist()
    with pytest.raises(ValueError, match=next(iter(given))):
        world.set_material(body, **given)
    assert (world.bodies.inverse_masses[body], world.shapes.densities.tolist()) == before
