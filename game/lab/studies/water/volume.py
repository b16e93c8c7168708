"""What it costs a liquid to keep its volume: a column falls in a tank, by method and cell."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload
from game.physics.grid.layout import Grid
from game.physics.liquid import CARRIERS, Liquid, LiquidSettings

SIDE, WIDTH, HEIGHT = 1.0, 0.4, 0.8  # m, of the tank and of the column
SECONDS, LAST, STEP = 6, 1.0, 1.0 / 60.0  # s; over the last of them the volume is measured
CELLS = (12, 16, 24, 32, 48)


class Way(NamedTuple):
    """How speeds pass, the share of FLIP, and of the crowding that is taken away."""

    title: str
    carrier: str
    flip: float
    keeping: float


WAYS = {
    "pic": Way("PIC", "pic-flip", 0.0, 1.0),
    "flip": Way("FLIP 0.95", "pic-flip", 0.95, 1.0),
    "apic": Way("APIC", "apic", 0.95, 1.0),
    "pic, crowded": Way("PIC, no correction", "pic-flip", 0.0, 0.0),
    "flip, crowded": Way("FLIP 0.95, no correction", "pic-flip", 0.95, 0.0),
    "apic, crowded": Way("APIC, no correction", "apic", 0.95, 0.0),
}


class FallTrial:
    """A column falls, and the tank sloshes for six seconds."""

    simulated_s = float(SECONDS)

    def __init__(self, setting: Setting):
        self.cells, way = max(8, round(SIDE / setting.knob)), WAYS[setting.method]
        self.settings = LiquidSettings(
            carrier=CARRIERS.index(way.carrier), flip=way.flip, keeping=way.keeping
        )

    def reset(self) -> None:
        """The column stands in the left corner."""
        n = self.cells
        self.liquid = Liquid(Grid(n, n, SIDE / n), self.settings, most=8 * n * n)
        self.liquid.add(self.liquid.lattice((0.0, 0.0), (WIDTH, HEIGHT)))

    def run(self) -> None:
        """Six seconds; the volume is noted in the last of them."""
        liquid, self.off = self.liquid, list[float]()
        for step in range(round(SECONDS / STEP)):
            liquid.advance(STEP)
            if step * STEP >= SECONDS - LAST:
                self.off.append(liquid.wet_area() / (liquid.count * liquid.area) - 1.0)

    def outcome(self) -> Outcome:
        """Share of the volume that is lost or gained, in the mean of the last second."""
        return Outcome(max(abs(float(np.mean(self.off))), 1e-6), int(self.liquid.clock[1]))


def _settings() -> list[Setting]:
    return [
        Setting(
            name,
            SIDE / n,
            {},
            {"carrier": way.carrier, "flip": way.flip, "keeping": way.keeping},
            float(n * n * n),
        )
        for name, way in WAYS.items()
        for n in CELLS
    ]


def _present(parameters: Mapping[str, Any]) -> Setting:
    """The scene's cells, as a share of the tank, and its method; FLIP shares below a half are PIC."""
    cell = min(max(SIDE / int(parameters["cells"]), SIDE / CELLS[-1]), SIDE / CELLS[0])
    name = "apic" if parameters["carrier"] == "apic" else "flip" if parameters["flip"] >= 0.5 else "pic"
    return Setting(name if parameters["keeping"] > 0.0 else f"{name}, crowded", cell, {})


volume_study = Study(
    name="liquid-volume",
    title="A tank keeps its water",
    error="share of the volume that is lost",
    error_unit="",
    counter="part steps",
    knob=Knob("cell", "cell", "m"),
    methods=tuple(Method(name, way.title, None) for name, way in WAYS.items()),
    settings=_settings,
    trial=FallTrial,
    reference="the particles' own area, which no step changes",
    expectation="A tenth or more is lost without the correction, most on fine grids; little with it.",
    present=_present,
    workload=Workload("a column that falls in a tank 1 m wide, for six seconds"),
    short="Volume",
)
