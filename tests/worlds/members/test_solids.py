"""Solids as a member of a world: settings by what is chosen, places between two states, the nearest box."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.fields import GRAVITY
from game.physics.solids import box
from game.physics.solids.effects import USUAL
from game.stage import Param, ParameterError, Parameters
from game.worlds.members import solids
from game.worlds.members.solids import Solids, bodies_between, nearest_box, substeps_of
from game.worlds.world import World


class Chosen(Parameters):
    gravity = Param(9.81, 0.0, 30.0)
    tier = solids.choose_quality()
    substeps = solids.choose_substeps(64)
    iterations = solids.choose_iterations(50)
    solver = solids.choose_solver()


def test_what_is_chosen_is_what_the_solver_gets() -> None:
    chosen = Chosen()
    member = Solids(chosen, USUAL)
    assert member.world.settings.gravity == (0.0, -9.81) and member.world.settings.substeps == 4
    chosen.tier, chosen.substeps, chosen.iterations, chosen.gravity = "own", 7, 3, 1.5
    member.change("substeps")
    settings = member.world.settings
    assert (settings.substeps, settings.iterations, settings.gravity) == (7, 3, (0.0, -1.5))
    assert substeps_of(chosen) == 7
    member.change_effects(USUAL.without(GRAVITY))
    assert GRAVITY not in member.world.settings.effects


def test_a_value_is_refused_where_it_comes_in() -> None:
    with pytest.raises(ParameterError, match="substeps"):
        Chosen().substeps = 65


def test_places_lie_between_two_states_but_for_a_slot_that_is_another_body_now() -> None:
    member = Solids(Chosen(), USUAL)
    one = member.world.add_body(box(1.0, 1.0), (0.0, 0.0), 0.0)
    two = member.world.add_body(box(1.0, 1.0), (5.0, 0.0), 0.0)
    (before,) = member.state()
    before = before._replace(bodies=type(before.bodies)(*(np.copy(part) for part in before.bodies)))
    member.world.set_pose(one, (4.0, 2.0), 1.0)
    member.world.set_pose(two, (9.0, 0.0), 0.0)
    before.bodies.inverse_masses[two] *= 2.0
    places, angles = bodies_between(member.world, before, 0.25)
    assert places[one].tolist() == pytest.approx([1.0, 0.5]) and angles[one] == pytest.approx(0.25)
    assert places[two].tolist() == [9.0, 0.0]
    assert bodies_between(member.world, None, 0.25)[0][one].tolist() == [4.0, 2.0]


def test_the_nearest_box_is_found_as_it_is_turned() -> None:
    world = Solids(Chosen(), USUAL).world
    bodies = np.array([world.add_body(box(4.0, 1.0), (0.0, 0.0), 0.5 * math.pi),
                       world.add_body(box(1.0, 1.0), (5.0, 0.0))])  # fmt: skip
    sizes = np.array([(4.0, 1.0), (1.0, 1.0)])
    best, outside = nearest_box(world, bodies, sizes, (0.0, 1.9))
    assert best == 0 and outside == pytest.approx(-0.1)
    best, outside = nearest_box(world, bodies, sizes, (3.9, 0.0))
    assert best == 1 and outside == pytest.approx(0.6)
    assert nearest_box(world, bodies[:0], sizes[:0], (0.0, 0.0)) == (-1, math.inf)


def test_a_world_steps_its_members_in_order_and_keeps_what_they_keep() -> None:
    chosen = Chosen()
    member = Solids(chosen, USUAL)
    body = member.world.add_body(box(1.0, 1.0), (0.0, 5.0))
    world = World(None, chosen, USUAL, member)
    world.state_type = lambda *fields: fields
    (before,) = world.state()
    kept = before._replace(bodies=type(before.bodies)(*(np.copy(part) for part in before.bodies)))
    world.advance(0.1)
    assert member.world.bodies.positions[body, 1] < 5.0 and world.time == pytest.approx(0.1)
    world.restore((kept,))
    assert member.world.bodies.positions[body, 1] == 5.0
    world.change_effects(USUAL.without(GRAVITY))
    assert world.gravity() == 0.0 and GRAVITY not in member.world.settings.effects
