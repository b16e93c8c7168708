"""No solver runs away: heaps that begin overlapping, a cradle, and what happens if one does all the same."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.solids import (
    SOLVERS,
    SUGGESTED,
    Capsule,
    Disc,
    Material,
    RunawayError,
    SolidSettings,
    SolidWorld,
    box,
)
from game.physics.solids.effects import SLEEP, USUAL
from game.physics.solids.solvers import sequential_impulses
from tests.physics.solids.setups import G, floor_world

FRAME = 1.0 / 60.0
MANY_POINTS = [name for name in SOLVERS if name != "complementarity"]  # which takes 60 points of contact


def crowd(seed, solver, overlapping, restitution):
    """60 bodies between walls, many of them in each other, or 40 that are apart."""
    rng = np.random.default_rng(seed)
    material = Material(friction=0.5, restitution=restitution)
    world, _ = floor_world(material, solver=solver, **SUGGESTED.get(solver, {}))
    for x in (-4.5, 4.5):
        world.add_body(box(1.0, 40.0, material=material), (x, 20.0), kind="fixed")
    count, across, apart = (60, 8, 0.7) if overlapping else (40, 5, 1.3)
    for k in range(count):
        size = 10.0 ** rng.uniform(-0.6, 0.0)
        shape = (
            box(size, size * rng.uniform(0.2, 1.0), material=material),
            Disc(0.5 * size, material=material),
            Capsule((-0.3 * size, 0.0), (0.3 * size, 0.0), 0.2 * size, material=material),
        )[k % 3]
        place = ((k % across - 0.5 * (across - 1)) * apart, 1.0 + apart * (k // across))
        world.add_body(shape, place, rng.uniform(0, 6), rng.uniform(-1.0, 1.0, 2), rng.uniform(-3, 3))
    return world


@pytest.mark.parametrize("restitution", [0.0, 0.3, 1.0])
@pytest.mark.parametrize("overlapping", [True, False])
@pytest.mark.parametrize("solver", MANY_POINTS)
def test_a_crowd_stays_below_the_energy_that_it_began_with(solver, overlapping, restitution):
    """What overlap drives apart at the start is the 0.1 above it."""
    for seed in range(4):
        world = crowd(seed, solver, overlapping, restitution)
        start = world.energy().total
        for _ in range(180):
            world.step(FRAME)
            assert world.energy().total < 1.1 * start, (seed, world.steps)


@pytest.mark.parametrize("solver", SOLVERS)
def test_a_cradle_is_no_faster_than_what_it_fell_from(solver):
    """Five balls on rods, two of them lifted by 45 degrees: sqrt(2 g L (1 - cos 45))."""
    material, length, swing = Material(density=8.0, friction=0.0, restitution=1.0), 3.0, math.radians(45.0)
    settings = SolidSettings(solver=solver, effects=USUAL.without(SLEEP), **SUGGESTED.get(solver, {}))
    world = SolidWorld(settings)
    ground = world.add_body(Disc(0.01, material=Material(mask=0, category=0)), kind="fixed")
    for k in range(5):
        x, turn = 0.608 * (k - 2), -swing if k < 2 else 0.0
        place = (x + length * math.sin(turn), 4.0 - length * math.cos(turn))
        ball = world.add_body(Disc(0.3, material=material), place)
        world.add_joint("distance", ground, ball, (x, 4.0), place)
    most = math.sqrt(2.0 * G * length * (1.0 - math.cos(swing)))
    for _ in range(3000):
        world.step(0.001)
        assert np.abs(world.bodies.velocities).max() < 1.01 * most


def test_a_solver_that_runs_away_is_stopped_and_named(monkeypatch):
    def solve(bodies, contacts, rows, joints, scratch, numbers):
        scratch.motion[1, 0] = 3e7

    monkeypatch.setitem(SOLVERS, "sequential-impulses", sequential_impulses.lean_kernel(solve))
    world, _ = floor_world(solver="sequential-impulses")
    world.add_body(Disc(0.1), (0.0, 5.0))
    with pytest.raises(
        RunawayError, match=r"body 1: 3e\+07 m/s after step 1: the solver sequential-impulses runs away"
    ):
        world.step(FRAME)


@pytest.mark.timeout(600)
def test_boxes_of_any_size_are_paired_in_no_time():
    """They grow with speed: a walk through all cells of the largest would not come to an end."""
    world = SolidWorld(SolidSettings(gravity=(0.0, 0.0)))
    bodies = [world.add_body(box(1.0, 1.0), (3.0 * k, 0.0)) for k in range(20)]
    world.bodies.velocities[bodies[3]] = 1e18, 0.0
    with pytest.raises(RunawayError, match=r"body 3: 1e\+18 m/s"):
        world.step(FRAME)
    meeting = (world.contacts.bodies == bodies[3]).any(axis=1)
    assert int(meeting.sum()) == 19
