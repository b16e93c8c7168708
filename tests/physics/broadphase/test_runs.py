"""Many boxes at once: runs longer than are noted, and more noted than are tested together."""

from __future__ import annotations

import itertools
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import tests
from game.physics.broadphase import BroadPhase, HierarchicalGrid, UniformGrid
from game.physics.broadphase.runs import MANY, SHORT
from tests.physics.broadphase.all_phases import PHASES, brute_pairs

COUNT = 3_000

GRIDS = {
    "near": lambda: UniformGrid((0.0, 0.0), (1.0, 1.0), 0.021),  # sparse: short runs
    "near, dense": lambda: UniformGrid((0.0, 0.0), (1.0, 1.0), 0.12),  # some forty boxes a cell
    "far": lambda: UniformGrid((0.0, 0.0), (1.0, 1.0), 0.006),
    "one cell": lambda: UniformGrid((0.0, 0.0), (1.0, 1.0), 1.0),
    "hierarchical": HierarchicalGrid,
    "hierarchical, 16": lambda: HierarchicalGrid(16),
}


def crowd(large: int, of_size: float) -> tuple[np.ndarray, np.ndarray]:
    """COUNT boxes in the unit square, so many of them large ones."""
    random = np.random.default_rng(large)
    lowers = random.random((COUNT, 2))
    sizes = random.uniform(0.001, 0.02, (COUNT, 2))
    sizes[:large] = of_size
    if large == 1:
        lowers[0] = -0.1  # one that meets all
    lowers[COUNT // 2 : COUNT // 2 + 40] = lowers[0] + 0.001  # a heap in one place
    return lowers, lowers + sizes


@pytest.mark.parametrize("name", GRIDS)
@pytest.mark.parametrize(("large", "of_size"), [(0, 0.0), (1, 1.5), (7, 0.5), (1500, 0.08)])
def test_no_pair_of_a_crowd_is_lost_or_doubled(name, large, of_size):
    """Many large boxes look up from fine levels to coarse ones, few run over the fine ones."""
    grid = GRIDS[name]()
    lowers, uppers = crowd(large, of_size)
    ids = grid.add_boxes(lowers, uppers)
    found = grid.pairs()
    assert np.array_equal(found, brute_pairs(ids, lowers, uppers))
    assert grid.tests > MANY > 100 * SHORT  # so all that is here said was done


@pytest.mark.parametrize("name", GRIDS)
def test_a_crowd_in_little_room_for_keys(name):
    """The room is doubled until all pairs fit in, whichever loop was the first to miss some."""
    lowers, uppers = crowd(40, 0.3)
    wanted = brute_pairs(np.arange(COUNT), lowers, uppers)
    for most in (len(wanted) // 64, len(wanted) // 3, len(wanted) - 1):
        grid = GRIDS[name]()
        grid.add_boxes(lowers, uppers)
        grid._sorter.reserve(most)
        assert np.array_equal(grid.pairs(), wanted)


def test_large_boxes_over_rows_that_share_buckets_in_little_room():
    """Some room is just too little for a run of such a row: then no pair may be left out either."""
    random = np.random.default_rng(9)
    lowers = random.random((303, 2))
    sizes = np.full((303, 2), 0.028)
    lowers[300:] = [(-0.1, -0.1), (0.3, 0.0), (0.0, 0.3)]
    sizes[300:] = 0.9
    wanted = brute_pairs(np.arange(303), lowers, lowers + sizes)
    for room in range(64, 2 * len(wanted)):
        grid = HierarchicalGrid()
        grid.add_boxes(lowers, lowers + sizes)
        grid._sorter.reserve(room)
        assert np.array_equal(grid.pairs(), wanted), room


def test_small_boxes_touch_on_every_side_whichever_comes_first():
    """Smaller than a cell, so that the earlier of two in a row of cells may lie above the other."""
    middle = np.array((0.5, 0.5))
    ways = [(0.25, 0.0), (0.0, 0.25), (0.25, 0.25), (0.25, -0.25)]
    for way in ways:
        lowers = np.array((middle, middle + way))
        for order, make in itertools.product((1, -1), GRIDS.values()):
            grid = make()
            ids = grid.add_boxes(lowers[::order], lowers[::order] + 0.25)
            assert grid.pairs().tolist() == [ids.tolist()], (way, order)
            grid.update_boxes(ids, lowers[::order] * 1.001, lowers[::order] * 1.001 + 0.25)
            assert len(grid.pairs()) == 0, (way, order)


def test_each_pair_of_equal_boxes_is_found_at_every_shift():
    """Runs of every length from 0 on, ended by each of their places."""
    for stack, across in itertools.product(range(1, 3 * SHORT), (0.0, 0.5, 0.999)):
        lowers = np.array([(0.5 + k % 2 * across, 0.5 + k * 1e-3) for k in range(stack)] + [(1.5, 1.2)])
        for grid in (UniformGrid((0.0, 0.0), (4.0, 4.0), 1.0), HierarchicalGrid()):
            ids = grid.add_boxes(lowers, lowers + 1.0)
            assert np.array_equal(grid.pairs(), brute_pairs(ids, lowers, lowers + 1.0))


def test_an_answer_stays_when_the_boxes_move():
    """Pairs are sorted in a buffer, but no caller holds it."""
    for make in PHASES.values():
        phase: BroadPhase = make()
        lowers = np.arange(40.0).reshape(20, 2) / 8.0
        ids = phase.add_boxes(lowers, lowers + 0.5)
        before = phase.pairs()
        kept = before.copy()
        phase.update_boxes(ids, lowers[::-1] * 1.5, lowers[::-1] * 1.5 + 0.5)
        assert not np.array_equal(phase.pairs(), kept)
        assert np.array_equal(before, kept)


def test_plain_python_finds_and_tests_the_same():
    """Every broad phase, compiled and not, with a warning for what would overflow."""
    code = """
import warnings
import numpy as np
from tests.physics.broadphase.all_phases import every_phase
warnings.simplefilter("error")
for name, phase in every_phase().items():
    random = np.random.default_rng(3)
    lowers = 7.0 * random.random((40, 2))
    sizes = np.where(np.arange(40)[:, None] < 3, 2.5, 0.6)
    ids = phase.add_boxes(lowers, lowers + sizes)
    for step in range(12):
        lowers += 0.1 * random.standard_normal(lowers.shape) * (step != 5)
        phase.update_boxes(ids, lowers, lowers + sizes)
        print(name, phase.tests, phase.pairs().tolist(), phase.query_point((3.0, 3.0)).tolist())
    phase.remove_boxes(ids[::3])
    print(phase.pairs().tolist())
    phase.check()
"""
    said = [
        subprocess.run(
            [sys.executable, "-c", code],
            cwd=Path(tests.__file__).parents[1],
            env={**os.environ, "NUMBA_DISABLE_JIT": flag},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for flag in ("0", "1")
    ]
    assert said[0] == said[1] != ""
