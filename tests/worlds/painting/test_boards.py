"""Polygons of boards: they lie below the floor, as thick as they are meant to be."""

from __future__ import annotations

import numpy as np
import pytest

from game.worlds.painting.boards import boards_of, joined, moved

THICK = 0.1


def test_a_smooth_run_is_one_board_whose_underside_follows_it():
    angles = np.linspace(1.9, 1.2, 8)
    arc = 3.0 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    shapes = boards_of(arc, THICK)
    assert shapes.starts.tolist() == [0, 16]
    assert shapes.corners[:8] == pytest.approx(arc)
    below = shapes.corners[8:][::-1]
    assert np.hypot(*below[1:-1].T) == pytest.approx(3.0 - THICK, abs=1e-3)
    towards = np.sum(below * arc, axis=1) / 3.0 / np.hypot(*below.T)
    assert towards[1:-1] == pytest.approx(1.0, abs=1e-9)
    assert np.hypot(*(below - arc).T) == pytest.approx(THICK, rel=0.01)


def test_a_corner_parts_two_boards():
    shapes = boards_of(np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 2.0)]), THICK)
    assert shapes.starts.tolist() == [0, 4, 8]
    assert shapes.corners[:4].tolist() == [[0.0, 0.0], [1.0, 0.0], [1.0, -THICK], [0.0, -THICK]]
    assert shapes.corners[4:] == pytest.approx(np.array([(1, 0), (1, 2), (1 + THICK, 2), (1 + THICK, 0)]))


def test_shapes_are_joined_and_moved():
    parts = [np.arange(6.0).reshape(3, 2), np.arange(8.0).reshape(4, 2)]
    both = joined(parts)
    assert both.starts.tolist() == [0, 3, 7] and both.corners[3:].tolist() == parts[1].tolist()
    assert moved(both, np.array([1.0, -2.0])).corners[0].tolist() == [1.0, -1.0]
    assert joined([]).starts.tolist() == [0]
