"""Tracks as lines to be drawn."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.physics.solids.tracks.curves import CX, CY, KIND, TRACK, VERTEX, Curve, Pieces

Floats = NDArray[np.float64]
PARTS = 4  # chords that a piece is drawn by


def lines_of(pieces: Pieces, curves: list[Curve], parts: int = PARTS) -> list[Floats]:
    """Each track as points (n, 2) m along its smooth curve."""
    found = []
    t = np.linspace(0.0, 1.0, parts, endpoint=False)[:, None]
    for number, curve in enumerate(curves):
        own = pieces.rows[(pieces.rows[:, TRACK] == number) & (pieces.rows[:, KIND] != VERTEX)]
        own = own[: len(own) // 2]  # the left side; the right one is the same curve
        axes = [own[:, c] + t * (own[:, c + 1] + t * (own[:, c + 2] + t * own[:, c + 3])) for c in (CX, CY)]
        line = np.stack([axis.T.ravel() for axis in axes], axis=1)
        end = [[own[-1, c : c + 4].sum() for c in (CX, CY)]]
        found.append(np.concatenate([line, line[:1] if curve.closed else end]))
    return found
