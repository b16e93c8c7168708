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


def test_a_pocket_at_the_floor_is_closed():
    """A floor is no side from which gas comes; without that, heat that is given to such a cell stays."""
    ax, ay = faces(4, 7)
    ax[0, 3] = ax[0, 4] = ay[1, 3] = 0.0
    found = Openings((4, 7), (True, True, False, True))
    found.take(ax, ay, 0.5)
    assert np.argwhere(~found.open).tolist() == [[0, 3]]
    ax, ay = faces(4, 7)
    ax[0, 3] = ax[0, 4] = ay[1, 3] = 0.0
    all_ways = Openings((4, 7))
    all_ways.take(ax, ay, 0.5)
    assert not all_ways.open[0, 3]  # one open face alone: a dead end


def test_a_pocket_of_two_cells_at_the_floor_is_closed():
    ax, ay = faces(4, 7)
    ax[0, 2] = ax[0, 4] = ay[1, 2] = ay[1, 3] = 0.0
    found = Openings((4, 7), (True, True, False, True))
    found.take(ax, ay, 0.5)
    assert np.argwhere(~found.open).tolist() == [[0, 2], [0, 3]]
    ax, ay = faces(4, 7)
    ax[0, 2] = ax[0, 4] = ay[1, 2] = ay[1, 3] = 0.0
    found = Openings((4, 7))
    found.take(ax, ay, 0.5)
    assert found.open.all()


def test_a_dead_end_is_closed_and_leads_to_its_mouth():
    """A lane one cell wide goes down into a block: nothing flows through it."""
    ax, ay = faces(6, 7)
    ax[0:4, 3] = ax[0:4, 4] = 0.0
    ay[1:4, 1:3] = ay[1:4, 4:6] = 0.0
    ax[0:4, 1:3] = ax[0:4, 5:7] = 0.0
    ay[4, 1:3] = ay[4, 4:6] = 0.0
    found = Openings((6, 7), (True, True, False, True))
    found.take(ax, ay, 0.5)
    assert not found.open[:4, 3].any() and found.open[4, 3] and ay[4, 3] == 0.0
    j, i = found.nearest_to(np.array([0, 3]), np.array([3, 3]))
    assert (int(j[1]), int(i[1])) == (4, 3)


def test_a_lane_through_a_block_stays_open():
    ax, ay = faces(6, 7)
    ax[1:4, 3] = ax[1:4, 4] = 0.0
    found = Openings((6, 7), (True, True, False, True))
    found.take(ax, ay, 0.5)
    assert found.open[1:4, 3].all() and (ay[1:5, 3] == 1.0).all()
