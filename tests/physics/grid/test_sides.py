"""What the faces on the sides are given, kind by kind; and what a grid keeps of its solids."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from game.physics.grid import Grid
from game.physics.grid.borders import INFLOW, NO_SLIP, OPEN, PERIODIC, WALL, Edges
from game.physics.grid.ghosts import fill_velocity_ghosts, set_side_velocities
from game.physics.grid.layout import PAD
from game.physics.grid.obstacles import LAYERS, GridObstacles
from tests.physics.grid.shapes import Disc

ONE_SIDED = (WALL, NO_SLIP, INFLOW, OPEN)


@pytest.mark.parametrize(
    ("across", "along"),
    [*product(((WALL, OPEN), (INFLOW, NO_SLIP), (OPEN, INFLOW)), repeat=2), ((PERIODIC,) * 2,) * 2],
)
def test_walls_stop_inflow_enters_open_sides_are_left_alone_and_joined_ones_are_equal(across, along):
    rng = np.random.default_rng(3)
    ny, nx = 4, 5
    u, v = rng.standard_normal((ny, nx + 1)), rng.standard_normal((ny + 1, nx))
    given = rng.standard_normal((4, 5, 2))
    was_u, was_v = u.copy(), v.copy()
    set_side_velocities(u, v, Edges(np.array([*across, *along]), given))
    assert np.array_equal(u[:, 1:-1], was_u[:, 1:-1]) and np.array_equal(v[1:-1], was_v[1:-1])
    ends = ((across, u[:, 0], u[:, -1], was_u[:, 0], was_u[:, -1], given[:2, :ny, 0]),
            (along, v[0], v[-1], was_v[0], was_v[-1], given[2:, :nx, 1]))  # fmt: skip
    for kinds, first, last, first_was, last_was, wind in ends:
        for number, (kind, now, was) in enumerate(
            zip(kinds, (first, last), (first_was, last_was), strict=True)
        ):
            wanted = {INFLOW: wind[number], OPEN: was, PERIODIC: first_was}.get(kind, np.zeros_like(was))
            assert np.array_equal(now, wanted), (kind, number)


@pytest.mark.parametrize("axis", [0, 1])
def test_ghosts_behind_sticking_walls_go_on_along_the_parabola(axis):
    """A parabola across is known by two cells and the wall: its ghosts are its own values."""
    n, h = 6, 0.25
    shape = (n, n + 1) if axis == 0 else (n + 1, n)
    places = (np.arange(-PAD, n + PAD) + 0.5) * h
    parabola = 1.5 - 0.7 * places + 0.4 * places**2
    ends = 1.5, 1.5 - 0.7 * n * h + 0.4 * (n * h) ** 2
    padded = np.zeros((shape[0] + 2 * PAD, shape[1] + 2 * PAD))
    across = padded.T if axis == 0 else padded
    across[:, PAD:-PAD] = parabola[PAD:-PAD]
    given = np.zeros((4, n, 2))
    first = 2 if axis == 0 else 0
    given[first, :, axis], given[first + 1, :, axis] = ends
    kinds = np.array([PERIODIC, PERIODIC, NO_SLIP, NO_SLIP] if axis == 0 else [NO_SLIP] * 2 + [PERIODIC] * 2)
    fill_velocity_ghosts(padded, axis, Edges(kinds, given))
    assert np.allclose(across[PAD:-PAD], parabola, rtol=0.0, atol=1e-12)


def test_faces_within_a_disc_lie_in_layers_and_clear_cells_are_far_from_it():
    obstacles = GridObstacles(Grid(18, 16, 0.1))
    faces = obstacles.update(Disc((0.87, 0.8), 0.43))
    for part, layer in ((faces.ax, faces.layer_u), (faces.ay, faces.layer_v)):
        free = np.argwhere(part > 0.0)
        steps = [[np.abs(free - place).sum(axis=1).min() for place in row] for row in _places(part.shape)]
        assert np.array_equal(layer, np.minimum(steps, LAYERS + 1))
        assert layer.max() == LAYERS + 1
    assert faces.clear[8, 8] == 0.0 and faces.clear.max() >= 4.0
    assert np.array_equal(obstacles.clear().layer_u, np.zeros_like(faces.layer_u))


def _places(shape):
    return [[np.array((j, i)) for i in range(shape[1])] for j in range(shape[0])]
