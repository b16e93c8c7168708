"""What accuracy costs for gas on a grid: eddies that are carried along, the eddy in a cavity, and a flow that
comes in on one side and goes out on the other.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import partial
from typing import Any

import numpy as np

from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload
from game.physics.gas import ADVECTIONS, Gas, GasSettings
from game.physics.grid import Border, Borders, Grid
from game.physics.kernels import elementwise

ORDERS = {"stam-1999": 1.0, "linear": 1.0, "cubic": 1.0, "maccormack": 1.0, "time-centred": 2.0}
LABELS = {
    "stam-1999": "Stam 1999", "linear": "midpoint, linear", "cubic": "midpoint, cubic",
    "maccormack": "MacCormack, limited", "time-centred": "time-centred, q 0.5",
}  # fmt: skip
WIND, COURANT, SECONDS = (1.0, 0.5), 1.3, 0.4
RE, STEADY_S = 100.0, 14.0
RODS_RE, RODS_S = 40.0, 2.0
LEAST_U = -0.21404412  # least u on the vertical centre line at Re 100, extrapolated (Botella and Peyret 1998)


class EddiesTrial:
    """Taylor and Green's eddies in a wind, on so many cells a side at a fixed Courant number."""

    simulated_s = SECONDS

    def __init__(self, setting: Setting):
        self.cells, self.method = int(setting.knob), setting.method

    def reset(self) -> None:
        """The eddies as they begin."""
        n = self.cells
        centred = self.method == "time-centred"
        settings = GasSettings(
            advection=self.method, centring=0.5, prime=centred, gravity=(0.0, 0.0), turns=12, tolerance=1e-9
        )
        self.gas = Gas(Grid(n, n, 1.0 / n), Borders.all("periodic"), settings, fields=("smoke",))
        self.gas.u[:], self.gas.v[:] = eddies(self.gas.grid, 0.0)
        self.steps = max(1, round(SECONDS * n * (1.0 + WIND[0]) / COURANT))

    def run(self) -> None:
        """All steps."""
        for _ in range(self.steps):
            self.gas.step(SECONDS / self.steps)

    def outcome(self) -> Outcome:
        """L2 error of u."""
        away = self.gas.u - eddies(self.gas.grid, SECONDS)[0]
        return Outcome(float(np.sqrt(np.mean(away * away))), self.steps)


def eddies(grid: Grid, time: float) -> tuple[np.ndarray, np.ndarray]:
    """u, v on faces of eddies of 1 m/s that a wind carries along (Taylor and Green 1937)."""
    k = 2.0 * math.pi
    x, y = grid.u_places()
    u = WIND[0] + elementwise.sin(k * (x - WIND[0] * time)) * elementwise.cos(k * (y - WIND[1] * time))
    x, y = grid.v_places()
    v = WIND[1] - elementwise.cos(k * (x - WIND[0] * time)) * elementwise.sin(k * (y - WIND[1] * time))
    return u, v


