"""Small motions that are known exactly: a pendulum, a bouncing ball, beads on springs."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.physics.kernels import elementary, elementwise, linear
from game.physics.rigid.free_top import elliptic_functions

MOST_BOUNCES = 10_000  # looked at for one answer


Acceleration = Callable[[NDArray[np.float64], object, float], NDArray[np.float64]]


def rod_pull(pull: float) -> Acceleration:
    """Angular acceleration (rad/s²) of a pendulum by its angle, for `integrate`; pull: g / l, 1/s²."""
    return lambda angle, rate, time: -pull * elementwise.sin(angle)


def pendulum_angle(start: float, pull: float, time: float) -> float:
    """Angle (rad) of a pendulum let go at ``start`` rad, ``time`` s later; pull: g / l, 1/s².

    2 asin(k cd(√pull t)) with k = sin(start / 2) (Jacobi 1829).
    """
    k = elementary.sin(0.5 * start)
    _, cn, dn = elliptic_functions(math.sqrt(pull) * time, 1.0 - k * k)
    return 2.0 * elementary.asin(min(max(k * cn / dn, -1.0), 1.0))


def pendulum_period(start: float, pull: float) -> float:
    """Period (s) of a pendulum let go at ``start`` rad; pull: g / l, 1/s².

    2 pi / (sqrt(pull) M(1, cos(start / 2))), M the arithmetic-geometric mean (Gauss 1799). Infinite without
    pull, or from upright on.
    """
    a, b = 1.0, elementary.cos(0.5 * start)
    if not (pull > 0.0 and b > 0.0):
        return math.inf
    while a - b > 1e-15 * a:
        a, b = 0.5 * (a + b), math.sqrt(a * b)
    return math.tau / (math.sqrt(pull) * a)


def fall(
    height: float, speed: float, pull: float, restitution: float | None, root: bool, dt: float
) -> tuple[float, float]:
    """Height (m) and speed upwards (m/s) after dt s of fall by ``pull`` m/s² over a ground at height 0.

    Exact but for the impact, of which a step sees one: at its end, or at the root of the height. A ball whose
    next flight would end within the step rests. restitution: None where there is no ground.
    """
    y, v = height + speed * dt - 0.5 * pull * dt * dt, speed - pull * dt
    if restitution is None or y >= 0.0 or v >= 0.0:
        return y, v
    if not root:
        return 0.0, -restitution * v
    hit = math.sqrt(speed * speed + 2.0 * pull * height)  # speed at the impact
    left = dt - (speed + hit) / pull if pull > 0.0 else dt + height / speed
    v = restitution * hit
    if 2.0 * v <= pull * left:
        return 0.0, 0.0
    return v * left - 0.5 * pull * left * left, v - pull * left


def bounce_height(height: float, restitution: float, gravity: float, time: float) -> float:
    """Height (m) of a ball ``time`` s after it was let go ``height`` m above the ground.

    Newton's law of impact: each bounce begins with ``restitution`` times the speed of the one before. Zero
    once all bounces are over, which for a restitution below 1 they are in a finite time (or after
    `MOST_BOUNCES`).
    """
    left = time - math.sqrt(2.0 * height / gravity)
    if left < 0.0:
        return height - 0.5 * gravity * time * time
    speed = restitution * math.sqrt(2.0 * gravity * height)
    for _ in range(MOST_BOUNCES):
        flight = 2.0 * speed / gravity
        if left < flight:
            return speed * left - 0.5 * gravity * left * left
        left, speed = left - flight, restitution * speed
        if speed <= 0.0:
            break
    return 0.0


def spring_pull(stiffness: float) -> Acceleration:
    """Acceleration (m/s²) of beads by their displacements (n,) m: springs to neighbours and to both walls.

    stiffness: k/m, 1/s². For `game.physics.integrators.integrate`.
    """

    def acceleration(beads: NDArray[np.float64], rates: object, time: float) -> NDArray[np.float64]:
        pull = -2.0 * beads
        pull[1:] += beads[:-1]
        pull[:-1] += beads[1:]
        return stiffness * pull

    return acceleration


def bead_positions(start: ArrayLike, frequency: float, time: float) -> NDArray[np.float64]:
    """Displacements (n,) m of equal beads on a chain of equal springs between two walls, let go at ``start``.

    The sum of the chain's normal modes sin(k j π / (n + 1)), which swing with 2 w sin(k π / 2 (n + 1)),
    ``frequency`` w = √(k/m), 1/s (Lagrange 1788).
    """
    start = np.asarray(start, dtype=np.float64)
    n = len(start)
    numbers = np.arange(1, n + 1)
    shapes = elementwise.sin(np.outer(numbers, numbers) * (math.pi / (n + 1)))
    amplitudes = (2.0 / (n + 1)) * (linear.product(shapes, start))
    swings = elementwise.cos(2.0 * frequency * elementwise.sin(numbers * (0.5 * math.pi / (n + 1))) * time)
    result: NDArray[np.float64] = linear.product(shapes, amplitudes * swings)
    return result
