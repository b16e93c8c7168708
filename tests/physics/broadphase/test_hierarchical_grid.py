"""Levels and hash tables of the hierarchical grid."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.physics.broadphase import HierarchicalGrid
from game.physics.broadphase.hash_levels import COUNT, FACTOR, LEVELS, LOWEST, MASK, TOP, bucket_of, lay_out
from game.physics.broadphase.workloads import make_boxes
from tests.physics.broadphase.all_phases import brute_pairs


def test_a_ratio_that_is_no_power_is_refused():
    for ratio in (0, 1, 3, 32, 2.5, None):
        with pytest.raises(ValueError, match="expected 2, 4, 8 or 16"):
            HierarchicalGrid(ratio)


@pytest.mark.parametrize("exponent", range(LOWEST, 31))
def test_a_box_of_a_cells_size_stands_on_its_level(exponent):
    grid = HierarchicalGrid()
    size = math.ldexp(1.0, exponent)
    box = grid.add_box((0.0, 0.0), (size, size / 2.0))
    assert grid.level(box) == exponent - LOWEST
    assert grid.cell_size(grid.level(box)) == size
    grid.update_box(box, (0.0, 0.0), (math.nextafter(size, math.inf), 0.0))
    assert grid.level(box) == min(exponent - LOWEST + 1, TOP)


@pytest.mark.parametrize(("ratio", "step"), [(2, 1), (4, 2), (8, 3), (16, 4)])
def test_coarser_ratios_use_every_second_third_fourth_level(ratio, step):
    grid = HierarchicalGrid(ratio)
    sizes = 2.0 ** np.linspace(-31.5, 29.5, 62)
    ids = grid.add_boxes(np.zeros((62, 2)), np.repeat(sizes[:, None], 2, axis=1))
    for box, size in zip(ids.tolist(), sizes.tolist(), strict=True):
        level = grid.level(box)
        assert level % step == 0 or level == TOP
        assert grid.cell_size(level) / ratio < size <= grid.cell_size(level) or level == TOP


def test_rounding_of_a_size_does_not_let_a_box_reach_two_cells_on():
    grid = HierarchicalGrid()
    box = grid.add_box(
        (-1e-30, 0.0), (1.0, 1.0)
    )  # 1 - -1e-30 rounds to 1, but the corners are in cells -1 and 1
    assert grid.cell_size(grid.level(box)) == 2.0
    grid.check()


@pytest.mark.parametrize("turn", [1, -1])
def test_a_box_that_comes_to_reach_two_cells_on_changes_its_level_and_keeps_its_partners(turn):
    """Its level of before is the first guess, and its rounded size is still one cell. Across, and up."""
    grid = HierarchicalGrid()
    boxes = [
        grid.add_box((0.25, 0.25)[::turn], (1.25, 0.75)[::turn]),
        grid.add_box((1.0, 0.25)[::turn], (1.5, 0.75)[::turn]),
    ]
    assert grid.pairs().tolist() == [boxes]
    for _ in range(2):
        grid.update_box(boxes[0], (-1e-30, 0.25)[::turn], (1.0, 0.75)[::turn])
        assert grid.pairs().tolist() == [boxes]
        assert grid.cell_size(grid.level(boxes[0])) == 2.0
        grid.update_box(boxes[0], (0.25, 0.25)[::turn], (1.25, 0.75)[::turn])
        assert grid.pairs().tolist() == [boxes]


@pytest.mark.parametrize("share", [0.5, 0.02])
def test_boxes_that_exchange_their_sizes_keep_their_partners(share):
    """As many stand on each level as before, so that the tables stay; every guess of a level may be wrong."""
    random = np.random.default_rng(5)
    count = 600
    sizes = np.where(random.random(count) < share, 0.6, 0.09) * random.uniform(0.9, 1.1, count)
    grid = HierarchicalGrid()
    lowers = random.uniform(0.0, 8.0, (count, 2))
    ids = grid.add_boxes(lowers, lowers + sizes[:, None])
    tables = len(grid.levels())
    assert tables == 2 and len(grid.pairs())
    for _ in range(6):
        sizes = random.permutation(sizes)
        lowers = lowers + random.uniform(-0.1, 0.1, (count, 2))
        uppers = lowers + sizes[:, None]
        grid.update_boxes(ids, lowers, uppers)
        assert np.array_equal(grid.pairs(), brute_pairs(ids, lowers, uppers))
        assert grid.levels() == [(k, n) for k, n in enumerate(grid.tables().layout[:, COUNT].tolist()) if n]
        assert len(grid.levels()) == tables


def test_the_smallest_boxes_come_back_under_their_ids():
    """An id not in use has no level; the finest one is the guess when it is used again."""
    grid = HierarchicalGrid()
    size = 0.75 * math.ldexp(1.0, LOWEST)
    lowers = np.array([(0.0, 0.0), (0.5 * size, 0.0), (size, 0.0)])
    for _ in range(2):
        ids = grid.add_boxes(lowers, lowers + size)
        assert grid.pairs().tolist() == [[0, 1], [0, 2], [1, 2]]
        grid.remove_boxes(ids)
        assert len(grid.pairs()) == 0


@pytest.mark.parametrize("boxes", [1, 5, 16, 17, 40, 1000, 3000, 100_000, 3_000_000])
def test_the_buckets_of_neighbouring_cells_are_distinct(boxes):
    layout = np.zeros((LEVELS, 4), dtype=np.int64)
    layout[30, COUNT] = boxes
    lay_out(layout, 1)
    mask, factor = int(layout[30, MASK]), int(layout[30, FACTOR])
    assert mask + 1 >= boxes and (mask + 1) & mask == 0 and factor % 8 == 3
    near = [
        bucket_of(column, row, mask, factor) for column, row in itertools.product(range(-1, 2), range(-1, 2))
    ]
    assert len(set(near)) == 9
    two_rows_on = [bucket_of(column, 2, mask, factor) for column in range(-2, 3)]
    assert not set(two_rows_on) & {bucket_of(column, 0, mask, factor) for column in range(-2, 3)} or mask < 32


@given(st.integers(-(2**62), 2**62), st.integers(-(2**62), 2**62))
def test_a_bucket_is_found_for_any_cell(column, row):
    bucket = bucket_of(column, row, 1023, 635)
    assert 0 <= bucket < 1024
    assert bucket == (column + row * 635) % 1024


def test_the_tables_take_memory_for_boxes_and_not_for_space():
    grid = HierarchicalGrid()
    generator = np.random.default_rng(0)
    lowers = generator.uniform(-1e9, 1e9, (1000, 2))
    grid.add_boxes(lowers, lowers + generator.uniform(0, 1, (1000, 1)) ** 8 * 1e3)
    assert len(grid.pairs()) == 0
    assert grid.query_box(lowers[3], lowers[3]).tolist() == [3]
    assert grid.memory() < 1000 * 2_000
    for box in range(1000):
        grid.remove_box(box)
    assert len(grid) == 0 and grid.levels() == []
    grid.check()


def test_levels_and_cells_are_told():
    boxes = make_boxes("heavy-tail", 300, np.random.default_rng(5))
    grid = HierarchicalGrid()
    ids = grid.add_boxes(boxes.lowers, boxes.uppers)
    assert [count for _, count in grid.levels()] == [297, 3]
    levels, lower = grid.cells()
    sizes = np.array([grid.cell_size(level) for level in levels.tolist()])
    assert levels.tolist() == [grid.level(box) for box in ids.tolist()]
    assert ((lower <= boxes.lowers) & (boxes.lowers < lower + sizes[:, None])).all()


def test_both_ways_of_looking_between_levels_find_the_same():
    """Few large boxes run over fine rows; many look up coarse cells. Brute force judges both."""
    generator = np.random.default_rng(9)
    for large, small in ((2, 2000), (1500, 600)):
        lowers = generator.random((large + small, 2)) * 10.0
        sizes = np.where(np.arange(large + small) < large, 0.9, 0.03)[:, None]
        grid = HierarchicalGrid()
        grid.add_boxes(lowers, lowers + sizes)
        meet = (lowers[:, None] <= (lowers + sizes)[None]).all(axis=2)
        expected = np.argwhere(np.triu(meet & meet.T, 1))
        assert np.array_equal(grid.pairs(), expected)
        assert len(expected) > 30
