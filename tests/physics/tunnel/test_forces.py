"""Forces along a wall and by the book of momentum, against flows whose forces are known."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.grid import Grid
from game.physics.tunnel import outline_of, shape_named
from game.physics.tunnel.balance import held, outflow
from game.physics.tunnel.outlines import PlacedOutline
from game.physics.tunnel.sticking import faces_near, stick
from game.physics.tunnel.wall_force import (
    FRICTION_TURN,
    FRICTION_X,
    FRICTION_Y,
    LENGTH,
    NORMAL_X,
    PRESSURE_TURN,
    PRESSURE_X,
    PRESSURE_Y,
    SHARE,
    sum_wall,
    wall_points,
)

GRID = Grid(60, 50, 0.1)
AT = (3.1, 2.43)


def fields(pressure, flow_u, flow_v, grid=GRID):
    """p (padded), u, v of functions of x, y."""
    h = grid.cell
    x = (np.arange(grid.nx + 2) - 0.5) * h
    y = (np.arange(grid.ny + 2) - 0.5) * h
    p = pressure(*np.meshgrid(x, y)) * np.ones((grid.ny + 2, grid.nx + 2))
    u = flow_u(*grid.u_places()) * np.ones((grid.ny, grid.nx + 1))
    v = flow_v(*grid.v_places()) * np.ones((grid.ny + 1, grid.nx))
    return np.ascontiguousarray(p), np.ascontiguousarray(u), np.ascontiguousarray(v)


def zero(x, y):
    return 0.0 * x


def summed(outline, p, u, v, viscosity=0.0, attack=0.4):
    place = PlacedOutline(outline.placed(attack, AT))
    out = np.zeros(6)
    sum_wall(p, u, v, wall_points(place, GRID), np.array([GRID.cell, viscosity, 0.0, 0.0, *AT]), out)
    return out


@pytest.mark.parametrize("name", ["disc", "square", "aerofoil", "leaf"])
def test_an_even_slope_of_pressure_lifts_by_the_displaced_area(name):
    """Archimedes: F = -(area) grad p, through the centroid, whatever the outline."""
    outline = shape_named(name)
    found = summed(outline, *fields(lambda x, y: 2.0 * x - 3.0 * y + 7.0, zero, zero))
    assert found[PRESSURE_X] == pytest.approx(-2.0 * outline.area, abs=1e-10)
    assert found[PRESSURE_Y] == pytest.approx(3.0 * outline.area, abs=1e-10)
    assert found[PRESSURE_TURN] == pytest.approx(0.0, abs=3e-3 * outline.area)
    assert not found[FRICTION_X : FRICTION_Y + 1].any()


def test_the_moment_of_pressure_turns_the_right_way():
    """Pressure below the right half of a square's lower side turns it anticlockwise."""
    p, u, v = fields(lambda x, y: np.where((y < AT[1] - 0.45) & (x > AT[0]), 1.0, 0.0), zero, zero)
    assert summed(shape_named("square"), p, u, v, attack=0.0)[PRESSURE_TURN] == pytest.approx(
        0.125, abs=0.035
    )


def test_air_that_turns_about_a_disc_drags_it_round():
    """u_t = r - R outside: the shear at the wall is 1, the moment nu 2 pi R²; the disc's corners cost 1 %."""

    def away(x, y):
        return np.sqrt((x - AT[0]) ** 2 + (y - AT[1]) ** 2)

    def turning(sign, part):
        def field(x, y):
            r = away(x, y)
            across = -(y - AT[1]) if part == 0 else (x - AT[0])
            return sign * np.maximum(r - 0.5, 0.0) * across / r

        return field

    found = summed(shape_named("disc"), *fields(zero, turning(1.0, 0), turning(1.0, 1)), viscosity=0.3)
    assert found[FRICTION_TURN] == pytest.approx(0.3 * 2.0 * math.pi * 0.25, rel=0.03)
    assert abs(found[FRICTION_X]) < 1e-3 and abs(found[PRESSURE_X]) == 0.0


