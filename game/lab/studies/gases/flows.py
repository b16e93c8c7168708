"""What accuracy costs for gas on a grid: eddies that are carried along, the eddy in a cavity, and a flow that
comes in on one side and goes out on the other.
"""

from __future__ import annotations

import math
from functools import partial

import numpy as np

from game.lab.studies.gases.whirl import gas_trial
from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.lab.trials import chosen_setting, every_setting
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


def eddies_trial(setting: Setting) -> Trial:
    """Eddies in a wind on so many cells a side, at a fixed Courant number: L2 error of u."""
    n, method = int(setting.knob), setting.method
    steps = max(1, round(SECONDS * n * (1.0 + WIND[0]) / COURANT))

    def begin() -> Gas:
        settings = GasSettings(
            advection=method, centring=0.5, prime=method == "time-centred", gravity=(0.0, 0.0), turns=12,
            tolerance=1e-9,
        )  # fmt: skip
        gas = Gas(Grid(n, n, 1.0 / n), Borders.all("periodic"), settings, fields=("smoke",))
        gas.u[:], gas.v[:] = eddies(gas.grid, 0.0)
        return gas

    def judge(gas: Gas) -> Outcome:
        away = gas.u - eddies(gas.grid, SECONDS)[0]
        return Outcome(float(np.sqrt(np.mean(away * away))), steps)

    return gas_trial(SECONDS, begin, SECONDS / steps, steps, judge)


def eddies(grid: Grid, time: float) -> tuple[np.ndarray, np.ndarray]:
    """u, v on faces of eddies of 1 m/s that a wind carries along (Taylor and Green 1937)."""
    k = 2.0 * math.pi
    x, y = grid.u_places()
    u = WIND[0] + elementwise.sin(k * (x - WIND[0] * time)) * elementwise.cos(k * (y - WIND[1] * time))
    x, y = grid.v_places()
    v = WIND[1] - elementwise.cos(k * (x - WIND[0] * time)) * elementwise.sin(k * (y - WIND[1] * time))
    return u, v


def cavity_trial(setting: Setting) -> Trial:
    """The eddy under a lid at Re 100, from rest until it stands: error of the least u."""
    n = int(setting.knob)
    steps = round(STEADY_S * n)

    def begin() -> Gas:
        still = Border("no-slip")
        settings = GasSettings(
            advection=setting.method, viscosity=1.0 / RE, gravity=(0.0, 0.0), turns=3, tolerance=1e-6
        )
        borders = Borders(still, still, still, Border("no-slip", (1.0, 0.0)))
        return Gas(Grid(n, n, 1.0 / n), borders, settings, fields=("smoke",))

    def judge(gas: Gas) -> Outcome:
        return Outcome(abs(float(np.min(gas.u[:, n // 2])) - LEAST_U), steps)

    return gas_trial(STEADY_S, begin, 1.0 / n, steps, judge)


def rods_trial(setting: Setting) -> Trial:
    """The flow behind a row of rods at Re 40 (Kovasznay 1948), from the exact one until its errors stand.

    L2 error of u, but for the last quarter before the open side; the Courant number is about a half.
    """
    n = int(setting.knob)
    steps = round(2.0 * RODS_S * n)
    grid = Grid(n, n, 1.0 / n, (-0.5, -0.5))
    exact = behind_rods(*grid.u_places())[0]

    def begin() -> Gas:
        _, y = grid.centres()
        left = np.full_like(y[:, 0], -0.5)
        given = np.stack(behind_rods(left, y[:, 0]), axis=1)
        borders = Borders(Border("inflow", given), Border("open"), Border("periodic"), Border("periodic"))
        settings = GasSettings(
            advection=setting.method, viscosity=1.0 / RODS_RE, gravity=(0.0, 0.0), turns=8, tolerance=1e-7
        )
        gas = Gas(grid, borders, settings, fields=("smoke",))
        gas.u[:], gas.v[:] = exact, behind_rods(*grid.v_places())[1]
        gas.jolt()
        return gas

    def judge(gas: Gas) -> Outcome:
        away = (gas.u - exact)[:, : 3 * n // 4]
        return Outcome(float(np.sqrt(np.mean(away * away))), steps)

    return gas_trial(RODS_S, begin, RODS_S / steps, steps, judge)


def behind_rods(x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """u, v in units of the stream, lengths in the rods' distance: a steady exact flow (Kovasznay 1948)."""
    decay = 0.5 * RODS_RE - math.sqrt(0.25 * RODS_RE * RODS_RE + 4.0 * math.pi * math.pi)
    k = 2.0 * math.pi
    wake = elementwise.exp(decay * x)
    return 1.0 - wake * elementwise.cos(k * y), decay / k * wake * elementwise.sin(k * y)


def _settings(cells: tuple[int, ...]) -> list[Setting]:
    return every_setting(
        ADVECTIONS, cells, lambda name, n: {"cells": n, "advection": name}, lambda n: 1.0 / n
    )


eddies_study = Study(
    name="eddies",
    short="Eddies in a wind",
    title="Eddies in a wind",
    error="speed u after 0.4 s, root mean square",
    error_unit="m/s",
    counter="steps",
    knob=Knob("cells", "cells a side", parts=True),
    methods=tuple(Method(name, LABELS[name], ORDERS[name]) for name in ADVECTIONS),
    settings=partial(_settings, (16, 32, 64, 96)),
    present=chosen_setting("advection", "cells"),
    trial=eddies_trial,
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
    settings=partial(_settings, (12, 16, 24, 32)),
    trial=rods_trial,
    reference="Kovasznay 1948: an exact steady flow, in at the left and out at the right.",
    expectation="At few cells linear interpolation is closest, by chance; only the error of the time-centred "
    "step falls with the square of the cells.",
    present=chosen_setting("advection", "cells"),
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
    settings=partial(_settings, (8, 16, 32)),
    trial=cavity_trial,
    reference="Two discretisations, extrapolated; Botella and Peyret 1998.",
    expectation="The time-centred step loses least of the eddy on the same cells.",
    present=chosen_setting("advection", "cells"),
    workload=Workload("a lid of 1 m/s over a square of 1 m at Re 100, from rest for 14 s"),
    related=(eddies_study, rods_study),
)