class CavityTrial:
    """The eddy under a lid at Re 100, from rest until it stands."""

    simulated_s = STEADY_S

    def __init__(self, setting: Setting):
        self.cells, self.method = int(setting.knob), setting.method

    def reset(self) -> None:
        """Gas at rest."""
        n = self.cells
        still = Border("no-slip")
        settings = GasSettings(
            advection=self.method, viscosity=1.0 / RE, gravity=(0.0, 0.0), turns=3, tolerance=1e-6
        )
        borders = Borders(still, still, still, Border("no-slip", (1.0, 0.0)))
        self.gas = Gas(Grid(n, n, 1.0 / n), borders, settings, fields=("smoke",))
        self.steps = round(STEADY_S * n)

    def run(self) -> None:
        """All steps."""
        for _ in range(self.steps):
            self.gas.step(1.0 / self.cells)

    def outcome(self) -> Outcome:
        """Error of the least u, over the lid's speed."""
        found = float(np.min(self.gas.u[:, self.cells // 2]))
        return Outcome(abs(found - LEAST_U), self.steps)


class RodsTrial:
    """The flow behind a row of rods at Re 40 (Kovasznay 1948), from the exact one until its errors stand."""

    simulated_s = RODS_S

    def __init__(self, setting: Setting):
        self.cells, self.method = int(setting.knob), setting.method

    def reset(self) -> None:
        """The exact flow at the faces."""
        n = self.cells
        grid = Grid(n, n, 1.0 / n, (-0.5, -0.5))
        _, y = grid.centres()
        left = np.full_like(y[:, 0], -0.5)
        given = np.stack(behind_rods(left, y[:, 0]), axis=1)
        borders = Borders(Border("inflow", given), Border("open"), Border("periodic"), Border("periodic"))
        settings = GasSettings(
            advection=self.method, viscosity=1.0 / RODS_RE, gravity=(0.0, 0.0), turns=8, tolerance=1e-7
        )
        self.gas = Gas(grid, borders, settings, fields=("smoke",))
        self.gas.u[:] = self.exact = behind_rods(*grid.u_places())[0]
        self.gas.v[:] = behind_rods(*grid.v_places())[1]
        self.gas.jolt()
        self.steps = round(2.0 * RODS_S * n)

    def run(self) -> None:
        """All steps, at a Courant number of about a half."""
        for _ in range(self.steps):
            self.gas.step(RODS_S / self.steps)

    def outcome(self) -> Outcome:
        """L2 error of u, but for the last quarter before the open side."""
        away = (self.gas.u - self.exact)[:, : 3 * self.cells // 4]
        return Outcome(float(np.sqrt(np.mean(away * away))), self.steps)


def behind_rods(x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """u, v in units of the stream, lengths in the rods' distance: a steady exact flow (Kovasznay 1948)."""
    decay = 0.5 * RODS_RE - math.sqrt(0.25 * RODS_RE * RODS_RE + 4.0 * math.pi * math.pi)
    k = 2.0 * math.pi
    wake = elementwise.exp(decay * x)
    return 1.0 - wake * elementwise.cos(k * y), decay / k * wake * elementwise.sin(k * y)


def _settings(cells: tuple[int, ...], methods: tuple[str, ...]) -> list[Setting]:
    return [
        Setting(name, float(n), {}, {"cells": n, "advection": name}, 1.0 / n)
        for name in methods
        for n in cells
    ]


def _present(parameters: Mapping[str, Any]) -> Setting:
    return Setting(str(parameters["advection"]), float(parameters["cells"]), {})


eddies_study = Study(
    name="eddies",
    short="Eddies in a wind",
    title="Eddies in a wind",
    error="speed u after 0.4 s, root mean square",
    error_unit="m/s",
    counter="steps",
    knob=Knob("cells", "cells a side", parts=True),
    methods=tuple(Method(name, LABELS[name], ORDERS[name]) for name in ADVECTIONS),
    settings=partial(_settings, (16, 32, 64, 96), ADVECTIONS),
    present=_present,
    trial=EddiesTrial,
    reference="Taylor and Green 1937: without viscosity the eddies only move.",
    expectation="Better interpolation hardly helps: what costs an order is taking pressure only at the end.",
    workload=Workload("two by two eddies of 1 m/s in a wind of (1, 0.5) m/s, Courant number 1.3"),
)

rods_study = Study(
    name="rods",
    title="Behind a row of rods",
    short="Behind rods",
    error="speed u after 2 s, root mean square",
    error_unit="m/s",
    counter="steps",
    knob=Knob("cells", "cells a side", parts=True),
    methods=tuple(Method(name, LABELS[name], ORDERS[name]) for name in ADVECTIONS),
    settings=partial(_settings, (12, 16, 24, 32), ADVECTIONS),
    trial=RodsTrial,
    reference="Kovasznay 1948: an exact steady flow, in at the left and out at the right.",
    expectation="At few cells linear interpolation is closest, by chance; only the error of the time-centred "
    "step falls with the square of the cells.",
    present=_present,
    workload=Workload("a stream of 1 m/s behind rods 1 m apart at Re 40, for 2 s"),
)

cavity_study = Study(
    name="cavity",
    short="Cavity",
    title="The eddy in a cavity",
    error="least u on the vertical centre line at Re 100",
    error_unit="m/s",
    counter="steps",
    knob=Knob("cells", "cells a side", parts=True),
    methods=tuple(Method(name, LABELS[name], 2.0 if name == "time-centred" else 1.0) for name in ADVECTIONS),
    settings=partial(_settings, (8, 16, 32), ADVECTIONS),
    trial=CavityTrial,
    reference="Two discretisations, extrapolated; Botella and Peyret 1998.",
    expectation="The time-centred step loses least of the eddy on the same cells.",
    present=_present,
    workload=Workload("a lid of 1 m/s over a square of 1 m at Re 100, from rest for 14 s"),
    related=(eddies_study, rods_study),
)
