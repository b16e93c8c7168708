"""What is measured of smoke."""

from __future__ import annotations

import math

import numpy as np

from game.scenes.smoke import model as m
from game.scenes.smoke.books import heat_readouts, momentum_readouts
from game.scenes.smoke.model import SmokeModel
from game.scenes.smoke.parameters import DYES
from game.stage import Readout


def readouts_of(model: SmokeModel) -> list[Readout]:
    """What the method leaves of divergence and sharpness, what it costs, then heat and fire."""
    cells, flow = model.scalars, model.velocity()
    left = model.divergence()
    fastest = float(np.sqrt(np.max(flow[..., 0] * flow[..., 0] + flow[..., 1] * flow[..., 1])))
    smoke = model.total(m.SMOKE)
    books = model.flames.books_now()
    at_first = model.smoke_at_first
    return [
        Readout("divergence", math.sqrt(float(np.mean(left * left))), "1/s"),
        Readout("smear", 100.0 * model.smear(), "%"),
        Readout(
            "energy kept",
            100.0 * model.energy() / model.energy_at_first if model.energy_at_first else math.nan,
            "%",
        ),
        Readout("smoke", smoke, "m²"),
        Readout("smoke kept", 100.0 * smoke / at_first if at_first > 0.0 else math.nan, "%"),
        *(Readout(f"{dye} dye", model.dye(dye), "m²") for dye in DYES),
        Readout("fastest", fastest, "m/s"),
        Readout("cells a step", fastest * model.parameters.step_length / model.cell),
        Readout("hottest", float(np.max(cells[..., m.WARM])), "K"),
        Readout("coldest", float(np.min(cells[..., m.WARM])), "K"),
        Readout("power", model.flames.power, "W/m"),
        Readout("fuel left", 1e3 * model.total(m.FUEL), "g/m"),
        Readout("fuel burnt", 1e3 * books.burnt, "g/m"),
        Readout("oxygen left", 1e3 * model.total(m.OXYGEN), "g/m"),
        Readout("oxygen used", 1e3 * books.used, "g/m"),
        Readout("pressure ratio", model.flames.pressure_ratio(np.ascontiguousarray(cells))),
        Readout("a step", model.watch.median("step"), "s"),
        *momentum_readouts(model),
        *heat_readouts(model),
    ]
