"""Values beyond the walls and faces in between, for fields of single numbers."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.stable_fluids import PrintedFluid
from game.physics.stable_fluids.printed import ACROSS, ALONG, PLAIN, fill_ghosts


@pytest.mark.parametrize("kind", [PLAIN, ACROSS, ALONG])
def test_beyond_a_wall_is_what_lies_before_it_or_its_opposite(kind):
    a = np.full((5, 6), np.nan)
    a[1:-1, 1:-1] = inner = np.arange(1.0, 13.0).reshape(3, 4)
    fill_ghosts(a, kind)
    across, along = (-1.0 if kind == ACROSS else 1.0), (-1.0 if kind == ALONG else 1.0)
    for row, own in ((0, 0), (-1, -1)):
        assert np.array_equal(a[row, 1:-1], along * inner[own])
        assert np.array_equal(a[1:-1, row], across * inner[:, own])
        for column, other in ((0, 0), (-1, -1)):  # a corner is the mean of both beside it
            assert a[row, column] == 0.5 * (along + across) * inner[own, other]


def test_what_flows_through_faces_is_the_mean_of_both_cells_and_nothing_through_walls():
    fluid = PrintedFluid((4, 5), 0.5, 0)
    u, v, _ = fluid.inner
    numbers = np.arange(20.0).reshape(4, 5)
    u[:], v[:] = numbers**1.5, numbers[::-1] ** 0.5
    found = fluid.face_divergence()
    for j in range(4):
        for i in range(5):
            right = 0.5 * (u[j, i] + u[j, i + 1]) if i < 4 else 0.0
            left = 0.5 * (u[j, i] + u[j, i - 1]) if i > 0 else 0.0
            top = 0.5 * (v[j, i] + v[j + 1, i]) if j < 3 else 0.0
            bottom = 0.5 * (v[j, i] + v[j - 1, i]) if j > 0 else 0.0
            assert found[j, i] == pytest.approx((right - left + top - bottom) / 0.5, abs=1e-12)
    assert found.sum() == pytest.approx(0.0, abs=1e-12)
