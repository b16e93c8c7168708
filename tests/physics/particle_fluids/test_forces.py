"""Forces between pairs: what they keep, what viscosity they are, what tension."""

import numpy as np
import pytest

from game.physics.particle_fluids import FluidSettings, Liquid, ParticleFluid, lattice
from game.physics.particle_fluids.adhesion import adhesion, cohesion_moment
from game.physics.particle_fluids.dragging import drag_along, fill_drags
from game.physics.particle_fluids.forces import act
from game.physics.particle_fluids.laws import follow_law
from game.physics.particle_fluids.settings import LAWS
from game.physics.particle_fluids.smoothing import CUBIC, fill_kernel
from game.physics.particle_fluids.sums import fill_bound, fill_rates, push_by_pressure, spread_heat

BOX = [(0.0, 0.0), (0.6, 0.0), (0.6, 0.6), (0.0, 0.6)]


def heap(law=3, noise=0.15, **liquid):
    fluid = ParticleFluid(0.05, [Liquid(**liquid)], [], FluidSettings(law=law, gravity=0.0))
    random = np.random.default_rng(3)
    fluid.add(lattice((0.0, 0.0), (0.6, 0.6), 0.05) + random.normal(0.0, noise * 0.05, (144, 2)))
    fluid.velocity[:] = random.normal(0.0, 0.5, fluid.place.shape)
    return fluid


@pytest.mark.parametrize("law", range(4), ids=LAWS)
def test_each_law_keeps_momentum(law):
    fluid = heap(law, viscosity=1.0, tension=0.05, springy=True)
    before = fluid.momentum()
    size = float(np.sum(fluid.masses()[:, None] * np.abs(fluid.velocity)))
    for _ in range(5):
        fluid.advance(1.0 / 120.0)
    assert np.max(np.abs(fluid.momentum() - before)) < 1e-12 * size


@pytest.mark.parametrize("law", range(4), ids=LAWS)
def test_the_order_of_particles_and_the_search_do_not_matter(law):
    one, other = heap(law, viscosity=1.0, tension=0.05), heap(law, viscosity=1.0, tension=0.05)
    turned = np.random.default_rng(8).permutation(144)
    other.place, other.velocity = other.place[turned].copy(), other.velocity[turned].copy()
    other.settings = other.settings._replace(search=1)
    for fluid in (one, other):
        for _ in range(3):
            fluid.advance(1.0 / 120.0)
    assert other.place == pytest.approx(one.place[turned], abs=1e-12)


def spin(fluid, velocity):
    return float(
        np.sum(fluid.masses() * (fluid.place[:, 0] * velocity[:, 1] - fluid.place[:, 1] * velocity[:, 0]))
    )


def test_pressure_tension_and_implicit_viscosity_act_along_pairs():
    """Forces along the line of a pair keep angular momentum as well."""
    fluid = heap(viscosity=5.0, tension=0.2)
    work = fluid.scratch()
    work.gather(fluid)
    before = spin(fluid, fluid.velocity)
    act(fluid, work, 0.01)
    pushed = np.zeros_like(work.place)
    push_by_pressure(work.pairs, work.felt, work.body, np.linspace(0.0, 900.0, 144), pushed)
    work.velocity += 0.01 * pushed
    after = np.zeros_like(fluid.velocity)
    after[work.order] = work.velocity
    size = float(np.sum(fluid.masses()[:, None] * np.abs(after)))
    assert abs(spin(fluid, after) - before) < 1e-12 * size
    assert np.max(np.abs(after - fluid.velocity)) > 0.1  # something has acted


