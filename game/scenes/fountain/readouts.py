"""What is measured of the fountain: energy, height, and its distance from the exact solution."""

from __future__ import annotations

import math

from game.physics.particles import ParticleSystem
from game.physics.particles.measures import count_touching, measure_swarm
from game.scenes.fountain.exact import (
    begin_of_claims,
    deviation,
    exact_envelope,
    force_law,
    has_exact,
    open_nozzles,
)
from game.scenes.fountain.model import FountainModel
from game.stage import Readout

ROUNDING = 1e-12  # m: an error up to it is shown as none


def readouts(model: FountainModel) -> list[Readout]:
    """What is measured. The highest particle is one of those for which the exact height holds."""
    system = model.system
    kinetic, potential, highest = _swarm(model, system)
    begin = model.first_step_in_contact()
    in_contact = sum(count_touching(system.tags, low, high, begin) for low, high in system.segments())
    worst, outside, compared = deviation(model) if has_exact(model) else (math.nan, 0, 0)
    curve = exact_envelope(model)
    top = max((row[1] for row in open_nozzles(model)), default=0.0)
    return [
        Readout("particles", len(system)),
        Readout("highest", highest, "m"),
        Readout("exact", float(curve[:, 1].max()) + top if len(curve) else math.nan, "m"),
        Readout("error", (worst if worst > ROUNDING else 0.0) if compared else math.nan, "m"),
        Readout("outside the curve", int(outside)),
        *([] if model.beside else [Readout("kinetic", kinetic, "J"), Readout("potential", potential, "J")]),
        Readout("total", kinetic + potential, "J"),
        Readout("in contact", int(in_contact)),
        Readout("born", int(system.born)),
        Readout("impacts", int(system.impacts)),
        Readout("dropped", int(system.dropped)),
        Readout("cut short", int(system.cut_short)),
        *_beside(model),
    ]


def _beside(model: FountainModel) -> list[Readout]:
    """Energy and height by the other methods, where three are shown."""
    found = []
    for name, system in zip(("Euler", "midpoint"), model.beside, strict=False):
        kinetic, potential, highest = _swarm(model, system)
        found += [
            Readout(f"{name} total", kinetic + potential, "J"),
            Readout(f"{name} highest", highest, "m"),
        ]
    return found


def _swarm(model: FountainModel, system: ParticleSystem) -> tuple[float, float, float]:
    """Kinetic and potential energy, J; the highest (m) of those for which the exact height holds."""
    floor, gravity, since = model.content.floor, force_law(model).gravity, begin_of_claims(model)
    kinetic = potential = 0.0
    highest = -math.inf
    for low, high in system.segments():
        k, p, top = measure_swarm(system.fields, low, high, gravity, floor, since)
        kinetic, potential, highest = kinetic + k, potential + p, max(highest, top)
    if highest == -math.inf:
        highest = math.nan if len(system) else floor
    return kinetic, potential, highest
