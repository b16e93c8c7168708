"""Boxes to try broad phases on: inside the world, as dense as asked for."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.broadphase import UniformGrid
from game.physics.broadphase.motion import BOUNDARY_BIT, MOTION_BIT, move_boxes_kernel
from game.physics.broadphase.workloads import WORKLOADS, expected_pairs, make_boxes


@pytest.mark.parametrize("kind", WORKLOADS)
def test_boxes_lie_in_the_world_and_move_at_the_speed_asked_for(kind):
    boxes = make_boxes(kind, 400, np.random.default_rng(1), extent=(3.0, 2.0), speed=0.5)
    assert (boxes.lowers >= -1e-12).all() and (boxes.uppers <= np.array([3.0, 2.0]) + 1e-12).all()
    assert np.allclose(np.hypot(*boxes.velocities.T), 0.5, rtol=8 * np.finfo(float).eps)
    again = make_boxes(kind, 400, np.random.default_rng(1), extent=(3.0, 2.0), speed=0.5)
    assert all(np.array_equal(a, b) for a, b in zip(boxes, again, strict=True))


def test_bad_numbers_are_refused():
    generator = np.random.default_rng(0)
    for words in (
        {"kind": "odd"},
        {"count": -1},
        {"fill": 0.0},
        {"fill": math.nan},
        {"extent": (0.0, 1.0)},
        {"share": 2.0},
        {"speed": math.inf},
        {"ratio": -2.0},
    ):
        with pytest.raises(ValueError):
            make_boxes(**{"kind": "equal", "count": 5, "generator": generator, **words})
    assert len(make_boxes("equal", 0, generator).centers) == 0


def test_the_mean_number_of_pairs_is_as_derived():
    assert math.isclose(expected_pairs(1000, 0.02), 815.257196215446, rel_tol=1e-12)
    counts = []
    for seed in range(60):
        lowers = np.random.default_rng(seed).random((1000, 2)) * 0.98
        grid = UniformGrid((0.0, 0.0), (1.0, 1.0), 0.02)
        grid.add_boxes(lowers, lowers + 0.02)
        counts.append(len(grid.pairs()))
    assert abs(np.mean(counts) - expected_pairs(1000, 0.02)) < 4.0 * np.std(counts) / math.sqrt(60)


def moved(center, velocity, mask=MOTION_BIT | BOUNDARY_BIT, growth=0.0, steps=1):
    lowers, uppers = np.array([center]) - 0.125, np.array([center]) + 0.125
    velocities, growing = np.array([velocity]), np.array([growth])
    alive = np.ones(1, dtype=np.uint8)
    for _ in range(steps):
        world = np.zeros(2), np.ones(2)
        move_boxes_kernel(mask)(lowers, uppers, velocities, growing, alive, *world, 0.5)
    return ((lowers + uppers) / 2)[0].tolist(), velocities[0].tolist(), (uppers - lowers)[0].tolist()


def test_a_step_is_explicit_euler():
    assert moved([0.5, 0.5], [0.25, -0.125]) == ([0.625, 0.4375], [0.25, -0.125], [0.25, 0.25])
    assert moved([0.5, 0.5], [0.25, -0.125], BOUNDARY_BIT)[:2] == ([0.5, 0.5], [0.25, -0.125])


def test_velocity_is_negated_beyond_the_boundary_and_only_on_the_way_out():
    assert moved([0.75, 0.5], [1.0, 0.0])[:2] == ([1.25, 0.5], [-1.0, 0.0])
    assert moved([1.25, 0.5], [-0.125, 0.0])[:2] == ([1.1875, 0.5], [-0.125, 0.0])
    assert moved([0.25, 0.25], [-1.0, -1.0])[:2] == ([-0.25, -0.25], [1.0, 1.0])
    assert moved([0.75, 0.5], [1.0, 0.0], MOTION_BIT)[:2] == ([1.25, 0.5], [1.0, 0.0])
    assert moved([0.5, 0.5], [1.0, 0.0], steps=400)[0][0] <= 1.5


def test_a_box_grows_until_it_fills_the_world_and_shrinks_until_it_is_nearly_gone():
    sizes = [moved([0.5, 0.5], [0.0, 0.0], growth=0.0625, steps=n)[2][0] for n in range(60)]
    assert sizes[:4] == [0.25, 0.3125, 0.375, 0.4375]
    assert max(sizes) == 1.0625 and min(sizes) >= 0.0 and sizes.count(max(sizes)) >= 1
    assert sizes[-1] != max(sizes)


def test_dead_boxes_stay_where_they_are():
    lowers, uppers = np.zeros((2, 2)), np.ones((2, 2))
    velocities, alive = np.ones((2, 2)), np.array([0, 1], dtype=np.uint8)
    world = np.zeros(2), np.ones(2)
    move_boxes_kernel(MOTION_BIT | BOUNDARY_BIT)(lowers, uppers, velocities, np.zeros(2), alive, *world, 0.5)
    assert lowers.tolist() == [[0.0, 0.0], [0.5, 0.5]] and velocities.tolist() == [[1.0, 1.0], [-1.0, -1.0]]


def test_the_power_law_has_a_true_heavy_tail():
    """Above s there are as many as (1/s - 1/ratio) / (1 - 1/ratio) says, on every scale."""
    count, ratio = 20_000, 64.0
    boxes = make_boxes("power-law", count, np.random.default_rng(4), (11.2, 8.0), 0.02, ratio=ratio)
    sizes = 2.0 * boxes.half_sizes[:, 0]
    sizes /= sizes.max() / ratio
    assert (np.diff(sizes) <= 0.0).all()  # the largest first, so that smaller ones are drawn above
    for least in (2.0, 4.0, 8.0, 16.0, 32.0):
        share = (1.0 / least - 1.0 / ratio) / (1.0 - 1.0 / ratio)
        spread = math.sqrt(share * (1.0 - share) * count)
        assert abs(np.count_nonzero(sizes > least) - share * count) < 4.0 * spread + 0.02 * share * count
