"""Integrators against closed forms: free fall, spring, drag; orders fitted."""

import math

import numpy as np
import pytest

from game.compiler.decorator import kernel
from game.physics.integrators import EVALUATIONS, METHODS, ORDERS, integrate

EPS = 2.0**-52
G = np.array([0.0, -9.81])


def fall(position, velocity, time):
    return G


def drag(position, velocity, time):
    return G - 0.7 * velocity


def slope(dts, errors):
    return np.polyfit(np.log(dts), np.log(errors), 1)[0]


@pytest.mark.parametrize(
    ("method", "error"),
    [
        ("explicit-euler", 0.04905),
        ("semi-implicit-euler", -0.04905),
        ("midpoint", 0.0),
        ("verlet", 0.0),
        ("rk4", 0.0),
    ],
)
def test_free_fall_position_error(method, error):
    """+g T dt/2, -g T dt/2, and nothing."""
    position, velocity = integrate(method, fall, [0.0, 0.0], [3.0, 8.0], 0.01, 100)
    assert abs(position[1] - (8.0 - 0.5 * 9.81 + error)) < 8 * 100 * EPS * 8.0
    assert abs(position[0] - 3.0) < 8 * 100 * EPS * 3.0
    assert abs(velocity[1] - (8.0 - 9.81)) < 8 * 100 * EPS * 9.81


@pytest.mark.parametrize(("method", "sign"), [("explicit-euler", 1.0), ("semi-implicit-euler", -1.0)])
def test_free_fall_energy_drift(method, sign):
    """N g^2 dt^2 / 2 per unit of mass, gained or lost."""
    position, velocity = integrate(method, fall, [0.0, 0.0], [3.0, 8.0], 0.01, 100)
    energy = 0.5 * velocity @ velocity + 9.81 * position[1]
    assert abs(energy - 36.5 - sign * 0.4811805) < 8 * 100 * EPS * 80.0


def test_explicit_euler_lets_a_spring_grow():
    """Amplitude times sqrt(1 + (w dt)^2) each step."""
    w, dt = 10.0, 1.0 / 60.0
    position, velocity = integrate("explicit-euler", lambda x, v, t: -w * w * x, [1.0], [0.0], dt, 600)
    amplitude = math.sqrt(position[0] ** 2 + (velocity[0] / w) ** 2)
    assert amplitude == pytest.approx((1.0 + (w * dt) ** 2) ** 300, rel=8 * 600 * EPS)
    assert amplitude == pytest.approx(3713.3594441784, rel=1e-12)


@pytest.mark.parametrize("method", ["semi-implicit-euler", "verlet"])
def test_symplectic_methods_keep_a_spring_bounded(method):
    w, dt = 10.0, 1.0 / 60.0
    for steps in (600, 6000):
        position, velocity = integrate(method, lambda x, v, t: -w * w * x, [1.0], [0.0], dt, steps)
        assert 0.8 < position[0] ** 2 + (velocity[0] / w) ** 2 < 1.25


@pytest.mark.parametrize("method", METHODS)
def test_order_with_linear_drag(method):
    """Against the exact exponential, at t = 1."""
    exact = np.array([2.15749155517967, 1.81759279300894, 1.48975591137423, -3.08231495510626])
    steps = np.array([20, 40, 80, 160, 320])
    errors = []
    for n in steps.tolist():
        position, velocity = integrate(method, drag, [0.0, 0.0], [3.0, 8.0], 1.0 / n, n)
        errors.append(np.abs(np.concatenate([position, velocity]) - exact).max())
    assert ORDERS[method] - 0.15 < slope(1.0 / steps, errors) < ORDERS[method] + 0.25
    assert errors[-1] > 1e3 * EPS


@pytest.mark.parametrize("method", METHODS)
def test_order_with_a_force_that_depends_on_time(method):
    """x'' = cos t from rest: x = 1 - cos t."""
    steps = np.array([10, 20, 40, 80, 160])
    errors = []
    for n in steps.tolist():
        position, velocity = integrate(method, lambda x, v, t: math.cos(t), 0.0, 0.0, 2.0 / n, n)
        errors.append(max(abs(position - (1.0 - math.cos(2.0))), abs(velocity - math.sin(2.0))))
    assert slope(1.0 / steps, errors) > ORDERS[method] - 0.15


@pytest.mark.parametrize(
    ("method", "limit"),
    [
        ("explicit-euler", 2.0),
        ("semi-implicit-euler", 2.0),
        ("midpoint", 2.0),
        ("verlet", 2.0),
        ("rk4", 2.78529356340528),
    ],
)
def test_drag_is_stable_up_to_its_limit(method, limit):
    for factor, stable in ((0.98, True), (1.02, False)):
        _, velocity = integrate(method, lambda x, v, t: -v, [0.0], [1.0], factor * limit, 2000)
        assert (abs(velocity[0]) < 1.0) == stable


@pytest.mark.parametrize("method", METHODS)
def test_counts_of_evaluations(method):
    calls = []
    integrate(method, lambda x, v, t: calls.append(t) or 0.0, [0.0], [1.0], 0.5, 3)
    assert len(calls) == 3 * EVALUATIONS[method]
    assert calls[0] == 0.0


def test_a_kernel_serves_as_acceleration():
    @kernel
    def pull(position, velocity, time):
        return -position

    compiled = integrate("rk4", pull, [1.0, 0.0], [0.0, 1.0], 0.01, 100)
    plain = integrate("rk4", lambda x, v, t: -x, [1.0, 0.0], [0.0, 1.0], 0.01, 100)
    assert (np.array(compiled) == np.array(plain)).all()


def test_inputs_are_left_alone_and_any_array_like_will_do():
    position = np.array([[1, 2], [3, 4]])
    position.setflags(write=False)
    after, _ = integrate("verlet", lambda x, v, t: 0.0, position, np.ones((2, 2), dtype=np.float32), 0.5, 2)
    assert (after == position + 1.0).all()
    same, still = integrate("rk4", fall, [1.0, 2.0], [0.0, 0.0], 0.5, 0)
    assert same.tolist() == [1.0, 2.0] and still.tolist() == [0.0, 0.0]


def test_what_runs_unstable_overflows_quietly():
    position, _ = integrate("explicit-euler", lambda x, v, t: -1e9 * x, [1.0], [0.0], 1.0, 500)
    assert not np.isfinite(position[0])


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"method": "leapfrog"}, "method"),
        ({"dt": 0.0}, "dt"),
        ({"dt": -1.0}, "dt"),
        ({"dt": math.nan}, "dt"),
        ({"steps": -1}, "steps"),
        ({"steps": 1.5}, "steps"),
        ({"position": [math.nan, 0.0]}, "position"),
        ({"velocity": [math.inf, 0.0]}, "velocity"),
        ({"velocity": [0.0]}, "velocity"),
    ],
)
def test_bad_input_is_refused(change, message):
    good = {
        "method": "rk4",
        "acceleration": fall,
        "position": [0.0, 0.0],
        "velocity": [0.0, 0.0],
        "dt": 0.1,
        "steps": 1,
    }
    with pytest.raises(ValueError, match=message):
        integrate(**{**good, **change})
