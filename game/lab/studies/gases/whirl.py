"""What accuracy costs for a gas: a steady whirl in a box, by both papers' ways and by those that came
after.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.lab.trials import Computation, chosen_setting, computation
from game.physics.gas import Gas, GasSettings
from game.physics.grid import Borders, Grid
from game.physics.kernels import elementary, elementwise
from game.physics.stable_fluids import PAPERS, PrintedFluid

METHODS = ("stam-2003", "stam-1999", "linear", "maccormack", "time-centred")
WIDE, TALL, FASTEST, SECONDS, COURANT = 2.0, 1.0, 1.0, 0.5, 1.0
CELLS = (16, 32, 64, 128)


class Whirl(NamedTuple):
    """What is left of a steady whirl: root mean square of its error m/s, share of its energy, and of its
    divergence 1/s, after so many steps.
    """

    error: float
    energy: float
    divergence: float
    steps: int


def flow(x: Floats, y: Floats) -> tuple[Floats, Floats]:
    """Two whirls in a box of 2 m by 1 m: they turn for ever without friction."""
    across, upright = 2.0 * math.pi * x / WIDE, math.pi * y / TALL
    return FASTEST * elementwise.sin(across) * elementwise.cos(upright), -FASTEST * elementwise.cos(
        across
    ) * elementwise.sin(upright)


def whirl_after(method: str, cells: int, seconds: float) -> Whirl:
    """Follow the whirl for some time on so many cells across, at a Courant number of 1."""
    grid = Grid(cells, cells // 2, WIDE / cells)
    steps = math.ceil(seconds * FASTEST / (COURANT * grid.cell))
    exact = np.stack(flow(*grid.centres()), axis=2)
    if method in PAPERS:
        fluid = PrintedFluid(grid.shape, grid.cell, 0, method)
        fluid.inner[0][:], fluid.inner[1][:] = exact[..., 0], exact[..., 1]
        first = float(np.sum(exact * exact))
        for _ in range(steps):
            fluid.step(seconds / steps)
        found, left = np.stack(fluid.inner[:2], axis=2), fluid.face_divergence()
    else:
        gas = Gas(grid, Borders(), GasSettings(advection=method, turns=4, tolerance=1e-8), ("smoke",))
        gas.u[:], gas.v[:] = flow(*grid.u_places())[0], flow(*grid.v_places())[1]
        gas.jolt()
        first = float(np.sum(elementary.square(gas.velocity())))
        for _ in range(steps):
            gas.step(seconds / steps)
        found, left = gas.velocity(), gas.divergence()
    off = found - exact
    return Whirl(
        float(np.sqrt(np.mean(off * off))), float(np.sum(found * found)) / first,
        float(np.sqrt(np.mean(left * left))), steps,
    )  # fmt: skip


def gas_trial(
    seconds: float, begin: Callable[[], Gas], dt: float, steps: int, judge: Callable[[Gas], Outcome]
) -> Trial:
    """A gas that is followed for so many steps of dt (s)."""

    def work(gas: Gas) -> Gas:
        for _ in range(steps):
            gas.step(dt)
        return gas

    return Computation(seconds, begin, work, judge)


def whirl_trial(setting: Setting) -> Trial:
    """The whirl on so many cells: how far the velocity is off."""
    return computation(
        SECONDS,
        lambda: whirl_after(setting.method, int(setting.knob), SECONDS),
        lambda found: Outcome(found.error, found.steps),
    )


@lru_cache(maxsize=1)
def _settings() -> list[Setting]:
    return [
        Setting(method, float(cells), {}, {"method": method, "cells": cells}, float(cells))
        for method in METHODS
        for cells in CELLS
        if not (method == "stam-1999" and cells > 64)  # solved to the end by sweeps: minutes
    ]


whirl_study = Study(
    name="whirl",
    title="A steady whirl",
    error="velocity after half a second",
    error_unit="m/s",
    counter="steps",
    knob=Knob("cells", "cells across", parts=True),
    methods=(
        Method("stam-2003", "Stam 2003 as printed", None, "twenty sweeps leave the more, the more cells"),
        Method("stam-1999", "Stam 1999 as printed", 1.0),
        Method("linear", "linear, multigrid", 1.0),
        Method("maccormack", "MacCormack, multigrid", 1.0),
        Method("time-centred", "time-centred, multigrid", 2.0),
    ),
    settings=_settings,
    trial=whirl_trial,
    reference="The whirl itself: it is steady.",
    expectation="What is carried along by interpolation alone is smeared in proportion to the cells; with a "
    "stored pressure the error falls with their square. Twenty sweeps are too few for many cells.",
    present=chosen_setting("method", "cells", METHODS),
    workload=Workload("two whirls in a box of 2 m by 1 m, Courant number 1"),
)
