"""What is measured of a burst: its radius beside drag ballistics, its momentum; of smoke: its drift."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.fields import QUADRATIC_DRAG
from game.physics.generations import BURNING, step
from game.physics.kernels import elementary, elementwise, linear
from game.scenes.fireworks.model import FireworksModel
from game.scenes.fireworks.shells import BURSTS, HEADS, SHELLS

NAMED_S = 3.0  # s after which a burst is not named any more
PIECES = 64  # of Simpson's rule for stars that burn away


class BurstNow(NamedTuple):
    """The newest burst: age s, radius m, what ballistics say m, net momentum (share of the sum of all).

    stars: all that it threw and that still burn. fastest: m/s, of those that are measured.
    depth: m, the farthest from the plane that faces the audience.
    """

    age: float
    radius: float
    ballistics: float
    momentum: float
    stars: int
    fastest: float
    depth: float


def reach_of(speed: float, drag: float, burnt: float, age: float) -> float:
    """How far (m) a star flies in still air within ``age`` s. drag: 1/m at full mass; burnt: share a second.

    ln(1 + c v t)/c for a mass that stays. Else 1/v = 1/v_0 - (c/b) ln(1 - b t), summed by Simpson's rule.
    """
    if drag <= 0.0:
        return speed * age
    if burnt <= 0.0:
        return elementary.log1p(drag * speed * age) / drag
    t = np.linspace(0.0, min(age, 0.999 / burnt), 2 * PIECES + 1)
    v = 1.0 / (1.0 / speed - drag / burnt * elementwise.log1p(-burnt * t))
    weights = np.full(len(t), 2.0)
    weights[1::2] = 4.0
    weights[0] = weights[-1] = 1.0
    return float(linear.product(weights, v)) * float(t[1]) / 3.0


def stars_of_burst(model: FireworksModel) -> NDArray[np.float64]:
    """(FIELDS, n) of the head stars of the newest burst that still burn."""
    instant, shell = float(model.burst[0]), int(model.burst[4])
    if shell < 0:
        return np.zeros((step.FIELDS, 0))
    stars = model.system.stars(HEADS[SHELLS[shell]].star)
    return stars[:, stars[step.BORN] == instant]


def burst_middle(model: FireworksModel) -> tuple[float, float, float]:
    """Where the middle of these stars is, m."""
    x, y, z = stars_of_burst(model)[[step.X, step.Y, step.Z]].mean(axis=1).tolist()
    return x, y, z


def thrown_now(model: FireworksModel) -> int:
    """Stars of all kinds that the newest burst threw and that still burn."""
    instant, shell = float(model.burst[0]), int(model.burst[4])
    kinds = sorted({birth.kind for birth in BURSTS[SHELLS[shell]]}) if shell >= 0 else []
    return sum(int(np.count_nonzero(model.system.stars(kind)[step.BORN] == instant)) for kind in kinds)


def burst_now(model: FireworksModel) -> BurstNow | None:
    """The newest burst; None when none of it burns."""
    stars = stars_of_burst(model)
    if stars.shape[1] < 2:
        return None
    head = HEADS[SHELLS[int(model.burst[4])]]
    kind = next(kind for kind in model.system.kinds if kind.name == head.star)
    age = model.system.time_s - float(model.burst[0])
    parameters = model.parameters
    drag = kind.drag_per_m * parameters.air / parameters.star_mass if QUADRATIC_DRAG in model.active else 0.0
    burnt = kind.burns / kind.life_s if BURNING in model.active else 0.0
    off = stars[[step.X, step.Y, step.Z]]
    off = off - off.mean(axis=1, keepdims=True)
    velocity = stars[[step.VX, step.VY, step.VZ]]
    total = [math.fsum(row.tolist()) for row in velocity]
    speed = np.sqrt((velocity * velocity).sum(axis=0))
    speeds = float(speed.sum())
    return BurstNow(
        age,
        math.sqrt(float(np.max((off * off).sum(axis=0)))),
        reach_of(head.speed, drag, burnt, age),
        elementary.length(*total) / speeds if speeds > 0.0 else 0.0,
        thrown_now(model),
        float(np.max(speed)),
        float(np.max(np.abs(off[2]))),
    )


def wind_at_smoke(model: FireworksModel) -> float:
    """Mean wind (m/s) at the heights of the puffs; nan without smoke. It grows with height by the shear."""
    smoke, air = model.system.stars("smoke"), model.system.air
    if not smoke.shape[1]:
        return math.nan
    heights = np.clip(smoke[step.Y], 0.0, air.ceiling)
    return model.wind * (1.0 + air.shear * float(heights.mean()))


def smoke_drift(model: FireworksModel) -> float:
    """Mean speed (m/s) of the smoke to the right; nan without smoke."""
    smoke = model.system.stars("smoke")
    return float(smoke[step.VX].mean()) if smoke.shape[1] else math.nan
