"""What is measured of the fountain: energy, height, and its distance from the exact solution."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from game.physics.fields import DRAG, GROUND, QUADRATIC_DRAG, WHIRL
from game.physics.particles import OBSTACLES, Forces
from game.physics.particles.measures import count_touching, envelope, measure_deviation, measure_swarm
from game.stage import Readout

if TYPE_CHECKING:
    from game.scenes.fountain.scene import Fountain

LOOKED_AT = 32_768  # particles compared with the exact solution; of more, every second, third, ...
TOLERANCE = 1e-3  # m beyond the exact envelope that counts as outside


def has_exact(scene: Fountain) -> bool:
    """Whether the closed form of the flight is known."""
    on = scene.active
    return QUADRATIC_DRAG not in on and (WHIRL not in on or DRAG not in on or scene.whirl == 0.0)


def exact_envelope(scene: Fountain) -> NDArray[np.float64]:
    """Curve (n, 2) m from a nozzle that no particle in free flight can pass; empty if none is known."""
    if not has_exact(scene) or scene.speed == 0.0 or not open_nozzles(scene):
        return np.zeros((0, 2))
    return _envelope(scene.law(), scene.speed, scene.life)


def open_nozzles(scene: Fountain) -> list[list[float]]:
    """Rows of the emitters that stand in no stone and not in the ground: who is born within begins on its
    surface."""
    lowest = scene.content.floor if GROUND in scene.active else -math.inf
    stones = scene.system.solids.rows[:, :3].tolist() if OBSTACLES in scene.active else []
    return [
        row
        for row in scene.system.state().emitters.tolist()
        if row[1] >= lowest
        and all((row[0] - x) ** 2 + (row[1] - y) ** 2 >= radius * radius for x, y, radius in stones)
    ]


@lru_cache(maxsize=8)
def _envelope(law: Forces, speed: float, life: float) -> NDArray[np.float64]:
    """It is asked for in every picture and changes only with the parameters."""
    curve = envelope(law, speed, life)
    curve.flags.writeable = False
    return curve


def deviation(scene: Fountain) -> tuple[float, int, int]:
    """Of untouched particles: (worst distance from the exact solution in m, how many are outside, of how
    many)."""
    system, worst, outside, looked = scene.system, 0.0, 0, 0
    emitters, law, now = system.state().emitters, scene.law(), system.time_s
    stride = -(-max(len(system), 1) // LOOKED_AT)
    for low, high in system.segments():
        bad, out, seen = measure_deviation(
            system.fields, system.tags, low, high, stride, emitters, law, now, scene.since, TOLERANCE
        )
        worst, outside, looked = max(worst, bad), outside + out * stride, looked + seen
    return worst, outside, looked


def begin_of_claims(scene: Fountain) -> float:
    """Instant (s) from which on one must be born for the exact envelope to hold: others knew another law, or
    another nozzle. From the beginning of time where no envelope is known."""
    return scene.since if len(exact_envelope(scene)) else -math.inf


def readouts(scene: Fountain) -> list[Readout]:
    """All that is measured. The highest particle is one of those for which the exact height holds."""
    system = scene.system
    kinetic = potential = 0.0
    highest = -math.inf
    touching, since = 0, begin_of_claims(scene)
    for low, high in system.segments():
        k, p, top = measure_swarm(system.fields, low, high, scene.law().gravity, scene.content.floor, since)
        kinetic, potential, highest = kinetic + k, potential + p, max(highest, top)
        touching += count_touching(system.tags, low, high, scene.touching_since())
    worst, outside, looked = deviation(scene) if has_exact(scene) else (math.nan, 0, 0)
    curve = exact_envelope(scene)
    top = max((row[1] for row in open_nozzles(scene)), default=0.0)
    if highest == -math.inf:
        highest = math.nan if len(system) else scene.content.floor
    return [
        Readout("particles", len(system)),
        Readout("highest", highest, "m"),
        Readout("exact", float(curve[:, 1].max()) + top if len(curve) else math.nan, "m"),
        Readout("error", worst if looked else math.nan, "m"),
        Readout("outside the curve", int(outside)),
        Readout("kinetic", kinetic, "J"),
        Readout("potential", potential, "J"),
        Readout("touching", int(touching)),
        Readout("born", int(system.born)),
        Readout("impacts", int(system.impacts)),
        Readout("dropped", int(system.dropped)),
        Readout("cut short", int(system.cut_short)),
    ]
