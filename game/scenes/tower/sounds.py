"""What is to be heard of the tower: charges, what begins to touch, and the air that is driven out."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementwise
from game.physics.solids import SolidWorld
from game.worlds.hearing import impacts, is_due, rows_of

STONE, THUD, CHARGE, AIR = range(4)
NAMES = {STONE: "stone", THUD: "thud", CHARGE: "burst", AIR: "wind"}
LEAST = 0.35  # m/s of approach
HEAVY = 4_000.0  # N s: what strikes with more is a thud
MOST = 24  # sounds that are remembered: the latest
QUIETER = 0.35  # of the speed, as what falls is far away
CHARGED = 3.0  # m/s, as loud as an impact of that speed a charge is
AIR_EVERY, AIR_SOFTER, AIR_LEAST = 0.18, 0.12, 0.5  # s between grains of the air's sound; of its speed; m/s
HALF = 25.0  # m to either side, from the left to the right


def charges(places: Floats, began: float) -> Floats:
    """Charges (k, HEARD_WIDTH) at x (k,) m in a step that began at ``began`` (s)."""
    return rows_of(began, CHARGE, np.full(len(places), CHARGED), places)


def impacts_heard(world: SolidWorld, began: float) -> Floats:
    """Contacts (k, HEARD_WIDTH) that began in a step: by speed and impulse, the heavy ones thuds."""
    found = impacts(world, LEAST)
    impulses, fast = found.rows[:, 2], found.rows[:, 3]
    weight = np.clip(elementwise.power(impulses / HEAVY, 1.0 / 3.0), 0.3, 2.0)
    return found.heard(began, np.where(impulses > HEAVY, THUD, STONE), QUIETER * fast * weight)


def air_heard(fastest: float, time: float, dt: float) -> Floats:
    """A grain (k, HEARD_WIDTH), now and then, of air that is so fast (m/s)."""
    heard = fastest >= AIR_LEAST and is_due(AIR_EVERY, time, dt)
    return rows_of(time, AIR, np.full(int(heard), AIR_SOFTER * fastest), np.zeros(int(heard)))
