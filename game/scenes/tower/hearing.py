"""What is heard of the tower: contacts that begin, as loud as they strike."""

from __future__ import annotations

import numpy as np

from game.physics.solids import SolidWorld
from game.scenes.shared.heard import HEARD_TIME
from game.scenes.shared.tables.sounds import REMEMBERED_S
from game.scenes.tower.tables import (
    Floats,
)

STONE, THUD = range(2)
LEAST = 1.2  # m/s of approach
HEAVY = 4_000.0  # N s: what strikes with more is a thud
MOST = 24  # sounds that are remembered: the latest
QUIETER = 0.35  # of the speed, as what falls is far away


def heard_now(world: SolidWorld, heard: Floats, began: float) -> Floats:
    """Sounds (k, HEARD_WIDTH) of the last moments, those of a step that began at ``began`` (s) among them."""
    _, places = world.contacts_begun()
    if len(heard):
        heard = heard[heard[:, HEARD_TIME] > began - REMEMBERED_S]
    loud = np.flatnonzero(places[:, 3] > LEAST) if len(places) else np.zeros(0, dtype=np.int64)
    if not len(loud):
        return heard
    rows = places[loud]
    kinds = np.where(rows[:, 2] > HEAVY, THUD, STONE)
    added = np.stack([began + rows[:, 4], kinds, QUIETER * rows[:, 3], rows[:, 0]], axis=1)
    return np.concatenate([heard, added[np.lexsort((added[:, 3], added[:, 0]))]])[-MOST:]
