"""What accuracy costs for a dam: the front of a column by liquid, by particles and by shallow water."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload
from game.physics.grid.layout import Grid
from game.physics.liquid import CARRIERS, Liquid, LiquidSettings
from game.physics.particle_fluids import FluidSettings, ParticleFluid, lattice
from game.physics.waves import ShallowWater

WIDTH, HEIGHT, LENGTH, STEP, G = 1.0, 2.0, 5.0, 1.0 / 240.0, 9.81
LATE, FRONT = 2.547, 3.34  # t sqrt(2 g / width); front over width by a particle code (PySPH, 3,938 particles)
CELLS = (8, 12, 16, 24, 32)
PARTICLES = "dfsph"
METHODS = (*CARRIERS, PARTICLES, "shallow")


class FrontTrial:
    """A column 1 m wide and 2 m high, until its front is at about 3.3 m."""

    simulated_s = LATE / math.sqrt(2.0 * G / WIDTH)

    def __init__(self, setting: Setting):
        self.cells, self.method = max(4, round(WIDTH / setting.knob)), setting.method

    def reset(self) -> None:
        """The gate stands."""
        n = self.cells
        if self.method == "shallow":
            x = (np.arange(5 * n) + 0.5) / n
            self.water = ShallowWater(np.where(x < WIDTH, HEIGHT, 0.0), np.zeros(5 * n), 1.0 / n)
            return
        if self.method == PARTICLES:
            tank = ((0.0, 0.0), (5.0, 0.0), (5.0, 3.0), (0.0, 3.0))
            self.fluid = ParticleFluid(
                1.0 / n, vessel=(tank,), settings=FluidSettings(iterations=12, courant=0.4)
            )
            self.fluid.add(lattice((0.0, 0.0), (WIDTH, HEIGHT), 1.0 / n))
            return
        settings = LiquidSettings(carrier=CARRIERS.index(self.method))
        self.liquid = Liquid(Grid(5 * n, 3 * n, 1.0 / n), settings, most=10 * n * n)
        self.liquid.add(self.liquid.lattice((0.0, 0.0), (WIDTH, HEIGHT)))

    def run(self) -> None:
        """It falls."""
        if self.method == "shallow":
            self.steps = self.water.advance(self.simulated_s)
            return
        count = round(self.simulated_s / STEP)
        water = self.fluid if self.method == PARTICLES else self.liquid
        self.steps = sum(water.advance(self.simulated_s / count) for _ in range(count))

    def outcome(self) -> Outcome:
        """Relative distance of the front from that of the particle code."""
        if self.method == "shallow":
            wet = np.flatnonzero(self.water.depth[0] > 0.01 * HEIGHT)
            front = (float(wet[-1]) + 1.0) / self.cells
        elif self.method == PARTICLES:
            front = float(np.max(self.fluid.place[:, 0])) + 0.5 / self.cells
        else:
            front = float(np.sort(self.liquid.places[:, 0])[-4])
        return Outcome(max(abs(front / FRONT - 1.0), 1e-5), self.steps)


def _settings() -> list[Setting]:
    return [
        Setting(
            method, 1.0 / n, {}, _scene(method, n), float(n * n * n) * (20.0 if method == PARTICLES else 1.0)
        )
        for method in METHODS
        for n in (CELLS[:-1] if method == PARTICLES else CELLS)
    ]


def _scene(method: str, cells: int) -> dict[str, Any]:
    if method == PARTICLES:
        return {"law": method, "particles": 2 * cells * cells}
    return {"carrier": method} if method in CARRIERS else {}


def _present(parameters: Mapping[str, Any]) -> Setting:
    """The scene's liquid."""
    cell = min(max(1.0 / int(parameters["cells"]), 1.0 / CELLS[-1]), 1.0 / CELLS[0])
    return Setting(str(parameters["carrier"]), cell, {})


front_study = Study(
    name="dam",
    title="The front of a dam",
    error="relative distance of the front from a particle code's",
    error_unit="",
    counter="steps",
    knob=Knob("cell", "cell", "m"),
    methods=(
        Method("pic-flip", "liquid, FLIP 0.95", 1.0),
        Method("apic", "liquid, APIC", 1.0),
        Method(PARTICLES, "particles, DFSPH", 1.0),
        Method("shallow", "shallow water", 0.0),
    ),
    settings=_settings,
    trial=FrontTrial,
    reference="PySPH with 3,938 particles; no exact front is known",
    expectation=(
        "The liquid's front lies within a few percent on any grid, that of particles too, at 20 times the "
        "price. Shallow water is ahead by far. PySPH took 13.8 s for a second."
    ),
    present=_present,
    workload=Workload("a column 1 m wide and 2 m high"),
)


def _of_the_valley(parameters: Mapping[str, Any]) -> Setting:
    """Cells along 128 m, and a column half as wide as its water is deep."""
    cells = 0.5 * float(parameters["level"]) * int(parameters["cells"]) / 128.0
    return _present({"cells": max(round(cells), 1), "carrier": parameters["carrier"]})


def _settings_of_the_valley() -> list[Setting]:
    """As they are, but for particles and shallow water, which the valley does not have."""
    return [setting if setting.method in CARRIERS else replace(setting, scene={}) for setting in _settings()]


valley_study = replace(front_study, name="valley", settings=_settings_of_the_valley, present=_of_the_valley)
