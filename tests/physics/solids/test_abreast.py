"""Contacts eight at a time give the bits of contacts one by one."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.compiler.decorator import lean_kernel
from game.physics.kernels.lanes import LANES
from game.physics.solids import Capsule, Disc, Material, SolidSettings, SolidWorld, box
from game.physics.solids.arrays.state import (
    APPROACH_0,
    APPROACH_1,
    BATCH_GAP,
    DA,
    DC,
    DS,
    DX,
    DY,
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
    STIFF_N,
)
from game.physics.solids.effects import SLEEP, USUAL
from game.physics.solids.rows import (
    CHILLED,
    FIRST,
    RESTLESS,
    SECOND,
    SINGLE,
    VIOLENT,
    copy_rows,
)
from game.physics.solids.solvers.abreast import put_back, sweep_batches, take_impulses, warm_batches
from game.physics.solids.solvers.impulses import gap_now, soft_springs, start_warm, sweep_contacts
from game.physics.solids.solvers.motion import accelerate, cosine_sine, move
from game.physics.solids.solvers.springs import spring_energies
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


@lean_kernel
def shift(motion, shifts):
    for i in range(len(motion)):
        motion[i, DX], motion[i, DY], motion[i, DA] = shifts[i]
        motion[i, DC], motion[i, DS] = cosine_sine(motion[i, DA])


@lean_kernel
def energies(rows, scratch, pull, found):
    """J in the springs of rows, one by one (column 0) and abreast (column 1)."""
    row, motion, batches = rows.rows, scratch.motion, scratch.batches
    for c in range(rows.count[0]):
        a, b = rows.ends[c, END_A], rows.ends[c, END_B]
        gap, under = gap_now(row, c, FIRST, motion, a, b), row[c, FIRST + STIFF_N]
        if rows.ends[c, END_POINTS] == 2:
            gap = 0.5 * (gap + gap_now(row, c, SECOND, motion, a, b))
            under = 0.25 * (under + row[c, SECOND + STIFF_N])
        own = 4.0 * pull if row[c, ROW_HARD] > 0.0 else pull
        found[c, 0] = 0.5 * own * gap * gap / under if gap < 0.0 else 0.0
    for k in range(batches.count[0]):
        spring_energies(batches, motion, k, pull)
        for lane in range(batches.filled[k]):
            found[batches.rows[k, lane], 1] = batches.values[k, BATCH_GAP, lane]


def heap(seed, count=40, shapes=3, restitution=0.0):
    """Boxes, discs and capsules (so many of these kinds) that fall onto a floor and onto a turning plank.

    Every fifth of them bounces with the restitution.
    """
    random, world = np.random.default_rng(seed), SolidWorld(SolidSettings())
    world.add_body(box(30.0, 1.0), (0.0, -0.5), kind="fixed")
    plank = world.add_body(box(6.0, 0.5), (0.0, 2.0), kind="key-framed")
    world.set_velocity(plank, (0.2, 0.0), 0.4)
    for k in range(count):
        width, height = random.uniform(0.3, 1.2, 2)
        own = Material(restitution=0.0 if k % 5 else restitution)
        shape = (
            box(width, height, material=own), Disc(0.5 * width, material=own),
            Capsule((0.0, 0.0), (width, 0.0), 0.3 * height, material=own),
        )[k % shapes]  # fmt: skip
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


def test_springs_abreast_hold_the_bits_of_springs_one_by_one():
    random, held, singles = np.random.default_rng(3), 0, 0
    for seed in range(3):
        world = heap(seed, shapes=3 - seed)
        for _ in range(60):
            world.step(FRAME)
        rows, scratch, numbers = begun(world)
        count = int(rows.count[0])
        shift(scratch.motion, random.uniform(-0.05, 0.05, (len(scratch.motion), 3)))
        found = np.full((count, 2), np.nan)
        energies(rows, scratch, numbers.contact_pull, found)
        np.testing.assert_array_equal(found[:, 0], found[:, 1])
        held += np.count_nonzero(found[:, 0] > 0.0)
        singles += np.count_nonzero(rows.ends[:count, END_POINTS] == 1)
    assert held > 20 and singles > 20


def test_a_batch_says_whether_one_of_its_rows_is_not_at_rest():
    seen = set()
    for seed in range(3):
        world = heap(seed, restitution=0.4)
        for stop in (20, 25, 90, 300):
            for _ in range(stop):
                world.step(FRAME)
            rows, scratch, _ = begun(world)
            for k in range(int(scratch.batches.count[0])):
                own = scratch.batches.rows[k, : scratch.batches.filled[k]]
                rare, two = rows.rare[own], rows.ends[own, END_POINTS] == 2
                speeds = np.where(two[:, None], rare[:, [APPROACH_0, APPROACH_1]], rare[:, [APPROACH_0]])
                violent = (np.abs(speeds).max(axis=1) > RESTLESS * FRAME) | (rare[:, IMPACT] > 0.0)
                expected = VIOLENT * bool(violent.any())
                assert scratch.batches.kinds[k] & VIOLENT == expected
                seen.add(expected)
    assert seen == {0, VIOLENT}


def impulses(world, among_rows):
    """Impulses of all contacts in their manifolds, and in rows or batches: (c, 4) each."""
    rows, batches, columns = world._rows, world._scratch.batches, [FIRST + JN, FIRST + JT]
    columns = [*columns, SECOND + JN, SECOND + JT]
    kept, found = [], []
    for k in range(int(batches.count[0])):
        for lane in range(int(batches.filled[k])):
            kept.append(world.contacts.manifolds[batches.pairs[k, lane]][[7, 8, 14, 15]])
            row = rows.rows[batches.rows[k, lane], columns]
            found.append(row if among_rows else batches.values[k, columns, lane])
    return np.array(kept), np.array(found)


def test_rows_are_copied_where_something_asks_for_them_and_left_where_all_is_at_rest():
    world = SolidWorld(SolidSettings(effects=USUAL.without(SLEEP)))
    world.add_body(box(10.0, 1.0), (0.0, -0.5), kind="fixed")
    for k in range(3):
        world.add_body(box(1.0, 1.0), (0.0, 0.5 + k))
    for _ in range(120):
        world.step(FRAME)
    assert world._rows.count.tolist() == [3, 0]
    kept, found = impulses(world, False)
    np.testing.assert_array_equal(kept, found)
    assert (kept[:, [0, 2]] > 0.0).all()
    ball = world.add_body(Disc(0.3, material=Material(restitution=0.5)), (3.0, 1.0))
    while world.bodies.velocities[ball, 1] <= 0.0:
        world.step(FRAME)
    assert world._rows.count.tolist() == [4, 1]
    kept, found = impulses(world, True)
    two = world._rows.ends[world._scratch.batches.rows[0, :4], END_POINTS] == 2
    np.testing.assert_array_equal(kept[two], found[two])
    np.testing.assert_array_equal(kept[~two, :2], found[~two, :2])
    np.testing.assert_array_equal(impulses(world, False)[1], found)  # of an impact, no impulse is kept
    world.remove_body(ball)
    world.step(FRAME)
    assert world._rows.count[1] == 0
    box_above = world.add_body(box(1.0, 1.0), (0.0, 3.5))
    shapes, places = world.contacts_begun()
    while not len(shapes):
        world.step(FRAME)
        shapes, places = world.contacts_begun()
    assert shapes.max() == world.shapes_of(box_above)[0]
    assert world._rows.count.tolist() == [4, 0]
    assert np.abs(places[0, :2] - (0.0, 3.0)) == pytest.approx((0.5, 0.0), abs=0.01)  # one of its corners
    assert places[0, 2] > 0.0


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
