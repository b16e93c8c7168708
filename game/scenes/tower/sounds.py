"""What is to be heard of the tower: charges, what begins to touch, and the air that is driven out."""

from __future__ import annotations

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementwise
from game.physics.solids import SolidWorld
from game.scenes.tower.tables import none_of
from game.stage import Hearing
from game.worlds.hearing import HEARD_TIME, HEARD_WIDTH, REMEMBERED_S, sounds_of

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
    found = np.zeros((len(places), HEARD_WIDTH))
    found[:] = began, CHARGE, CHARGED, 0.0
    found[:, 3] = places
    return found


def impacts(world: SolidWorld, began: float) -> Floats:
    """Contacts (k, HEARD_WIDTH) that began in a step: by speed and impulse, the heavy ones thuds."""
    _, places = world.contacts_begun()
    rows = places[places[:, 3] > LEAST] if len(places) else np.zeros((0, 5))
    if not len(rows):
        return none_of(HEARD_WIDTH)
    kinds = np.where(rows[:, 2] > HEAVY, THUD, STONE)
    weight = np.clip(elementwise.power(rows[:, 2] / HEAVY, 1.0 / 3.0), 0.3, 2.0)
    return np.stack([began + rows[:, 4], kinds, QUIETER * rows[:, 3] * weight, rows[:, 0]], axis=1)


def air_heard(fastest: float, time: float, dt: float) -> Floats:
    """A grain (k, HEARD_WIDTH), now and then, of air that is so fast (m/s)."""
    if fastest < AIR_LEAST or int(time / AIR_EVERY) == int((time - dt) / AIR_EVERY):
        return none_of(HEARD_WIDTH)
    return np.array([[time, AIR, AIR_SOFTER * fastest, 0.0]])


def remembered(heard: Floats, added: list[Floats], began: float) -> Floats:
    """Sounds (k, HEARD_WIDTH) of the last moments, those of a step that began at ``began`` (s) among them."""
    if len(heard):
        heard = heard[heard[:, HEARD_TIME] > began - REMEMBERED_S]
    rows = np.concatenate(added)
    if not len(rows):
        return heard
    rows = rows[np.lexsort((rows[:, 3], rows[:, 0]))]
    charged = rows[:, 1] == CHARGE  # none of them is lost among the stones
    return np.concatenate([heard, rows[~charged], rows[charged]])[-MOST:]


def hearing_of(heard: Floats, time: float) -> Hearing:
    """Sounds (k, HEARD_WIDTH) of the last moments, at a time (s)."""
    return Hearing("tower", time, sounds_of(heard, NAMES, HALF))
