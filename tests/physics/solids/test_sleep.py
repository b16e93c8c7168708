"""Islands fall asleep together and wake when they are touched, or when what carries them goes."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.solids import Disc, box
from game.physics.solids.arrays.state import ASLEEP
from game.physics.solids.effects import SLEEP, USUAL
from tests.physics.solids.setups import column, floor_world, run


def asleep(world, bodies):
    """Which of these sleep."""
    return (world.bodies.flags[bodies] & ASLEEP != 0).tolist()


def test_a_column_sleeps_and_another_that_moves_does_not():
    world, _ = floor_world()
    bodies = column(world, 5)
    ball = world.add_body(Disc(0.5), (20.0, 0.5), velocity=(3.0, 0.0), spin=-6.0)
    run(world, 4.0)
    assert asleep(world, bodies) == [True] * 5
    assert asleep(world, [ball]) == [False]
    places = world.bodies.positions[bodies].copy()
    run(world, 2.0)
    assert np.array_equal(places, world.bodies.positions[bodies])


def test_without_the_effect_nothing_sleeps():
    world, _ = floor_world(effects=USUAL.without(SLEEP))
    bodies = column(world, 3)
    run(world, 4.0)
    assert asleep(world, bodies) == [False] * 3


def test_what_is_hit_wakes_with_its_island():
    world, _ = floor_world()
    bodies = column(world, 4)
    run(world, 3.0)
    assert all(asleep(world, bodies))
    world.add_body(Disc(0.3), (-4.0, 1.5), velocity=(12.0, 3.0))
    run(world, 0.6)
    assert not any(asleep(world, bodies))
    assert np.abs(world.bodies.positions[bodies, 0]).max() > 0.05


def test_when_the_support_is_taken_away_what_slept_falls():
    world, _ = floor_world()
    shelf = world.add_body(box(4.0, 0.2), (0.0, 3.0), kind="fixed")
    bodies = [world.add_body(box(1.0, 1.0), (0.0, 3.6 + k)) for k in range(3)]
    run(world, 3.0)
    assert all(asleep(world, bodies))
    world.remove_body(shelf)
    run(world, 0.5)
    assert not any(asleep(world, bodies))
    assert world.bodies.positions[bodies[0], 1] < 2.7


def test_a_key_framed_floor_that_starts_to_move_takes_sleepers_along():
    world, _ = floor_world()
    lift = world.add_body(box(4.0, 0.2), (0.0, 3.0), kind="key-framed")
    body = world.add_body(box(1.0, 1.0), (0.0, 3.6))
    run(world, 3.0)
    assert asleep(world, [body]) == [True]
    world.set_velocity(lift, (0.0, 1.0))
    run(world, 1.0)
    assert world.bodies.positions[body, 1] == pytest.approx(4.6, abs=0.02)
    assert world.bodies.positions[lift, 1] == pytest.approx(4.0, abs=1e-9)
