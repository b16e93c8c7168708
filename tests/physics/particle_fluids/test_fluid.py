"""Whole fluids: hard cases, rest, layers, honey, slime, boiling, and the dam beside another code."""

import numpy as np
import pytest

from game.physics.effects import EffectSet
from game.physics.particle_fluids import LAWS, FluidSettings, Liquid, ParticleFluid, lattice
from game.physics.particle_fluids.effects import DRAGGING, PARTICLE_FLUIDS, SPRINGS

WATER = (Liquid(),)
BOX = [[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]]
# Column a by 2a: t sqrt(2 g / a) and front / a of a run of PySPH with 3,938 particles
DAM = ((0.832, 1.38), (1.219, 1.71), (1.997, 2.6), (2.547, 3.34))


def filled(law=3, height=0.5, liquids=WATER, **settings):
    fluid = ParticleFluid(0.05, liquids, BOX, FluidSettings(law=law, **settings))
    fluid.add(lattice((0.0, 0.0), (1.0, height), 0.05))
    return fluid


def played(fluid, seconds):
    for _ in range(round(60.0 * seconds)):
        fluid.advance(1.0 / 60.0)
    return fluid


def inside(fluid):
    return bool(((fluid.place > 0.0) & (fluid.place < 1.0)).all() and np.isfinite(fluid.velocity).all())


@pytest.mark.parametrize("law", range(4), ids=LAWS)
def test_a_lone_particle_falls_and_lies(law):
    fluid = ParticleFluid(0.05, settings=FluidSettings(law=law), vessel=BOX)
    fluid.add([(0.5, 0.5)])
    played(fluid, 0.2)
    assert fluid.place[0, 1] == pytest.approx(0.5 - 0.5 * 9.81 * 0.04, rel=0.05)
    played(fluid, 1.0)
    assert fluid.place[0] == pytest.approx((0.5, 0.005), abs=0.03) and not fluid.velocity[0, 1]


@pytest.mark.parametrize("law", range(4), ids=LAWS)
def test_two_on_one_spot_part(law):
    fluid = ParticleFluid(0.05, settings=FluidSettings(law=law), vessel=BOX)
    fluid.add([(0.5, 0.4), (0.5, 0.4)])
    played(fluid, 1.0)
    assert inside(fluid) and abs(fluid.place[0, 0] - fluid.place[1, 0]) > 0.02


@pytest.mark.parametrize("law", [0, 1, 3], ids=[LAWS[0], LAWS[1], LAWS[3]])
def test_500_in_one_cell_come_apart_and_stay_inside(law):
    fluid = ParticleFluid(0.05, settings=FluidSettings(law=law), vessel=BOX)
    fluid.add(np.random.default_rng(2).uniform(0.5, 0.55, (500, 2)))
    played(fluid, 0.5)
    assert inside(fluid) and np.ptp(fluid.place[:, 0]) > 0.5
    assert np.max(np.abs(fluid.velocity)) < 20.0


@pytest.mark.parametrize("law", range(4), ids=LAWS)
def test_corners_and_gaps_narrower_than_a_kernel(law):
    wedge = [[(0.0, 1.0), (0.49, 0.0), (0.51, 0.0), (1.0, 1.0)]]
    fluid = ParticleFluid(0.05, settings=FluidSettings(law=law), vessel=wedge)
    fluid.add(lattice((0.3, 0.7), (0.7, 0.95), 0.05))
    played(fluid, 1.5)
    side = np.abs(fluid.place[:, 0] - 0.5)
    assert (side <= 0.01 + 0.49 * fluid.place[:, 1] + 1e-9).all() and np.isfinite(fluid.velocity).all()


def test_60_s_of_rest():
    """No creep, next to no motion, no area lost."""
    fluid = played(filled(), 20.0)
    height = float(np.mean(fluid.place[:, 1]))
    played(fluid, 40.0)
    motion = fluid.energy()[0]
    assert motion <= 1e-4 * float(np.sum(fluid.masses())) * 9.81 * 0.5
    assert float(np.mean(fluid.place[:, 1])) == pytest.approx(height, rel=0.01)
    assert height == pytest.approx(0.25, rel=0.015)
    assert fluid.error < 2e-3 and fluid.worst < 0.01


@pytest.mark.parametrize("law", [0, 1, 2], ids=LAWS[:3])
def test_printed_laws_come_to_rest_too(law):
    fluid = played(filled(law), 10.0)
    assert fluid.energy()[0] <= 2e-4 * float(np.sum(fluid.masses())) * 9.81 * 0.5


@pytest.mark.parametrize("ratio", [2.0, 100.0])
def test_a_light_liquid_rests_on_a_heavy_one(ratio):
    fluid = filled(height=0.3, liquids=[Liquid(1000.0), Liquid(1000.0 / ratio)])
    fluid.add(lattice((0.0, 0.3), (1.0, 0.6), 0.05), 1)
    played(fluid, 10.0)
    heavy, light = (fluid.place[fluid.kind == kind, 1] for kind in (0, 1))
    assert float(np.mean(heavy)) == pytest.approx(0.15, rel=0.03)
    assert float(np.mean(light)) == pytest.approx(0.45, rel=0.04)
    assert np.quantile(heavy, 0.9) < np.quantile(light, 0.1)


