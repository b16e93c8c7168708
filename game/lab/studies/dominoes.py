"""What accuracy costs for a row of dominoes: the speed of the wave against the substeps of a step."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import lru_cache
from typing import Any

import numpy as np

from game.lab.studies.qualities import quality_marks
from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload
from game.naming import words_of
from game.physics.dominoes import STANDARD_GRAVITY, domino_wave_speed
from game.physics.solids import TIERS, Chain, Material, SolidSettings, SolidWorld, box

THICK, GAP, FRICTION = 0.16, 0.3, 0.2  # heights; they are 1 m high
COUNT, FIRST, LAST = 34, 14, 32  # dominoes; between which two the speed is measured
STEP_S = 1.0 / 60.0
LONGEST_S = 6.0
STRUCK = 0.03  # rad
COUNTS = (1, 2, 4, 8, 12, 16, 24, 32, 64)
SOLVERS = ("soft-step", "sequential-impulses")


@lru_cache(maxsize=1)
def exact_speed() -> float:
    """m/s, of the steady wave."""
    return math.sqrt(STANDARD_GRAVITY) * domino_wave_speed(GAP, THICK, FRICTION)


class DominoTrial:
    """A row on a rough floor, its first domino pushed, until the last has been struck."""

    def __init__(self, setting: Setting):
        self._substeps = max(1, round(STEP_S / setting.knob))
        self._solver = setting.method if setting.method in SOLVERS else str(setting.scene["solver"])
        self.simulated_s = LONGEST_S
        self.reset()

    def reset(self) -> None:
        """All upright."""
        self._world = SolidWorld(SolidSettings(solver=self._solver, substeps=self._substeps))
        self._world.add_body(
            Chain([(-3.0, 0.0), (60.0, 0.0)], material=Material(friction=1.0 / FRICTION)), kind="fixed"
        )
        shape = box(THICK, 1.0, material=Material(friction=FRICTION))
        bodies = [self._world.add_body(shape, (k * (THICK + GAP), 0.5)) for k in range(COUNT)]
        spin = -math.sqrt(STANDARD_GRAVITY)
        self._world.set_velocity(bodies[0], (-0.5 * spin, -0.5 * THICK * spin), spin)
        self._bodies = np.array(bodies)
        self._struck = np.full(COUNT, -1.0)
        self._steps = 0

    def run(self) -> None:
        """Until the last but one is struck, or for too long."""
        while self._struck[LAST] < 0.0 and self._world.time < LONGEST_S:
            before = np.abs(self._world.bodies.angles[self._bodies])
            self._world.step(STEP_S)
            self._steps += 1
            now = np.abs(self._world.bodies.angles[self._bodies])
            hit = (now > STRUCK) & (self._struck < 0.0)
            share = (STRUCK - before[hit]) / np.maximum(now[hit] - before[hit], 1e-12)
            self._struck[hit] = self._world.time - STEP_S + np.clip(share, 0.0, 1.0) * STEP_S
        self.simulated_s = self._world.time

    def outcome(self) -> Outcome:
        """Relative error of the speed; 1 if the wave has stopped."""
        took = self._struck[LAST] - self._struck[FIRST]
        error = 1.0
        if self._struck[LAST] >= 0.0 and took > 0.0:
            error = abs((LAST - FIRST) * (THICK + GAP) / took / exact_speed() - 1.0)
        return Outcome(max(error, 1e-9), self._steps * self._substeps)


def domino_settings() -> list[Setting]:
    """1 to 64 substeps."""
    return [
        Setting(
            name, STEP_S / n, {},
            {"solver": name, "substeps": n, "tier": "own", "step_length": STEP_S, "iterations": 1},
            10.0 + n,
        )
        for n in COUNTS
        for name in SOLVERS
    ]  # fmt: skip


def present_domino(parameters: Mapping[str, Any]) -> Setting:
    """Where a scene with these parameters stands: its solver and its substep."""
    substeps = TIERS.get(parameters["tier"], int(parameters["substeps"]))
    h = float(parameters["step_length"]) / substeps
    solver = str(parameters["solver"])
    name = solver if solver in SOLVERS else "present"
    return Setting(name, min(max(h, STEP_S / COUNTS[-1]), STEP_S), {}, {"solver": solver})


domino_study = Study(
    name="a01",
    title="A wave of dominoes",
    error="relative error of its speed",
    error_unit="",
    counter="substeps",
    knob=Knob("step_length", "substep", "s"),
    methods=tuple(Method(name, words_of(name), None) for name in SOLVERS),
    settings=domino_settings,
    trial=DominoTrial,
    reference="the speed of van Leeuwen (2010)",
    expectation=(
        "Impacts are found at the end of a substep, so the error falls about as the substep does, by chance "
        "more or less. Below half a percent the theory is not exact: it keeps all dominoes in touch."
    ),
    present=present_domino,
    workload=Workload("34 dominoes"),
    mark=quality_marks("soft-step"),
)
