"""What accuracy costs for an ember: steps of the scene against the exact cooling by T⁴ and by the air."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np

from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.lab.trials import Computation
from game.physics.heat import BurningBodies
from game.physics.heat.effects import HEAT
from game.physics.heat.nodes import STEFAN_BOLTZMANN
from game.scenes.fireplace.tables import ROOM
from game.scenes.fireplace.wood import OPEN, SKIN, fuel_of_wood

RATES = (30, 60, 120, 240, 480, 960)  # steps in a second
GLOWS, LOOKED_AT_S = 1100.0, 8.0  # K at first; s after which it is looked at
POINTS, HALVINGS = 64, 60  # of the quadrature, and of the search


def rate_of(kelvin: np.ndarray) -> np.ndarray:
    """K/s by which an ember cools: radiation and the air, over what a square metre of a log's skin holds."""
    wood = fuel_of_wood(1.0, HEAT.known)
    square, room = kelvin * kelvin, ROOM * ROOM
    shining = wood.emissivity * STEFAN_BOLTZMANN * (square * square - room * room)
    return OPEN * (shining + wood.exchange * (kelvin - ROOM)) / SKIN


@cache
def exact() -> float:
    """K at the end: where the time since the beginning, by Gauss-Legendre quadrature of 1/rate, is right."""
    nodes, weights = np.polynomial.legendre.leggauss(POINTS)
    low, high = ROOM + 1.0, GLOWS
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        half = 0.5 * (GLOWS - middle)
        took = half * float(np.sum(weights / rate_of(middle + half * (nodes + 1.0))))
        low, high = (middle, high) if took > LOOKED_AT_S else (low, middle)
    return 0.5 * (low + high)


def ember_trial(setting: Setting) -> Trial:
    """One piece of a log, burnt out, that glows in the room."""
    steps = round(LOOKED_AT_S / setting.knob)

    def begin() -> BurningBodies:
        wood = fuel_of_wood(1.0, HEAT.known)
        return BurningBodies(1, temperature=GLOWS, rest=SKIN, area=OPEN, made_of=wood)

    def work(ember: BurningBodies) -> BurningBodies:
        for _ in range(steps):
            ember.step(LOOKED_AT_S / steps)
        return ember

    def judge(ember: BurningBodies) -> Outcome:
        return Outcome(abs(float(ember.temperature[0]) - exact()), steps)

    return Computation(LOOKED_AT_S, begin, work, judge)


def _settings() -> list[Setting]:
    return [
        Setting("one after the other", 1.0 / rate, {}, {"step_length": 1.0 / rate}, float(rate))
        for rate in RATES
    ]


def _present(parameters: Mapping[str, Any]) -> Setting:
    return Setting("one after the other", float(parameters["step_length"]), {})


ember_study = Study(
    name="ember",
    title="An ember that glows and warms the air",
    error="temperature after 8 s",
    error_unit="K",
    counter="steps",
    knob=Knob("step_length", "step", "s"),
    methods=(Method("one after the other", "radiation after convection", 1.0),),
    settings=_settings,
    trial=ember_trial,
    reference="The time of cooling from 1,100 K, by quadrature of what radiation and air take.",
    expectation="Radiation alone and air alone are exact in each step, as long as it may be. One after the "
    "other they are of first order.",
    present=_present,
    workload=Workload("a piece of a log, burnt out, alone in the room"),
)