@pytest.mark.parametrize("ratio", [2.0, 10.0, 100.0])
def test_a_heavy_liquid_sinks_through_a_light_one(ratio):
    """Neither is ever squeezed, whatever their densities, and they change places."""
    fluid = filled(height=0.3, liquids=[Liquid(1000.0 / ratio), Liquid(1000.0)])
    random = np.random.default_rng(0)
    above = lattice((0.0, 0.3), (1.0, 0.6), 0.05)
    fluid.add(above + random.normal(0.0, 0.002, above.shape), 1)
    for _ in range(round(60 * 4.0)):
        fluid.advance(1.0 / 60.0)
        assert fluid.worst < 0.15 and fluid.error < 0.02
    assert np.mean(fluid.place[fluid.kind == 1, 1]) < 0.22 < 0.38 < np.mean(fluid.place[fluid.kind == 0, 1])


def test_light_liquid_under_heavy_takes_shorter_steps():
    """As the root of the density: pressure over density is the square of a speed."""
    steps = []
    for density in (1000.0, 10.0):
        fluid = filled(height=0.2, liquids=[Liquid(density), Liquid(1000.0)])
        fluid.add(lattice((0.0, 0.2), (1.0, 0.8), 0.05), 1)
        fluid.pressure[1] = 1000.0 * 9.81 * (0.8 - fluid.place[:, 1])
        steps.append(fluid.longest_step())
    assert steps[1] == pytest.approx(0.5 * 0.05 / np.sqrt(9.81 * 0.775 * 100.0), rel=1e-12)
    assert steps[0] > 5.0 * steps[1]


def test_vapour_a_tenth_as_dense_rises_through_what_boils():
    water = Liquid(1000.0, boils=373.0, latent=20.0, vapour=1)
    fluid = filled(height=0.6, liquids=[water, Liquid(100.0)], diffusivity=0.0)
    fluid.heat[fluid.place[:, 1] < 0.1] = 420.0
    worst = 0.0
    for _ in range(120):
        fluid.advance(1.0 / 60.0)
        worst = max(worst, fluid.worst)
    vapour = fluid.place[fluid.kind == 1, 1]
    assert len(vapour) == 40 and np.mean(vapour) > 0.3 and worst < 0.15


def test_a_column_of_fifty_layers_stands():
    """Pressure goes through all of them, though no step has iterations enough to do so at once."""
    fluid = ParticleFluid(0.03, [Liquid(1000.0, 0.05)], [[(0, 0), (0.3, 0), (0.3, 2), (0, 2)]])
    fluid.add(lattice((0.0, 0.0), (0.3, 1.5), 0.03))
    for _ in range(120):
        fluid.advance(1.0 / 120.0)
        assert fluid.worst < 0.1
    assert fluid.error < 0.01 and float(np.mean(fluid.place[:, 1])) == pytest.approx(0.75, rel=0.03)


def test_honey_at_the_step_of_water():
    """Ten thousand times as viscous: no more substeps, and a heap that has hardly begun to spread.

    A free block of height H gives way at its foot by ρ g H / (4 μ) of its width a second, the most there is.
    """
    steps, fronts = [], []
    for viscosity in (0.001, 10.0, 1e5):
        fluid = ParticleFluid(
            0.05, [Liquid(1400.0, viscosity)], [[(0, 0), (4, 0), (4, 2), (0, 2)]], FluidSettings()
        )
        fluid.add(lattice((0.0, 0.0), (1.0, 1.0), 0.05))
        steps.append(sum(fluid.advance(1.0 / 60.0) for _ in range(30)))
        fronts.append(float(np.max(fluid.place[:, 0])))
    assert steps[1] <= steps[0] and steps[2] <= steps[0]
    assert fronts[0] > fronts[1] + 0.05 > 1.0
    strain = 0.5 * 1400.0 * 9.81 * 1.0 / (4.0 * 1e5)
    assert 0.975 < fronts[2] < 0.975 * (1.0 + strain)


def test_the_dam_beside_another_code():
    """Fronts within 3 % of PySPH's at equal times, with half as many particles."""
    spacing = 1.0 / 30.0
    fluid = ParticleFluid(spacing, [Liquid()], [[(0, 0), (4, 0), (4, 4), (0, 4)]], FluidSettings())
    fluid.add(lattice((0.0, 0.0), (1.0, 2.0), spacing))
    time = 0.0
    for until, front in DAM:
        now = until / np.sqrt(2.0 * 9.81)
        while time < now - 1e-12:
            step = min(1.0 / 60.0, now - time)
            fluid.advance(step)
            time += step
        assert float(np.max(fluid.place[:, 0])) == pytest.approx(front, rel=0.03)
        assert fluid.error < 0.02


