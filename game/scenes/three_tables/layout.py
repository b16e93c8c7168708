"""Where the balls are on the three tables before a shot: as the level says, racked, or put back."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.billiards.table.rack import BALL_MASS, BALL_RADIUS, HEAD_SPOT, eight_ball_rack
from game.billiards.table.table import Table
from game.physics.kernels import elementary
from game.scenes.shared.tables.demo_shots import free_head_spot
from game.scenes.shared.tables.level import BallEntry


class LaidOut(NamedTuple):
    """All balls, the cue ball first."""

    numbers: NDArray[np.int64]  # (n,)
    places: Floats  # (n, 2) m
    radii: Floats  # (n,) m
    masses: Floats  # (n,) kg


def laid_out(balls: Sequence[BallEntry], bed: Table) -> LaidOut:
    """The balls of a level, or a full rack if it lists none. ValueError if the cue ball is missing."""
    rows = sorted(balls, key=lambda row: row.number != 0)
    if not rows:
        return LaidOut(np.arange(16), eight_ball_rack(bed), np.full(16, BALL_RADIUS), np.full(16, BALL_MASS))
    if rows[0].number != 0:
        raise ValueError("balls: expected the cue ball (number 0)")
    return LaidOut(
        np.array([row.number for row in rows]),
        np.array([row.position for row in rows], dtype=np.float64),
        np.array([row.radius for row in rows]),
        np.array([row.mass for row in rows]),
    )


def free_spot(bed: Table, others: Floats, largest: float) -> Floats:
    """Where (2,) m the cue ball comes back to; the head spot itself if all is full.

    others (k, 2) m: the balls in play; largest: radius of any, m.
    """
    reach = 2.1 * largest

    def is_free(place: Floats) -> bool:
        return not len(others) or bool(np.sqrt((elementary.square(others - place)).sum(axis=1)).min() > reach)

    spot = free_head_spot(bed, BALL_RADIUS, is_free)
    return np.array([0.5 * bed.width, HEAD_SPOT * bed.length]) if spot is None else spot
