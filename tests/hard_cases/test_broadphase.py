"""The hard cases of broad phases: C05 H1 to H12, C06 H1 to H8, C07 H1 to H9."""

from __future__ import annotations

import itertools
import math
import sys

import numpy as np
import pytest

from game.physics.broadphase import (
    CoveringGrid,
    HashedPairs,
    HierarchicalGrid,
    MatrixPairs,
    NaiveBroadPhase,
    SweepAndPrune,
    UniformGrid,
)
from game.physics.broadphase.endpoints import insertion_sort
from game.physics.broadphase.hash_levels import LOWEST, TOP
from game.physics.broadphase.pair_table import triangular_index
from game.physics.broadphase.workloads import make_boxes

INF = math.inf


def grids(cell: float = 1.0, extent: float = 8.0):
    return [kind((0.0, 0.0), (extent, extent), cell) for kind in (UniformGrid, CoveringGrid)]


def phases(cell: float = 1.0, extent: float = 8.0):
    return [NaiveBroadPhase(), *grids(cell, extent), HierarchicalGrid(), SweepAndPrune()]


def pairs_of(phase, boxes) -> list[list[int]]:
    phase.add_boxes([box[0] for box in boxes], [box[1] for box in boxes])
    phase.check()
    return phase.pairs().tolist()


def agree(boxes, **grid) -> list[list[int]]:
    """The pairs, after all broad phases have given the same ones, in bulk and one by one."""
    answers = [pairs_of(phase, boxes) for phase in phases(**grid)]
    for phase in phases(**grid):
        for low, high in boxes:
            phase.add_box(low, high)
        answers.append(phase.pairs().tolist())
    assert all(answer == answers[0] for answer in answers)
    return answers[0]


