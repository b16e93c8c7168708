"""What the pages of fluids of particles measure, held to laws and to naive twins."""

from __future__ import annotations

import numpy as np
import pytest

from game.app.stagehand.headless import picture_of_stage
from game.levels import level_files, load_level
from game.physics.particle_fluids.walls import EXACT, NONE, PARTICLES, WEIGHTS
from game.scenes.honey.level import HoneyContent
from game.scenes.honey.papers import kernels, liquids, order, slime, vessels
from game.scenes.honey.scene import Honey
from game.stage import Stage


def test_symmetric_pressures_make_no_momentum_and_plain_ones_do():
    assert kernels.lopsided(True) < 1e-14 < 1e-3 < kernels.lopsided(False)


def test_the_printed_curvature_goes_with_the_support_and_not_with_the_drop():
    coarse, fine = (kernels.rim(spacing)[2] for spacing in (0.1, 0.05))
    assert coarse > 5.0 and fine == pytest.approx(2.0 * coarse, rel=0.05)


def test_kernels_fill_the_plane_once_and_viscosity_never_speeds_up():
    q = np.linspace(0.01, 0.99, 50)
    assert all(kernels.integral(kind) == pytest.approx(1.0, abs=1e-12) for kind in kernels.PRINTED)
    assert (kernels._bend(kernels.VISCOUS, q) > 0.0).all() and kernels._bend(kernels.POLY6, q)[0] < 0.0
    step = 1e-5
    up, down = (kernels.kernel_values(kernels.POLY6, q + side)[1] for side in (step, -step))
    known = (up - down) / (2.0 * step) + kernels.kernel_values(kernels.POLY6, q)[1] / q
    assert kernels._bend(kernels.POLY6, q) == pytest.approx(known, rel=1e-4, abs=1e-3)
    points, parts = np.polynomial.legendre.leggauss(8)
    at = 0.5 * (1.0 + points)  # the Laplacian of x² + y² is 4
    assert np.sum(0.5 * parts * 2.0 * np.pi * at**3 * kernels._bend(kernels.VISCOUS, at)) == pytest.approx(
        4.0
    )


def test_densities_by_masses_jump_where_liquids_meet_and_those_by_volumes_do_not():
    _, by_mass, by_volume = liquids.densities_at_interface(10.0)
    assert np.max(by_mass) > 2.0 and np.max(np.abs(by_volume[:-1] - 1.0)) < 0.05
    _, alike, volumes = liquids.densities_at_interface(1.0)
    assert alike == pytest.approx(volumes, rel=1e-12)


def test_heat_along_a_bar_is_fouriers():
    x, found = liquids.warmed(20.0)
    assert np.max(np.abs(found - liquids.heat_law(x, 20.0))) < 0.01 * (liquids.HOT - liquids.COLD)


def test_a_square_drop_becomes_round_and_keeps_its_mass():
    before, after = liquids.square_drop(0.0), liquids.square_drop(2.0)
    assert liquids.roundness(before.place) == pytest.approx(np.sqrt(2.0), rel=1e-9)
    assert liquids.roundness(after.place) < 1.08
    assert np.array_equal(before.masses(), after.masses())
    first, last = liquids.boiled()
    assert last == pytest.approx(first, rel=1e-12)


def test_air_is_made_under_a_falling_block_alone():
    fluid = liquids.falling_block()
    air, water = (fluid.place[fluid.kind == kind] for kind in (1, 0))
    assert len(air) > 4 and np.max(air[:, 1]) < np.min(water[:, 1]) + liquids.SPACING


def test_springs_flow_by_their_law_and_a_slab_that_yielded_stays_wider():
    ours, law = slime.flowed(0.3)
    assert ours == pytest.approx(law, rel=0.01)
    widths = {name: [np.ptp(slime.slab(rules, s).place[:, 0]) for s in (0.4, 0.7, 1.0)] for name, rules in
              slime.RULES.items()}  # fmt: skip
    means = {name: float(np.mean(one)) / 0.55 for name, one in widths.items()}
    assert means["yielding"] > means["elastic"] + 0.1 > means["no springs"] + 0.3
    assert means["elastic"] == pytest.approx(1.0, abs=0.1)


def test_relaxation_parts_clusters():
    strewn, relaxed = (slime.nearest(slime.heap(seconds).place) / slime.SPACING for seconds in (0.0, 1.0))
    assert np.mean(strewn < 0.5) > 0.2 and np.mean(relaxed < 0.5) < 0.02


def test_walls_that_are_felt_take_most_of_the_error_away():
    rows, corners = zip(*(vessels.density_errors(walls) for walls in range(4)), strict=True)
    for off in (rows, corners):
        assert max(off[WEIGHTS], off[EXACT], off[PARTICLES]) < 0.4 * off[NONE]
    assert corners[EXACT] < 0.7 * corners[WEIGHTS]


def test_the_model_of_a_cache_counts_as_one_does_by_hand():
    # lines of 2 places, 2 lines held: 0-1 | 0-1, 2-3 | 0-1 is here, 4-5 puts 2-3 out | 2-3 again puts 0-1 out
    assert order.misses([0, 1, 0, 2], [0, 2, 4, 5], line=2, cache=2) == 4
    assert order.misses([0, 2, 4, 0], [1, 3, 5, 1], line=2, cache=2) == 4
    assert order.misses([0, 2, 4, 0], [1, 3, 5, 1], line=2, cache=3) == 3


def test_along_the_curve_a_small_cache_fetches_less():
    found = {method: order.misses(*order.pairs_in_order(method, 20_000)) for method in ("grid", "z-order")}
    assert found["z-order"] < 0.8 * found["grid"]
    apart, together = order.cells_looked_up(20_000)
    assert together < 0.3 * apart


def test_ranks_are_places_in_memory():
    fluid = kernels.pool(300)
    ranks = fluid.ranks()
    assert sorted(ranks.tolist()) == list(range(len(fluid.place)))
    assert np.array_equal(fluid.place[np.argsort(ranks)], fluid.scratch().place)


def test_a_level_shows_where_particles_stand_in_memory():
    path = next(path for path in level_files("honey") if path.stem == "z-order")
    stage = Stage(Honey, level=load_level(path, "honey", HoneyContent))
    stage.run(1)
    picture = picture_of_stage(stage, (320, 180))
    row = [tuple(picture.get_at((x, 150)))[:3] for x in range(70, 250)]
    assert len(set(row)) > 60, "as many colours as there are turns of the curve"
