"""Both papers' fluids: stable however long the step, what is left of the divergence, smear, dyes."""

from __future__ import annotations

import math

import numpy as np
import pytest

from game.physics.stable_fluids import PAPERS, PrintedFluid
from game.physics.stable_fluids.printed import carry_fields


def whirl(paper: str, n: int = 32, **settings) -> PrintedFluid:
    """Two rows of whirls in a closed box of 1 m."""
    fluid = PrintedFluid((n, n), 1.0 / n, 1, paper, **settings)
    x = (np.arange(n) + 0.5) / n
    u, v, _ = fluid.inner
    u[:] = np.sin(math.pi * x)[None, :] * np.cos(math.pi * x)[:, None]
    v[:] = -np.cos(math.pi * x)[None, :] * np.sin(math.pi * x)[:, None]
    return fluid


@pytest.mark.parametrize("paper", PAPERS)
def test_however_long_the_step_nothing_grows(paper):
    for dt in (0.01, 1.0, 100.0):
        fluid = whirl(paper)
        u, v, dye = fluid.inner
        dye[8:16, 8:16] = 1.0
        fastest = np.max(np.hypot(u, v))
        for _ in range(10):
            fluid.step(dt)
            u, v, dye = fluid.inner
            assert np.max(np.hypot(u, v)) <= 1.2 * fastest  # the projection alone is no mean of values
            assert np.min(dye) >= -1e-12 and np.max(dye) <= 1.0 + 1e-12


def test_the_first_paper_solves_to_the_end_and_the_second_by_twenty_sweeps():
    left = {}
    for paper in PAPERS:
        fluid = whirl(paper)
        x = (np.arange(32) + 0.5) / 32
        fluid.inner[0][:] += np.sin(math.pi * x)[None, :]  # all of it wants to go to the right
        before = np.sqrt(np.mean(fluid.divergence() ** 2))
        fluid.step(0.005)
        left[paper] = np.sqrt(np.mean(fluid.divergence() ** 2)) / before
        assert fluid.sweeps == (40 if paper == "stam-2003" else fluid.sweeps) and fluid.sweeps >= 40
    assert left["stam-1999"] < 0.2 * left["stam-2003"] < 0.2


def test_a_pressure_that_is_solved_has_the_divergence_that_was_there():
    fluid = whirl("stam-1999")
    fluid.inner[0][10:14, 10:14] += 1.0
    fluid.step(1e-9)  # nothing is carried: the projection alone
    p = fluid.pressure
    laplacian = p[1:-1, :-2] + p[1:-1, 2:] + p[:-2, 1:-1] + p[2:, 1:-1] - 4.0 * p[1:-1, 1:-1]
    wanted = whirl("stam-1999")
    wanted.inner[0][10:14, 10:14] += 1.0
    wide = wanted.divergence()
    inner = np.s_[2:-2, 2:-2]
    assert np.allclose(laplacian[inner] * 32**2, wide[inner], atol=1e-3 * np.max(np.abs(wide)))


@pytest.mark.parametrize("paper", PAPERS)
def test_a_whirl_decays_as_its_viscosity_says(paper):
    """The whirl is an eigenfunction of the box: an implicit step divides it by 1 + 2 π² ν dt."""
    kept = {}
    for nu in (0.0, 0.02):
        fluid = whirl(paper, 24, viscosity=nu, sweeps=400)
        before = float(np.sum(fluid.inner[0] ** 2))
        for _ in range(10):
            fluid.step(0.01)
        kept[nu] = math.sqrt(float(np.sum(fluid.inner[0] ** 2)) / before)
    exact = (1.0 + 2.0 * math.pi**2 * 0.02 * 0.01) ** -10
    assert kept[0.02] / kept[0.0] == pytest.approx(exact, rel=2e-3) and exact < 0.97


def test_dye_goes_with_the_flow_and_two_stages_turn_it_better_than_one():
    """A spot is turned about the middle by a quarter: one straight trace back throws it outwards."""
    n, off = 48, {}
    for paper in PAPERS:
        fluid = PrintedFluid((n, n), 1.0 / n, 1, paper)
        x = (np.arange(n) + 0.5) / n - 0.5
        dye = np.exp(-((x[None, :] - 0.2) ** 2 + x[:, None] ** 2) / 0.004)
        fluid.fields[1:-1, 1:-1, 0] = dye
        for _ in range(8):
            for field, values in ((fluid.u, -x[:, None]), (fluid.v, x[None, :])):
                field[1:-1, 1:-1] = values
            stages = 2 if paper == "stam-1999" else 1
            turned = np.zeros_like(fluid.fields)
            carry_fields(fluid.fields, fluid.u, fluid.v, 0.5 * math.pi / 8 * n, stages, turned)
            fluid.fields[:] = turned
        share = fluid.inner[2][..., 0] / np.sum(fluid.inner[2][..., 0])
        off[paper] = math.hypot(np.sum(share * x[None, :]) - 0.0, np.sum(share * x[:, None]) - 0.2)
    assert off["stam-1999"] < 0.25 * off["stam-2003"]


@pytest.mark.parametrize("paper", PAPERS)
def test_nothing_moves_in_a_solid_and_a_mirror_gives_the_mirror(paper):
    one, other = whirl(paper), whirl(paper)
    for fluid in (one, other):
        fluid.solid[12:20, 4:10] = True
    other.solid[:] = other.solid[:, ::-1]
    other.inner[0][:], other.inner[1][:] = -other.inner[0][:, ::-1], other.inner[1][:, ::-1]
    for fluid in (one, other):
        fluid.inner[2][5:9, :] = 1.0
        fluid.step(0.02)
    assert np.allclose(one.inner[2], other.inner[2][:, ::-1], atol=0.02)
    assert np.max(np.abs(one.inner[0][14:18, 6:8])) < 0.25


@pytest.mark.parametrize("paper", PAPERS)
def test_put_back_it_goes_on_as_before(paper):
    fluid = whirl(paper)
    fluid.step(0.02)
    kept = type(fluid.state())(*(array.copy() for array in fluid.state()))
    fluid.step(0.02)
    after = fluid.u.copy()
    fluid.restore(kept)
    fluid.step(0.02)
    assert np.array_equal(after, fluid.u)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"shape": (3, 9)}, "shape"),
        ({"cell": 0.0}, "cell"),
        ({"paper": "stam-2013"}, "paper"),
        ({"viscosity": -1.0}, "viscosity"),
        ({"sweeps": 0}, "sweeps"),
        ({"fields": 99}, "fields"),
    ],
)
def test_nonsense_is_refused_by_name(given, words):
    with pytest.raises(ValueError, match=words):
        PrintedFluid(**{"shape": (8, 8), "cell": 0.1, **given})
    with pytest.raises(ValueError, match="dt"):
        PrintedFluid((8, 8), 0.1).step(math.nan)