class TestC05:
    def test_an_edge_on_a_cell_border_is_in_both_cells_and_the_pair_is_found_once(self):
        boxes = [((1.25, 1.25), (2.0, 2.0)), ((2.0, 2.0), (2.5, 2.5)), ((2.0, 1.5), (3.0, 1.75))]
        covering = grids()[1]
        assert pairs_of(covering, boxes) == agree(boxes) == [[0, 1], [0, 2]]
        assert covering.cells_of(0) == [(1, 1), (2, 1), (1, 2), (2, 2)]
        assert all(0 in phase.query_point((2.0, 2.0)) for phase in [covering])

    def test_borders_at_multiples_of_a_tenth_are_in_the_right_cell(self):
        assert sum(math.floor(k * 0.1 / 0.1) != k for k in range(1000)) == 47  # what dividing would give
        grid = UniformGrid((0.0, 0.0), (100.0, 1.0), 0.1)
        assert [grid.cell_of(k * 0.1, 0.0)[0] for k in range(1000)] == list(range(1000))
        for cell in (0.1, 0.3, 1.0 / 3.0, 0.125):
            touching = [((k * cell, 0.0), ((k + 1) * cell, cell)) for k in range(200)]
            expected = pairs_of(NaiveBroadPhase(), touching)
            for phase in grids(cell, 200 * cell):
                assert pairs_of(phase, touching) == expected

    def test_negative_coordinates_are_rounded_down(self):
        grid = UniformGrid((-4.0, -4.0), (4.0, 4.0), 1.0)
        assert grid.cell_of(-0.3, -1.0) == (3, 3)
        boxes = [((-0.3, -0.3), (-0.1, -0.1)), ((-0.2, -0.2), (0.2, 0.2)), ((0.1, 0.1), (0.3, 0.3))]
        assert pairs_of(grid, boxes) == agree(boxes) == [[0, 1], [1, 2]]

    def test_boxes_larger_than_cell_and_grid_outside_and_across_are_paired_once(self):
        boxes = [
            ((-50.0, -50.0), (60.0, 60.0)),  # larger than the grid
            ((2.5, 2.5), (6.5, 3.0)),  # larger than a cell
            ((20.0, 20.0), (21.0, 21.0)),  # outside
            ((20.5, 20.5), (22.0, 22.0)),
            ((7.5, 7.5), (9.0, 9.0)),  # partly outside
            ((8.5, 8.5), (10.0, 10.0)),
            ((-30.0, 5.0), (-20.0, 6.0)),
        ]
        expected = sorted([[0, k] for k in range(1, 7)] + [[2, 3], [4, 5]])
        assert agree(boxes) == expected
        assert agree(boxes, cell=8.0) == expected  # a grid of one cell
        for grid in grids(8.0):
            assert (grid.columns, grid.rows) == (1, 1)

    def test_no_size_the_same_place_and_a_thousand_in_one_cell(self):
        point = ((1.0, 1.0), (1.0, 1.0))
        assert agree([point, point, ((0.0, 0.0), (1.0, 1.0)), ((2.0, 2.0), (2.0, 2.0))]) == [
            [0, 1],
            [0, 2],
            [1, 2],
        ]
        for phase in phases():
            phase.add_boxes(np.full((1000, 2), 0.25), np.full((1000, 2), 0.75))
            pairs = phase.pairs()
            assert len(pairs) == 1000 * 999 // 2
            assert pairs[[0, -1]].tolist() == [[0, 1], [998, 999]]

    def test_a_pair_that_shares_cells_is_found_once_by_owner_cell_as_by_pair_manager(self):
        boxes = [((0.5, 0.5), (4.5, 4.5)), ((1.5, 1.5), (5.5, 5.5))]
        covering = grids()[1]
        assert pairs_of(covering, boxes) == [[0, 1]]
        shared = set(covering.cells_of(0)) & set(covering.cells_of(1))
        assert len(shared) == covering.tests == 16
        manager = HashedPairs()
        manager.add_pairs([(0, 1)] * len(shared))
        assert manager.pairs().tolist() == [[0, 1]]

    @pytest.mark.parametrize("make", [lambda: MatrixPairs(9), HashedPairs])
    def test_managers_are_idempotent_and_symmetric_and_refuse_a_box_with_itself(self, make):
        manager = make()
        assert manager.add(7, 3) and not manager.add(3, 7)
        assert (3, 7) in manager and (7, 3) in manager and len(manager) == 1
        assert not manager.remove(1, 2)
        assert manager.remove(3, 7) and not manager.remove(7, 3)
        assert manager.add(3, 7) and manager.pairs().tolist() == [[3, 7]]
        with pytest.raises(ValueError, match="no pair with itself"):
            manager.add(4, 4)
        assert (4, 4) not in manager

    def test_the_triangular_index_is_a_bijection_and_does_not_overflow(self):
        assert triangular_index(5, 20, 37) == 184
        n = 37
        assert [triangular_index(i, j, n) for i, j in itertools.combinations(range(n), 2)] == list(range(666))
        for n in (46_341, 100_000, 2**31 - 1):
            exact = (n - 2) * (2 * n - (n - 2) - 1) // 2 + (n - 1) - (n - 2) - 1
            assert (
                triangular_index(np.int32(n - 2), np.int32(n - 1), np.int32(n))
                == exact
                == n * (n - 1) // 2 - 1
            )

    def test_clearing_and_listing_do_not_touch_the_whole_matrix(self):
        """Memory of the matrix is given as it is touched: 2 GiB of it would show."""
        resource = pytest.importorskip("resource")
        if sys.platform != "linux":
            pytest.skip("memory that was never touched is counted elsewhere")
        before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
        manager = MatrixPairs(20_000)
        assert manager.memory() > 790e6
        for frame in range(50):
            manager.set_pairs([(frame, 19_999 - frame), (0, frame + 1)])
            assert len(manager.pairs()) == 2
            assert len(manager.take_events().begun) == 2
            manager.clear()
            manager.take_events()
        assert len(manager) == 0
        assert (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) * 1024 < 100e6

    def test_a_hash_table_with_hard_keys_loses_nothing_and_lists_in_order(self):
        manager = HashedPairs()
        keys = [(1024 * a, 1024 * a + 4096 * b) for a in range(60) for b in range(1, 30)]
        keys += [(-a - 1, 1024 * b) for a in range(20) for b in range(20)]
        manager.add_pairs(keys)
        for key in keys[::2]:
            manager.remove(*key)
        for key in keys[::4]:
            manager.add(*key)
        left = sorted(map(list, set(keys[1::2]) | set(keys[::4])))
        assert manager.pairs().tolist() == left
        assert all(tuple(pair) in manager for pair in left)
        manager.check()

    def test_a_removed_box_leaves_no_pair_to_the_next_one_of_its_id(self):
        for phase in phases():
            phase.add_boxes([(0, 0), (0.5, 0.5)], [(1, 1), (1.5, 1.5)])
            assert phase.pairs().tolist() == [[0, 1]]
            phase.remove_box(1)
            assert phase.pairs().tolist() == []
            assert phase.add_box((5, 5), (6, 6)) == 1
            assert phase.pairs().tolist() == []
            assert phase.query_point((0.75, 0.75)).tolist() == [0]
            phase.check()

    def test_all_boxes_leap_into_one_cell_and_back(self):
        boxes = make_boxes("equal", 200, np.random.default_rng(3), extent=(8.0, 8.0))
        for phase in phases():
            ids = phase.add_boxes(boxes.lowers, boxes.uppers)
            before = phase.pairs()
            phase.update_boxes(ids, np.full((200, 2), 0.1), np.full((200, 2), 0.2))
            assert len(phase.pairs()) == 200 * 199 // 2
            phase.update_boxes(ids, boxes.lowers, boxes.uppers)
            assert np.array_equal(phase.pairs(), before)
            phase.check()


