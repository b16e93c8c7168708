"""What is to be heard of the tower: contacts that begin, stone on stone or floors on floors."""

from __future__ import annotations

import numpy as np

from game.physics.solids import SolidWorld
from game.scenes.tower.tables import Floats
from game.stage import Hearing
from game.worlds.hearing import HEARD_TIME, REMEMBERED_S, sounds_of

STONE, THUD = range(2)
NAMES = {STONE: "stone", THUD: "thud"}
LEAST = 1.2  # m/s of approach
HEAVY = 4_000.0  # N s: what strikes with more is a thud
MOST = 24  # sounds that are remembered: the latest
QUIETER = 0.35  # of the speed, as what falls is far away
HALF = 25.0  # m to either side, from the left to the right


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


def hearing_of(heard: Floats, time: float) -> Hearing:
    """Sounds (k, HEARD_WIDTH) of the last moments, at a time (s)."""
    return Hearing("tower", time, sounds_of(heard, NAMES, HALF))
