"""What accuracy costs for a free drop that is drawn out into an ellipse: cells, and the share of FLIP."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload
from game.physics.grid.layout import Grid
from game.physics.liquid import CARRIERS, Liquid, LiquidSettings

RATE, SECONDS, STEP = 1.0, 1.0, 1.0 / 60.0  # 1/s, s, s
WIDE = 5.0  # m, of the box about a drop of a radius of 1 m
CELLS = (20, 28, 40, 56, 80, 112)
SHARES = {"apic": None, "flip": 1.0, "flip-95": 0.95, "flip-half": 0.5}


def exact_axis() -> float:
    """m: the longer half axis after SECONDS. u = A x, v = -A y, A' = A^2 (a^2 - b^2) / (a^2 + b^2), a b = 1
    (Dirichlet 1860; Longuet-Higgins 1972), by Heun's method.
    """
    b, rate, count = 1.0, RATE, 4000
    dt = SECONDS / count
    for _ in range(count):
        db, dr = _slope(b, rate)
        eb, er = _slope(b + dt * db, rate + dt * dr)
        b, rate = b + 0.5 * dt * (db + eb), rate + 0.5 * dt * (dr + er)
    return b


def _slope(b: float, rate: float) -> tuple[float, float]:
    across, along = 1.0 / (b * b), b * b
    return rate * b, rate * rate * (across - along) / (across + along)


class DropTrial:
    """A drop of a radius of 1 m, drawn out along y for a second; nothing pulls at it."""

    simulated_s = SECONDS

    def __init__(self, setting: Setting):
        self.cells = max(12, round(WIDE / setting.knob))
        share = SHARES[setting.method]
        carrier = CARRIERS.index("apic" if share is None else "pic-flip")
        self.settings = LiquidSettings(gravity=0.0, carrier=carrier, flip=1.0 if share is None else share)

    def reset(self) -> None:
        """The drop is round, and has the speeds of the exact flow."""
        n, half = self.cells, 0.5 * WIDE
        self.liquid = Liquid(Grid(n, n, WIDE / n), self.settings, most=4 * n * n)
        places = self.liquid.lattice((half - 1.0, half - 1.0), (half + 1.0, half + 1.0))
        away = places - half
        self.liquid.add(places[(away * away).sum(axis=1) <= 1.0])
        away = self.liquid.places - half
        self.liquid.speeds[:] = RATE * away * (-1.0, 1.0)
        affine = self.liquid.particles.affine[: self.liquid.count]
        affine[:] = np.array((-1.0, 0.0, 0.0, 1.0)) * (RATE * WIDE / n)

    def run(self) -> None:
        """A second."""
        for _ in range(round(SECONDS / STEP)):
            self.liquid.advance(STEP)

    def outcome(self) -> Outcome:
        """Relative error of the longer half axis, by the mean square of y: b^2 / 4 in an ellipse."""
        y = self.liquid.places[:, 1] - self.liquid.places[:, 1].mean()
        axis = 2.0 * math.sqrt(float((y * y).mean()))
        return Outcome(abs(axis / exact_axis() - 1.0), int(self.liquid.clock[1]))


def _settings() -> list[Setting]:
    return [
        Setting(
            method, WIDE / n, {},
            {"carrier": "apic"} if share is None else {"carrier": "pic-flip", "flip": share},
            float(n * n * n),
        )
        for method, share in SHARES.items()
        for n in CELLS
    ]  # fmt: skip


def _present(parameters: Mapping[str, Any]) -> Setting:
    """As many cells across the drop as the scene has."""
    cell = 2.7 / int(parameters["cells"]) / float(parameters["size"])
    method = "apic"
    if parameters["carrier"] != "apic":
        share = float(parameters["flip"])
        method = min(("flip", "flip-95", "flip-half"), key=lambda one: abs((SHARES[one] or 0.0) - share))
    return Setting(method, min(max(cell, WIDE / CELLS[-1]), WIDE / CELLS[0]), {})


drop_study = Study(
    name="drop",
    title="A drop is drawn out",
    error="relative error of the longer half axis",
    error_unit="",
    counter="part steps",
    knob=Knob("cell", "cell", "m"),
    methods=(
        Method("apic", "APIC", 1.0),
        Method("flip", "FLIP alone", 1.0),
        Method("flip-95", "FLIP 0.95", 1.0),
        Method("flip-half", "FLIP 0.5", 1.0),
    ),
    settings=_settings,
    trial=DropTrial,
    reference="the ellipse of Dirichlet (1860) and Longuet-Higgins (1972)",
    expectation="A drop needs ten cells across; the more PIC, the more its flow is held back.",
    present=_present,
    workload=Workload("a drop of 1 m drawn out for a second"),
)
