"""Conductances between cells, written again one by one."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.heat.conduction import join_cells


@pytest.mark.parametrize("held", [(0, 0, 0, 0), (1, 0, 0, 1), (0, 1, 1, 0), (1, 1, 1, 1)])
def test_faces_conduct_by_the_harmonic_mean_and_held_edges_over_half_a_cell(held):
    k, h = np.random.default_rng(2).uniform(0.1, 5.0, (4, 6)), 0.25
    k[1, 2] = 0.0
    gx, gy = np.full((4, 7), np.nan), np.full((5, 6), np.nan)
    join_cells(k, h, np.array(held, dtype=float), gx, gy)
    with np.errstate(divide="ignore"):
        across = 2.0 / (1.0 / k[:, 1:] + 1.0 / k[:, :-1])
        along = 2.0 / (1.0 / k[1:] + 1.0 / k[:-1])
    assert gx[:, 1:-1] == pytest.approx(across / h**2) and gy[1:-1] == pytest.approx(along / h**2)
    left, right, lower, upper = held
    assert gx[:, 0] == pytest.approx(2.0 * left * k[:, 0] / h**2)
    assert gx[:, -1] == pytest.approx(2.0 * right * k[:, -1] / h**2)
    assert gy[0] == pytest.approx(2.0 * lower * k[0] / h**2)
    assert gy[-1] == pytest.approx(2.0 * upper * k[-1] / h**2)