@pytest.mark.parametrize("ratio", [1.0, 10.0, 1000.0])
def test_a_step_of_the_pressures_is_never_too_long(ratio):
    """Eigenvalues of their matrix beside its bound: none above 1, nor all far below, which would be slow."""
    fluid = ParticleFluid(0.05, [Liquid(1000.0), Liquid(1000.0 / ratio)], [BOX], FluidSettings())
    random = np.random.default_rng(3)
    fluid.add(
        np.clip(lattice((0.0, 0.0), (0.6, 0.6), 0.05) + random.normal(0.0, 0.015, (144, 2)), 0.01, 0.59)
    )
    fluid.kind[random.random(144) < 0.3] = 1
    work = fluid.scratch()
    work.gather(fluid)
    bound, matrix = np.zeros(144), np.zeros((144, 144))
    fill_bound(work.pairs, work.felt, work.body, work.work.total, work.spread, bound)
    for i in range(144):
        pressure, pushed, rate = np.zeros(144), np.zeros((144, 2)), np.zeros(144)
        pressure[i] = 1.0
        push_by_pressure(work.pairs, work.felt, work.body, pressure, pushed)
        fill_rates(work.pairs, work.felt, work.body, pushed, rate)
        matrix[:, i] = -rate
    assert matrix == pytest.approx(matrix.T, abs=1e-12 * np.max(matrix))
    root = np.sqrt(bound)
    largest = float(np.max(np.linalg.eigvalsh(matrix / root[:, None] / root)))
    assert 0.6 < largest <= 1.0 + 1e-12
    own = np.sqrt(np.diag(matrix))
    assert float(np.max(np.linalg.eigvalsh(matrix / own[:, None] / own))) > 2.0, (
        "its own diagonal is no bound"
    )


def slowing(explicit, direction):
    """Rate against ν k² at which u = sin(k n · x) across n slows, inside a lattice."""
    spacing, viscosity, dt = 1.0 / 60.0, 10.0, 1e-6
    settings = FluidSettings(law=0 if explicit else 3, gravity=0.0, softness=2.0)
    fluid = ParticleFluid(spacing, [Liquid(1000.0, 1000.0 * viscosity)], [], settings)
    fluid.add(lattice((0.0, 0.0), (1.0, 1.0), spacing))
    wave, (x, y) = 2.0 * np.pi, direction
    fluid.velocity[:] = np.sin(wave * (fluid.place @ direction))[:, None] * np.array((-y, x))
    work = fluid.scratch()
    work.gather(fluid)
    act(fluid, work, dt)
    after = np.zeros_like(fluid.velocity)
    after[work.order] = work.velocity
    inner = np.max(np.abs(fluid.place - 0.5), axis=1) < 0.4
    lost = np.sum(((fluid.velocity - after) * fluid.velocity)[inner])
    return float(lost / dt / np.sum(np.square(fluid.velocity[inner])) / (viscosity * wave * wave))


def lattice_viscosity(direction, explicit=False, spacing=1.0 / 60.0):
    """Share of the viscosity asked for that a square lattice has for a wave: the sum over its neighbours."""
    at = np.arange(-2, 3)
    apart = spacing * np.stack(np.meshgrid(at, at), axis=-1).reshape(-1, 2)
    gap = np.sqrt(np.sum(np.square(apart), axis=1))
    support, wave = 2.0 * spacing, 2.0 * np.pi
    apart, gap = apart[(gap > 0.0) & (gap < support)], gap[(gap > 0.0) & (gap < support)]
    values, slopes = np.zeros(len(gap)), np.zeros(len(gap))
    fill_kernel(CUBIC, gap / support, values, slopes)
    across = (apart @ np.array((-direction[1], direction[0]))) / gap
    felt = 8.0 * np.abs(slopes) / support**3 / gap * across * across
    if explicit:
        felt = 40.0 / np.pi * (1.0 - gap / support) / support**4
    left = 1.0 - np.cos(wave * (apart @ np.array(direction)))
    return float(spacing * spacing * np.sum(felt * left)) / (wave * wave)


@pytest.mark.parametrize("explicit", [False, True], ids=["implicit", "Müller"])
@pytest.mark.parametrize("direction", [(1.0, 0.0), (np.sqrt(0.5), np.sqrt(0.5))], ids=["rows", "diagonals"])
def test_viscosity_of_a_shear_wave_is_the_sum_over_the_lattice(explicit, direction):
    """The bound is what conjugate gradients leave: 1e-6 of the momentum, of which a step takes 4e-4."""
    known = lattice_viscosity(direction, explicit)
    assert slowing(explicit, direction) == pytest.approx(known, rel=1e-6 / 4e-4)