class TestC06:
    def test_a_size_of_a_power_of_two_stands_on_the_documented_level(self):
        wrong = [k for k in range(60) if math.ceil(math.log(2**k) / math.log(2)) != k]
        assert wrong == [29, 31, 39, 47, 51, 55, 58, 59]  # what logarithms would give
        grid = HierarchicalGrid()
        for k in range(-30, 31):
            box = grid.add_box((0.0, 0.0), (2.0**k, 2.0**k))
            assert grid.level(box) == k - LOWEST
            assert grid.cell_size(grid.level(box)) == 2.0**k

    def test_beyond_the_finest_and_the_coarsest_level(self):
        boxes = [
            ((0.0, 0.0), (1e-30, 1e-30)),
            ((0.0, 0.0), (0.0, 0.0)),
            ((-1e12, -1e12), (1e12, 1e12)),
            ((1e-30, 0.0), (1e12, 1.0)),
            ((2e12, 0.0), (3e12, 1.0)),
        ]
        grid = HierarchicalGrid()
        assert pairs_of(grid, boxes) == agree(boxes) == [[0, 1], [0, 2], [0, 3], [1, 2], [2, 3]]
        assert [grid.level(box) for box in range(5)] == [0, 0, TOP, TOP, TOP]

    @pytest.mark.parametrize("exponents", [(-20, 0), (-3, -3), (-20, -19)])
    def test_size_ratios_of_a_million_one_level_one_per_level(self, exponents):
        generator = np.random.default_rng(7)
        n = 400
        lowers = generator.random((n, 2)) * 8.0
        sizes = 2.0 ** np.linspace(*exponents, n)
        boxes = list(zip(lowers.tolist(), (lowers + sizes[:, None]).tolist(), strict=True))
        grid = HierarchicalGrid()
        assert pairs_of(grid, boxes) == pairs_of(NaiveBroadPhase(), boxes)
        grid.query_point((1, 1))
        assert grid.memory() < 4_000 * n  # as for boxes of one size, whatever the ratio
        assert len(grid.levels()) >= (19 if exponents == (-20, 0) else 1)

    def test_a_box_that_grows_over_a_level_border_every_frame_loses_no_pair(self):
        for bulk in (False, True):
            grid, naive = HierarchicalGrid(), NaiveBroadPhase()
            lowers = np.random.default_rng(2).random((60, 2)) * 4.0
            for phase in (grid, naive):
                ids = phase.add_boxes(lowers, lowers + 0.25)
            met = set()
            for frame in range(40):
                size = 2.0 ** (frame % 20 - 10) * (1.0 + 1e-12)
                for phase in (grid, naive):
                    if bulk:
                        phase.update_boxes(ids[:1], [(2.0, 2.0)], [(2.0 + size, 2.0 + size)])
                    else:
                        phase.update_box(0, (2.0, 2.0), (2.0 + size, 2.0 + size))
                assert np.array_equal(grid.pairs(), naive.pairs())
                assert np.array_equal(grid.partners(0), naive.partners(0))
                met.add(grid.level(0))
            assert len(met) == 20
            grid.check()

    def test_cells_that_share_a_bucket_are_not_taken_for_one(self):
        """All boxes in cells of one column and row modulo the table: every look-up meets all of them."""
        n = 32
        apart = 1024.0  # columns: a multiple of the number of buckets
        lowers = np.stack([np.arange(n) * apart, np.zeros(n)], axis=1)
        boxes = list(zip(lowers.tolist(), (lowers + 1.0).tolist(), strict=True))
        grid = HierarchicalGrid()
        assert pairs_of(grid, boxes) == []
        assert grid.tests >= n * (n - 1) // 2
        assert grid.query_point((apart + 0.5, 0.5)).tolist() == [1]
        assert grid.query_box((apart, 0.0), (2 * apart + 1.0, 0.5)).tolist() == [1, 2]
        boxes.append(((apart - 0.5, 0.5), (apart + 0.5, 0.75)))
        assert agree(boxes) == [[1, 32]]

    def test_coordinates_of_a_thousand_million_and_negative_ones(self):
        near = [((0.0, 0.0), (1e-6, 1e-6)), ((5e-7, 5e-7), (2e-6, 2e-6)), ((-3e-7, -3e-7), (-1e-7, -1e-7))]
        far = [((x, -x), (x + 1.0, -x + 1.0)) for x in (1e9, -1e9, 1e9 + 0.5, -1e9 - 0.5, 1e9 - 3.0)]
        assert agree(near + far) == [[0, 1], [3, 5], [4, 6]]
        cell = 2.0**LOWEST
        assert int(1e9 / cell) > 2**61  # no 32 bits would do for such columns

    def test_empty_levels_cost_no_test_and_no_table(self):
        grid = HierarchicalGrid()
        lowers = np.arange(100.0)[:, None] * [[10.0, 0.0]]
        grid.add_boxes(lowers, lowers + 1.0)
        assert grid.pairs().tolist() == []
        tests = grid.tests
        giant = grid.add_box((0.0, 100.0), (2.0**20, 2.0**20))
        assert grid.pairs().tolist() == []
        assert [count for _, count in grid.levels()] == [100, 1]
        assert grid.tests <= tests + 100 * 9
        grid.remove_box(giant)
        assert grid.pairs().tolist() == [] and len(grid.levels()) == 1

    def test_a_pair_of_two_levels_is_found_once(self):
        generator = np.random.default_rng(17)
        for large in (1, 30, 300):
            lowers = generator.random((330, 2)) * 8.0
            sizes = np.where(np.arange(330) < large, 2.0, 0.05)[:, None]
            boxes = list(zip(lowers.tolist(), (lowers + sizes).tolist(), strict=True))
            grid = HierarchicalGrid()
            found = pairs_of(grid, boxes)
            assert found == pairs_of(NaiveBroadPhase(), boxes)
            assert len(set(map(tuple, found))) == len(found)
            assert any(grid.level(a) != grid.level(b) for a, b in found)


