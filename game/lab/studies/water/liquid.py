"""What accuracy costs for a liquid: the period of a sloshing tank, by method and cell."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from game.lab.studies.water.volume import volume_study
from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload
from game.physics.grid.layout import Grid
from game.physics.kernels import elementary, elementwise
from game.physics.liquid import CARRIERS, Liquid, LiquidSettings

DEPTH, SWING, STEP = 0.5, 0.02, 1.0 / 120.0  # m, m, s
CELLS = (12, 16, 24, 32, 48, 64)
SURFACES = {"apic": 0, "pic-flip": 0, "plain": 1}
WAVE = math.pi  # rad/m, of the lowest mode of a tank 1 m wide


def exact_rate(depth: float = DEPTH, gravity: float = 9.81) -> float:
    """rad/s: w^2 = g k tanh(k h)."""
    return math.sqrt(gravity * WAVE * elementary.tanh(WAVE * depth))


class SloshTrial:
    """A tank 1 m wide, half full, that sloshes for two periods."""

    simulated_s = 2.0 * math.tau / exact_rate()

    def __init__(self, setting: Setting):
        self.cells = max(8, round(1.0 / setting.knob))
        carrier = CARRIERS.index("pic-flip" if setting.method == "pic-flip" else "apic")
        self.settings = LiquidSettings(carrier=carrier, surface=SURFACES[setting.method])

    def reset(self) -> None:
        """The surface is flat, and the water has the speeds of the mode."""
        n = self.cells
        self.liquid = Liquid(Grid(n, n, 1.0 / n), self.settings, most=8 * n * n)
        self.liquid.add(self.liquid.lattice((0.0, 0.0), (1.0, DEPTH)))
        x, y = self.liquid.places.T
        up, down = elementwise.exp(WAVE * y), elementwise.exp(-WAVE * y)
        size = SWING * exact_rate() / (elementary.exp(WAVE * DEPTH) - elementary.exp(-WAVE * DEPTH))
        self.liquid.speeds[:, 0] = -size * elementwise.sin(WAVE * x) * (up + down)
        self.liquid.speeds[:, 1] = size * elementwise.cos(WAVE * x) * (up - down)

    def run(self) -> None:
        """Two periods; the middle of the water is noted."""
        self.off = [0.0]
        for _ in range(round(self.simulated_s / STEP)):
            self.liquid.advance(STEP)
            self.off.append(float(self.liquid.places[:, 0].mean()) - 0.5)

    def outcome(self) -> Outcome:
        """Relative error of the period, by the times at which the middle passes the tank's."""
        off = np.array(self.off)
        at = np.flatnonzero(off[1:-1] * off[2:] < 0.0) + 1
        times = STEP * (at + off[at] / (off[at] - off[at + 1]))
        half = float(np.mean(np.diff(times))) if len(times) > 1 else math.inf
        error = abs(half * exact_rate() / math.pi - 1.0) if math.isfinite(half) else 1.0
        return Outcome(max(error, 1e-6), int(self.liquid.clock[1]))


def _settings() -> list[Setting]:
    return [
        Setting(
            method, 1.0 / n, {}, {"carrier": "pic-flip" if method == "pic-flip" else "apic"}, float(n * n * n)
        )
        for method in SURFACES
        for n in CELLS
    ]


def _present(parameters: Mapping[str, Any]) -> Setting:
    """The scene's cells, as a share of the tank."""
    cell = min(max(1.0 / int(parameters["cells"]), 1.0 / CELLS[-1]), 1.0 / CELLS[0])
    plain = parameters["surface"] == "plain"
    return Setting("plain" if plain else str(parameters["carrier"]), cell, {})


liquid_study = Study(
    name="liquid",
    title="A tank sloshes",
    error="relative error of the period",
    error_unit="",
    counter="part steps",
    knob=Knob("cell", "cell", "m"),
    methods=(
        Method("apic", "APIC, surface at its place", 1.0),
        Method("pic-flip", "FLIP 0.95, surface at its place", 1.0),
        Method("plain", "APIC, pressure 0 in cells of air", 1.0),
    ),
    settings=_settings,
    trial=SloshTrial,
    reference="w^2 = g k tanh(k h) (Airy 1841)",
    expectation="A surface at its place is right on few cells; in cells of air low waves are hardly seen.",
    present=_present,
    workload=Workload("a tank 1 m wide, half full, for two periods"),
    short="Period",
    related=(volume_study,),
)
