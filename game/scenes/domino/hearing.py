"""What is heard of dominoes: contacts that begin, as loud as they strike."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.physics.solids import SolidWorld
from game.physics.solids.state import DISC, SEGMENT
from game.worlds.hearing import HEARD_TIME, REMEMBERED_S

Floats = NDArray[np.float64]
WOOD, BALL, THUD = range(3)
LEAST = 0.25  # m/s of approach; what leans and slides is silent
MOST = 24  # sounds that are remembered: the latest
REFERENCE = 0.08  # kg: half a domino; what strikes with more sounds faster than it is


def heard_now(world: SolidWorld, heard: Floats, began: float, balls: list[int]) -> Floats:
    """Sounds (k, HEARD_WIDTH) of the last moments, those of a step that began at ``began`` (s) among them."""
    shapes, places = world.contacts_begun()
    if len(heard):
        heard = heard[heard[:, HEARD_TIME] > began - REMEMBERED_S]
    loud = np.flatnonzero(places[:, 3] > LEAST) if len(places) else np.zeros(0, dtype=np.int64)
    if not len(loud):
        return heard
    pairs, rows = world.shapes.bodies[shapes[loud]], places[loud]
    kinds = world.shapes.kinds[shapes[loud]]
    of_balls = np.isin(pairs, balls) if balls else np.zeros(pairs.shape, dtype=bool)
    found = np.where((kinds == SEGMENT).any(axis=1), THUD, WOOD)
    found = np.where((of_balls & (kinds == DISC)).all(axis=1), BALL, found)
    # by impulse: a heavy one sounds as a light one that is faster
    speeds = rows[:, 3] * np.clip(rows[:, 2] / (REFERENCE * rows[:, 3]), 0.3, 2.0)
    added = np.stack([began + rows[:, 4], found.astype(np.float64), speeds, rows[:, 0]], axis=1)
    return np.concatenate([heard, added[np.lexsort((added[:, 3], added[:, 0]))]])[-MOST:]
