"""The surface between rooms: distances, velocities, pushes, heat; fields, exits, ledger, key frames."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely

from game.physics.particles.solids import Discs
from game.physics.solids import Capsule, Chain, Disc, Polygon, SolidSettings, SolidWorld, box
from game.physics.spheres.spheres import SphereBodies
from game.physics.surfaces import (
    BallSurface,
    ConstantField,
    DiscSurface,
    Exits,
    FunctionField,
    GridField,
    KeyFrames,
    Ledger,
    SolidSurface,
    SphereSurface,
)
from game.physics.surfaces.ledger import Entry
from game.physics.surfaces.surface import ROOM_TEMPERATURE

POINTS = np.random.default_rng(4).uniform(-3.0, 3.0, (400, 2))


def one_body(shape, **more):
    world = SolidWorld(SolidSettings(gravity=(0.0, 0.0)))
    return world, world.add_body(shape, (0.3, -0.2), 0.7, **more)


@pytest.mark.parametrize(
    "shape",
    [
        Disc(0.8),
        Capsule((-0.7, 0.1), (0.6, 0.0), 0.3),
        box(1.5, 0.7),
        box(1.5, 0.7, 0.1),
        Polygon([(0, 0), (2, 0.3), (0.5, 1.5)]),
    ],
)
def test_distance_is_that_of_the_outline(shape):
    """Against shapely: outside everywhere, and the sign inside."""
    world, _ = one_body(shape)
    corners = world.corners(0)
    core = (
        shapely.Point(corners[0]) if len(corners) == 1 else shapely.convex_hull(shapely.MultiPoint(corners))
    )
    radius = float(world.shapes.radii[0])
    found = SolidSurface(world).sample(POINTS)
    exact = np.array([core.distance(shapely.Point(point)) for point in POINTS])
    outside = exact > 1e-9
    assert found.distance[outside] == pytest.approx(exact[outside] - radius, abs=1e-12)
    assert (found.distance[~outside] <= -radius + 1e-12).all()
    walked = POINTS[outside] - (found.distance[outside] + radius)[:, None] * found.normal[outside]
    assert max(core.distance(shapely.Point(point)) for point in walked) < 1e-9


def test_velocity_is_that_of_the_turning_body():
    world, body = one_body(box(1.0, 1.0), velocity=(1.0, 2.0), spin=3.0)
    found = SolidSurface(world).sample([(1.0, 0.5)])
    x, y = world.bodies.positions[body]
    assert found.velocity[0] == pytest.approx([1.0 - 3.0 * (0.5 - y), 2.0 + 3.0 * (1.0 - x)])
    assert found.body[0] == body
    assert found.friction[0] == 0.6


def test_a_chain_is_solid_behind_and_the_nearest_body_answers():
    world = SolidWorld(SolidSettings())
    ground = world.add_body(Chain([(-5.0, 0.0), (5.0, 0.0)]), kind="fixed")
    ball = world.add_body(Disc(0.5), (0.0, 2.0))
    found = SolidSurface(world).sample([(1.0, 0.25), (1.0, -0.25), (0.0, 1.4)])
    assert found.distance == pytest.approx([0.25, -0.25, 0.1])
    assert found.normal == pytest.approx(np.array([[0.0, 1.0], [0.0, 1.0], [0.0, -1.0]]))
    assert found.body.tolist() == [ground, ground, ball]


def test_a_push_changes_momentum_by_the_impulse_and_heat_warms():
    world, body = one_body(box(1.0, 2.0))
    surface = SolidSurface(world)
    inverse, inverse_inertia, centre = surface.inverse_mass(body)
    assert (inverse, inverse_inertia) == pytest.approx((0.5, 12.0 / (2.0 * 5.0)))
    surface.push(body, (centre[0] + 0.5, centre[1]), (0.0, 4.0))
    assert world.bodies.velocities[body] == pytest.approx([0.0, 2.0])
    assert world.bodies.spins[body] == pytest.approx(2.0 * inverse_inertia)
    surface.heat(body, 900.0 * 2.0 * 5.0)
    assert surface.sample([centre]).temperature[0] == pytest.approx(ROOM_TEMPERATURE + 5.0)
    with pytest.raises(ValueError, match="joule"):
        surface.heat(body, -1e9)


def test_discs_spheres_and_balls_speak_it_too():
    discs = Discs()
    discs.add((1.0, 0.0), 0.5)
    spheres = SphereBodies([(1.0, 0.0)], [0.5], [(0.0, 2.0)], masses=[2.0], inertias="solid")
    struck = []
    balls = BallSurface(
        lambda: (np.array([[1.0, 0.0]]), np.array([[0.0, 2.0]])),
        lambda ball, j: struck.append((ball, j)),
        0.5,
        2.0,
    )
    for surface in (DiscSurface(discs), SphereSurface(spheres), balls):
        found = surface.sample([(3.0, 0.0), (1.0, 0.2)])
        assert found.distance == pytest.approx([1.5, -0.3])
        assert found.normal == pytest.approx(np.array([[1.0, 0.0], [0.0, 1.0]]))
        surface.push(0, (1.5, 0.0), (0.0, 1.0))
    assert discs.impulses[0] == pytest.approx([0.0, 1.0])
    assert spheres.velocities[0, :2] == pytest.approx([0.0, 2.5])
    assert spheres.turning[0, 2] == pytest.approx(0.5 / (0.4 * 2.0 * 0.25))
    assert struck[0][0] == 0
    assert balls.inverse_mass(0)[0] == 0.5
    assert DiscSurface(discs).inverse_mass(0)[:2] == (0.0, 0.0)


def test_fields_constant_by_formula_and_on_a_grid():
    assert ConstantField((1.0, 2.0)).sample(POINTS[:3]).tolist() == [[1.0, 2.0]] * 3
    plane = FunctionField(lambda places, time: 2.0 * places[:, 0] - places[:, 1] + time)
    x, y = np.meshgrid(np.linspace(-4, 4, 9), np.linspace(-4, 4, 9))
    grid = GridField(2.0 * x - y, (-4.0, -4.0), 1.0)
    assert grid.sample(POINTS) == pytest.approx(plane.sample(POINTS))
    assert grid.sample([(99.0, 0.0)])[0, 0] == pytest.approx(8.0)
    with pytest.raises(ValueError, match="spacing"):
        GridField(np.zeros((3, 3)), (0.0, 0.0), 0.0)


def test_exits_are_taken_once():
    exits = Exits()
    exits.add("hit", (1.0, 2.0), (3.0, 4.0), 0.5, heat=7.0, time=0.01, body=3)
    taken = exits.take()
    assert (taken.mass[0], taken.body[0], taken.position[0].tolist()) == (0.5, 3, [1.0, 2.0])
    assert len(exits.take().mass) == 0
    with pytest.raises(ValueError, match="reason"):
        exits.add("lost", (0, 0), (0, 0), 1.0)


def test_the_ledger_closes_over_two_rooms():
    ledger = Ledger()
    ledger.open_book({"water": Entry(10.0, 1.0), "spray": Entry(1.0, 2.0)})
    ledger.bring(Entry(0.0, 0.5))
    assert ledger.open_share({"water": Entry(10.5, 3.0), "spray": Entry(0.5, 0.5)}) == Entry()
    assert ledger.open_share({"water": Entry(10.5), "spray": Entry(0.5)}).momentum_x == -3.5


def test_a_key_framed_body_follows_its_curve_and_is_handed_over_in_mid_swing():
    world = SolidWorld(SolidSettings())
    body = world.add_body(box(1.0, 0.2), (2.0, 0.0))
    keys = KeyFrames(world, body, lambda t: (2.0 * math.cos(t), 2.0 * math.sin(t), t))
    dt = 1.0 / 60.0
    for k in range(30):
        keys.lead(k * dt, dt)
        world.step(dt)
    assert world.bodies.positions[body] == pytest.approx(
        [2.0 * math.cos(0.5), 2.0 * math.sin(0.5)], abs=1e-12
    )
    before = [*world.bodies.positions[body], world.bodies.angles[body], *world.bodies.velocities[body]]
    before.append(world.bodies.spins[body])
    keys.let_go()
    after = [*world.bodies.positions[body], world.bodies.angles[body], *world.bodies.velocities[body]]
    after.append(world.bodies.spins[body])
    assert before == after
    world.step(dt)
    drop = world.bodies.velocities[body] - before[3:5]
    assert drop == pytest.approx([0.0, -9.81 * dt], abs=1e-12)
