"""What a world has heard: remembered in order, forgotten in time, panned by where it was."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.solids import SolidWorld, box
from game.worlds.hearing import HEARD_SPEED, HEARD_TIME, HEARD_X, Heard, impacts, is_due, rows_of


def test_sounds_are_in_the_order_of_time_and_old_ones_go() -> None:
    heard = Heard(most=3, seconds=0.4)
    heard.remember(np.array([(0.2, 1.0, 3.0, 5.0), (0.1, 0.0, 2.0, -1.0)]), 0.1)
    assert heard.rows[:, HEARD_TIME].tolist() == [0.1, 0.2]
    heard.add(0.45, 1, 1.0, 0.0)
    heard.remember(np.array([(0.55, 0.0, 4.0, 0.0)]), 0.55)
    assert heard.rows[:, HEARD_TIME].tolist() == [0.2, 0.45, 0.55]
    heard.add(0.6, 0, 1.0, 0.0)
    assert len(heard.rows) == 3 and heard.rows[0, HEARD_TIME] == 0.45
    heard.forget(1.1)
    assert len(heard.rows) == 0


def test_what_is_beyond_the_sides_is_all_on_one() -> None:
    heard = Heard()
    for x in (-30.0, 2.0, 30.0):
        heard.add(0.0, 0, 1.0, x)
    assert [sound.pan for sound in heard.sounds({0: "wood"}, 10.0, -3.0)] == [-1.0, 0.5, 1.0]


def test_a_state_brings_it_back() -> None:
    heard = Heard()
    heard.add(0.25, 1, 2.0, 3.0)
    (rows,) = heard.state()
    kept = rows.copy()
    heard.add(0.3, 0, 1.0, 0.0)
    heard.restore(iter([kept]))
    assert heard.rows.tolist() == [[0.25, 1.0, 2.0, 3.0]]


def test_a_box_that_lands_is_heard_once_by_its_speed() -> None:
    world = SolidWorld()
    floor = world.add_body(box(20.0, 1.0), (0.0, -0.5), kind="fixed")
    fallen = world.add_body(box(1.0, 1.0), (2.0, 0.51), velocity=(0.0, -3.0))
    world.step(1.0 / 60.0)
    found = impacts(world, 1.0)
    assert len(found.rows) == 1 and sorted(found.bodies[0].tolist()) == [floor, fallen]
    sounds = found.heard(10.0, [2], found.by_impulse(1e9, 2.0))
    assert 10.0 <= sounds[0, HEARD_TIME] <= 10.0 + 1.0 / 60.0
    assert sounds[0, HEARD_SPEED] == pytest.approx(0.3 * found.rows[0, 3])  # far lighter than the reference
    assert abs(sounds[0, HEARD_X] - 2.0) <= 0.5
    assert len(impacts(world, 100.0).rows) == 0


def test_grains_of_what_goes_on_are_due_once_in_a_while() -> None:
    """In two seconds of steps of 1/60 s, one in the first step that ends beyond each 0.22 s."""
    due = [k for k in range(1, 121) if is_due(0.22, k / 60.0, 1.0 / 60.0)]
    assert due == [math.ceil(0.22 * 60.0 * k) for k in range(1, 10)]


def test_sounds_of_one_kind_have_each_its_speed_and_place() -> None:
    rows = rows_of(2.0, 3, np.array([0.5, 0.25]), np.array([-1.0, 4.0]))
    assert rows.tolist() == [[2.0, 3.0, 0.5, -1.0], [2.0, 3.0, 0.25, 4.0]]
