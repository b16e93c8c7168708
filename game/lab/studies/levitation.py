"""What accuracy costs for a grain in a trap that moves: the length of a substep against where it ends."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.lab.trials import computation
from game.physics.acoustics import Levitator, LevitatorSettings, facing_rows
from game.physics.kernels import elementwise

STEP, STEPS, SPEED, STRENGTH = 1.0 / 60.0, 12, 0.3, 10.0
SUBSTEPS = (4, 8, 16, 32, 64, 128, 256)
FINEST = 1_000
THROWN = 0.004  # m, about half a wave, where the next trap is
CENTRED = "drift-kick-drift"


def moved_grain(substeps: int) -> Levitator:
    """A grain that begins in the trap, which is then led along a circle."""
    levitator = Levitator(
        facing_rows(2, 17, 0.010, 0.20, STRENGTH), [(0.0203, 0.0)], figure="circle", size=0.02,
        settings=LevitatorSettings(substeps=substeps, speed=SPEED),
    )  # fmt: skip
    for _ in range(STEPS):
        levitator.step(STEP)
    return levitator


@lru_cache(maxsize=1)
def _reference() -> NDArray[np.float64]:
    """Where it ends, by steps of 1/60000 s extrapolated once more (second order)."""
    fine, half = moved_grain(FINEST).positions[0], moved_grain(FINEST // 2).positions[0]
    return np.asarray(fine + (fine - half) / 3.0)


def trap_trial(setting: Setting) -> Trial:
    """The grain with so many substeps: farther than the next trap it was thrown out of its own."""
    substeps = int(setting.knob)

    def judge(levitator: Levitator) -> Outcome:
        away = float(elementwise.hypot(*(levitator.positions[0] - _reference())))
        return Outcome(away, STEPS * substeps, "thrown out of its trap" if away > THROWN else "")

    return computation(STEP * STEPS, lambda: moved_grain(substeps), judge)


def _settings() -> list[Setting]:
    return [Setting(CENTRED, float(n), {}, {"substeps": n}, float(n)) for n in SUBSTEPS]


def _present(parameters: Mapping[str, Any]) -> Setting:
    """As many substeps of this study's step as give substeps of the same length."""
    length = float(parameters["step_length"]) / float(parameters["substeps"])
    return Setting(CENTRED, max(1.0, float(round(STEP / length))), {})


trap_study = Study(
    name="trap",
    title="A grain in a trap that moves",
    error="place of the grain after 0.2 s",
    error_unit="m",
    counter="substeps",
    knob=Knob("substeps", "substeps of 1/60 s", parts=True),
    methods=(Method(CENTRED, "drift, kick, drift", 2.0),),
    settings=_settings,
    trial=trap_trial,
    reference="1000 and 500 substeps, extrapolated.",
    expectation="The trap swings at about 100 Hz: with too few substeps a swing the grain is thrown out.",
    present=_present,
    workload=Workload("one grain 1.2 mm across, led at 0.3 m/s along a circle of 20 mm"),
)
