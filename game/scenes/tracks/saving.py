"""Tracks and balls as they stand, as the content of a level file."""

from __future__ import annotations

from typing import Any

import numpy as np

from game.physics.solids.tracks.motion import (
    BOUNCE,
    FREE,
    FRICTION,
    MASS,
    PIECE,
    RADIUS,
    SHARE,
    SPIN,
    VX,
    VY,
    X,
    Y,
)
from game.scenes.tracks.level import BallEntry, TrackContent
from game.scenes.tracks.model import COLOURS, OWN_FRICTION, OWN_RESTITUTION, TracksModel
from game.worlds.entries.tracks import TrackEntry


def content_of(model: TracksModel) -> TrackContent:
    """Tracks point by point, ball by ball; gauges are left out: they count from the beginning."""
    tracks = tuple(
        TrackEntry(
            points=tuple((float(x), float(y)) for x, y in np.asarray(curve.points)),
            closed=curve.closed,
            corner=curve.corner,
        )
        for curve in model.world.curves
    )
    balls = tuple(_ball(model, k) for k in range(len(model.energies)))
    return TrackContent(tracks=tracks, balls=balls, view=model.content.view)


def _ball(model: TracksModel, ball: int) -> BallEntry:
    row, tint = model.world.balls.rows[ball].tolist(), int(model.tints[ball])
    colour: Any = COLOURS[tint & 255]
    return BallEntry(
        position=(row[X], row[Y]),
        radius=row[RADIUS],
        velocity=(row[VX], row[VY]),
        spin=row[SPIN],
        share=row[SHARE],
        mass=row[MASS],
        friction=row[FRICTION] if tint & OWN_FRICTION else None,
        restitution=row[BOUNCE] if tint & OWN_RESTITUTION else None,
        colour=colour,
        seated=bool(model.world.balls.pieces[ball, PIECE] != FREE),
    )
