"""The marble run as it stands, as the content of a level file."""

from __future__ import annotations

import msgspec
import numpy as np

from game.physics.solids.tracks.motion import RADIUS, VX, VY, X, Y
from game.scenes.metal.level import BallEntry, MetalContent
from game.scenes.metal.model import MetalModel
from game.scenes.metal.tables import DELAY, FREED, GATE, GRIP, NONE, NOT_YET, ROD
from game.worlds.entries.tracks import TrackEntry


def content_of(model: MetalModel) -> MetalContent:
    """The level; where a hand has changed it, tracks point by point and balls where they are.

    Balls that hang stay in their cradles, which begin anew, as towers do; gauges of balls that are gone, and
    those of formulas that have been bent, are left out.
    """
    if not model.changed:
        return model.content
    content = model.content
    tracks = tuple(
        TrackEntry(
            points=tuple((float(x), float(y)) for x, y in np.asarray(curve.points)),
            closed=curve.closed,
            corner=curve.corner,
        )
        for curve in model.riders.curves
    )
    balls, names = [], model.names()
    for ball in np.flatnonzero(model.there()).tolist():
        row, own = model.riders.balls.rows[ball], model.table[ball]
        held = own[FREED] == NOT_YET
        if own[ROD] >= 0.0:
            continue
        balls.append(
            BallEntry(
                at=(float(row[X]), float(row[Y])),
                radius=float(row[RADIUS]),
                gate=content.gates[int(own[GATE])] if held else "",
                delay=float(own[DELAY]) if held else 0.0,
                name=names[ball] if ball < len(names) else "",
                velocity=(float(row[VX]), float(row[VY])),
                friction=float(own[GRIP]) if own[GRIP] != NONE else None,
                seated=bool(model.riders.balls.pieces[ball, 0] >= 0),
            )
        )
    kept = {one.name for one in balls}
    gauges = tuple(
        one
        for one in content.gauges
        if (not one.of or one.of in kept) and one.measure not in ("drop", "leaves")
    )
    return msgspec.structs.replace(
        content, tracks=tracks, balls=tuple(balls), heaps=(), gauges=gauges, expected=()
    )
