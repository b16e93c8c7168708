"""The share of a kernel beyond walls, held to integrals known from elsewhere."""

import numpy as np
import pytest

from game.compiler.decorator import kernel
from game.physics.particle_fluids import FluidSettings, Liquid, ParticleFluid, lattice
from game.physics.particle_fluids.laws import follow_law
from game.physics.particle_fluids.smoothing import CUBIC, POLY6, WENDLAND, fill_kernel
from game.physics.particle_fluids.walls import (
    EXACT,
    WEIGHTS,
    Contacts,
    edges_of,
    fill_contacts,
    fill_shares,
    hold_inside,
    stop_at_walls,
    wall_table,
)

PLANE = edges_of([[(-5.0, 0.0), (5.0, 0.0), (5.0, 5.0), (-5.0, 5.0)]])
CORNER = edges_of([[(0.0, 0.0), (5.0, 0.0), (5.0, 5.0), (0.0, 5.0)]])
KERNELS = [POLY6, CUBIC, WENDLAND]


def shares(places, edges, method, kind):
    places = np.array(places, dtype=np.float64)
    share, push = np.zeros(len(places)), np.zeros((len(places), 2))
    fill_shares(places, edges, (method, kind, 1.0), wall_table(kind), share, push)
    return share, push


@pytest.mark.parametrize("method", [WEIGHTS, EXACT])
@pytest.mark.parametrize(
    ("kind", "known"),
    [(POLY6, 0.8149584388589659), (CUBIC, 0.8507566311565898), (WENDLAND, 0.8678491692858623)],
)
def test_a_plane_wall_at_three_tenths(method, kind, known):
    share, push = shares([(0.2, 0.3)], PLANE, method, kind)
    assert 1.0 - share[0] == pytest.approx(known, abs=2e-5)
    assert push[0, 0] == pytest.approx(0.0, abs=1e-12) and push[0, 1] < 0.0
    assert shares([(0.2, 1e-9)], PLANE, method, kind)[0][0] == pytest.approx(0.5, abs=1e-6)


@pytest.mark.parametrize("kind", KERNELS)
def test_a_corner_is_three_quarters_of_the_plane_by_the_edges_and_half_by_the_nearest(kind):
    assert shares([(1e-9, 1e-9)], CORNER, EXACT, kind)[0][0] == pytest.approx(0.75, abs=1e-5)
    assert shares([(1e-9, 1e-9)], CORNER, WEIGHTS, kind)[0][0] == pytest.approx(0.5, abs=1e-5)


@pytest.mark.parametrize("kind", KERNELS)
def test_any_polygon_by_quadrature(kind):
    edges = edges_of([[(0.0, 0.0), (0.7, -0.2), (0.9, 0.6), (0.3, 0.35), (0.05, 0.8)]])
    at = np.array((0.35, 0.2))
    cells = (np.arange(1500) + 0.5) / 1500 * 2.0 - 1.0
    x, y = np.meshgrid(cells, cells)
    inside = np.zeros(x.shape, dtype=bool)
    for ax, ay, bx, by in edges.tolist():
        rises = ((ay - at[1]) > y) != ((by - at[1]) > y)
        with np.errstate(divide="ignore", invalid="ignore"):
            inside ^= rises & (x < ax - at[0] + (y - ay + at[1]) * (bx - ax) / (by - ay))
    value = np.zeros(x.size)
    fill_kernel(kind, np.hypot(x, y).ravel(), value, np.zeros(x.size))
    inner = float(np.sum(value.reshape(x.shape)[inside])) * (2.0 / 1500) * (2.0 / 1500)
    assert shares([at], edges, EXACT, kind)[0][0] == pytest.approx(1.0 - inner, abs=2e-4)


@pytest.mark.parametrize("kind", KERNELS)
@pytest.mark.parametrize("at", [(0.3, 0.4), (0.05, 0.7), (0.6, 0.02)])
def test_its_gradient_is_that_of_the_share(kind, at):
    step = 1e-5
    moved = [(at[0] + step, at[1]), (at[0] - step, at[1]), (at[0], at[1] + step), (at[0], at[1] - step)]
    found = shares(moved, CORNER, EXACT, kind)[0]
    push = shares([at], CORNER, EXACT, kind)[1][0]
    assert push == pytest.approx([(found[0] - found[1]) / 2e-5, (found[2] - found[3]) / 2e-5], abs=2e-3)


def test_what_left_a_vessel_comes_back_and_stops():
    place = np.array([(-0.1, 2.0), (-0.1, -0.1), (2.0, 2.0), (0.001, 3.0)])
    velocity = np.array([(-1.0, 1.0), (-1.0, -1.0), (-1.0, 0.0), (-1.0, 0.5)])
    assert hold_inside(place, velocity, np.ones(4), CORNER, 0.01) >= 2
    assert place[0] == pytest.approx((0.01, 2.0)) and velocity[0] == pytest.approx((0.0, 1.0))
    assert place[1] == pytest.approx((0.01, 0.01)) and velocity[1] == pytest.approx((0.0, 0.0))
    assert place[2].tolist() == [2.0, 2.0] and velocity[2].tolist() == [-1.0, 0.0]
    assert place[3] == pytest.approx((0.01, 3.0)) and velocity[3] == pytest.approx((0.0, 0.5))


