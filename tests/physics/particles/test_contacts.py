"""Impact: orders of the three ways with every method, Newton's law, moving solids."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from game.physics.fields import DRAG, GRAVITY, GROUND
from game.physics.particles import CALM, CONTACTS, METHODS, OBSTACLES, PARTICLES, Discs
from game.physics.particles.contacts import Rules, fly_among_solids
from game.physics.particles.shot import shoot as shoot_all

STONE = Discs([(2, 1.2)], [0.5], 0.5)
FALL = PARTICLES.mask(GRAVITY | DRAG | OBSTACLES)
LAW = CALM._replace(drag=0.7)
# the shot (3, 8) with k = 0.7 meets the stone once; state at 1.6 s by root of the exact flight, impact and
# exact flight again
AFTER = (3.65777553100942, 0.202285803307705, 2.13691894914877, -4.67085708677009)


def shoot(method, contact, steps, until=1.6, solids=STONE, mask=FALL, state=(0, 0, 3, 8), law=LAW):
    """State (4,) after so many steps from t = 0, with solids that stand still if there are several."""
    rules = Rules(CONTACTS.index(contact), METHODS.index(method), mask, 0.0, 0.5, until / steps)
    states = np.array([state], dtype=np.float64)
    shoot_all(rules, law, solids.rows, states, steps, solids.impulses)
    return states[0]


def envelope_slope(method, contact):
    """Order by the upper envelope: the phase of the contact in its step makes the error saw-toothed."""
    counts = np.unique(np.round(np.geomspace(24, 1500, 96)).astype(int))
    errors = np.array([np.linalg.norm(shoot(method, contact, int(n))[:2] - AFTER[:2]) for n in counts])
    bins = np.array_split(np.arange(len(counts)), 12)
    tops = [part[np.argmax(errors[part])] for part in bins]
    return -np.polyfit(np.log(counts[tops]), np.log(errors[tops]), 1)[0]


ORDERS = {
    "end": {"explicit-euler": 1, "midpoint": 1, "verlet": 1, "rk4": 1},
    "chord": {
        "explicit-euler": 1,
        "semi-implicit-euler": 1,
        "midpoint": 2,
        "verlet": 2,
        "stormer-verlet": 2,
        "rk4": 2,
    },
    "root": {"semi-implicit-euler": 1, "midpoint": 2, "verlet": 2, "rk4": 4},
}


@pytest.mark.parametrize(
    ("contact", "method", "order"), [(c, m, o) for c in ORDERS for m, o in ORDERS[c].items()]
)
def test_order_with_an_impact(contact, method, order):
    """All of first order by the naive way; second with the chord; the method's own with the root."""
    assert abs(envelope_slope(method, contact) - order) <= 0.15


def test_exact_flight_and_exact_impact_make_an_exact_shot():
    for steps in (24, 57, 333):
        assert np.allclose(shoot("exponential", "root", steps), AFTER, rtol=0, atol=1e-12)


@pytest.mark.parametrize("e", [0.3, 0.5, 0.8, 0.95, 1.0])
def test_rebound_height_is_e_squared(e):
    """Dropped from 2 m on the top of a stone."""
    stone = Discs([(0, -1)], [1.0], e)
    up = math.sqrt(4.0 / 9.81) * (1.0 + e)  # instant of the first apex
    x, y, vx, vy = shoot("verlet", "root", 64, up, stone, PARTICLES.mask(GRAVITY | OBSTACLES), (0, 2, 0, 0))
    assert abs(y - 2.0 * e * e) < 1e-13
    assert abs(vy) < 1e-12
    assert (x, vx) == (0.0, 0.0)


def test_endless_bounces_end_when_they_should():
    """From 1 m with e = 0.5: all is still after 1.3546 s, on a way of 5/3 m."""
    rules = Rules(
        CONTACTS.index("root"), METHODS.index("verlet"), PARTICLES.mask(GRAVITY | GROUND), 0.0, 0.5, 1e-4
    )
    none, state, way, time = Discs(), (0.0, 1.0, 0.0, 0.0), 0.0, 0.0
    while time < 2.0:
        before = state
        x, y, vx, vy, _, _, lost = fly_among_solids(rules, CALM, none.rows, state, 0.0, 1e-4, none.impulses)
        assert lost == 0.0
        state, time = (x, y, vx, vy), time + 1e-4
        way += abs(y - before[1])
        if y == 0.0 and vy == 0.0 and before[1] == 0.0:
            break
    assert abs(time - 1.35457092295719) < 5e-3  # bounces below 2 g dt are not made
    assert abs(way - 5.0 / 3.0) < 1e-3


