"""Chains of one-sided segments: nothing is felt where segments meet; ends, ridges and valleys carry."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.solids import Capsule, Chain, Disc, Material, SolidSettings, SolidWorld, box
from tests.physics.solids.setups import run

SMOOTH = Material(friction=0.0)


def level_chain(uneven):
    """A line of 120 m in 200 pieces, equal or 0.1 mm to 3 m long; its free side is above."""
    rng = np.random.default_rng(1)
    steps = 10.0 ** rng.uniform(-4, 0.5, 200) if uneven else np.ones(200)
    x = -60.0 + 120.0 * np.concatenate([[0.0], np.cumsum(steps) / steps.sum()])
    return Chain(np.stack([x, np.zeros_like(x)], axis=1), material=SMOOTH)


def world_on(chain):
    """A world on a fixed chain."""
    world = SolidWorld(SolidSettings())
    world.add_body(chain, kind="fixed")
    return world


@pytest.mark.parametrize("uneven", [False, True])
@pytest.mark.parametrize("shape", [box(1.0, 1.0, material=SMOOTH), Disc(0.5, material=SMOOTH)])
def test_sliding_over_pieces_of_a_line_keeps_the_speed(shape, uneven):
    world = world_on(level_chain(uneven))
    body = world.add_body(shape, (-40.0, 0.5), velocity=(5.0, 0.0))
    heights = []
    for _ in range(600):
        world.step(1.0 / 60.0)
        heights.append(world.bodies.positions[body, 1])
    assert world.bodies.velocities[body, 0] == pytest.approx(5.0, rel=1e-7)
    assert world.bodies.angles[body] == pytest.approx(0.0, abs=1e-4)  # a joint halves the stiffness under it
    assert np.ptp(heights[60:]) < 2e-3
    assert min(heights) > 0.49


def test_boxes_slide_over_equal_tiles():
    """A hundred separate tiles: no hop, no loss."""
    world = SolidWorld(SolidSettings())
    for k in range(100):
        world.add_body(box(1.0, 1.0, material=SMOOTH), (k - 50.0, -0.5), kind="fixed")
    body = world.add_body(box(1.0, 1.0, material=SMOOTH), (-40.0, 0.5), velocity=(5.0, 0.0))
    run(world, 14.0)
    assert world.bodies.velocities[body, 0] == pytest.approx(5.0, rel=1e-3)
    assert abs(world.bodies.positions[body, 1] - 0.5) < 5e-3


def test_a_disc_rests_in_a_valley_and_on_a_ridge():
    chain = Chain([(-4.0, 4.0), (0.0, 0.0), (4.0, 4.0)])
    world = SolidWorld(SolidSettings())
    world.add_body(chain, kind="fixed")
    body = world.add_body(Disc(0.5), (0.0, 1.5))
    run(world, 4.0)
    assert world.bodies.positions[body] == pytest.approx([0.0, 0.5 * np.sqrt(2.0)], abs=5e-3)
    ridge = SolidWorld(SolidSettings(gravity=(0.0, -9.81)))
    ridge.add_body(Chain([(-4.0, -4.0), (0.0, 0.0), (4.0, -4.0)]), kind="fixed")
    ball = ridge.add_body(Disc(0.5), (0.0, 0.5))
    run(ridge, 0.5)
    assert ridge.bodies.positions[ball] == pytest.approx([0.0, 0.5], abs=5e-3)


@pytest.mark.parametrize(
    ("shape", "height"),
    [(box(1.0, 1.0), 0.5), (Capsule((-0.5, 0.0), (0.5, 0.0), 0.2), 0.2), (box(0.6, 0.6, 0.1), 0.3)],
)
def test_shapes_rest_on_a_chain_across_a_joint(shape, height):
    world = world_on(Chain([(-10.0, 0.0), (0.0, 0.0), (10.0, 0.0)]))
    body = world.add_body(shape, (0.1, height + 0.2))
    run(world, 3.0)
    assert world.bodies.positions[body] == pytest.approx([0.1, height], abs=3e-3)
    assert world.bodies.angles[body] == pytest.approx(0.0, abs=1e-4)


def test_a_chain_is_passed_from_behind_and_held_from_the_front():
    world = SolidWorld(SolidSettings())
    world.add_body(Chain([(-5.0, 0.0), (5.0, 0.0)]), kind="fixed")
    below = world.add_body(Disc(0.2), (-2.0, -1.0), velocity=(0.0, 8.0))
    above = world.add_body(Disc(0.2), (2.0, 1.0))
    run(world, 0.5)
    assert world.bodies.positions[below, 1] > 0.5
    run(world, 2.5)
    assert world.bodies.positions[above, 1] == pytest.approx(0.2, abs=3e-3)
    assert world.bodies.positions[below, 1] == pytest.approx(0.2, abs=3e-3)


def test_the_ends_of_an_open_chain_carry():
    world = SolidWorld(SolidSettings())
    world.add_body(Chain([(-1.0, 0.0), (1.0, 0.0)]), kind="fixed")
    body = world.add_body(box(1.0, 0.4), (1.2, 0.2))  # its middle is beyond the end: it tips over the end
    other = world.add_body(box(1.0, 0.4), (-0.8, 0.2))  # its middle is within: it stays
    run(world, 1.0)
    assert world.bodies.positions[body, 1] < -0.5
    assert world.bodies.positions[other] == pytest.approx([-0.8, 0.2], abs=3e-3)


def test_a_disc_falls_into_a_closed_chain_and_stays():
    angles = np.linspace(0.0, 2.0 * np.pi, 60, endpoint=False)  # anticlockwise: free inside
    ring = np.stack([np.cos(angles), np.sin(angles)], axis=1) * 3.0
    world = SolidWorld(SolidSettings())
    world.add_body(Chain(ring, closed=True), kind="fixed")
    body = world.add_body(Disc(0.3), (1.0, 0.0))
    run(world, 10.0)
    assert np.hypot(*world.bodies.positions[body]) == pytest.approx(2.7, abs=0.02)
