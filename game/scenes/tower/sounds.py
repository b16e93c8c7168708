"""What is to be heard of the tower: contacts that begin, stone on stone or floors on floors."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.physics.solids import SolidWorld
from game.worlds.hearing import impacts

STONE, THUD = range(2)
NAMES = {STONE: "stone", THUD: "thud"}
LEAST = 1.2  # m/s of approach
HEAVY = 4_000.0  # N s: what strikes with more is a thud
QUIETER = 0.35  # of the speed, as what falls is far away
HALF = 25.0  # m to either side, from the left to the right


def sounds_now(world: SolidWorld, began: float) -> Floats:
    """Sounds (k, HEARD_WIDTH) of a step that began at ``began`` (s)."""
    found = impacts(world, LEAST)
    return found.heard(began, np.where(found.rows[:, 2] > HEAVY, THUD, STONE), QUIETER * found.rows[:, 3])