def stopped(place, velocity, dt=1.0):
    """Velocity (m/s) left of one at a place, near the walls of a corner and 0.05 m kept off them."""
    contacts = Contacts(np.zeros((1, 2, 2)), np.zeros((1, 2)))
    fill_contacts(np.array([place]), CORNER, 0.5, 0.05, contacts)
    left = np.array([velocity])
    stop(left, contacts, dt)
    return left[0]


@kernel
def stop(velocity, contacts, dt):
    stop_at_walls(velocity, contacts, dt)


def test_a_step_ends_at_a_wall_and_not_beyond():
    assert stopped((2.0, 0.15), (3.0, -0.3)) == pytest.approx((3.0, -0.1))
    assert stopped((2.0, 0.15), (3.0, -0.3), 0.1) == pytest.approx((3.0, -0.3)), (
        "not that far in a short step"
    )
    assert stopped((2.0, 0.15), (3.0, 0.3)) == pytest.approx((3.0, 0.3)), "away from it"
    assert stopped((0.15, 0.25), (-3.0, -3.0)) == pytest.approx((-0.1, -0.2)), "two walls of a corner"
    assert stopped((2.0, 2.0), (0.0, -9.0)) == pytest.approx((0.0, -9.0)), "none near"


def test_pressure_presses_nothing_light_into_a_wall():
    """A light row on the floor, and heavy ones that come down on it: walls are known before places change."""
    fluid = ParticleFluid(0.05, [Liquid(1000.0), Liquid(10.0)], [[(0, 0), (1, 0), (1, 1), (0, 1)]])
    fluid.add(lattice((0.0, -0.015), (1.0, 0.285), 0.05), 0, (0.0, -1.0))
    fluid.kind[:20] = 1
    fluid.place[:20:2, 1] = 0.006
    work = fluid.scratch()
    work.gather(fluid)
    follow_law(fluid, work, 0.004)
    light = work.kind == 1
    assert float(np.min(work.place[light, 1])) >= 0.005 - 1e-12


def density_of_a_row(walls):
    """Relative density beside a plane wall of a full lattice, far from corners."""
    fluid = ParticleFluid(0.05, [Liquid()], [[(0, 0), (1, 0), (1, 1), (0, 1)]], FluidSettings(walls=walls))
    fluid.add(lattice((0.0, 0.0), (1.0, 1.0), 0.05))
    row = (fluid.place[:, 1] < 0.05) & (np.abs(fluid.place[:, 0] - 0.5) < 0.3)
    return float(np.mean(fluid.density()[row]))


def test_what_a_felt_wall_leaves_is_the_error_of_the_lattice_alone():
    """Half a lattice of two spacings a support, and what lies beyond a wall a quarter of it away."""
    at = np.arange(-2, 3)
    x, y = np.meshgrid(at, np.arange(3))
    gaps = np.minimum(np.hypot(x, y).ravel() / 2.0, 1.0)
    value = np.zeros(len(gaps))
    fill_kernel(CUBIC, gaps, value, np.zeros(len(gaps)))
    half = float(np.sum(value)) / 4.0
    points, parts = np.polynomial.legendre.leggauss(60)
    up = 0.625 + 0.375 * points
    reach = np.sqrt(1.0 - up * up)
    across = reach[:, None] * points
    value = np.zeros(across.size)
    fill_kernel(CUBIC, np.minimum(np.hypot(across, up[:, None]).ravel(), 1.0), value, np.zeros(across.size))
    beyond = float(np.sum(0.375 * parts * reach * np.sum(value.reshape(across.shape) * parts, axis=1)))
    assert density_of_a_row(0) == pytest.approx(half, rel=1e-9)
    for felt in (WEIGHTS, EXACT):
        assert density_of_a_row(felt) == pytest.approx(half + beyond, rel=2e-5)


@pytest.mark.parametrize(
    "loops",
    [[[(0, 0), (1, 0)]], [[(0, 0), (1, 1), (2, 2)]], [[(0, 0), (1, 0), (np.nan, 1)]], [[0.0, 1.0]]],
)
def test_vessels_without_an_area_are_refused(loops):
    with pytest.raises(ValueError, match="vessel"):
        edges_of(loops)


def test_the_way_round_does_not_matter():
    assert len(edges_of([[(0, 0), (0, 1), (1, 1), (1, 0)]])) == 4
    turned = edges_of([[(0, 0), (0, 5), (5, 5), (5, 0)]])
    assert shares([(0.2, 0.3)], turned, EXACT, CUBIC)[0] == shares([(0.2, 0.3)], CORNER, EXACT, CUBIC)[0]