def test_viscosity_over_all_directions_is_the_one_asked_for():
    """A lattice resists by a third too little along its rows and too much along its diagonals.

    What is left over all directions, and of the explicit law in each, is the error of so few neighbours.
    """
    turns = np.linspace(0.0, np.pi, 16, endpoint=False)
    over_all = [lattice_viscosity((np.cos(turn), np.sin(turn))) for turn in turns]
    assert np.mean(over_all) == pytest.approx(1.0, abs=0.02)
    of_explicit = [lattice_viscosity((np.cos(turn), np.sin(turn)), True) for turn in turns]
    assert np.ptp(of_explicit) < 0.01 and of_explicit[0] == pytest.approx(0.8633, abs=1e-3)


def test_viscosity_takes_energy_whatever_the_step():
    for dt in (1e-4, 1.0, 1e4):
        fluid = heap(viscosity=100.0)
        work = fluid.scratch()
        work.gather(fluid)
        before = fluid.energy()[0]
        drags = (work.pair_drag, work.wall_drag)
        fill_drags(work.pairs, work.felt, work.body, drags, (fluid.viscosities, work.kind, 0.025, 0.1, 1.0))
        made = drag_along(work.pairs, work.body, drags, work.velocity, tuple(work.vectors), (dt, 1e-10, 2000))
        assert made < 2000
        work.scatter(fluid)
        assert 0.0 <= fluid.energy()[0] < before


def test_tension_is_the_work_that_parts_a_lattice():
    """Energy of all pairs across a line of a square lattice, half for each side: within a tenth of σ."""
    spacing, support = 0.5, 1.0
    strength = float(adhesion([0.07], support)[0, 0])
    q = np.linspace(0.0, 1.0, 20001)
    force = (q - 1.0 / 3.0) * (1.0 - q) * (3.0 + 4.2 * q)
    energy = -np.cumsum(force[::-1])[::-1] * (q[1] - q[0])
    total = 0.0
    for a in range(1, 4):
        for b in range(-3, 4):
            total -= 0.5 * (a / spacing) * np.interp(np.hypot(a, b) * spacing, q, energy, right=0.0)
    volume = spacing * spacing
    assert strength * volume * volume * total == pytest.approx(0.07, rel=0.1)
    assert cohesion_moment() == pytest.approx(float(np.trapezoid(q * q * q * force, q)), rel=1e-6)


def test_heat_spreads_at_its_rate_and_none_is_lost():
    """Temperature x² over a lattice: its Laplacian is 2."""
    fluid = ParticleFluid(0.05, [Liquid()], [], FluidSettings(gravity=0.0))
    fluid.add(lattice((0.0, 0.0), (1.0, 1.0), 0.05))
    work = fluid.scratch()
    work.gather(fluid)
    heat = 300.0 + np.square(work.place[:, 0])
    before = heat.copy()
    spread_heat(work.pairs, work.felt, work.body, (before.copy(), heat), 1e-3)
    inner = np.max(np.abs(work.place - 0.5), axis=1) < 0.35
    assert float(np.mean((heat - before)[inner])) == pytest.approx(2e-3, rel=0.1)
    assert float(np.sum(heat)) == pytest.approx(float(np.sum(before)), rel=1e-14)


def test_two_kinds_do_not_hold_together():
    strengths = adhesion([0.07, 0.02], 0.1)
    assert strengths[0, 1] == strengths[1, 0] == 0.0 and strengths[0, 0] > strengths[1, 1] > 0.0


def test_a_law_says_how_many_iterations_it_made():
    fluid = heap()
    work = fluid.scratch()
    work.gather(fluid)
    assert 2 <= follow_law(fluid, work, 1e-3) <= 2 * fluid.settings.iterations