class TestC07:
    def test_ends_that_coincide_overlap(self):
        boxes = [
            ((0.0, 0.0), (1.0, 1.0)),
            ((1.0, 0.0), (2.0, 1.0)),
            ((1.0, 1.0), (1.0, 1.0)),
            ((0.0, 0.0), (1.0, 1.0)),
            ((-1.0, -1.0), (-0.0, -0.0)),
            ((2.5, 0.0), (3.0, 1.0)),
        ]
        expected = [[0, 1], [0, 2], [0, 3], [0, 4], [1, 2], [1, 3], [2, 3], [3, 4]]
        assert agree(boxes) == expected
        sap = SweepAndPrune()
        apart = np.repeat(np.arange(6.0)[:, None] * 10.0, 2, axis=1)
        ids = sap.add_boxes(apart, apart + 1.0)
        sap.update_boxes(ids, [box[0] for box in boxes], [box[1] for box in boxes])
        assert sap.pairs().tolist() == expected
        sap.check()

    def test_what_is_not_a_number_never_reaches_the_sort(self):
        sap = SweepAndPrune()
        ids = sap.add_boxes([(0, 0), (2, 2)], [(1, 1), (3, 3)])
        for bad in ((math.nan, 0.0), (0.0, math.nan)):
            with pytest.raises(ValueError, match="expected numbers"):
                sap.update_box(0, bad, (1, 1))
            with pytest.raises(ValueError, match="expected numbers"):
                sap.update_boxes(ids, [(0, 0), (2, 2)], [(1, 1), bad])
        sap.check()
        assert sap.box(0)[0].tolist() == [0.0, 0.0]

    def test_a_leap_of_all_boxes_is_finished_by_sorting_and_counts_the_swaps_it_spared(self):
        n = 2000
        generator = np.random.default_rng(21)
        boxes = make_boxes("equal", n, generator, fill=0.1)
        size = boxes.uppers - boxes.lowers
        sap = SweepAndPrune()
        ids = sap.add_boxes(boxes.lowers, boxes.uppers)
        counts = []
        for _ in range(8):
            lowers = generator.random((n, 2)) * (1.0 - size)
            before = sap.swaps
            sap.update_boxes(ids, lowers, lowers + size)
            counts.append(sap.swaps - before)
        assert sap.resorts == 8
        # four pairs of ends of each pair of boxes on two axes, each inverted with chance 1 / 2
        mean = 2 * n * (n - 1)
        assert abs(np.mean(counts) - mean) < 4.0 * np.std(counts, ddof=1) / math.sqrt(8)
        grid = UniformGrid((0.0, 0.0), (1.0, 1.0), float(size[0, 0]))
        grid.add_boxes(lowers, lowers + size)
        assert np.array_equal(sap.pairs(), grid.pairs())
        sap.check()

    def test_insertion_swaps_are_the_inversions_of_a_known_permutation(self):
        values = np.random.default_rng(7).permutation(500).astype(float)
        codes = np.arange(500, dtype=np.int32)
        boxes = np.zeros((500, 4))
        changes = np.empty(4, dtype=np.int64)
        _, place, swaps, _ = insertion_sort(boxes, values, codes, 500, 0, 1 << 40, changes, 0)
        assert (place, swaps) == (500, 63_479)
        assert values.tolist() == list(range(500))

    def test_boxes_come_and_go_every_frame(self):
        generator = np.random.default_rng(5)
        sap, naive = SweepAndPrune(), NaiveBroadPhase()
        for _ in range(60):
            lowers = generator.random((5, 2))
            for phase in (sap, naive):
                phase.add_box(lowers[0], lowers[0] + 0.2)
                phase.add_boxes(lowers[1:], lowers[1:] + 0.2)
            assert np.array_equal(sap.ids(), naive.ids())
            gone = generator.choice(naive.ids(), size=min(4, len(naive)), replace=False)
            for phase in (sap, naive):
                phase.remove_box(int(gone[0]))
                phase.remove_boxes(gone[1:])
            assert np.array_equal(sap.pairs(), naive.pairs())
            sap.check()

    @pytest.mark.parametrize("resort", [True, False])
    def test_all_boxes_on_one_line(self, resort):
        n = 300
        generator = np.random.default_rng(8)
        boxes = make_boxes("line", n, generator)
        sap, naive = SweepAndPrune(resort=resort), NaiveBroadPhase()
        for phase in (sap, naive):
            ids = phase.add_boxes(boxes.lowers, boxes.uppers)
        for _ in range(10):
            shake = generator.standard_normal((n, 2)) * 1e-9
            for phase in (sap, naive):
                phase.update_boxes(ids, boxes.lowers + shake, boxes.uppers + shake)
            assert np.array_equal(sap.pairs(), naive.pairs())
        # half of the n (n - 1) / 2 pairs of lower ends, and of upper ones: however small the motion
        assert abs(sap.swaps / 10 / (n * (n - 1) / 2) - 1.0) < 0.2
        sap.check()

    def test_a_box_that_grows_over_many_others_and_one_upside_down(self):
        lowers = np.random.default_rng(4).random((100, 2)) * 10.0
        sap, naive = SweepAndPrune(), NaiveBroadPhase()
        for phase in (sap, naive):
            phase.add_boxes(lowers, lowers + 0.3)
        for size in (0.1, 3.0, 20.0, 1e6, 1.0, 0.0):
            for phase in (sap, naive):
                phase.update_box(50, (5.0 - size, 5.0 - size), (5.0 + size, 5.0 + size))
            assert np.array_equal(sap.pairs(), naive.pairs())
            sap.check()
        with pytest.raises(ValueError, match="not above"):
            sap.update_box(50, (5.0, 5.0), (4.0, 6.0))

    def test_an_overlap_on_one_axis_alone_is_none(self):
        boxes = [((0.0, 0.0), (1.0, 1.0)), ((0.5, 5.0), (1.5, 6.0)), ((5.0, 0.5), (6.0, 1.5))]
        assert agree(boxes) == []
        sap = SweepAndPrune()
        ids = sap.add_boxes([(0, 0), (10, 10)], [(1, 1), (11, 11)])
        sap.update_box(ids[1], (0.5, 10.0), (1.5, 11.0))
        assert sap.pairs().tolist() == []
        sap.update_box(ids[1], (0.5, 0.5), (1.5, 1.5))
        assert sap.pairs().tolist() == [[0, 1]]
        sap.update_box(ids[1], (3.0, 0.5), (4.0, 1.5))
        assert sap.pairs().tolist() == []

    @pytest.mark.parametrize("bulk", [True, False])
    def test_a_box_that_jumps_over_another_begins_and_ends_nothing(self, bulk):
        sap = SweepAndPrune()
        ids = sap.add_boxes([(0, 0), (2, 0)], [(1, 1), (3, 1)])
        sap.manager.take_events()
        for x in (5.0, 0.0, 2.0, 0.0):
            if bulk:
                sap.update_boxes(ids, [(x, 0), (2, 0)], [(x + 1, 1), (3, 1)])
            else:
                sap.update_box(0, (x, 0), (x + 1, 1))
            sap.check()
        assert [len(events) for events in sap.manager.take_events()] == [0, 0]

    def test_a_floor_without_end(self):
        floor = ((-INF, -INF), (INF, 0.0))
        boxes = [floor, ((3.0, -0.5), (4.0, 0.5)), ((3.0, 0.25), (4.0, 1.0)), ((-1e300, -1.0), (-1e299, 0.0))]
        assert agree(boxes) == [[0, 1], [0, 3], [1, 2]]
        sap = SweepAndPrune()
        pairs_of(sap, [*boxes, ((-INF, -INF), (INF, INF))])
        assert sap.end_points(0)[1][[0, 1]].tolist() == [0, 4] and sap.end_points(0)[1][
            [-2, -1]
        ].tolist() == [0, 4]
        sap.update_box(1, (3.0, 2.0), (4.0, 3.0))
        assert sap.pairs().tolist() == [[0, 3], [0, 4], [1, 4], [2, 4], [3, 4]]
        sap.check()
