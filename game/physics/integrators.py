"""Steppers for x'' = a(x, v, t): explicit and semi-implicit Euler, midpoint, Verlet, classical Runge-Kutta.

| method              | order | undamped spring w               | stable for spring w, drag k   |
| ------------------- | ----- | ------------------------------- | ----------------------------- |
| explicit-euler      | 1     | grows by sqrt(1 + (w dt)^2)     | never,        k dt < 2        |
| semi-implicit-euler | 1     | energy error bounded            | w dt < 2,     k dt < 2        |
| midpoint            | 2     | grows by sqrt(1 + (w dt)^4 / 4) | never,        k dt < 2        |
| verlet              | 2     | energy error bounded            | w dt < 2,     k dt < 2        |
| rk4                 | 4     | shrinks slightly                | w dt < 2.828, k dt < 2.785    |

Verlet is velocity Verlet. Where the acceleration depends on the velocity, that is predicted with v + a dt,
which keeps second order. The backward difference of the textbook form would not.

`integrate` serves one body, or any array of bodies, with a plain Python acceleration. Kernels that need speed
write the same few lines out for their own forces.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from game.arrays import Floats

Acceleration = Callable[[Floats, Floats, float], Any]
Step = Callable[[Acceleration, Floats, Floats, float, float], tuple[Floats, Floats]]

MAX_STEPS = 100_000_000


def _explicit_euler(a: Acceleration, x: Floats, v: Floats, t: float, dt: float) -> tuple[Floats, Floats]:
    """Both from the old state (Euler 1768)."""
    return x + v * dt, v + a(x, v, t) * dt


def _semi_implicit_euler(a: Acceleration, x: Floats, v: Floats, t: float, dt: float) -> tuple[Floats, Floats]:
    """Velocity first, position with the new velocity; symplectic."""
    v = v + a(x, v, t) * dt
    return x + v * dt, v


def _midpoint(a: Acceleration, x: Floats, v: Floats, t: float, dt: float) -> tuple[Floats, Floats]:
    """Slope in the middle, reached by half an Euler step (Runge 1895)."""
    half = 0.5 * dt
    x_middle, v_middle = x + v * half, v + a(x, v, t) * half
    return x + v_middle * dt, v + a(x_middle, v_middle, t + half) * dt


def _verlet(a: Acceleration, x: Floats, v: Floats, t: float, dt: float) -> tuple[Floats, Floats]:
    """Velocity Verlet (Swope, Andersen, Berens, Wilson 1982), the velocity in a(...) predicted by Euler."""
    before = a(x, v, t)
    x = x + v * dt + before * (0.5 * dt * dt)
    after = a(x, v + before * dt, t + dt)
    return x, v + (before + after) * (0.5 * dt)


def _rk4(a: Acceleration, x: Floats, v: Floats, t: float, dt: float) -> tuple[Floats, Floats]:
    """Classical Runge-Kutta (Kutta 1901)."""
    half = 0.5 * dt
    a1 = a(x, v, t)
    v2 = v + a1 * half
    a2 = a(x + v * half, v2, t + half)
    v3 = v + a2 * half
    a3 = a(x + v2 * half, v3, t + half)
    v4 = v + a3 * dt
    a4 = a(x + v3 * dt, v4, t + dt)
    return x + (v + 2.0 * (v2 + v3) + v4) * (dt / 6.0), v + (a1 + 2.0 * (a2 + a3) + a4) * (dt / 6.0)


_STEPS: dict[str, Step] = {
    "explicit-euler": _explicit_euler,
    "semi-implicit-euler": _semi_implicit_euler,
    "midpoint": _midpoint,
    "verlet": _verlet,
    "rk4": _rk4,
}
METHODS: tuple[str, ...] = tuple(_STEPS)
ORDERS: dict[str, int] = dict(zip(METHODS, (1, 1, 2, 2, 4), strict=True))
EVALUATIONS: dict[str, int] = dict(zip(METHODS, (1, 1, 2, 2, 4), strict=True))  # of a, in one step


def integrate(
    method: str,
    acceleration: Acceleration,
    position: ArrayLike,
    velocity: ArrayLike,
    dt: float,
    steps: int,
) -> tuple[Floats, Floats]:
    """Position and velocity after `steps` steps of dt s, from time 0; new arrays.

    acceleration(position, velocity, time): a Python function or a kernel; it gets arrays of the shape of
    `position` and returns such an array (or a number). position, velocity: equal shapes, any, m and m/s.
    The time handed over is k dt, from a counter, not a running sum. ValueError for an unknown method,
    numbers that are not finite, dt that is not positive, a negative or absurd number of steps. A method
    that runs unstable gives inf or nan without a warning: that is what it computes.
    """
    if method not in _STEPS:
        raise ValueError(f"method: must be one of {', '.join(METHODS)}, got {method!r}")
    if not (isinstance(dt, int | float) and math.isfinite(dt) and dt > 0.0):
        raise ValueError(f"dt: must be positive and finite, got {dt!r}")
    if isinstance(steps, bool) or not isinstance(steps, int | np.integer) or not 0 <= steps <= MAX_STEPS:
        raise ValueError(f"steps: must be a whole number from 0 to {MAX_STEPS}, got {steps!r}")
    x, v = _finite("position", position), _finite("velocity", velocity)
    if x.shape != v.shape:
        raise ValueError(f"velocity: must have the shape of position, {x.shape}, got {v.shape}")
    step = _STEPS[method]
    with np.errstate(over="ignore", invalid="ignore"):
        for k in range(int(steps)):
            x, v = step(acceleration, x, v, k * dt, dt)
    return np.asarray(x), np.asarray(v)


def _finite(name: str, value: ArrayLike) -> Floats:
    """A float64 copy; ValueError if an entry is not finite."""
    array = np.array(value, dtype=np.float64)
    if not np.isfinite(array).all():
        raise ValueError(f"{name}: must be finite")
    return array
