"""Who may touch a disc within a step: a superset of all that can, and far fewer than all."""

from __future__ import annotations

import numpy as np
import pytest

from game.physics.particles.advance import mark_near_disc


@pytest.mark.parametrize("slack", [0.0, 0.05, 0.6])
@pytest.mark.parametrize("carried", [(0.0, 0.0), (3.0, -2.0)])
def test_whoever_can_reach_a_disc_is_marked(slack, carried):
    random = np.random.default_rng(1)
    n, h, radius = 4000, 0.02, 0.3
    x, y = random.uniform(-4.0, 4.0, (2, n))
    vx, vy = random.normal(0.0, 10.0, (2, n))
    vx[:1000] = vy[:1000] = 0.0
    solid = np.array([0.5, -0.2, radius, *carried, 0.0])
    marks = np.zeros(n, np.uint8)
    mark_near_disc(x, y, vx, vy, marks, solid, slack, h)
    way = h * np.hypot(vx, vy) + slack + h * np.hypot(*carried)
    near = np.hypot(x - 0.5, y + 0.2) <= radius + way
    assert near.sum() > 20
    assert marks[near].all()
    assert slack > 0.5 or marks.mean() < 0.2
