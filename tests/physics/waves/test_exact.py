"""Exact solutions of shallow water, against values that were found by another route."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from game.physics.waves import Bowl, bernoulli_depth, conjugate_depth, critical_depth, dam_break

G = 9.81


def test_ritters_dam_on_a_dry_bed():
    dam = dam_break(1.0, 0.0)
    depth, speed = dam.at(np.array([0.0, 1.0, -10.0, 9.0]), 0.8)
    assert depth[0] * speed[0] == pytest.approx(0.9280272452364934, rel=1e-12)
    assert depth == pytest.approx([4.0 / 9.0, 0.2847665674100598, 1.0, 0.0], rel=1e-12)
    assert dam.bore * 0.8 == pytest.approx(5.011347124277065, rel=1e-12)


@pytest.mark.parametrize(
    ("right", "middle", "speed", "bore"),
    [
        (0.1, 0.3961748167994429, 2.3213549956407444, 3.1051336506682135),
        (0.5, 0.7269204461872865, 0.9233639019770798, 2.957918120187525),
        (0.001, 0.06682978341618494, 4.644801090428531, 4.715358835713267),
    ],
)
def test_stokers_dam_on_a_wet_bed(right, middle, speed, bore):
    dam = dam_break(1.0, right)
    assert (dam.middle, dam.speed, dam.bore) == pytest.approx((middle, speed, bore), rel=1e-10)


def test_the_fan_of_a_dam_solves_the_equations():
    """Differences of depth and discharge in time and place cancel, and the depth has no jump but the bore."""
    dam, x, t = dam_break(1.0, 0.1), np.linspace(-2.0, 0.0, 9), 0.7
    e = 1e-5

    def fields(x, t):
        h, u = dam.at(x, t)
        return np.array([h, h * u]), np.array([h * u, h * u * u + 0.5 * G * h * h])

    rate = (fields(x, t + e)[0] - fields(x, t - e)[0]) / (2.0 * e)
    slope = (fields(x + e, t)[1] - fields(x - e, t)[1]) / (2.0 * e)
    assert np.max(np.abs(rate + slope)) < 1e-8
    at = np.linspace(-4.0, 0.999 * dam.bore * t, 4000)
    assert np.max(np.abs(np.diff(dam.at(at, t)[0]))) < 0.01


@pytest.mark.parametrize(
    ("left", "right"), [(0.0, 0.0), (1.0, 1.0), (1.0, -0.1), (math.inf, 0.0), (math.nan, 0.0)]
)
def test_what_is_no_dam_is_refused(left, right):
    with pytest.raises(ValueError, match="left"):
        dam_break(left, right)


def test_depths_over_a_bump():
    """Goutal and Maurel (1997): a slow flow, and one that becomes fast at the crest."""
    head = 2.0 + 4.42**2 / (2.0 * G * 4.0)
    assert bernoulli_depth(head - 0.2, 4.42) == pytest.approx(1.7073474679150338, rel=1e-9)
    assert bernoulli_depth(head - 0.15, 4.42) == pytest.approx(1.7871845746895403, rel=1e-9)
    crest = critical_depth(1.53)
    assert crest == pytest.approx(0.6202564436995096, rel=1e-12)
    assert bernoulli_depth(1.5 * crest + 0.2, 1.53) == pytest.approx(1.0144467983010192, rel=1e-9)
    assert bernoulli_depth(1.5 * crest + 0.2, 1.53, fast=True) == pytest.approx(0.405780945345038, rel=1e-9)
    with pytest.raises(ValueError, match="head"):
        bernoulli_depth(1.4 * crest, 1.53)


def test_a_jump_keeps_its_momentum():
    def force(h):
        return 0.18**2 / h + 0.5 * G * h * h

    behind = conjugate_depth(0.07597027371341673, 0.18)
    assert behind == pytest.approx(0.2593217976608145, rel=1e-9)
    other = brentq(lambda h: force(h) - force(0.07597027371341673), 0.15, 1.0, xtol=1e-15)
    assert behind == pytest.approx(other, rel=1e-12)


def test_the_bowl_swings_as_its_water_does():
    """Against the law of motion of the body of water: its middle is a pendulum in the bowl."""
    bowl = Bowl(0.5, 1.0, 0.25)
    assert 2.0 * math.pi / bowl.rate == pytest.approx(2.006066680710647, rel=1e-12)
    moving = solve_ivp(
        lambda t, y: [y[1], -2.0 * G * bowl.depth / bowl.half**2 * y[0]],
        (0.0, 1.0),
        [0.25, 0.0],
        rtol=1e-11,
        atol=1e-12,
    )
    x = np.linspace(-2.0, 2.0, 4001)
    depth, speed = bowl.at(x, 1.0)
    wet = depth > 0.0
    assert x[wet].mean() == pytest.approx(moving.y[0, -1], abs=2e-3)
    assert speed == pytest.approx(moving.y[1, -1], abs=1e-8)
    assert np.sum(depth) == pytest.approx(np.sum(bowl.at(x, 0.0)[0]), rel=1e-5)
