"""Eight numbers side by side: in every lane what a plain float gives."""

from __future__ import annotations

import os
import subprocess
import sys

import numpy as np
import pytest
from numba import config

from game.compiler.decorator import lean_kernel
from game.compiler.entrances import Entrances
from game.physics.kernels import lanes
from game.physics.kernels.lanes import (
    LANES,
    all_of,
    any_of,
    choose,
    either,
    fetch,
    gather,
    larger,
    load,
    load_quads,
    root,
    smaller,
    store,
    store_quads,
    zeros,
)

SPECIAL = (0.0, -0.0, 1.0, -1.0, np.inf, -np.inf, np.nan, 5e-324, 1e300, 1.0 / 3.0)


@lean_kernel
def side_by_side(a, b, out):
    x, y = load(a, 0), load(b, 0)
    results = (
        x + y, x - y, x * y, x / y, -x, larger(x, y), smaller(x, y), choose(x > y, x, 2.0),
        choose(x >= y, x, y),
        choose((x < y) & (x <= 0.0), x, y), choose(either(x < y, y <= -1.0), x, y), root(x * x), zeros(),
        x * y + 0.1, larger(x, 0.0),
    )  # fmt: skip
    for k, result in enumerate(results):
        store(out, k * LANES, result)
    return any_of(x > y), all_of(x > y)


def one_by_one(x, y):
    """The same of two floats."""
    return (
        x + y, x - y, x * y, np.divide(x, y), -x, y if y > x else x, y if y < x else x, x if x > y else 2.0,
        x if x >= y else y, x if x < y and x <= 0.0 else y, x if x < y or y <= -1.0 else y,
        np.sqrt(x * x), 0.0,
        x * y + 0.1, 0.0 if x < 0.0 else x,
    )  # fmt: skip


def bits(numbers):
    """Bits of floats; every NaN the same."""
    given = np.where(np.isnan(numbers), np.nan, numbers)
    return given.view(np.uint64)


def test_every_lane_gives_the_bits_of_a_plain_float():
    random = np.random.default_rng(7)
    for turn in range(200):
        a, b = random.normal(size=LANES), random.normal(size=LANES)
        if turn % 2:
            a, b = random.choice(SPECIAL, LANES), random.choice(SPECIAL, LANES)
        out = np.zeros((15, LANES))
        with np.errstate(all="ignore"):
            found = side_by_side(a, b, out)
            expected = np.array(
                [one_by_one(np.float64(x), np.float64(y)) for x, y in zip(a, b, strict=True)]
            ).T
        np.testing.assert_array_equal(bits(out), bits(np.ascontiguousarray(expected)))
        assert found == (bool((a > b).any()), bool((a > b).all()))


@lean_kernel
def move_quads(table, other, numbers, out):
    quads = load_quads(table, 11, numbers, LANES, 5)
    for k in range(4):
        store(out, k * LANES, quads[k])
    store(out, 4 * LANES, gather(table, 11, numbers, LANES, 9))
    store_quads(other, 11, numbers, LANES, 2, quads)


def test_quads_are_four_columns_of_named_rows():
    table, other, out = np.arange(330.0).reshape(30, 11), np.zeros((30, 11)), np.zeros((5, LANES))
    numbers = np.array([[0] * LANES, [29, 3, 8, 1, 0, 17, 22, 4]], dtype=np.int32)
    move_quads(table, other, numbers, out)
    np.testing.assert_array_equal(out[:4], table[numbers[1], 5:9].T)
    np.testing.assert_array_equal(out[4], table[numbers[1], 9])
    expected = np.zeros((30, 11))
    expected[numbers[1], 2:6] = table[numbers[1], 5:9]
    np.testing.assert_array_equal(other, expected)


@lean_kernel
def store_numbered(table, numbers, values):
    quads = load(values, 0), load(values, LANES), load(values, 2 * LANES), load(values, 3 * LANES)
    store_quads(table, 5, numbers, 0, 1, quads)


def test_of_lanes_that_name_one_row_the_first_stays():
    table, values = np.zeros((4, 5)), np.arange(4.0 * LANES).reshape(4, LANES)
    numbers = np.array([2, 1, 2, 1, 2, 2, 2, 2], dtype=np.int32)
    store_numbered(table, numbers, values)
    np.testing.assert_array_equal(table[2, 1:], values[:, 0])
    np.testing.assert_array_equal(table[1, 1:], values[:, 1])
    assert not table[[0, 3]].any() and not table[:, 0].any()


@lean_kernel
def total_of(table, whole):
    total = 0.0
    for k in range(whole.shape[0]):
        fetch(table, min(k + 2, whole.shape[0] - 1) * table.shape[1])
        total += table[k, 0] + whole[k]
    return total


def test_what_is_fetched_stays_as_it_is():
    table, whole = np.arange(60.0).reshape(20, 3), np.arange(20, dtype=np.int32)
    assert total_of(table, whole) == 3.0 * 190.0 + 190.0
    assert table.tolist() == np.arange(60.0).reshape(20, 3).tolist()


@pytest.mark.skipif(config.DISABLE_JIT, reason="it is what runs already")
def test_without_compilation_lanes_are_the_same():
    code = (
        "import sys, os; sys.path.insert(0, os.path.dirname(sys.argv[1]));"
        "import test_lanes as t; assert t.lanes.choose is t.np.where;"
        "t.test_every_lane_gives_the_bits_of_a_plain_float(); t.test_quads_are_four_columns_of_named_rows();"
        "t.test_of_lanes_that_name_one_row_the_first_stays()"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, __file__], env={**os.environ, "NUMBA_DISABLE_JIT": "1"}, check=False,
        capture_output=True, text=True, timeout=900,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert lanes.choose is not np.where


@lean_kernel
def total(numbers):
    return numbers[0] + numbers[1]


def test_an_entrance_looks_at_types_again_when_it_is_told():
    entrances = Entrances()
    assert entrances.call(total, np.array([1.0, 2.5])) == 3.5
    assert entrances.call(total, np.array([4.0, 2.5])) == 6.5
    entrances.forget()
    assert entrances.call(total, np.array([1, 2])) == 3
    assert isinstance(entrances.call(total, np.array([5, 2])), int)
