"""The staggered grid: sizes, sides, and solids as open parts of faces."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.physics.grid import Border, Borders, Grid, edges_of
from game.physics.grid.obstacles import GridObstacles
from tests.physics.grid.shapes import Box, Disc


def test_places_are_where_the_layout_says():
    grid = Grid(6, 4, 0.5, (1.0, 2.0))
    assert grid.upper == (4.0, 4.0) and grid.shape == (4, 6)
    assert grid.centres()[0][0, 0] == 1.25 and grid.centres()[1][3, 0] == 3.75
    assert grid.u_places()[0].shape == (4, 7) and grid.u_places()[0][0, 6] == 4.0
    assert grid.v_places()[1].shape == (5, 6) and grid.v_places()[1][4, 0] == 4.0
    assert grid.cell_at(1.6, 3.9) == (3, 1) and grid.cell_at(-9.0, 99.0) == (3, 0)


@pytest.mark.parametrize(
    ("arguments", "named"),
    [
        ((3, 8, 1.0), "nx"), ((8, 3, 1.0), "ny"), ((8, 8.0, 1.0), "ny"), ((8, 8, 0.0), "cell"),
        ((8, 8, math.nan), "cell"), ((8192, 8192, 1.0), "at most"), ((8, 8, 1.0, (math.inf, 0.0)), "lower"),
        ((8, 8, 1e300), "cell"), ((8, 8, 1e-300), "cell"),
    ],
)  # fmt: skip
def test_a_grid_refuses_nonsense(arguments, named):
    with pytest.raises(ValueError, match=named):
        Grid(*arguments)


def test_sides_refuse_nonsense():
    for build, named in (
        (lambda: Border("sponge"), "kind"),
        (lambda: Border("inflow", (math.nan, 0.0)), "velocity"),
        (lambda: Border("wall", scalars={"smoke": math.inf}), "smoke"),
        (lambda: Borders(left=Border("periodic")), "periodic"),
        (lambda: edges_of(Borders(left=Border("inflow", np.ones((3, 2)))), Grid(8, 8, 1.0)), "left"),
    ):
        with pytest.raises(ValueError, match=named):
            build()


def perimeter_and_area(faces, h):
    """Length of the outline by what the cells' faces leave, and the area of the solid."""
    across, up = np.diff(faces.ax, axis=1), np.diff(faces.ay, axis=0)
    return h * float(np.sum(np.hypot(across, up))), h * h * float(np.sum(1.0 - faces.volume))


@given(
    st.floats(0.8, 1.2), st.floats(0.8, 1.2), st.floats(0.15, 0.6),
    st.floats(0.0, 1.0), st.floats(0.0, 1.0), st.floats(0.0, 3.0),
)  # fmt: skip
def test_parts_of_faces_are_those_of_the_shape(x, y, radius, ux, uy, spin):
    grid = Grid(48, 48, 2.0 / 48)
    faces = GridObstacles(grid).update(Disc((x, y), radius, (ux, uy), spin))
    length, area = perimeter_and_area(faces, grid.cell)
    assert min(faces.ax.min(), faces.ay.min()) >= 0.0 and max(faces.ax.max(), faces.ay.max()) <= 1.0
    assert length == pytest.approx(2.0 * math.pi * radius, rel=0.04)
    assert area == pytest.approx(math.pi * radius**2, rel=0.06)
    # a closed outline: what the faces leave open sums to nothing
    assert abs(np.sum(np.diff(faces.ax, axis=1))) < 1e-9
    cut = (faces.ax > 0.0) & (faces.ax < 1.0)
    px, py = grid.u_places()
    assert np.allclose(faces.u[cut], (ux - spin * (py - y))[cut])
    corners_x, corners_y = px, py - 0.5 * grid.cell
    inside = np.hypot(corners_x - x, corners_y - y) < radius
    above = np.hypot(corners_x - x, corners_y + grid.cell - y) < radius
    assert np.all(faces.ax[inside & above] == 0.0)


@given(st.integers(0, 8))
def test_a_wall_of_one_cell_is_tight_wherever_it_lies(eighth):
    """Not a path through it, by the open faces."""
    grid = Grid(16, 12, 1.0)
    faces = GridObstacles(grid).update(Box((8.0 + eighth / 8.0, 6.0), (0.5, 99.0)))
    assert not _connected(faces, (6, 2), (6, 14))


@given(st.floats(0.1, 1.4))
def test_a_slanted_wall_of_one_cell_is_tight(angle):
    grid = Grid(24, 24, 1.0)
    faces = GridObstacles(grid).update(Box((12.1, 11.9), (99.0, 0.51), angle))
    assert not _connected(faces, (22, 1), (1, 22))


def _connected(faces, start, goal):
    """Whether open faces lead from one cell (row, column) to another."""
    seen, todo = {start}, [start]
    while todo:
        j, i = todo.pop()
        for part, (m, n) in (
            (faces.ax[j, i], (j, i - 1)), (faces.ax[j, i + 1], (j, i + 1)),
            (faces.ay[j, i], (j - 1, i)), (faces.ay[j + 1, i], (j + 1, i)),
        ):  # fmt: skip
            if (
                part > 0.0
                and (m, n) not in seen
                and 0 <= m < faces.volume.shape[0]
                and 0 <= n < faces.volume.shape[1]
            ):
                seen.add((m, n))
                todo.append((m, n))
    return goal in seen


@pytest.mark.parametrize("shift", [0.0, 0.25, 0.5])
def test_a_gap_of_one_cell_stays_open(shift):
    grid = Grid(16, 12, 1.0)
    walls = Box((8.0, 0.0 + shift), (1.0, 5.0)), Box((8.0, 12.0 + shift), (1.0, 6.0))
    faces = GridObstacles(grid).update(*walls)
    assert _connected(faces, (6, 2), (6, 14))
    assert np.sum(faces.ax[:, 8]) == pytest.approx(1.0, abs=1e-9)


def test_what_touches_at_a_corner_lets_nothing_through():
    grid = Grid(8, 8, 1.0)
    faces = GridObstacles(grid).update(Box((2.0, 6.0), (2.0, 2.0)), Box((6.0, 2.0), (2.0, 2.0)))
    assert not _connected(faces, (1, 1), (6, 6))


def test_what_is_far_from_outlines_is_not_asked():
    """The cost goes by the length of the outlines, not by the cells."""
    asked = []

    class Counted(Disc):
        def sample(self, points):
            asked.append(len(points))
            return super().sample(points)

    grid = Grid(256, 256, 1.0 / 256)
    found = GridObstacles(grid)
    faces = found.update(Counted((0.5, 0.5), 0.1))
    assert sum(asked) < 0.2 * 4 * 256 * 256
    assert faces.volume[128, 128] == 0.0 and faces.volume[10, 10] == 1.0
    assert faces.clear[128, 128 + 40] == pytest.approx(40 - 25.6, abs=2.0)
    found.clear()
    assert np.all(faces.ax == 1.0) and np.all(faces.volume == 1.0)


def test_surfaces_that_answer_nonsense_and_parts_out_of_range_are_refused():
    class Wrong(Disc):
        def sample(self, points):
            found = super().sample(points)
            found.distance[:] = np.nan
            return found

    found = GridObstacles(Grid(8, 8, 1.0))
    with pytest.raises(ValueError, match="obstacle"):
        found.update(Wrong((4.0, 4.0), 2.0))
    with pytest.raises(ValueError, match="ax"):
        found.set_parts(np.full((8, 9), 1.5), np.ones((9, 8)))
    with pytest.raises(ValueError, match="ay"):
        found.set_parts(np.ones((8, 9)), np.ones((8, 8)))
