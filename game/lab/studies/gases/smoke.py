"""What a step of smoke costs: how much divergence each pressure solver leaves, how much each way of carrying
smears.
"""

from __future__ import annotations

import math
from dataclasses import replace
from functools import lru_cache

import numpy as np

from game.arrays import Floats
from game.lab.studies.gases.whirl import SECONDS, TALL, WIDE, flow, gas_trial, whirl_study
from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.lab.trials import chosen_setting, every_setting
from game.physics.gas import ADVECTIONS, Gas, GasSettings
from game.physics.grid import Grid
from game.physics.kernels import elementary
from game.physics.multigrid import SOLVERS

PER_STEP = "CPU time for one step"
ROOM, HOT = 293.15, 393.15  # K
PUFF, PUFF_RADIUS = (0.7, 0.3), 0.2  # m
PUFF_CELLS, PUFF_STEPS, DT = 128, 24, 1.0 / 60.0
TURNS = {
    "multigrid": (1, 2, 3, 5), "v-cycles": (1, 2, 4, 8), "conjugate-gradients": (4, 10, 25),
    "gauss-seidel": (5, 20, 80, 320), "jacobi": (5, 20, 80, 320),
}  # fmt: skip
SOLVER_LABELS = {
    "multigrid": "CG before V-cycles", "v-cycles": "V-cycles", "conjugate-gradients": "PCG, MIC(0)",
    "gauss-seidel": "Gauss-Seidel", "jacobi": "Jacobi",
}  # fmt: skip
SMEAR_LABELS = {
    "stam-1999": "Stam 1999, linear", "linear": "midpoint, linear", "cubic": "midpoint, cubic",
    "maccormack": "MacCormack, limited", "time-centred": "time-centred",
}  # fmt: skip
SMEAR_CELLS, FINE, TRACES = (32, 48, 64, 96, 128), 4, 24


def puff_trial(setting: Setting) -> Trial:
    """A disc of hot air begins to rise in a closed box: all turns are made, whatever is left.

    Divergence that is left, root mean square over all cells. A step takes the place of a second.
    """
    n, turns = PUFF_CELLS, int(setting.knob)

    def begin() -> Gas:
        settings = GasSettings(
            advection="maccormack", pressure=setting.method, turns=turns, tolerance=0.0, ambient=ROOM
        )
        gas = Gas(Grid(n, n // 2, WIDE / n), settings=settings, fields=("temperature",))
        x, y = gas.grid.centres()
        near = elementary.square(x - PUFF[0]) + elementary.square(y - PUFF[1]) < PUFF_RADIUS * PUFF_RADIUS
        gas.field("temperature")[near] = HOT
        return gas

    def judge(gas: Gas) -> Outcome:
        left = gas.divergence()
        return Outcome(float(np.sqrt(np.mean(left * left))), turns * PUFF_STEPS)

    return gas_trial(float(PUFF_STEPS), begin, DT, PUFF_STEPS, judge)


def smear_trial(setting: Setting) -> Trial:
    """Two steady whirls turn a layer of smoke into spirals, at a Courant number of 1.

    How much more the smoke is mixed than an exact one seen through the same cells, %.
    """
    n = int(setting.knob)
    steps = math.ceil(SECONDS * n / WIDE)

    def begin() -> Gas:
        grid = Grid(n, n // 2, WIDE / n)
        settings = GasSettings(advection=setting.method, turns=4, tolerance=1e-8, gravity=(0.0, 0.0))
        gas = Gas(grid, settings=settings, fields=("smoke",))
        gas.u[:], gas.v[:] = flow(*grid.u_places())[0], flow(*grid.v_places())[1]
        gas.jolt()
        gas.field("smoke")[:] = (grid.centres()[1] > 0.5 * TALL).astype(np.float64)
        return gas

    def judge(gas: Gas) -> Outcome:
        return Outcome(100.0 * abs(mixed(gas.field("smoke")) - exact_mixing(n)), steps)

    return gas_trial(float(steps), begin, SECONDS / steps, steps, judge)


def mixed(smoke: Floats) -> float:
    """0 to 1: by how much the cells that smoke lies in are not full of it."""
    there = np.clip(smoke, 0.0, 1.0)
    return float(np.sum(there * (1.0 - there)) / np.sum(there))


@lru_cache(maxsize=len(SMEAR_CELLS))
def exact_mixing(cells: int) -> float:
    """Of the exact layer after SECONDS: points are followed back along the steady flow (Runge-Kutta 4)."""
    fine = Grid(cells * FINE, cells * FINE // 2, WIDE / (cells * FINE))
    x, y = fine.centres()
    h = -SECONDS / TRACES
    for _ in range(TRACES):
        a = flow(x, y)
        b = flow(x + 0.5 * h * a[0], y + 0.5 * h * a[1])
        c = flow(x + 0.5 * h * b[0], y + 0.5 * h * b[1])
        d = flow(x + h * c[0], y + h * c[1])
        x = x + h / 6.0 * (a[0] + 2.0 * b[0] + 2.0 * c[0] + d[0])
        y = y + h / 6.0 * (a[1] + 2.0 * b[1] + 2.0 * c[1] + d[1])
    parts = (y > 0.5 * TALL).reshape(cells // 2, FINE, cells, FINE)
    return mixed(parts.mean(axis=(1, 3)))


def _divergence_settings() -> list[Setting]:
    return [
        Setting(
            solver, float(turns), {}, {"pressure": solver, "turns": turns, "cells": PUFF_CELLS}, float(turns)
        )
        for solver in SOLVERS
        for turns in TURNS[solver]
    ]


def _smear_settings() -> list[Setting]:
    return every_setting(ADVECTIONS, SMEAR_CELLS, lambda method, cells: {"method": method, "cells": cells})


divergence_study = Study(
    name="divergence-left",
    title="Divergence left in a step",
    short="Divergence",
    error="divergence after 24 steps, root mean square",
    error_unit="1/s",
    counter="turns",
    knob=Knob("turns", "turns of the solver", parts=True),
    methods=tuple(Method(name, SOLVER_LABELS[name]) for name in SOLVERS),
    settings=_divergence_settings,
    trial=puff_trial,
    reference="None is left by a flow that keeps its volume.",
    expectation="Sweeps go on for ever where a V-cycle or two are done: they cannot see what is far apart.",
    present=chosen_setting("pressure", "turns"),
    cost=PER_STEP,
    workload=Workload("a disc of hot air in a closed box of 128 by 64 cells, carried by MacCormack's way"),
)

smear_study = Study(
    name="smear",
    title="Smoke that is smeared",
    short="Smear",
    error="smoke mixed beyond an exact layer's",
    error_unit="%",
    counter="steps",
    knob=Knob("cells", "cells across", parts=True),
    methods=tuple(Method(name, SMEAR_LABELS[name]) for name in ADVECTIONS),
    settings=_smear_settings,
    trial=smear_trial,
    reference="The layer itself, followed back along the steady flow, seen through the same cells.",
    expectation="A sharp edge stays no sharper than a few cells: the order is below 1 for each of them, and "
    "what a method buys is fewer cells of smear.",
    present=chosen_setting("method", "cells", ADVECTIONS),
    cost=PER_STEP,
    workload=Workload("two whirls of 1 m/s turn a layer of smoke for half a second, Courant number 1"),
)

smoke_study = replace(whirl_study, short="Whirl", related=(divergence_study, smear_study))
