"""The exact free body: against values known to 15 digits, its invariants, and the limits of its formulas."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.special import ellipj

from game.physics.rigid import (
    FreeTop,
    quaternion_normalized,
    quaternion_rotate,
    quaternion_to_matrix,
    turn_between,
)
from game.physics.rigid.free_top import elliptic_functions
from tests.physics.rigid.rigid_motion import FLIPS, MOMENTS, PERIODS, SPINS_AT_10, STARTS

EPS = 2.0**-52
START = quaternion_normalized((0.5, 0.1, -0.7, 0.3))


@pytest.mark.parametrize("name", STARTS)
def test_spin_period_and_flips(name):
    """Known along two ways to 1e-12."""
    top = FreeTop(MOMENTS, STARTS[name])
    assert np.allclose(top.spin(0.0), STARTS[name], rtol=0, atol=4 * EPS)
    assert np.allclose(top.spin(10.0), SPINS_AT_10[name], rtol=0, atol=1e-12)
    assert top.period == pytest.approx(PERIODS[name], rel=1e-13)
    assert np.allclose(top.spin(top.period), STARTS[name], rtol=0, atol=1e-13)
    count, first = FLIPS[name]
    flips = top.flips(100.0)
    assert len(flips) == count
    assert flips[0] == pytest.approx(first, abs=1e-12)
    assert np.allclose(np.diff(flips), 0.5 * PERIODS[name], rtol=1e-12)
    assert all(abs(top.spin(t)[1]) < 1e-11 for t in flips)


@pytest.mark.parametrize(
    "spin",
    [
        *STARTS.values(),
        (-0.4, -3.0, -0.1),
        (-1.0, 0.5, -2.0),
        (1.0, 0.0, 1.0),
        (0.0, 1.0, 1.0),
        (2.9, 0.1, 0.01),
    ],
)
def test_orientation_against_an_integrator_of_order_eight(spin):
    def slope(_, y):
        (w, x, y_, z), (a, b, c) = y[:4], y[4:]
        turn = (
            -x * a - y_ * b - z * c,
            w * a + y_ * c - z * b,
            w * b + z * a - x * c,
            w * c + x * b - y_ * a,
        )
        return np.concatenate((0.5 * np.array(turn), -np.cross(y[4:], MOMENTS * y[4:]) / MOMENTS))

    run = solve_ivp(slope, (0, 10), (*START, *spin), method="DOP853", rtol=1e-13, atol=1e-14)
    top = FreeTop(MOMENTS, spin)
    assert np.allclose(top.spin(10.0), run.y[4:, -1], rtol=0, atol=5e-12)
    assert turn_between(top.orientation(START, 10.0), run.y[:4, -1]) < 2e-12


def test_a_symmetric_body_precesses():
    """I = (1, 1, 3), w = (0.5, 0, 2): the spin goes round axis 3 at (I3 - I1) / I1 w3 = 4 rad/s."""
    top = FreeTop((1.0, 1.0, 3.0), (0.5, 0.0, 2.0))
    assert np.allclose(top.spin(1.0), (0.5 * math.cos(4), 0.5 * math.sin(4), 2.0), rtol=0, atol=1e-14)
    assert np.allclose(top.spin(1.0)[:2], (-0.326821810431806, -0.378401247653964), rtol=0, atol=1e-14)
    assert top.period == pytest.approx(math.pi / 2, rel=1e-14)
    long = FreeTop((1.0, 3.0, 3.0), (2.0, 0.0, 0.5))  # the other way for a long one: (I1 - I3) / I3 w1
    assert np.allclose(
        long.spin(1.0), (2.0, -0.5 * math.sin(-4 / 3), 0.5 * math.cos(4 / 3)), rtol=0, atol=1e-14
    )
    ball = FreeTop((2.0, 2.0, 2.0), (1.0, 2.0, 3.0))
    assert np.allclose(ball.spin(7.0), (1, 2, 3), rtol=0, atol=1e-14)


@pytest.mark.parametrize("axis", range(3))
def test_a_spin_about_an_axis_stays(axis):
    """Also about the middle axis: what is exact does not fall."""
    spin = np.zeros(3)
    spin[axis] = 3.0
    top = FreeTop(MOMENTS, spin)
    assert np.array_equal(top.spin(1000.0), spin)
    assert top.flips(100.0) == []
    turn = top.orientation((1, 0, 0, 0), 2.0)
    back = quaternion_rotate(turn, spin)
    assert np.allclose(back, spin, rtol=0, atol=1e-14)
    assert turn_between((1, 0, 0, 0), turn) == pytest.approx(2 * math.pi - 6.0, abs=1e-13)


def test_no_spin_at_all():
    top = FreeTop(MOMENTS, (0, 0, 0))
    assert np.array_equal(top.spin(5.0), np.zeros(3))
    assert np.allclose(top.orientation(START, 5.0), START, rtol=0, atol=EPS)
    assert top.flips(10.0) == []


@pytest.mark.parametrize("tilt", [1e-3, 1e-6, 1e-9, 1e-12])
def test_a_wobble_about_the_middle_axis_grows_as_it_must(tilt):
    """At first by e^(1.7320508 t) along the growing direction; it flips after ln(6/tilt) / 1.73 s."""
    top = FreeTop(MOMENTS, (tilt, 3.0, -tilt * math.sqrt(1 / 3)))
    for t in (0.5, 1.0, 2.0):
        if tilt * math.exp(math.sqrt(3) * t) < 1e-2:
            ratio = top.spin(t)[0] / tilt
            assert ratio == pytest.approx(math.exp(1.73205080756888 * t), rel=1e-3)
    (first,) = top.flips(100.0)[:1]  # 3 sech comes from 6 e^-u to tilt
    assert first == pytest.approx(math.log(6.0 / tilt) / math.sqrt(3.0), abs=2e-6)


@given(
    spin=st.tuples(*[st.floats(-5, 5)] * 3),
    moments=st.tuples(st.floats(0.1, 1.0), st.floats(0.0, 1.0), st.floats(0.0, 1.0)),
    t=st.floats(0.0, 50.0),
)
def test_energy_momentum_and_composition(spin, moments, t):
    """E and L² stay; L stays in the world; two steps are one."""
    i1, a, b = moments
    i2 = i1 + a * i1
    i = np.array((i1, i2, i2 + b * i1))
    w = np.array(spin)
    top = FreeTop(i, w)
    after = top.spin(t)
    energy, square = i @ (w * w), (i * w) @ (i * w)
    size = np.abs(w).max()
    assert i @ (after * after) == pytest.approx(energy, rel=1e-11, abs=1e-300)
    assert (i * after) @ (i * after) == pytest.approx(square, rel=1e-11, abs=1e-300)
    if size > 1e-3:
        q = top.orientation(START, t)
        before = quaternion_to_matrix(START) @ (i * w)
        assert np.allclose(
            quaternion_to_matrix(q) @ (i * after), before, rtol=0, atol=1e-9 * np.abs(i * w).max()
        )


def test_two_steps_are_one():
    top = FreeTop(MOMENTS, STARTS["generic"])
    half = FreeTop(MOMENTS, top.spin(3.0))
    assert np.allclose(half.spin(4.0), top.spin(7.0), rtol=0, atol=1e-13)
    q = half.orientation(top.orientation(START, 3.0), 4.0)
    assert turn_between(q, top.orientation(START, 7.0)) < 1e-13


@given(u=st.floats(-20.0, 20.0), m=st.floats(0.0, 1.0 - 1e-9))
def test_elliptic_functions(u, m):
    """Against another library."""
    mine, theirs = elliptic_functions(u, 1.0 - m), ellipj(u, m)[:3]
    assert np.allclose(mine, theirs, rtol=0, atol=1e-12 / (1.0 - m) ** 0.5)
    sn, cn, dn = mine
    assert sn * sn + cn * cn == pytest.approx(1.0, abs=4 * EPS)
    assert dn * dn + m * sn * sn == pytest.approx(1.0, abs=8 * EPS)


def test_the_separatrix_itself():
    assert np.allclose(
        elliptic_functions(2.0, 0.0), (math.tanh(2), 1 / math.cosh(2), 1 / math.cosh(2)), rtol=1e-15
    )
    assert np.allclose(elliptic_functions(-800.0, 0.0), (-1.0, 0.0, 0.0), rtol=0, atol=1e-300)


@pytest.mark.parametrize(
    ("moments", "spin", "words"),
    [
        ((3, 2, 1), (1, 1, 1), "ascending"),
        ((0, 1, 1), (1, 1, 1), "above 0"),
        ((1, 2, 3), (1, math.nan, 1), "spin"),
        ((1, 2), (1, 1, 1), "moments"),
    ],
)
def test_nonsense_is_refused(moments, spin, words):
    with pytest.raises(ValueError, match=words):
        FreeTop(moments, spin)