@example(angle=4.25, aim=0.0, speed=3.0, e=0.0, ux=0.0, uy=2.0, contact="chord")  # approach left by rounding
@given(
    angle=st.floats(0.0, 2 * math.pi),
    aim=st.floats(-0.95, 0.95),
    speed=st.floats(0.5, 200.0),
    e=st.floats(0.0, 1.0),
    ux=st.floats(-5, 5),
    uy=st.floats(-5, 5),
    contact=st.sampled_from(("chord", "root")),
)
def test_newtons_law_at_a_moving_stone(angle, aim, speed, e, ux, uy, contact):
    """No force but the impact: e of the approach leaves along the normal, the tangential part is kept."""
    stone = Discs([(0.3, -0.2)], [0.4], e)
    stone.carry(0, (ux, uy))
    direction = np.array([math.cos(angle), math.sin(angle)])
    side = np.array([-direction[1], direction[0]])
    flight = 0.8 / speed  # in the frame of the stone it starts 0.8 m before the line of centres
    relative = speed * direction
    start = np.array([0.3, -0.2]) - 0.8 * direction + 0.4 * aim * side
    velocity = relative + np.array([ux, uy])
    x, y, vx, vy = shoot("rk4", contact, 1, flight, stone, PARTICLES.mask(OBSTACLES), (*start, *velocity))
    reach = 0.4 * math.sqrt(1.0 - aim * aim)
    normal = (-reach * direction + 0.4 * aim * side) / 0.4
    approach = -relative @ normal
    expected = velocity + (1 + e) * approach * normal
    scale = 1e-9 * (speed + 10)
    assert np.allclose((vx, vy), expected, rtol=0, atol=scale)
    assert np.allclose(stone.impulses[0], velocity - expected, rtol=0, atol=scale)
    centre = np.array([0.3, -0.2]) + flight * np.array([ux, uy])
    assert math.dist((x, y), centre) >= 0.4 - 1e-12


@pytest.mark.parametrize("contact", ["chord", "root"])
@pytest.mark.parametrize(("start", "aim"), [(-0.7, 0.0), (-2.0, 0.4), (-3.3, -0.8)])
def test_a_stone_that_a_step_leaps_over_is_met(contact, start, aim):
    """Both ends of the step lie outside: only the nearest place of the path tells."""
    state = (start, 0.3 * aim, 40.0, 0.0)
    x, y, vx, vy = shoot(
        "rk4", contact, 1, 0.1, Discs([(0, 0)], [0.3], 1.0), PARTICLES.mask(OBSTACLES), state
    )
    normal = np.array([-math.sqrt(1.0 - aim * aim), aim])
    place = 0.3 * normal
    turned = np.array([40.0, 0.0]) - 80.0 * normal[0] * normal
    assert (vx, vy) == pytest.approx(tuple(turned), abs=1e-6)
    left = 0.1 - (place[0] - start) / 40.0
    assert (x, y) == pytest.approx(tuple(place + left * turned), abs=1e-6)


def test_the_first_of_two_stones_is_met():
    row = Discs([(3, 0), (1, 0)], [0.5, 0.5], 1.0)
    x, y, vx, vy = shoot("verlet", "chord", 1, 1.0, row, PARTICLES.mask(OBSTACLES), (0, 0, 4, 0))
    assert (x, y, vx, vy) == (-3.0, 0.0, -4.0, 0.0)


def test_off_means_off():
    for mask, y in ((PARTICLES.mask(GRAVITY), -1.0), (PARTICLES.mask(GRAVITY | GROUND), 0.0)):
        assert shoot("verlet", "end", 100, 2.0, Discs([(0, 0)], [0.1]), mask, (0, 0.5, 0, 0))[1] <= y
