"""Air on demand: made under a surface that looks down and falls, taken away where it is free."""

import numpy as np

from game.physics.particle_fluids import FluidSettings, Liquid, ParticleFluid, lattice
from game.physics.particle_fluids.air import air_kind, renew_air

BOX = [[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]]
KINDS = [Liquid(), Liquid(100.0, air=True)]


def block(speed, kinds=KINDS):
    fluid = ParticleFluid(0.05, kinds, BOX, FluidSettings())
    fluid.add(lattice((0.3, 0.5), (0.7, 0.8), 0.05), 0, (0.0, speed))
    return fluid


def test_air_is_made_below_a_block_that_falls_and_not_above_it():
    fluid = block(-3.0)
    count = len(fluid.place)
    made, gone = renew_air(fluid)
    air = fluid.place[fluid.kind == 1]
    assert made == len(air) == len(fluid.place) - count > 0 and gone == 0
    assert (air[:, 1] < 0.5).all() and (fluid.velocity[fluid.kind == 1, 1] == -3.0).all()
    apart = [np.sort(np.linalg.norm(fluid.place - place, axis=1))[1] for place in air]
    assert min(apart) >= 0.8 * 0.05 - 1e-12


def test_none_is_made_by_what_rests_rises_or_has_no_air():
    for fluid in (block(0.0), block(3.0), block(-3.0, [Liquid()])):
        assert renew_air(fluid) == (0, 0)
    assert air_kind(block(0.0)) == 1 and air_kind(block(0.0, [Liquid()])) == -1


def test_air_that_is_free_goes_and_air_within_liquid_stays():
    fluid = block(0.0)
    inside = int(np.argmin(np.sum(np.square(fluid.place - (0.5, 0.65)), axis=1)))
    fluid.kind[inside] = 1
    fluid.add([(0.1, 0.1), (0.9, 0.9)], 1)
    kept = fluid.place[inside].copy()
    assert renew_air(fluid) == (0, 2)
    assert fluid.place[fluid.kind == 1].tolist() == [kept.tolist()]
