"""Laws of one impact with friction, beside closed forms and beside a walk in small steps of the impulse."""

from __future__ import annotations

import math

import numba
import numpy as np
import pytest

from game.physics.solids.solvers.impact_law import ENERGETIC, IMPACT_LAWS, NEWTON, POISSON, impact_impulse

LAWS = range(len(IMPACT_LAWS))


@numba.njit
def _impulse(coupling, speeds, mu, e, law):
    return impact_impulse(coupling, speeds, mu, e, law)


def after(coupling, speeds, mu, e, law):
    """Impulses, speeds after them, and the energy that they take (J, negative: taken)."""
    (knn, knt, ktt), (vn, vt) = coupling, speeds
    jn, jt = _impulse(coupling, speeds, mu, e, law)
    un, ut = vn + knn * jn + knt * jt, vt + knt * jn + ktt * jt
    return (jn, jt), (un, ut), 0.5 * (jn * (vn + un) + jt * (vt + ut))


def rod(angle):
    """Coupling of the end of a rod, 1 kg and 1 m, at an angle to a fixed plane."""
    x, y = 0.5 * math.cos(angle), 0.5 * math.sin(angle)
    return 1.0 + 12.0 * x * x, 12.0 * x * y, 1.0 + 12.0 * y * y


def walk(coupling, speeds, mu, e, law, parts=20000):
    """The same by small steps of the normal impulse: of first order in them."""
    (knn, knt, ktt), (vn, vt) = coupling, speeds
    first, p, jt, work, d = vn, 0.0, 0.0, 0.0, -vn / knn / parts
    spent, stuck = None, False
    for _ in range(2000 * parts):
        hold = min(mu, max(-mu, -knt / ktt))
        share = hold if stuck else -mu if vt > 0.0 else mu
        un, ut = vn + (knn + knt * share) * d, vt + (knt + ktt * share) * d
        stuck = stuck and abs(hold) < mu
        if vt * ut < 0.0:
            ut, stuck = 0.0, True
        p, jt, work = p + d, jt + share * d, work + 0.5 * (vn + un) * d
        vn, vt = un, ut
        if spent is None and vn >= 0.0:
            spent = p, work
        if spent is not None and (
            (law == NEWTON and vn >= -e * first)
            or (law == POISSON and p >= (1.0 + e) * spent[0])
            or (law == ENERGETIC and work - spent[1] >= -e * e * spent[1])
        ):
            break
    return p, jt


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("e", [0.0, 0.6, 1.0])
def test_without_friction_all_laws_are_one(law, e):
    (jn, jt), (un, _), _ = after((2.5, 0.7, 1.9), (-3.0, 1.1), 0.0, e, law)
    assert (jn, jt) == pytest.approx(((1.0 + e) * 3.0 / 2.5, 0.0), rel=1e-14)
    assert un == pytest.approx(3.0 * e, rel=1e-13, abs=1e-14)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize(("slide", "sticks"), [(1.0, True), (6.0, False)])
def test_a_disc_sticks_or_slides_as_routh_said(law, slide, sticks):
    """Tangential impulse min(mu (1 + e) v, slide / 3) of a mass of 1: ktt = 3."""
    e, mu, v = 0.8, 0.25, 3.0
    (jn, jt), (un, ut), _ = after((1.0, 0.0, 3.0), (-v, slide), mu, e, law)
    assert jn == pytest.approx((1.0 + e) * v, rel=1e-14)
    assert jt == pytest.approx(-min(mu * (1.0 + e) * v, slide / 3.0), rel=1e-14)
    assert un == pytest.approx(e * v, rel=1e-13)
    assert (ut == pytest.approx(0.0, abs=1e-14)) == sticks


@pytest.mark.parametrize("slide", [20.0, -20.0])
def test_where_it_slides_all_through_the_laws_differ_by_nothing(slide):
    """J = (1 + e) v / (knn - mu s knt): one rate, so compression and restitution are alike."""
    coupling, e, mu, v = rod(math.radians(50.0)), 0.5, 0.2, 2.0
    s = math.copysign(1.0, slide)
    for law in LAWS:
        (jn, jt), (un, ut), _ = after(coupling, (-v, slide), mu, e, law)
        assert jn == pytest.approx((1.0 + e) * v / (coupling[0] - mu * s * coupling[1]), rel=1e-13)
        assert jt == pytest.approx(-mu * s * jn, rel=1e-13)
        assert un == pytest.approx(e * v, rel=1e-12)
        assert ut * s > 0.0


