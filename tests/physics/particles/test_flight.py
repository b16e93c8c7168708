"""Free flight: closed forms, orders, stability limits, and a naive twin of the whole force law."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.special import lambertw

from game.physics.fields import ATTRACTOR, DRAG, GRAVITY, QUADRATIC_DRAG, WHIRL, WIND
from game.physics.particles import CALM, METHODS, ORDERS, PARTICLES, STABILITY_LIMITS, Forces
from game.physics.particles.flight import decay_over, fly_alone

G = 9.81
EPS = 2.0**-52
ALL = PARTICLES.mask(GRAVITY | DRAG | QUADRATIC_DRAG | WIND | WHIRL | ATTRACTOR)
LAW = Forces(G, 0.7, 0.05, 2.0, -0.5, 1.0, 1.5, 1.3, 0.4, 0.5, 0.2, 3.0)


def fly(method, mask, forces, state, dt, steps):
    state = tuple(map(float, state))
    for _ in range(steps):
        state = fly_alone(METHODS.index(method), mask, forces, *state, dt)
    return np.array(state)


def slope(counts, errors):
    return -np.polyfit(np.log(counts), np.log(errors), 1)[0]


def closed_form(k, v0, t):
    """Exact flight from the origin with gravity and linear drag: x, y, vx, vy."""
    decay = math.exp(-k * t)
    reach = (1 - decay) / k
    fall = G / k
    return np.array(
        [v0[0] * reach, (v0[1] + fall) * reach - fall * t, v0[0] * decay, (v0[1] + fall) * decay - fall]
    )


@pytest.mark.parametrize(
    ("method", "factor"),
    [("explicit-euler", 0.5), ("semi-implicit-euler", -0.5), ("midpoint", 0.0), ("verlet", 0.0),
     ("stormer-verlet", 0.0), ("rk4", 0.0), ("exponential", 0.0)],
)  # fmt: skip
def test_free_fall_is_off_by_half_a_step(method, factor):
    """Position off by +-g T dt / 2 for the Euler methods, by nothing for the rest; energy by N g² dt² / 2."""
    steps, dt = 100, 0.01
    x, y, vx, vy = fly(method, PARTICLES.mask(GRAVITY), CALM, (0, 0, 0, 5), dt, steps)
    scale = 8 * steps * EPS * 10
    assert abs(y - (5 - G / 2) - factor * G * dt) < scale
    assert abs(vy - (5 - G)) < scale
    assert (x, vx) == (0.0, 0.0)
    gain = vy * vy / 2 + G * y - 12.5
    assert abs(gain - factor * 2 * steps * G * G * dt * dt / 2) < 20 * scale


def test_state_of_a_shot_with_linear_drag():
    """v0 = (3, 8), k = 0.7: at 1 s, at the apex and back on the ground, to the digits of the closed form."""
    forces = CALM._replace(drag=0.7)
    mask = PARTICLES.mask(GRAVITY | DRAG)
    known = (2.15749155517967, 1.81759279300894, 1.48975591137423, -3.08231495510626)
    assert np.allclose(fly("exponential", mask, forces, (0, 0, 3, 8), 0.01, 100), known, rtol=0, atol=1e-13)
    assert np.allclose(closed_form(0.7, (3, 8), 1.0), known, rtol=0, atol=1e-13)
    apex = math.log(1 + 0.7 * 8 / G) / 0.7
    _, y, _, vy = fly("exponential", mask, forces, (0, 0, 3, 8), apex / 64, 64)
    assert abs(apex - 0.645163393935361) < 1e-14
    assert abs(y - 2.38706729356301) < 1e-13
    assert abs(vy) < 1e-13
    a = 1 + 0.7 * 8 / G
    landing = (a + float(lambertw(-a * math.exp(-a)).real)) / 0.7
    x, y, _, _ = fly("exponential", mask, forces, (0, 0, 3, 8), landing / 64, 64)
    assert abs(landing - 1.40448020887751) < 1e-13
    assert abs(x - 2.68227466237931) < 1e-13
    assert abs(y) < 1e-13


def test_fall_with_quadratic_drag():
    """Terminal speed 12 m/s: drop and speed after 2 s."""
    forces = CALM._replace(quadratic_drag=G / 144.0)
    mask = PARTICLES.mask(GRAVITY | QUADRATIC_DRAG)
    _, y, _, vy = fly("rk4", mask, forces, (0, 0, 0, 0), 2.0 / 2000, 2000)
    assert abs(-y - 14.3729144359903) < 1e-10
    assert abs(-vy - 11.1212441214122) < 1e-10


@pytest.mark.parametrize("method", METHODS)
def test_order_with_linear_drag(method):
    """Slope over a factor of 32 in the step, within [p - 0.15, p + 0.25]; the exponential method is exact."""
    forces = CALM._replace(drag=0.7)
    exact = closed_form(0.7, (3, 8), 1.0)[:2]
    counts = np.array([10, 20, 40, 80, 160, 320])
    errors = [
        np.linalg.norm(
            fly(method, PARTICLES.mask(GRAVITY | DRAG), forces, (0, 0, 3, 8), 1.0 / n, n)[:2] - exact
        )
        for n in counts.tolist()
    ]
    if method == "exponential":
        assert max(errors) < 8 * 320 * EPS * 8
        return
    order = ORDERS[METHODS.index(method)]
    assert order - 0.15 <= slope(counts, errors) <= order + 0.25


def test_stormer_with_lagged_drag_is_of_first_order_and_semi_implicit_euler():
    """x(n+1) = 2 x(n) - x(n-1) + dt² a with drag from (x(n) - x(n-1)) / dt, started by x0 - v0 dt."""
    k, counts = 0.7, [40, 80, 160, 320, 640]
    exact = closed_form(k, (3, 8), 1.0)[:2]
    naive, taylor = [], []
    for n in counts:
        dt = 1.0 / n
        for errors, start in ((naive, 0.0), (taylor, 0.5)):
            v0 = np.array([3.0, 8.0])
            before = -v0 * dt + start * dt * dt * (np.array([0, -G]) - k * v0)
            now = np.zeros(2)
            for _ in range(n):
                after = 2 * now - before + dt * dt * (np.array([0, -G]) - k * (now - before) / dt)
                before, now = now, after
            errors.append(np.linalg.norm(now - exact))
        twin = fly(
            "semi-implicit-euler", PARTICLES.mask(GRAVITY | DRAG), CALM._replace(drag=k), (0, 0, 3, 8), dt, n
        )
        assert abs(np.linalg.norm(twin[:2] - exact) - naive[-1]) < 1e-10
    assert abs(slope(counts, naive) - 1.0) < 0.15
    assert abs(slope(counts, taylor) - 1.0) < 0.15


def twin_acceleration(x, y, vx, vy):
    """The whole force law written once more, without bits."""
    f = LAW
    rx, ry = x - f.whirl_x, y - f.whirl_y
    turn = f.whirl_strength / (rx**2 + ry**2 + f.whirl_core**2)
    ux, uy = vx - (f.wind_x - turn * ry), vy - (f.wind_y + turn * rx)
    drag = f.drag + f.quadratic_drag * math.sqrt(ux**2 + uy**2)
    return (
        -drag * ux - f.pull * (x - f.pull_x),
        -f.gravity - drag * uy - f.pull * (y - f.pull_y),
    )


@pytest.mark.parametrize("method", METHODS)
def test_whole_force_law_against_a_naive_twin(method):
    """All terms at once: each method converges with its order to what DOP853 makes of the twin."""
    start = (0.3, 0.1, 2.0, 5.0)
    exact = solve_ivp(
        lambda t, s: [s[2], s[3], *twin_acceleration(*s)],
        (0, 1),
        start,
        method="DOP853",
        rtol=1e-13,
        atol=1e-13,
    ).y[:, -1]
    order = ORDERS[METHODS.index(method)]
    counts = [32, 64, 128, 256, 512]
    errors = [np.linalg.norm(fly(method, ALL, LAW, start, 1.0 / n, n) - exact) for n in counts]
    assert order - 0.15 <= slope(counts, errors) <= order + 0.25
    assert errors[-1] < (0.2, 2e-2, 1e-4, 1e-6)[order - 1 if order < 3 else 3]


@pytest.mark.parametrize("method", METHODS)
def test_limit_of_stability(method):
    """Drag times step a little below the limit decays, a little above grows."""
    limit = STABILITY_LIMITS[METHODS.index(method)]
    for part in (0.999, 1.001) if math.isfinite(limit) else (1.0,):
        stiff = CALM._replace(drag=part * limit if math.isfinite(limit) else 200.0)
        speed = abs(fly(method, PARTICLES.mask(DRAG), stiff, (0, 0, 1, 0), 1.0, 3000)[2])
        if math.isfinite(limit):
            assert speed < 0.9 if part < 1.0 else speed > 1.1
        else:
            assert speed < 1.0


def test_a_spring_grows_by_a_known_factor_with_explicit_euler():
    """Amplitude times sqrt(1 + (w dt)²) each step: 3713.359 after 600 steps of 1/60 s, w = 10 rad/s."""
    forces = CALM._replace(pull=100.0)
    dt, w = 1.0 / 60.0, 10.0
    x, y, vx, vy = fly("explicit-euler", PARTICLES.mask(ATTRACTOR), forces, (1, 0, 0, 0), dt, 600)
    amplitude = math.sqrt(x * x + (vx / w) ** 2)
    assert abs(amplitude / 3713.3594441784 - 1.0) < 1e-12
    assert (y, vy) == (0.0, 0.0)


@pytest.mark.parametrize("method", METHODS)
def test_wind_is_felt_only_by_way_of_drag(method):
    windy = CALM._replace(wind_x=50.0)
    still = fly(method, PARTICLES.mask(GRAVITY), CALM, (0, 0, 1, 2), 0.01, 50)
    assert np.array_equal(fly(method, PARTICLES.mask(GRAVITY | WIND), windy, (0, 0, 1, 2), 0.01, 50), still)
    assert fly(method, PARTICLES.mask(GRAVITY | WIND | DRAG), windy, (0, 0, 1, 2), 0.01, 50)[0] > still[0]


def test_decay_is_the_same_by_series_and_by_formula():
    """The three numbers join at the border of the series, and are those of k = 0 there."""
    for h in (1e-3, 0.1):
        below, above = decay_over(0.999999e-3 / h, h), decay_over(1.000001e-3 / h, h)
        assert np.allclose(below, above, rtol=3e-9, atol=0)
        assert decay_over(0.0, h) == (1.0, h, 0.5 * h * h)
    assert abs(decay_over(0.9999e-3, 1.0).reach / (-math.expm1(-0.9999e-3) / 0.9999e-3) - 1) < 4 * EPS
