"""How a mortar is laid: speed and fuse with which a shell bursts where it is to burst, at the top of its way.

Height and time of the top have closed forms for a shell that goes straight up (drag c v²): with the terminal
speed v_t = √(g/c), v_0 = v_t √(exp(2 c y) − 1) and t = (v_t/g) atan(v_0/v_t). A slanting way is then found by
shooting at it, with Runge and Kutta's fourth order.
"""

from __future__ import annotations

import math

from game.physics.kernels import elementary

Pair = tuple[float, float]
LEAST_PULL = 1.0  # m/s², with which fuses are chosen where there is less gravity
LEAST_RISE = 5.0  # m
FASTEST = 400.0  # m/s
STEPS = 24
SHOTS = 30
NEAR_ENOUGH = 1e-3  # m
THICKEST = 0.02  # 1/m, drag for which a mortar is laid at most: what is thicker lets no shell through anyway


def fuse_for(rise: float, gravity: float, drag: float) -> Pair:
    """Upward speed (m/s) and time (s) to the top of a way that rises so far (m). drag: 1/m."""
    pull, height = max(gravity, LEAST_PULL), max(rise, LEAST_RISE)
    if drag * height < 1e-6:
        speed = math.sqrt(2.0 * pull * height)
        return speed, speed / pull
    terminal = math.sqrt(pull / drag)
    speed = min(terminal * math.sqrt(elementary.expm1(min(2.0 * drag * height, 50.0))), FASTEST)
    return speed, terminal / pull * elementary.atan(speed / terminal)


def fly_shell(velocity: Pair, seconds: float, gravity: float, drag: float, wind: float) -> Pair:
    """How far (m, m) a shell flies in so long."""
    h = seconds / STEPS
    x = y = 0.0
    vx, vy = velocity

    def pulled(ux: float, uy: float) -> Pair:
        rate = drag * elementary.hypot(ux - wind, uy)
        return -rate * (ux - wind), -gravity - rate * uy

    for _ in range(STEPS):
        ax, ay = pulled(vx, vy)
        bx, by = pulled(vx + 0.5 * h * ax, vy + 0.5 * h * ay)
        cx, cy = pulled(vx + 0.5 * h * bx, vy + 0.5 * h * by)
        dx, dy = pulled(vx + h * cx, vy + h * cy)
        x += h * (vx + h / 6.0 * (ax + bx + cx))
        y += h * (vy + h / 6.0 * (ay + by + cy))
        vx += h / 6.0 * (ax + 2.0 * bx + 2.0 * cx + dx)
        vy += h / 6.0 * (ay + 2.0 * by + 2.0 * cy + dy)
    return x, y


def aim(way: Pair, gravity: float, drag: float, wind: float = 0.0) -> tuple[Pair, float]:
    """Velocity (m/s) and fuse (s) with which a shell goes a way (m, m). drag: 1/m; wind: m/s, even."""
    drag = min(drag, THICKEST)
    speed, seconds = fuse_for(way[1], gravity, drag)
    velocity = (way[0] / seconds, speed)
    for _ in range(SHOTS):
        reached = fly_shell(velocity, seconds, gravity, drag, wind)
        if elementary.dist(reached, way) < NEAR_ENOUGH:
            break
        velocity = (
            min(max(velocity[0] + (way[0] - reached[0]) / seconds, -FASTEST), FASTEST),
            min(max(velocity[1] + (way[1] - reached[1]) / seconds, -FASTEST), FASTEST),
        )
    return velocity, seconds