def test_a_wall_point_in_a_bay_looks_less_far():
    made = outline_of(
        [
            (-0.5, -0.5),
            (0.5, -0.5),
            (0.5, -0.1),
            (-0.3, -0.1),
            (-0.3, 0.1),
            (0.5, 0.1),
            (0.5, 0.5),
            (-0.5, 0.5),
        ]
    )
    points = wall_points(PlacedOutline(made.placed(0.0, AT)), GRID)
    assert points[:, LENGTH].sum() == pytest.approx(
        1.0 + 1.0 + 1.0 + 4 * 0.4 - 0.2 - 0.2 + 1.8 - 1.2 + 0.2, abs=1.0
    )
    assert points[:, SHARE].min() < 0.5 and points[:, SHARE].max() == 1.0
    inner = np.abs(points[:, 1] - AT[1]) < 0.11
    assert (points[inner & (np.abs(points[:, NORMAL_X]) < 0.5), SHARE] < 1.0).all()


def book(p, u, v, box, viscosity=0.0, at=AT, grid=GRID):
    out = np.zeros(3)
    outflow(p, u, v, np.array(box), np.array([grid.cell, viscosity, -at[0], -at[1]]), out)
    return out


def test_an_even_wind_and_an_even_shear_leave_nothing_in_a_box():
    box = (5, 41, 7, 39)
    assert book(
        *fields(zero, lambda x, y: 1.5 + zero(x, y), lambda x, y: 0.5 + zero(x, y)), box
    ) == pytest.approx(np.zeros(3), abs=1e-12)
    steady = book(*fields(zero, lambda x, y: y, zero), box, viscosity=0.7)
    assert steady[:2] == pytest.approx(np.zeros(2), abs=1e-12)
    # tau is symmetric: no moment either
    assert steady[2] == pytest.approx(0.0, abs=1e-10)


def test_a_flow_towards_a_stagnation_point_balances_in_the_second_order():
    """u = (x, -y), p = -(x² + y²)/2 about any place is steady: what a box is left with falls by four."""
    errors = []
    for n in (1, 2):
        grid = Grid(40 * n, 40 * n, 0.1 / n)

        def pressure(x, y):
            return -0.5 * ((x - 1.3) ** 2 + (y - 1.7) ** 2)

        made = fields(pressure, lambda x, y: x - 1.3, lambda x, y: -(y - 1.7), grid)
        found = book(*made, (8 * n, 33 * n, 6 * n, 30 * n), 0.4, (2.0, 2.0), grid)
        errors.append(float(np.max(np.abs(found))))
    assert errors[0] < 0.03
    assert errors[1] < 0.3 * errors[0] + 1e-12


def test_the_momentum_that_a_box_holds_is_counted_once_and_where_it_is():
    _, u, v = fields(zero, lambda x, y: 2.0 + zero(x, y), lambda x, y: -1.0 + zero(x, y))
    out = np.zeros(3)
    box = np.array((10, 30, 5, 25))
    held(u, v, np.ones_like(u), np.ones_like(v), box, np.array([0.1, 0.0, -1.0, -0.5]), out)
    assert out[:2] == pytest.approx((8.0, -4.0))
    # middle of the box at (2, 1.5), the point at (1, 0.5): x py - y px = 1 * -4 - 1 * 8
    assert out[2] == pytest.approx(-12.0)
    half = np.zeros(3)
    held(u, v, 0.5 * np.ones_like(u), np.ones_like(v), box, np.array([0.1, 0.0, -1.0, -0.5]), half)
    assert half[0] == pytest.approx(4.0)


def test_faces_near_a_wall_take_the_parabola_from_it_and_faces_inside_stand_still():
    square = shape_named("square", 2.0)
    place = PlacedOutline(square.placed(0.0, AT))
    near = faces_near(place, GRID)
    top = AT[1] + 1.0

    def flow(x, y):
        d = y - top
        return 3.0 * d - 0.5 * d * d

    _, u, v = fields(zero, flow, zero)
    wanted = u.copy()
    stick(u, v, near.faces, near.rows, near.room)
    x, y = GRID.u_places()
    over = (np.abs(x - AT[0]) < 0.7) & (y > top) & (y < top + 0.099)
    assert over.any()
    # the flow between points of the grid is linear, which the parabola's bend leaves a little of
    assert u[over] == pytest.approx(wanted[over], abs=0.002)
    inside = (np.abs(x - AT[0]) < 0.9) & (y < top - 0.001) & (y > top - 0.15)
    assert not u[inside].any()
    far = y > top + 0.11
    assert np.array_equal(u[far], wanted[far])
