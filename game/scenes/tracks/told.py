"""What a story says of balls on tracks: readouts, and the level as it is now."""

from __future__ import annotations

from typing import Any

import numpy as np

from game.physics.kernels import elementary
from game.physics.solids.tracks import motion as m
from game.scenes.tracks.level import BallEntry, TrackContent
from game.scenes.tracks.world import COLOURS, OWN_FRICTION, OWN_RESTITUTION, TracksWorld
from game.stage import Readout

ROUNDING = 1e-8  # of the energies: less is lost to figures alone
UNITS = {"arrives": "s", "leaves": "°", "period": "s", "speed": "m/s", "high": "m", "past": "", "rode": ""}


def readouts(model: TracksWorld) -> list[Readout]:
    """The level's gauges first; speeds are those of the first ball."""
    found = [
        Readout(gauge.name, int(value) if gauge.measure in ("past", "rode") else value, UNITS[gauge.measure])
        for gauge, value in zip(model.content.gauges, model.balls.gauges[:, 0].tolist(), strict=True)
    ]
    rows, there = model.rows, len(model.rows) > 0
    energies = model.tracks.riders.energies()
    way, turn, height = energies.sum(axis=0).tolist() if there else (0.0, 0.0, 0.0)
    total = way + turn + height
    lost = model.lost()
    lost = lost if abs(lost) > ROUNDING * (way + turn + abs(height)) else 0.0
    return [
        *found,
        Readout("speed", elementary.hypot(rows[0, m.VX], rows[0, m.VY]) if there else 0.0, "m/s"),
        Readout("exact", model.exact_speed(0) if there else 0.0, "m/s"),
        Readout("sum", total, "J"),
        Readout("moving", way, "J"),
        Readout("turning", turn, "J"),
        Readout("height", height, "J"),
        Readout("lost", lost, "J"),
        Readout("balls", len(rows)),
        Readout("on a track", int(np.count_nonzero(model.tracks.rolling()))),
        Readout("a step", model.tracks.watch.median("step"), "s"),
    ]


def saved(model: TracksWorld) -> TrackContent:
    """Tracks point by point, ball by ball; gauges are left out: they count from the beginning."""
    balls = tuple(_ball(model, k) for k in range(len(model.rows)))
    return TrackContent(tracks=model.tracks.entries(), balls=balls, view=model.content.view)


def _ball(model: TracksWorld, ball: int) -> BallEntry:
    row, tint = model.rows[ball].tolist(), int(model.balls.tints[ball])
    colour: Any = COLOURS[tint & 255]
    return BallEntry(
        position=(row[m.X], row[m.Y]), radius=row[m.RADIUS], velocity=(row[m.VX], row[m.VY]),
        spin=row[m.SPIN], share=row[m.SHARE], mass=row[m.MASS],
        friction=row[m.FRICTION] if tint & OWN_FRICTION else None,
        restitution=row[m.BOUNCE] if tint & OWN_RESTITUTION else None,
        colour=colour, seated=bool(model.tracks.rolling()[ball]),
    )  # fmt: skip
