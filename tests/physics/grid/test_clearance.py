"""How far cells are from solids, and layers of closed faces: counted again one by one."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.grid.fractions import clearance, layers


def closed_at_random(seed, ny=7, nx=9, share=0.06):
    rng = np.random.default_rng(seed)
    ax = np.where(rng.random((ny, nx + 1)) < share, 0.4, 1.0)
    ay = np.where(rng.random((ny + 1, nx)) < share, 0.0, 1.0)
    return ax, ay


@pytest.mark.parametrize("seed", range(5))
def test_clearance_is_the_kings_way_to_the_nearest_cell_that_is_not_all_open(seed):
    ax, ay = closed_at_random(seed)
    ny, nx = len(ax), len(ay[0])
    clear = np.zeros((ny, nx))
    clearance(ax, ay, clear)
    whole = (ax[:, :-1] == 1.0) & (ax[:, 1:] == 1.0) & (ay[:-1] == 1.0) & (ay[1:] == 1.0)
    places = np.argwhere(~whole)
    assert 0 < len(places) < ny * nx
    wanted = np.array(
        [[np.abs(places - (j, i)).max(axis=1).min() for i in range(nx)] for j in range(ny)], dtype=float
    )
    assert np.array_equal(clear, wanted)


def test_where_all_is_open_everything_is_far():
    clear = np.zeros((3, 5))
    clearance(np.ones((3, 6)), np.ones((4, 5)), clear)
    assert (clear >= 5.0).all()


@pytest.mark.parametrize("seed", range(4))
def test_layers_of_closed_faces_are_counted_from_the_open_ones(seed):
    """Depth by steps to a neighbour, up and across, from what is open."""
    parts = np.where(np.random.default_rng(seed).random((8, 9)) < 0.8, 0.0, 0.5)
    layer = np.zeros(parts.shape, np.int64)
    layers(parts, 3, layer)
    places = np.argwhere(parts > 0.0)
    steps = np.array([[np.abs(places - (j, i)).sum(axis=1).min() for i in range(9)] for j in range(8)])
    assert np.array_equal(layer, np.minimum(steps, 4))
