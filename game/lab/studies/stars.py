"""What accuracy costs for a star of a firework that is thrown straight up, beside its exact height."""

from __future__ import annotations

import math

from game.lab.studies.motion import KnownMotion, motion_study
from game.lab.study import Method
from game.naming import words_of
from game.physics.effects import EffectSet
from game.physics.fields import GRAVITY, QUADRATIC_DRAG
from game.physics.generations import CALM, Kind, StarSystem
from game.physics.generations.step import Y
from game.physics.kernels import elementary

SPEED, DRAG, SECONDS = 60.0, 0.01, 1.0  # m/s, 1/m, s; it still rises then
ORDERS = {"split-drag": 2.0, "explicit-euler": 1.0, "semi-implicit-euler": 1.0, "midpoint": 2.0, "rk4": 4.0}
STAR = Kind("star", life_s=1000.0, drag_per_m=DRAG, grounded=False, capacity=1)


def height_after(seconds: float, gravity: float = CALM.gravity) -> float:
    """Height (m) of a star thrown up with SPEED, while it rises: v_t²/g ln(cos(a - g t/v_t)/cos a)."""
    terminal = math.sqrt(gravity / DRAG)
    begin = elementary.atan(SPEED / terminal)
    now = begin - gravity * seconds / terminal
    if now < 0.0:
        raise ValueError(f"seconds = {seconds!r}: it falls by then")
    return (terminal * terminal) / gravity * elementary.log(elementary.cos(now) / elementary.cos(begin))


def throw(method: str, dt: float, steps: int) -> float:
    """Height (m) after so many steps by a method of `StarSystem`."""
    system = StarSystem([STAR], effects=EffectSet([GRAVITY, QUADRATIC_DRAG]), method=method)
    system.launch("star", (0.0, 0.0), (0.0, SPEED))
    for _ in range(steps):
        system.step(dt)
    return float(system.stars("star")[Y, 0])


star_study = motion_study(
    "stars", "A star thrown straight up", throw,
    tuple(Method(name, words_of(name), order) for name, order in ORDERS.items()),
    KnownMotion("a star thrown up at 60 m/s against quadratic drag", SECONDS, height_after(SECONDS)),
    reference="ln(cos(a − g t/v) / cos a), Bernoulli.",
    expectation="Split drag solves the drag alone exactly and is of second order in all.",
)  # fmt: skip
