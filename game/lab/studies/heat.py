"""What accuracy costs for heat: a hot spot that spreads, by three schemes."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.lab.trials import Computation
from game.physics.heat import HeatGrid
from game.physics.kernels import elementary, elementwise

CELLS, SIZE, SECONDS, DIFFUSIVITY = 48, 1.0, 0.04, 1.0
STEPS = {
    "explicit": (400, 800, 1600, 3200),
    "crank-nicolson": (4, 8, 16, 32, 64),
    "alternating": (4, 8, 16, 32, 64),
}
WAVES = ((1, 2, 100.0), (2, 1, 60.0), (3, 3, 25.0))  # across, along, K: of which the start is made


def start_and_end() -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Temperatures K at first, and exactly as the grid itself has them at the end."""
    cell = SIZE / CELLS
    x = (np.arange(CELLS) + 0.5) / CELLS
    first, last = np.full((CELLS, CELLS), 300.0), np.full((CELLS, CELLS), 300.0)
    for across, along, high in WAVES:
        wave = (
            high
            * elementwise.cos(math.pi * across * x)[None, :]
            * elementwise.cos(math.pi * along * x)[:, None]
        )
        slow = sum(2.0 - 2.0 * elementary.cos(math.pi * number / CELLS) for number in (across, along))
        first += wave
        last += wave * elementary.exp(-DIFFUSIVITY * slow / (cell * cell) * SECONDS)
    return first, last


def heat_trial(setting: Setting) -> Trial:
    """The plate with so many steps: the root of the mean square of what the temperatures are off."""
    first, last = start_and_end()
    steps = int(setting.knob)

    def begin() -> HeatGrid:
        grid = HeatGrid(first, SIZE / CELLS, DIFFUSIVITY, 1.0, scheme=setting.method)
        grid.fresh = 0  # nothing jumps here
        return grid

    def work(grid: HeatGrid) -> HeatGrid:
        for _ in range(steps):
            grid.step(SECONDS / steps)
        return grid

    def judge(grid: HeatGrid) -> Outcome:
        off = grid.temperature - last
        return Outcome(float(np.sqrt(np.mean(off * off))), steps)

    return Computation(SECONDS, begin, work, judge)


def _settings() -> list[Setting]:
    return [
        Setting(scheme, float(steps), {}, {}, float(steps))
        for scheme, counts in STEPS.items()
        for steps in counts
    ]


def _present(_parameters: Mapping[str, Any]) -> Setting:
    """The fire's own steps are those of what moves; its threads take the explicit scheme in short
    substeps.
    """
    return Setting("explicit", float(STEPS["explicit"][0]), {})


conduction_study = Study(
    name="conduction",
    title="Heat that spreads in a plate",
    error="temperature after 0.04 s",
    error_unit="K",
    counter="steps",
    knob=Knob("steps", "steps", parts=True),
    methods=(
        Method("explicit", "explicit Euler", 1.0),
        Method("crank-nicolson", "Crank and Nicolson", 2.0),
        Method("alternating", "Peaceman and Rachford", 2.0),
    ),
    settings=_settings,
    trial=heat_trial,
    reference="Three waves of the grid, each with its exact rate.",
    expectation="The explicit scheme needs 370 steps to be stable at all; the implicit ones are of second "
    "order from the first step on.",
    present=_present,
    workload=Workload("48 by 48 cells, insulated"),
)