def test_longer_steps_are_cut_and_nonsense_is_refused():
    fluid = filled()
    assert fluid.advance(1.0 / 6.0) > 10
    for wrong in (-1.0, float("nan"), float("inf")):
        with pytest.raises(ValueError, match="duration"):
            fluid.advance(wrong)
    with pytest.raises(RuntimeError, match="substeps"):
        fluid.advance(1e4)
    for spacing in (0.0, -1.0, 1e300, 1e-300, float("nan")):
        with pytest.raises(ValueError, match="spacing"):
            ParticleFluid(spacing)
    with pytest.raises(ValueError, match="places"):
        fluid.add([(np.nan, 0.0)])
    with pytest.raises(ValueError, match="kind"):
        fluid.add([(0.5, 0.9)], 3)
    with pytest.raises(ValueError, match="heat"):
        fluid.add([(0.5, 0.9)], 0, heat=0.0)
    for wrong in ({"density": 0.0}, {"viscosity": -1.0}, {"tension": float("inf")}, {"vapour": 4}):
        with pytest.raises(ValueError, match=next(iter(wrong))):
            ParticleFluid(0.1, [Liquid(**wrong)])
    with pytest.raises(ValueError, match="liquids: expected 1"):
        fluid.set_liquids([])


def test_a_place_that_is_no_number_is_named():
    fluid = filled()
    fluid.place[7, 0] = np.nan
    with pytest.raises(ValueError, match="particle 7"):
        fluid.advance(1.0 / 60.0)


@pytest.mark.parametrize("law", range(4), ids=LAWS)
def test_a_state_taken_back_gives_the_same_bits(law):
    fluid = played(filled(law, liquids=[Liquid(springy=True)]), 0.2)
    saved = type(fluid.state())(*(field.copy() for field in fluid.state()))
    played(fluid, 0.2)
    after = [field.copy() for field in fluid.state()]
    fluid.restore(saved)
    fluid.remove(np.zeros(len(fluid.place), dtype=bool))
    played(fluid, 0.2)
    assert all(np.array_equal(a, b) for a, b in zip(after, fluid.state(), strict=True))


def slab(active, **settings):
    """A slab that hangs free is stretched to 1.1 times its width, and let go."""
    fluid = ParticleFluid(
        0.05, [Liquid(viscosity=5.0, springy=True)], [], FluidSettings(gravity=0.0, **settings), active
    )
    fluid.add(lattice((0.0, 0.0), (0.6, 0.3), 0.05))
    fluid.advance(1e-4)
    fluid.place[:, 0] = 0.3 + 1.1 * (fluid.place[:, 0] - 0.3)
    return fluid


def test_slime_springs_back_until_it_has_yielded():
    everything = EffectSet(PARTICLE_FLUIDS.known)
    widths = {}
    for name, fluid in {
        "elastic": slab(everything, borne=0.5),
        "yields": slab(everything, borne=0.0, flow=50.0),
        "none": slab(everything.without(SPRINGS)),
    }.items():
        for _ in range(30):
            fluid.advance(1.0 / 60.0)
        widths[name] = float(np.ptp(fluid.place[:, 0]))
    assert widths["elastic"] < widths["yields"] - 0.01 < widths["none"] + 0.02


def test_springs_outlive_the_removal_of_others():
    fluid = slab(EffectSet(PARTICLE_FLUIDS.known))
    kept = np.zeros(len(fluid.place), dtype=bool)
    kept[::7] = True
    fluid.remove(kept)
    assert fluid.partner.max() < len(fluid.place) == len(fluid.partner)
    fluid.advance(1.0 / 60.0)
    assert np.isfinite(fluid.place).all()


def test_boiled_and_condensed_again_nothing_is_missing():
    """Heat is kept by conduction, and what boiled is liquid again, with its own heat."""
    water = Liquid(1000.0, boils=373.0, latent=50.0, vapour=1)
    fluid = filled(height=0.3, liquids=[water, Liquid(10.0, 0.001)])
    count = len(fluid.place)
    fluid.heat[:] = 430.0
    played(fluid, 0.2)
    assert (fluid.kind == 1).all() and fluid.temperature() == pytest.approx(np.full(count, 380.0))
    assert float(np.sum(fluid.masses())) == pytest.approx(0.01 * 1000.0 * 0.3, rel=1e-9)
    fluid.heat[:] = 400.0
    played(fluid, 0.1)
    assert (fluid.kind == 1).all() and fluid.temperature() == pytest.approx(np.full(count, 373.0))
    fluid.heat[:] = 350.0
    played(fluid, 0.2)
    assert (fluid.kind == 0).all() and len(fluid.place) == count
    assert float(np.sum(fluid.masses())) == pytest.approx(1000.0 * 0.3, rel=1e-9)


def test_without_viscosity_honey_is_water():
    active = EffectSet(PARTICLE_FLUIDS.known).without(DRAGGING)
    one, other = (filled(liquids=[Liquid(viscosity=viscosity)]) for viscosity in (100.0, 0.0))
    one.active = active
    assert np.array_equal(played(one, 0.2).place, played(other, 0.2).place)
