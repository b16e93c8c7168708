"""Cells of the uniform grids: where boxes stand, how many cells they cover, and what matrix is refused."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.physics.broadphase import CoveringGrid, UniformGrid
from game.physics.broadphase.workloads import make_boxes


@pytest.mark.parametrize(
    ("lower", "upper", "cell"),
    [
        ((0, 0), (1, 1), 0.0),
        ((0, 0), (1, 1), -1.0),
        ((0, 0), (1, 1), math.nan),
        ((0, 0), (1, 1), math.inf),
        ((0, 0), (1, 1), "a"),
        ((0, 0), (1, 1), 1e-300),
        ((0, 0), (1, 1), 1e-4),
        ((0, 0), (0, 1), 1.0),
        ((1, 0), (0, 1), 1.0),
        ((0, 0), (math.inf, 1), 1.0),
        ((math.nan, 0), (1, 1), 1.0),
        ((-1e308, 0), (1e308, 1), 1.0),
        ((0,), (1, 1), 1.0),
    ],
)
def test_a_matrix_that_cannot_be_is_refused_in_one_line(lower, upper, cell):
    with pytest.raises(ValueError) as error:
        UniformGrid(lower, upper, cell)
    assert "\n" not in str(error.value)


def test_loads_count_the_boxes_of_each_cell():
    boxes = make_boxes("clustered", 500, np.random.default_rng(1), fill=0.1)
    grid, covering = (kind((0.0, 0.0), (1.0, 1.0), 0.125) for kind in (UniformGrid, CoveringGrid))
    for phase in (grid, covering):
        phase.add_boxes(boxes.lowers, boxes.uppers)
    expected = np.zeros((8, 8), dtype=int)
    for x, y in np.floor(boxes.lowers * 8).astype(int).clip(0, 7).tolist():
        expected[y, x] += 1
    assert grid.loads().tolist() == expected.tolist()
    assert covering.loads().sum() == covering.entries == sum(len(covering.cells_of(i)) for i in range(500))


def test_a_box_covers_as_many_cells_as_expected():
    width, cell, n = 1.7, 1.0, 6_000
    generator = np.random.default_rng(8)
    lowers = generator.random((n, 2)) * 60.0 + 1.0
    grid = CoveringGrid((0.0, 0.0), (64.0, 64.0), cell)
    grid.add_boxes(lowers, lowers + width)
    across = np.floor(lowers[:, 0] + width) - np.floor(lowers[:, 0]) + 1
    assert across.max() == math.floor(width / cell) + 2 == 3
    # mean 1 + w / c on each axis: 4 standard errors of a sample of this size
    assert abs(across.mean() - 2.7) < 4.0 * across.std() / math.sqrt(n)
    assert grid.pairs().shape[1] == 2
    assert abs(grid.entries / n - 2.7**2) < 4.0 * (across.std() * 2 * 2.7) / math.sqrt(n)


@given(
    st.floats(-1e6, 1e6),
    st.floats(0.0, 1e3),
    st.sampled_from([0.1, 0.3, 1.0, 2.0**-7, 1.0 / 3.0, 77.7]),
    st.sampled_from([-1e6, 0.0, -0.1, 12.3]),
)
def test_the_cell_of_a_coordinate_never_falls_while_the_coordinate_rises(x, rise, cell, origin):
    grid = UniformGrid((origin, 0.0), (origin + 1000.0 * cell, cell), cell)
    assert grid.cell_of(x, 0.0)[0] <= grid.cell_of(x + rise, 0.0)[0]
    assert 0 <= grid.cell_of(x, 0.0)[0] <= grid.columns - 1


def test_lists_stay_right_when_single_and_bulk_calls_alternate():
    generator = np.random.default_rng(6)
    grid = UniformGrid((0, 0), (4, 4), 0.5)
    ids = grid.add_boxes(generator.random((50, 2)) * 4, generator.random((50, 2)) + 5.0)
    for _ in range(20):
        lowers = generator.random((50, 2)) * 4
        grid.update_boxes(ids, lowers, lowers + 0.4)
        grid.update_box(7, (1, 1), (1, 1))
        assert 7 in grid.query_point((1, 1))
        grid.update_box(7, (3, 3), (9, 9))
        assert 7 not in grid.query_point((1, 1)) and 7 in grid.query_point((8.5, 8.5))
        grid.check()
