"""The event-driven run of smooth spheres: closed forms, invariants, time reversal."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.spheres.smooth_spheres import SmoothSpheres

G = 9.81


def crowd(seed, count=12, **more):
    random = np.random.default_rng(seed)
    places = np.array([(i % 4, i // 4) for i in range(count)]) + random.uniform(-0.2, 0.2, (count, 2))
    window = (-1, -1, 4, count // 4 + 1)
    return SmoothSpheres(places, random.normal(0, 1, (count, 2)), 0.25, window=window, **more)


def test_two_spheres_and_a_wall():
    """At 1 m/s over 2 m, to the wall and back: times by hand."""
    run = SmoothSpheres([(0, 0), (3, 0)], [(1, 0), (0, 0)], 0.5, window=(-9, -9, 5.5, 9))
    assert run.fly(1.9) == 0
    assert run.positions[0, 0] == pytest.approx(1.9)
    assert run.fly(0.2) == 1
    assert run.velocities[:, 0].tolist() == [0.0, 1.0]
    assert run.fly(4.0) == 2
    assert run.positions[:, 0] == pytest.approx([2.0 - 0.1, 3.0], abs=1e-12)


def test_a_bouncing_sphere():
    """Bounces at t, t + 2 e t, ...; height e² of the last."""
    run = SmoothSpheres([(0, 1.5)], [(0, 0)], 0.5, wall_restitution=0.8, gravity=G, window=(-9, 0, 9, 99))
    fall = math.sqrt(2 / G)
    run.fly(fall * 1.8)
    assert run.impacts == 1
    assert run.positions[0, 1] - 0.5 == pytest.approx(0.64, abs=1e-12)
    with pytest.raises(ValueError, match="do not end"):
        run.fly(fall * 20, most=500)


def test_energy_momentum_and_reversal():
    """Elastic: E stays to rounding over 200 impacts; velocities turned round lead back to the start."""
    run = crowd(3)
    start, energy = run.positions.copy(), run.energy()
    run.fly(2.0)
    assert 15 < run.impacts < 60
    run.velocities *= -1.0
    run.fly(2.0)
    assert np.abs(run.positions - start).max() < 1e-9
    run.fly(16.0)
    assert run.impacts > 200
    assert run.energy() == pytest.approx(energy, rel=1e-13)


def test_an_oblique_impact_in_space():
    """Along the line of centres the velocities of equal spheres are exchanged, across it nothing changes."""
    line = np.array([2.0, -1.0, 2.0]) / 3.0
    velocities = np.array([[3.0, 1.0, 2.0], [-1.0, 0.5, -2.0]])
    places = np.array([-0.6 * line, 0.6 * line]) - 0.1 * velocities
    run = SmoothSpheres(places, velocities, [0.6, 0.6])
    assert run.fly(0.2) == 1
    along = (velocities[1] - velocities[0]) @ line * line
    assert run.velocities == pytest.approx(velocities + np.array([along, -along]))


def test_nobody_overlaps_or_leaves():
    run = crowd(5, gravity=G, restitution=0.9, wall_restitution=0.95)
    for _ in range(40):
        run.fly(0.05)
        apart = run.positions[:, None] - run.positions[None]
        distance = np.sqrt((apart**2).sum(axis=2)) + np.eye(len(apart))
        assert distance.min() >= 0.5 * (1 - 1e-9)
        assert run.positions[:, 1].min() >= -1 + 0.25 * (1 - 1e-9)


def test_touching_spheres_and_a_fixed_one():
    cradle = SmoothSpheres([(i, 0) for i in range(4)], [(1, 0)] + [(0, 0)] * 3, 0.5)
    cradle.fly(0.5)
    assert cradle.velocities[:, 0].tolist() == [0, 0, 0, 1]
    wall = SmoothSpheres([(0, 0), (2, 0)], [(1, 0), (0, 0)], 0.5, [1.0, math.inf], gravity=0.0)
    wall.fly(2.0)
    assert wall.velocities[:, 0].tolist() == [-1.0, 0.0]


@pytest.mark.parametrize(
    "arguments",
    [
        ([], [], 1),
        ([(0, 0)], [(0, 0, 0)], 1),
        ([(0, math.nan)], [(0, 0)], 1),
        ([(0, 0)], [(0, 0)], 0),
        ([(0, 0)], [(0, 0)], 1, 0),
    ],
)
def test_nonsense_is_refused(arguments):
    with pytest.raises(ValueError, match=r"\w"):
        SmoothSpheres(*arguments)
    with pytest.raises(ValueError, match="restitution"):
        SmoothSpheres([(0, 0)], [(0, 0)], 1, restitution=1.5)
    with pytest.raises(ValueError, match="duration"):
        SmoothSpheres([(0, 0)], [(0, 0)], 1).fly(math.nan)
