"""What is measured in the marble run, beside what theory says."""

from __future__ import annotations

import math

import numpy as np

from game.physics.kernels import elementwise
from game.physics.solids.tracks.motion import VX, VY, X, Y
from game.scenes.metal.gauges import VALUE, exact_of, rolls_on
from game.scenes.metal.model import MetalModel
from game.scenes.metal.tables import BODY, FREED, NOT_YET, RIDES
from game.stage import Readout

UNITS = {
    "speeds up": "m/s²", "arrives": "s", "drop": "m", "leaves": "°", "rode": "", "rises": "m", "speed": "m/s",
    "inside": "", "fallen": "", "kept": "%",
}  # fmt: skip
COUNTED = ("rode", "inside", "fallen")
COMPARED = ("speeds up", "arrives")  # with a formula, so that there is an error
WITH_EXACT = (*COMPARED, "drop", "leaves")


def readouts(model: MetalModel) -> list[Readout]:
    """The level's gauges first, each with what is exact; then the balls."""
    found, worst = [], math.nan
    rows, table, tracks = model.riders.balls.rows, model.table, model.content.tracks
    for gauge, ball, noted in zip(model.content.gauges, model.measured, model.gauges, strict=True):
        value = float(noted[VALUE])
        if gauge.measure in COUNTED and value != NOT_YET:
            value = int(value)
        found.append(Readout(gauge.name, math.nan if value == NOT_YET else value, UNITS[gauge.measure]))
        if gauge.measure not in WITH_EXACT:
            continue
        track = tracks[gauge.track] if gauge.track < len(tracks) else None
        exact = exact_of(gauge, noted, track, table[ball], rows[ball], model.gravity())
        if gauge.measure == "arrives" and math.isnan(exact):
            continue
        found.append(Readout(f"{gauge.name} exact", exact, UNITS[gauge.measure]))
        if gauge.measure == "drop":
            found.append(Readout(f"{gauge.name} margin", 100.0 * (value / exact - 1.0), "%"))
        if gauge.measure in COMPARED and value != NOT_YET and exact > 0.0:
            error = 100.0 * abs(value / exact - 1.0)
            worst = error if math.isnan(worst) else max(worst, error)
    if any(gauge.measure in COMPARED for gauge in model.content.gauges):
        found.append(Readout("worst error", worst, "%"))
    return [*found, *_of_balls(model), Readout("a step", model.watch.median("step"), "s")]


def _of_balls(model: MetalModel) -> list[Readout]:
    rows, table, there = model.riders.balls.rows, model.table, model.there()
    speeds = elementwise.hypot(rows[there, VX], rows[there, VY])
    moving = there & (table[:, FREED] != NOT_YET)
    return [
        Readout("balls", int(there.sum())),
        Readout("riding", int(np.count_nonzero(rolls_on(model.riders.balls.pieces) & moving))),
        Readout("loose", int(np.count_nonzero(table[:, BODY] != RIDES))),
        Readout("gates open", int(np.count_nonzero(model.gates != NOT_YET))),
        Readout("fastest", float(speeds.max(initial=0.0)), "m/s"),
        Readout("awake", model.awake()),
        Readout("lowest", float(rows[there, Y].min(initial=0.0)), "m"),
        Readout("farthest", float(np.abs(rows[there, X]).max(initial=0.0)), "m"),
    ]
