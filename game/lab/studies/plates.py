"""What accuracy costs for a plate that falls: each integrator's step against where it is after 10 a/U."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.lab.trials import computation
from game.naming import words_of
from game.physics.plates import METHODS, Plate
from game.physics.plates.regimes import drop

PLATE = Plate(half_chord=1.0, inertia=1.1)
TIME, TILT = 10.0, 0.2  # a/U, rad
# the drag on a spin goes with |spin| spin: where it changes its sign the second derivative jumps
ORDERS = {"explicit-euler": 1.0, "midpoint": 2.0, "rk4": 3.0}
NOTES = {"rk4": "4 but for the drag on the spin, whose second derivative jumps where the plate turns back"}
STEPS = {
    "explicit-euler": (200, 400, 800, 1600, 3200), "midpoint": (100, 200, 400, 800, 1600),
    "rk4": (100, 200, 400, 800, 1600, 3200),
}  # fmt: skip
FINEST = 64_000


def fallen(method: str, steps: int) -> NDArray[np.float64]:
    """The state (STATE,) after TIME."""
    return np.asarray(drop([PLATE], TILT, TIME, TIME / steps, every=steps, method=method)[-1, :, 0])


@lru_cache(maxsize=1)
def _reference() -> NDArray[np.float64]:
    """By RK4 in steps so short that half as many differ by no more than 1e-12."""
    return fallen("rk4", FINEST)


def fall_trial(setting: Setting) -> Trial:
    """One fall: the largest error of any state."""
    steps = max(1, round(TIME / setting.knob))
    return computation(
        TIME,
        lambda: fallen(setting.method, steps),
        lambda end: Outcome(float(np.max(np.abs(end - _reference()))), steps),
    )


def _settings() -> list[Setting]:
    return [
        Setting(method, TIME / steps, {}, {"method": method}, float(steps))
        for method in METHODS
        for steps in STEPS[method]
    ]


def _present(parameters: Mapping[str, Any]) -> Setting:
    """The scene's step in units of its own plate."""
    plate = Plate(
        float(parameters["half_chord"]), float(parameters["inertia"]), float(parameters["thickness"])
    )
    return Setting(str(parameters["method"]), float(parameters["step_length"]) / plate.time)


plate_study = Study(
    name="plates",
    title="A plate that flutters",
    error="largest error of place, velocity, angle and spin after 10 a/U",
    error_unit="a, U",
    counter="steps",
    knob=Knob("step", "step", "a/U"),
    methods=tuple(Method(name, words_of(name), ORDERS[name], NOTES.get(name, "")) for name in METHODS),
    settings=_settings,
    trial=fall_trial,
    reference=f"RK4 in {FINEST} steps; half as many agree to 1e-12.",
    expectation="Each has its order but RK4, which has 3 and not 4: the drag on the spin bends the law where "
    "the plate turns back.",
    floor=1e-11,
    present=_present,
    workload=Workload("a plate of I = 1.1, beta = 1/14, let go at a tilt of 0.2 rad"),
)


def _present_leaf(parameters: Mapping[str, Any]) -> Setting:
    """The scene's step in units of a leaf of half a chord of 4 cm and inertia 0.9."""
    return Setting(str(parameters["method"]), float(parameters["step_length"]) / Plate(0.04, 0.9, 0.03).time)


leaf_study = replace(plate_study, name="leaves", title="A leaf that flutters", present=_present_leaf)
