"""What is measured of balls on tracks."""

from __future__ import annotations

import numpy as np

from game.physics.kernels import elementary
from game.physics.solids.tracks.motion import FREE, PIECE, VX, VY
from game.scenes.tracks.model import TracksModel
from game.stage import Readout

ROUNDING = 1e-8  # of the energies: less is lost to figures alone
UNITS = {"arrives": "s", "leaves": "°", "period": "s", "speed": "m/s", "high": "m", "past": "", "rode": ""}


def readouts(model: TracksModel) -> list[Readout]:
    """The level's gauges first; speeds are those of the first ball."""
    rows = [
        Readout(gauge.name, int(value) if gauge.measure in ("past", "rode") else value, UNITS[gauge.measure])
        for gauge, value in zip(model.content.gauges, model.gauges[:, 0].tolist(), strict=True)
    ]
    balls = model.world.balls
    there = len(balls.rows) > 0
    way, turn, height = model.world.energies().sum(axis=0).tolist() if there else (0.0, 0.0, 0.0)
    total = way + turn + height
    lost = model.lost()
    lost = lost if abs(lost) > ROUNDING * (way + turn + abs(height)) else 0.0
    speed = elementary.hypot(balls.rows[0, VX], balls.rows[0, VY]) if there else 0.0
    return [
        *rows,
        Readout("speed", speed, "m/s"),
        Readout("exact", model.exact_speed(0) if there else 0.0, "m/s"),
        Readout("sum", total, "J"),
        Readout("moving", way, "J"),
        Readout("turning", turn, "J"),
        Readout("height", height, "J"),
        Readout("lost", lost, "J"),
        Readout("balls", len(balls.rows)),
        Readout("on a track", int(np.count_nonzero(balls.pieces[:, PIECE] != FREE))),
        Readout("a step", model.watch.median("step"), "s"),
    ]
