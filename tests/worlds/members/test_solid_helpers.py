"""What worlds of solids share: ropes, walls, momentum, energy, drag; and tools that take solids."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest

from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY
from game.physics.solids import Disc, Material, box
from game.physics.solids.effects import CONTACTS, FRICTION, JOINTS
from game.scenes.trebuchet.parameters import TrebuchetParameters
from game.worlds.members import solids
from game.worlds.members.solids import Solids
from game.worlds.painting.boards import beams


@pytest.fixture
def member() -> Solids:
    return Solids(TrebuchetParameters(), EffectSet([GRAVITY, CONTACTS, FRICTION, JOINTS]))


def test_a_rope_has_its_length_and_its_mass(member: Solids) -> None:
    world, ends = member.world, [member.world.add_body(box(0.2, 0.2), at) for at in ((1.0, -2.0), (4.0, 2.0))]
    found = member.hang_rope((ends[0], ends[1]), (1.0, -2.0), (4.0, 2.0), 5, 0.7)
    assert (len(found.bodies), len(found.joints)) == (4, 5)
    assert 1.0 / world.bodies.inverse_masses[found.bodies] == pytest.approx(0.7, rel=1e-9)
    chain = [ends[0], *found.bodies, ends[1]]
    assert world.joints.bodies[found.joints].tolist() == [list(pair) for pair in itertools.pairwise(chain)]
    assert world.bodies.positions[found.bodies] == pytest.approx(
        np.array([(1.6, -1.2), (2.2, -0.4), (2.8, 0.4), (3.4, 1.2)])
    )


def test_a_rope_holds_what_hangs_on_it(member: Solids) -> None:
    world, anchor = member.world, member.anchor()
    weight = world.add_body(Disc(0.3, material=Material(100.0)), (0.0, -2.0))
    member.hang_rope((anchor, weight), (0.0, 0.0), (0.0, -2.0), 4, 0.5)
    for _ in range(240):
        world.step(1.0 / 120.0)
    assert world.bodies.positions[weight] == pytest.approx((0.0, -2.0), abs=1e-3)


def test_courses_of_a_wall_are_as_long_as_one_another(member: Solids) -> None:
    bodies, sizes = member.lay_courses(5.0, (4, 3), (0.8, 0.5), Material(700.0))
    places = member.world.bodies.positions[bodies]
    assert len(bodies) == 3 + 4 + 3 + 4 + 2
    for row in range(4):
        own = np.isclose(places[:, 1], (row + 0.5) * 0.5)
        left, right = places[own, 0] - 0.5 * sizes[own, 0], places[own, 0] + 0.5 * sizes[own, 0]
        assert (left.min(), right.max()) == pytest.approx((5.0, 5.0 + 3 * 0.8))
        assert np.sort(left)[1:] == pytest.approx(np.sort(right)[:-1])
    top = places[np.isclose(places[:, 1], 2.25)]
    assert top[:, 0] == pytest.approx([5.4, 7.0])
    masses = 1.0 / member.world.bodies.inverse_masses[bodies]
    assert masses == pytest.approx(700.0 * sizes.prod(axis=1))


def test_momentum_and_energy_of_some_bodies(member: Solids) -> None:
    world = member.world
    one = world.add_body(box(1.0, 1.0, material=Material(2.0)), (0.0, 3.0), 0.0, (1.5, -1.0), 0.5)
    other = world.add_body(box(1.0, 1.0, material=Material(4.0)), (5.0, 1.0), 0.0, (-1.0, 0.0))
    both = np.array([one, other])
    assert solids.momentum(world, both) == pytest.approx(2.0 * 1.5 - 4.0)
    spin = 0.5 * (2.0 / 6.0) * 0.25
    assert solids.energy(world, both) == pytest.approx(
        0.5 * 2.0 * 3.25 + spin + 0.5 * 4.0 + 9.81 * (2.0 * 3.0 + 4.0)
    )
    assert solids.energy(world, both) == pytest.approx(world.energy().total)


def test_a_sphere_falls_at_its_terminal_speed(member: Solids) -> None:
    """sqrt(2 m g / (c rho A)) downwards: it stays there."""
    world, radius, mass = member.world, 0.3, 5.0
    body = world.add_body(Disc(radius, material=Material(mass / (math.pi * radius**2))), (0.0, 100.0))
    terminal = math.sqrt(2.0 * mass * 9.81 / (0.47 * 1.2 * math.pi * radius**2))
    world.set_velocity(body, (0.0, -terminal))
    for _ in range(60):
        solids.drag_sphere(world, body, radius)
        world.step(1.0 / 240.0)
    assert world.bodies.velocities[body] == pytest.approx((0.0, -terminal), rel=1e-6, abs=1e-9)


def test_beams_reach_from_end_to_end() -> None:
    corners = beams(np.array([[(0.0, 0.0), (3.0, 4.0)]]), 0.5)
    assert corners.mean(axis=0) == pytest.approx((1.5, 2.0))
    sides = np.hypot(*np.diff(np.concatenate([corners, corners[:1]]), axis=0).T)
    assert sides == pytest.approx([5.0, 0.5, 5.0, 0.5])
