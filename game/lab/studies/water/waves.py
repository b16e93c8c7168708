"""What accuracy costs for shallow water: the broken dam by constant and linear cells."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload
from game.physics.waves import METHODS, DamBreak, ShallowSettings, ShallowWater, dam_break

LENGTH, SECONDS, DEPTH = 20.0, 0.8, 1.0  # m, s, m
CELLS = (125, 250, 500, 1000, 2000, 4000)
PARTS = 16  # of a cell, over which the exact depth is averaged


class DamTrial:
    """A dam of 1 m, in the middle of 20 m, that breaks on a dry or a wet bed."""

    simulated_s = SECONDS

    def __init__(self, setting: Setting):
        self.cells = max(8, round(LENGTH / setting.knob))
        self.method = METHODS.index(setting.method)
        self.dam = dam_break(DEPTH, float(setting.scene.get("right", 0.0)))

    def reset(self) -> None:
        """The dam stands."""
        cell = LENGTH / self.cells
        self.x = (np.arange(self.cells) + 0.5) * cell - 0.5 * LENGTH
        self.water = ShallowWater(
            np.where(self.x < 0.0, self.dam.left, self.dam.right), np.zeros(self.cells), cell,
            ShallowSettings(method=self.method), ("open", "open", "wall", "wall"),
        )  # fmt: skip

    def run(self) -> None:
        """Until waves are 5 m away."""
        self.steps = self.water.advance(SECONDS)

    def outcome(self) -> Outcome:
        """L1 of the depth, m²."""
        away = self.water.depth[0] - means_of(self.dam, self.x, self.water.cell, SECONDS)
        return Outcome(float(np.sum(np.abs(away))) * self.water.cell, self.steps)


def means_of(dam: DamBreak, x: np.ndarray, cell: float, time: float) -> np.ndarray:
    """The exact depths (m) in the mean over cells about x (m from the dam), at a time (s)."""
    inside = (np.arange(PARTS) + 0.5) / PARTS - 0.5
    return np.asarray(np.mean([dam.at(x + part * cell, time)[0] for part in inside], axis=0))


def _settings() -> list[Setting]:
    return [
        Setting(method, LENGTH / n, {"right": 0.0}, {"method": method}, float(n) * n)
        for method in METHODS
        for n in CELLS
    ]


def _present(parameters: Mapping[str, Any]) -> Setting:
    """The scene's cells, of the study's length."""
    cell = float(parameters["length"]) / int(parameters["cells"])
    return Setting(
        str(parameters["method"]), min(max(cell, LENGTH / CELLS[-1]), LENGTH / CELLS[0]), {"right": 0.0}
    )


dam_study = Study(
    name="waves",
    title="A dam breaks on dry ground",
    error="L1 error of the depth over 20 m, 0.8 s after",
    error_unit="m²",
    counter="steps",
    knob=Knob("cell", "cell", "m"),
    methods=(
        Method("constant", "constant in a cell (Godunov)", 0.75),
        Method("linear", "linear in a cell (MUSCL-Hancock)", 1.0),
    ),
    settings=_settings,
    trial=DamTrial,
    reference="Ritter (1892), in the mean over each cell",
    expectation="The corners of the exact depth hold linear cells to order one, constant ones below.",
    present=_present,
    workload=Workload("a dam of 1 m in the middle of 20 m"),
)
