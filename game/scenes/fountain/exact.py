"""What is known of the fountain in closed form, and how far the particles are from it."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from game.physics.fields import DRAG, GRAVITY, GROUND, QUADRATIC_DRAG, WHIRL, WIND
from game.physics.kernels import elementary
from game.physics.particles import OBSTACLES, Forces
from game.physics.particles.in_between import Swarm
from game.physics.particles.measures import envelope, measure_deviation
from game.scenes.fountain.model import FountainModel

COMPARED = 32_768  # particles compared with the exact solution; of more, every second, third, ...
TOLERANCE = 1e-3  # m beyond the exact envelope that counts as outside


def force_law(model: FountainModel) -> Forces:
    """The force law with what is off taken out."""
    forces, on = model.system.forces, model.active
    windy = WIND in on and DRAG in on
    return forces._replace(
        gravity=forces.gravity if GRAVITY in on else 0.0,
        drag=forces.drag if DRAG in on else 0.0,
        wind_x=forces.wind_x if windy else 0.0,
    )


def has_exact(model: FountainModel) -> bool:
    """Whether the closed form of the flight is known."""
    on = model.active
    return QUADRATIC_DRAG not in on and (WHIRL not in on or DRAG not in on or model.parameters.whirl == 0.0)


def exact_envelope(model: FountainModel) -> NDArray[np.float64]:
    """Curve (n, 2) m from a nozzle that no particle in free flight can pass; empty if none is known."""
    speed = model.parameters.speed
    if not has_exact(model) or speed == 0.0 or not open_nozzles(model):
        return np.zeros((0, 2))
    return _envelope(force_law(model), speed, model.parameters.life)


def open_nozzles(model: FountainModel) -> list[list[float]]:
    """Rows of the emitters that stand in no stone and not in the ground: who is born within begins on its
    surface."""
    lowest = model.content.floor if GROUND in model.active else -math.inf
    stones = model.system.solids.rows[:, :3].tolist() if OBSTACLES in model.active else []
    return [
        row
        for row in model.system.state().emitters.tolist()
        if row[1] >= lowest
        and all(
            elementary.square(row[0] - x) + elementary.square(row[1] - y) >= radius * radius
            for x, y, radius in stones
        )
    ]


@lru_cache(maxsize=8)
def _envelope(law: Forces, speed: float, life: float) -> NDArray[np.float64]:
    """It is asked for in every picture and changes only with the parameters."""
    curve = envelope(law, speed, life)
    curve.flags.writeable = False
    return curve


def begin_of_claims(model: FountainModel) -> float:
    """Instant (s) from which on one must be born for the exact envelope to hold: others knew another law, or
    another nozzle. From the beginning of time where no envelope is known."""
    return model.since if len(exact_envelope(model)) else -math.inf


def deviation(model: FountainModel) -> tuple[float, int, int]:
    """Of untouched particles: (worst distance from the exact solution in m, how many are outside, of how
    many)."""
    system, worst, outside, compared = model.system, 0.0, 0, 0
    swarm = Swarm(system.fields, system.tags)
    emitters, law, now = system.state().emitters, force_law(model), system.time_s
    stride = -(-max(len(system), 1) // COMPARED)
    for low, high in system.segments():
        bad, out, seen = measure_deviation(
            swarm, low, high, stride, emitters, law, now, model.since, TOLERANCE
        )
        worst, outside, compared = max(worst, bad), outside + out * stride, compared + seen
    return worst, outside, compared
