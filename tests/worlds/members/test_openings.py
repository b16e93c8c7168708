"""Slits between solids are shut, pockets too; each closed cell knows the open one that is nearest."""

from __future__ import annotations

import numpy as np

from game.worlds.members.openings import Openings


def faces(ny: int, nx: int):
    return np.ones((ny, nx + 1)), np.ones((ny + 1, nx))


def test_all_is_open_without_solids():
    ax, ay = faces(5, 7)
    found = Openings((5, 7))
    found.take(ax, ay, 0.5)
    assert found.open.all() and (ax == 1.0).all() and (ay == 1.0).all()


def test_a_slit_is_shut_and_what_is_wider_is_not():
    ax, ay = faces(3, 6)
    ax[:, 3] = (0.49, 0.5, 0.2)
    Openings((3, 6)).take(ax, ay, 0.5)
    assert ax[:, 3].tolist() == [0.0, 0.5, 0.0]


def test_a_pocket_that_leads_nowhere_is_closed():
    ax, ay = faces(5, 5)
    ax[2, 2] = ax[2, 3] = ay[2, 2] = ay[3, 2] = 0.0  # a cell by itself, in the middle
    ax[1, 2] = 0.0
    found = Openings((5, 5))
    found.take(ax, ay, 0.5)
    assert not found.open[2, 2] and np.count_nonzero(~found.open) == 1
    j, i = found.nearest_to(np.array([2]), np.array([2]))
    assert abs(int(j[0]) - 2) + abs(int(i[0]) - 2) == 1


def test_nearest_is_counted_in_steps():
    ax, ay = faces(1, 9)
    ax[0, 3:8] = 0.0  # cells 3 to 6 are closed
    ay[:, 3:7] = 0.0
    found = Openings((1, 9))
    found.take(ax, ay, 0.5)
    assert found.open[0].tolist() == [True] * 3 + [False] * 4 + [True] * 2
    assert found.nearest[0].tolist() == [0, 1, 2, 2, 2, 7, 7, 7, 8]


def test_where_nothing_is_open_a_cell_stays_itself():
    ax, ay = np.zeros((2, 3)), np.zeros((3, 2))
    found = Openings((2, 2))
    found.take(ax, ay, 0.5)
    assert not found.open.any()
    j, i = found.nearest_to(np.array([0, 1]), np.array([1, 0]))
    assert j.tolist() == [0, 1] and i.tolist() == [1, 0]
