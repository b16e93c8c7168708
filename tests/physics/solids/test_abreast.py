"""Contacts eight at a time give the bits of contacts one by one."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.kernels.lanes import LANES
from game.physics.kernels.lean import lean_kernel
from game.physics.solids import Capsule, Disc, SolidSettings, SolidWorld, box
from game.physics.solids.rows import CHILLED, FIRST, SECOND, SINGLE, copy_rows
from game.physics.solids.solvers.abreast import put_back, sweep_batches, take_impulses, warm_batches
from game.physics.solids.solvers.impulses import soft_springs, start_warm, sweep_contacts
from game.physics.solids.solvers.motion import accelerate, move
from game.physics.solids.state import (
    END_A,
    END_B,
    END_POINTS,
    IMPACT,
    JN,
    JT,
    ROW_HARD,
    ROW_IIA,
    ROW_IMA,
    ROW_IMB,
    ROW_MU,
    ROW_WIDTH,
    SEP,
)
from game.physics.solids.stepping import begin_step

FRAME = 1.0 / 60.0


@lean_kernel
def begin(bodies, shapes, pool, contacts, rows, joints, scratch, numbers):
    begin_step(bodies, shapes, pool, contacts, rows, joints, scratch, numbers)
    copy_rows(rows, scratch.batches)


@lean_kernel
def one_by_one(rows, scratch, numbers):
    springs = soft_springs(numbers)
    for _ in range(numbers.substeps):
        accelerate(scratch, numbers)
        start_warm(rows, scratch.motion)
        sweep_contacts(rows, scratch.motion, springs, True, False)
        move(scratch.motion, numbers.h)
        sweep_contacts(rows, scratch.motion, springs, False, True)


@lean_kernel
def abreast(rows, scratch, numbers, anew):
    springs, batches = soft_springs(numbers), scratch.batches
    for _ in range(numbers.substeps):
        accelerate(scratch, numbers)
        warm_batches(batches, scratch.motion)
        sweep_batches(batches, scratch.motion, springs, True, anew)
        move(scratch.motion, numbers.h)
        sweep_batches(batches, scratch.motion, springs, False, True)
        if anew:
            put_back(rows, batches)
            take_impulses(rows, batches)
    copy_rows(rows, batches)


def heap(seed, count=40, shapes=3):
    """Boxes, discs and capsules (so many of these kinds) that fall onto a floor and onto a turning plank."""
    random, world = np.random.default_rng(seed), SolidWorld(SolidSettings())
    world.add_body(box(30.0, 1.0), (0.0, -0.5), kind="fixed")
    plank = world.add_body(box(6.0, 0.5), (0.0, 2.0), kind="key-framed")
    world.set_velocity(plank, (0.2, 0.0), 0.4)
    for k in range(count):
        width, height = random.uniform(0.3, 1.2, 2)
        shape = (box(width, height), Disc(0.5 * width), Capsule((0.0, 0.0), (width, 0.0), 0.3 * height))[
            k % shapes
        ]
        world.add_body(shape, (random.uniform(-4.0, 4.0), 1.0 + 0.4 * k), random.uniform(0.0, math.pi))
    return world


def begun(world):
    """A world in the middle of a step, with its rows: what kernels take."""
    numbers = world._numbers
    parts = world._bodies.rows, world._shapes.rows, world._pool.rows
    world._renew()
    begin(*parts, world._contacts, world._rows, world._joints.rows, world._scratch, numbers)
    return world._rows, world._scratch, numbers


@pytest.mark.parametrize("anew", [False, True])
def test_sweeps_over_batches_give_the_bits_of_sweeps_over_rows(anew):
    kinds, singles, hits = set(), 0, 0
    for seed in range(3):
        world = heap(seed, shapes=3 - seed)
        for stop in (20, 25, 90):
            for _ in range(stop):
                world.step(FRAME)
            rows, scratch, numbers = begun(world)
            count = int(rows.count[0])
            motion, row, rare = scratch.motion.copy(), rows.rows.copy(), rows.rare.copy()
            one_by_one(rows, scratch, numbers)
            expected = scratch.motion.copy(), rows.rows[:count].copy(), rows.rare[:count].copy()
            scratch.motion[:], rows.rows[:], rows.rare[:] = motion, row, rare
            abreast(rows, scratch, numbers, anew)
            np.testing.assert_array_equal(scratch.motion, expected[0])
            two = rows.ends[:count, END_POINTS] == 2
            np.testing.assert_array_equal(rows.rows[:count][two], expected[1][two])
            np.testing.assert_array_equal(rows.rows[:count, :SECOND], expected[1][:, :SECOND])
            np.testing.assert_array_equal(rows.rare[:count], expected[2])
            assert not np.array_equal(scratch.motion, motion)
            kinds |= set((scratch.batches.kinds[: scratch.batches.count[0]] & (SINGLE | CHILLED)).tolist())
            singles, hits = singles + int((~two).sum()), hits + int(rows.rare[:count, IMPACT].sum())
    assert singles > 0 and hits > 0 and {0, SINGLE, SINGLE | CHILLED} <= kinds


def test_no_moving_body_is_twice_in_a_batch_and_every_row_is_in_one():
    world = heap(5, 80)
    hub = world.add_body(Disc(2.0), (8.0, 4.0))
    for angle in np.linspace(0.0, 2.0 * math.pi, 30)[:-1]:  # more than there are colours
        world.add_body(Disc(0.2), (8.0 + 2.19 * math.cos(angle), 4.0 + 2.19 * math.sin(angle)))
    for _ in range(3):
        world.step(FRAME)
    rows, scratch, _ = begun(world)
    batches, seen, most = scratch.batches, [], 0
    for k in range(int(batches.count[0])):
        filled = int(batches.filled[k])
        own = batches.rows[k, :filled]
        seen += own.tolist()
        most = max(most, filled)
        for end, mass in ((END_A, ROW_IMA), (END_B, ROW_IMB)):
            np.testing.assert_array_equal(batches.ends[k, end, :filled], rows.ends[own, end])
            np.testing.assert_array_equal(batches.ends[k, end, filled:], rows.ends[own[0], end])
            assert not batches.values[k, mass, filled:].any()
        assert not batches.values[k, ROW_IIA, filled:].any()
        moving = [int(b) for c in own for b in rows.ends[c, :2] if world.bodies.inverse_masses[b] > 0.0]
        assert len(moving) == len(set(moving)), k
        np.testing.assert_array_equal(batches.values[k, :SECOND, :filled].T, rows.rows[own, :SECOND])
    assert seen == list(range(int(rows.count[0])))
    assert most == LANES and np.count_nonzero(rows.ends[: len(seen), :2] == hub) > 23


def test_rows_of_one_point_have_a_second_one_that_does_nothing():
    world = SolidWorld(SolidSettings())
    world.add_body(box(10.0, 1.0), (0.0, -0.5), kind="fixed")
    for k in range(11):
        world.add_body(box(0.4, 0.4) if k % 2 else Disc(0.2), (0.5 * k - 2.5, 0.2))
    for _ in range(5):
        world.step(FRAME)
    rows, _, _ = begun(world)
    single = np.flatnonzero(rows.ends[: rows.count[0], END_POINTS] == 1)
    assert len(single) == 6 and rows.count[0] == 11
    second = rows.rows[single, SECOND:ROW_WIDTH]
    second[:, 5] -= 1.0  # one over the effective mass, which is divided by
    assert not second.any()
    assert (rows.rows[single, FIRST + JN] > 0.0).all()


def test_a_row_says_what_its_two_are():
    world = SolidWorld(SolidSettings())
    floor = world.add_body(box(10.0, 1.0), (0.0, -0.5), kind="fixed")
    lower, upper = (world.add_body(box(1.0, 0.5), (0.3, y)) for y in (0.25, 0.749))
    for _ in range(2):
        world.step(FRAME)
    rows, _, _ = begun(world)
    assert rows.count[0] == 2
    ends = [set(pair) for pair in rows.ends[:2, :2].tolist()]
    on_floor, between = ends.index({floor, lower}), ends.index({lower, upper})
    assert rows.rows[on_floor, ROW_HARD] == 1.0 and rows.rows[between, ROW_HARD] == 0.0
    assert (rows.rows[:2, ROW_MU] == world.shapes.frictions[0]).all()
    y = world.bodies.positions[:, 1]
    np.testing.assert_allclose(rows.rows[on_floor, FIRST + SEP], y[lower] - 0.25, rtol=0.0, atol=1e-12)
    np.testing.assert_allclose(
        rows.rows[between, FIRST + SEP], y[upper] - y[lower] - 0.5, rtol=0.0, atol=1e-12
    )
    weight = FRAME / 4.0 * 9.81 / world.bodies.inverse_masses[lower]
    held = rows.rows[on_floor, [FIRST + JN, SECOND + JN]].sum()
    assert 0.5 * weight < held < 4.0 * weight
    assert abs(rows.rows[on_floor, FIRST + JT]) < 0.01 * weight
