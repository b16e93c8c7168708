"""What goes down to a coarser level beside walls comes up again by the same weights."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.multigrid.walls import prolong_irregular, restrict_irregular


def axis(count, coarse, rng):
    """(near, far, share) of an axis: each fine cell between its own coarse cell and the one beside it."""
    near = np.arange(count) // 2
    far = np.clip(near + np.where(np.arange(count) % 2 == 0, -1, 1), 0, coarse - 1)
    share = rng.uniform(0.1, 0.9, count)
    return near, far, np.stack([share, 1.0 - share], axis=1)


@pytest.mark.parametrize("seed", range(3))
def test_restriction_is_the_transpose_of_prolongation(seed):
    """<R r, e> = <r, P e> for any r and e, whichever coarse cells a fine one may take from."""
    rng = np.random.default_rng(seed)
    ny, nx = 6, 10
    x, y = axis(nx, nx // 2, rng), axis(ny, ny // 2, rng)
    listed = rng.permutation(ny * nx)[:40]
    ways = rng.integers(0, 16, 40)
    r, e = rng.standard_normal((ny + 2, nx + 2)), np.zeros((ny // 2 + 2, nx // 2 + 2))
    e[1:-1, 1:-1] = rng.standard_normal((ny // 2, nx // 2))
    down, up = np.zeros((ny // 2, nx // 2)), np.zeros((ny + 2, nx + 2))
    restrict_irregular(r, down, ways, listed, x, y)
    prolong_irregular(e, up, ways, listed, x, y)
    assert np.sum(down * e[1:-1, 1:-1]) == pytest.approx(np.sum(r * up), rel=1e-12)
    assert np.abs(down).min() > 0.0


def test_a_constant_comes_up_as_itself():
    """Weights sum to 1 wherever a fine cell may take from any coarse cell at all."""
    rng = np.random.default_rng(0)
    x, y = axis(4, 2, rng), axis(4, 2, rng)
    ones, listed = np.ones((4, 4)), np.arange(16)
    up = np.zeros((6, 6))
    prolong_irregular(ones, up, np.arange(16), listed, x, y)
    assert up[1:-1, 1:-1].ravel() == pytest.approx([0.0] + [1.0] * 15, rel=1e-12)