def test_poisson_and_stronge_where_the_slide_stops_in_compression():
    """Routh's lines: slide until p1, then stick; compression ends at p2, both laws in closed form."""
    knn, knt, ktt = coupling = rod(math.radians(70.0))
    e, mu, v, slide = 0.7, 0.8, 4.0, 0.5
    rate, slide_rate, hold = knn - mu * knt, knt - mu * ktt, -knt / ktt
    assert abs(hold) < mu and slide_rate < 0.0
    p1 = -slide / slide_rate
    v1, stuck = -v + rate * p1, knn + knt * hold
    p2 = p1 - v1 / stuck
    assert v1 < 0.0
    (jn, jt), _, _ = after(coupling, (-v, slide), mu, e, POISSON)
    assert jn == pytest.approx((1.0 + e) * p2, rel=1e-13)
    assert jt == pytest.approx(-mu * p1 + hold * (jn - p1), rel=1e-13)
    work = 0.5 * (-v + v1) * p1 + 0.5 * v1 * (p2 - p1)
    (jn, _), (un, _), _ = after(coupling, (-v, slide), mu, e, ENERGETIC)
    assert un == pytest.approx(math.sqrt(-2.0 * e * e * work * stuck), rel=1e-13)
    assert jn == pytest.approx(p2 + un / stuck, rel=1e-13)
    (_, _), (un, ut), _ = after(coupling, (-v, slide), mu, e, NEWTON)
    assert (un, ut) == pytest.approx((e * v, 0.0), rel=1e-13, abs=1e-13)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("seed", range(12))
def test_any_impact_is_that_of_a_walk_in_small_steps(law, seed):
    rng = np.random.default_rng(seed)
    half = rng.normal(size=(2, 2))
    (knn, knt), (_, ktt) = half @ half.T + 0.2 * np.eye(2)
    coupling, speeds = (knn, knt, ktt), (-rng.uniform(0.5, 3.0), rng.normal())
    mu, e = rng.uniform(0.0, 1.5), rng.uniform(0.0, 1.0)
    found, _, _ = after(coupling, speeds, mu, e, law)
    assert found == pytest.approx(walk(coupling, speeds, mu, e, law), rel=3e-3, abs=3e-4)


def test_stronges_law_gives_no_energy_and_newtons_may():
    """Kane's pendulum is such a case; here by chance."""
    rng, most = np.random.default_rng(7), dict.fromkeys(LAWS, -math.inf)
    for _ in range(3000):
        half = rng.normal(size=(2, 2))
        (knn, knt), (_, ktt) = half @ half.T + 0.01 * np.eye(2)
        speeds = (-rng.uniform(0.1, 3.0), rng.normal())
        mu, e = rng.uniform(0.0, 2.0), rng.uniform(0.0, 1.0)
        for law in LAWS:
            (jn, jt), (un, _), gain = after((knn, knt, ktt), speeds, mu, e, law)
            assert abs(jt) <= mu * jn * (1.0 + 1e-12)
            assert un >= -1e-9
            if law == NEWTON:
                assert un == pytest.approx(-e * speeds[0], abs=1e-9)
            most[law] = max(most[law], gain)
    assert most[ENERGETIC] < 1e-12 < most[NEWTON]


def test_what_parts_has_no_impact():
    assert _impulse((1.0, 0.0, 1.0), (0.0, 3.0), 0.5, 1.0, ENERGETIC) == (0.0, 0.0)


@pytest.mark.parametrize("law", LAWS)
def test_painleves_rod_ends_in_an_impact(law):
    """It slides foot first, steeper than friction has a force for: it jams, stops, and leaves."""
    coupling = rod(math.radians(63.4))
    mu, e = 1.5, 0.5
    s = -math.copysign(1.0, coupling[1])
    assert coupling[0] + mu * s * coupling[1] < 0.0
    (jn, _), (un, ut), gain = after(coupling, (-0.1, 3.0 * -s), mu, e, law)
    assert jn > 0.0 and un > 0.0 and gain < 0.0
    assert ut == pytest.approx(0.0, abs=1e-12)
