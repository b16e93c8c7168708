"""The direct solver: against a dense matrix, heavy ends, what it refuses."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from game.physics.constraints import LINKS, PositionBasedDynamics
from game.physics.constraints.chains import find_chains
from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY

ONLY_LINKS = EffectSet([LINKS])


def dense_step(positions, weights, links, rest, compliance, h):
    """One Newton step for the lengths by numpy's dense solver (least squares where it is singular)."""
    way = positions[links[:, 1]] - positions[links[:, 0]]
    length = np.linalg.norm(way, axis=1)
    jacobian = np.zeros((len(links), len(positions), 2))
    rows = np.arange(len(links))
    jacobian[rows, links[:, 1]] = way / length[:, None]
    jacobian[rows, links[:, 0]] = -way / length[:, None]
    flat = jacobian.reshape(len(links), -1)
    inverse = np.repeat(weights, 2)
    matrix = flat * inverse @ flat.T + np.diag(np.full(len(links), compliance / h**2))
    tension = np.linalg.solve(matrix, length - rest)
    return positions - (inverse * (flat.T @ tension)).reshape(-1, 2)


@settings(max_examples=30)
@given(st.integers(1, 12), st.integers(0, 10_000), st.booleans(), st.sampled_from((0.0, 1e-4)))
def test_one_solve_is_one_newton_step(count, seed, pinned, compliance):
    rng = np.random.default_rng(seed)
    positions = np.cumsum(rng.uniform(0.2, 1.0, (count + 1, 2)) * rng.choice([-1, 1], (count + 1, 2)), axis=0)
    weights = rng.uniform(0.1, 3.0, count + 1)
    if pinned:
        weights[0] = 0.0
    links = np.array([(i, i + 1) for i in range(count)])[rng.permutation(count)]
    rest = rng.uniform(0.3, 1.2, count)
    system = PositionBasedDynamics(
        positions, weights, links, rest_lengths=rest, compliances=compliance, model="xpbd",
        solver="direct", iterations=1, effects=ONLY_LINKS,
    )  # fmt: skip
    system.step(0.1)
    expected = dense_step(positions, weights, links, rest, compliance, 0.1)
    assert np.allclose(system.positions, expected, rtol=0, atol=1e-11)
    system.check()


def heavy_chain(ratio, x, y, substeps, order="coloured", **settings):
    """Ten links of 0.1 m along (x, y) with a bead at the end of ``ratio`` times the mass of the others."""
    positions = [(0.1 * i * x, 0.1 * i * y) for i in range(11)]
    weights = [0.0] + [1.0] * 9 + [1.0 / ratio]
    return PositionBasedDynamics(
        positions, weights, [(i, i + 1) for i in range(10)], substeps=substeps, effects=GRAVITY | LINKS,
        order=order, **settings,
    )  # fmt: skip


@pytest.mark.parametrize("ratio", [1.0, 1e2, 1e4, 1e6])
def test_a_heavy_end_hangs_without_stretch(ratio):
    """Where sweeps by turns would need thousands of substeps: one solve of one substep."""
    system = heavy_chain(ratio, 0, -1, 1, solver="direct", iterations=1)
    for _ in range(60):
        system.step(1 / 60)
    assert system.measure().worst_strain < 80 * 2.0**-52 * max(ratio, 10.0)  # the matrix's condition


@pytest.mark.parametrize(("ratio", "substeps"), [(1.0, 4), (1e2, 4), (1e4, 20)])
def test_a_heavy_end_swings_without_stretch(ratio, substeps):
    """From horizontal; very unequal masses want smaller substeps, or Newton's steps are too long."""
    system = heavy_chain(ratio, 1, 0, substeps, solver="direct", iterations=4)
    for _ in range(120):
        system.step(1 / 60)
        assert system.measure().worst_strain < 1e-8
    assert system.positions[-1, 1] < -0.2


def test_several_chains_and_free_particles():
    nodes, starts, links = find_chains(np.array([(5, 6), (0, 1), (2, 1)]), 8)
    assert starts.tolist() == [0, 3, 5]
    assert nodes.tolist() in ([0, 1, 2, 5, 6], [2, 1, 0, 5, 6])
    assert sorted(links.tolist()) == [0, 1, 2]


@pytest.mark.parametrize(
    ("links", "word"), [([(0, 1), (0, 2), (0, 3)], "fork at particle 0"), ([(1, 2), (2, 3), (1, 3)], "ring")]
)
def test_what_is_no_chain_is_refused_and_nothing_changed(links, word):
    positions = np.random.default_rng(1).normal(size=(4, 2))
    with pytest.raises(ValueError, match=word):
        PositionBasedDynamics(positions, 1.0, links, solver="direct")
    system = PositionBasedDynamics(positions, 1.0, links)
    with pytest.raises(ValueError, match=word):
        system.change(solver="direct")
    assert system.settings.solver == "gauss-seidel"
    system.step(0.01)
