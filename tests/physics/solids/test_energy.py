"""Passive scenes gain no energy: random heaps, overlap at the start, bounces, and what bodies start with."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.solids import Disc, Material, SolidSettings, SolidWorld, box
from tests.physics.solids.random_scenes import GAINS_TOO_MUCH, largest_gain
from tests.physics.solids.setups import G, floor_world, run

# heaps in which a step once gained: stopped while they bounced (the first seven), woken in it (the last)
GAINED = (156, 484, 511, 739, 702, 1749, 1942, 48)


@pytest.mark.parametrize("substeps", [4, 12])
def test_random_heaps_gain_nothing_in_any_step(substeps):
    gains = [largest_gain(seed, 150, substeps=substeps).gain for seed in (*range(40), *GAINED)]
    assert max(gains) < GAINS_TOO_MUCH


def test_boxes_that_overlap_by_half_part_slowly():
    world = SolidWorld(SolidSettings(gravity=(0.0, 0.0)))
    for k in range(100):
        world.add_body(box(1.0, 1.0), (0.5 * (k % 10), 0.5 * (k // 10)))
    for _ in range(600):
        before = world.bodies.positions.copy()
        world.step(1.0 / 60.0)
        assert np.hypot(*(world.bodies.positions - before).T).max() < 3.05 / 60.0
        assert np.hypot(*world.bodies.velocities.T).max() < 2.5
    x, y = np.ptp(world.bodies.positions, axis=0)
    assert min(x, y) > 8.5  # they were 4.5 m wide, and have to be 9


def test_energy_is_that_of_motion_and_of_height():
    world, _ = floor_world()
    disc = Disc(0.5, material=Material(density=2.0))
    world.add_body(disc, (3.0, 7.0), velocity=(3.0, 4.0), spin=2.0)
    mass = 0.5 * np.pi
    energy = world.energy()
    assert energy.kinetic == pytest.approx(0.5 * mass * 25.0 + 0.5 * (0.5 * mass * 0.25) * 4.0)
    assert energy.potential == pytest.approx(mass * G * 7.0)
    assert energy.elastic == 0.0  # nothing has sunk yet
    assert energy.total == energy.kinetic + energy.potential


@pytest.mark.parametrize("e", [0.0, 0.5, 1.0])
def test_a_block_bounces_by_its_restitution_and_never_higher(e):
    material = Material(restitution=e)
    world, _ = floor_world(material, substeps=12)
    body = world.add_body(box(1.0, 0.5, material=material), (0.0, 2.25))
    before, highest, down = world.energy().total, 0.0, False
    for _ in range(120):
        world.step(1.0 / 60.0)
        now = world.energy().total
        assert now <= before * (1.0 + 1e-9)
        before, up = now, world.bodies.velocities[body, 1] > 0.0
        down = down or up or world.bodies.positions[body, 1] < 0.26
        if down:
            highest = max(highest, float(world.bodies.positions[body, 1]) - 0.25)
    assert highest == pytest.approx(2.0 * e**2, rel=0.05, abs=0.02)


def test_a_key_framed_body_gives_what_it_takes_to_push():
    """Ten boxes are pushed at 2 m/s by a wall: all end with about its speed."""
    world, _ = floor_world(Material(friction=0.0))
    wall = world.add_body(box(0.5, 2.0), (-1.0, 1.1), kind="key-framed", velocity=(2.0, 0.0))
    smooth = Material(friction=0.0)
    boxes = [world.add_body(box(1.0, 1.0, material=smooth), (0.5 + 1.1 * k, 0.5)) for k in range(10)]
    run(world, 3.0)
    assert world.bodies.velocities[wall] == pytest.approx([2.0, 0.0], abs=1e-12)
    assert world.bodies.velocities[boxes, 0] == pytest.approx([2.0] * 10, rel=0.1)
