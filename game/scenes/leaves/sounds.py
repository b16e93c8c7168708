"""What is heard of leaves: how they land, rub on what they lie on, and the wind about them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.kernels import elementwise
from game.physics.plates.law import VX, VY, X
from game.worlds.hearing import HEARD_TIME, HEARD_WIDTH, REMEMBERED_S

LANDING, RUBBING, WIND = range(3)
NAMES = {LANDING: "rustle", RUBBING: "rustle", WIND: "wind"}
HALF = 3.0  # m to either side, from the left to the right
SOFT = 0.125  # of the speed of a landing, as leaves weigh next to nothing
RUBS_EVERY, RUBS, RUB_LEAST, RUB_SOFT = 0.06, 3, 0.15, 0.06  # s between them; most; m/s; of the speed
WIND_EVERY, WIND_LEAST, WIND_SOFT = 0.2, 0.08, 0.16  # s between grains; m/s; of the speed of the wind
MOST = 24  # sounds that are remembered: the latest


def landings(landed: NDArray[np.int64], before: Floats, rows: Floats, time: float) -> Floats:
    """Leaves that touch down, by their speed before: (k, HEARD_WIDTH). before, rows: (STATE, n)."""
    speeds = elementwise.hypot(before[VX, landed], before[VY, landed])
    return _sounds(time, LANDING, SOFT * speeds, rows[X, landed])


def rubbing(touched: NDArray[np.bool_], rows: Floats, time: float, dt: float) -> Floats:
    """The fastest of the leaves that move while they touch something, now and then: (k, HEARD_WIDTH)."""
    if not _is_due(RUBS_EVERY, time, dt):
        return np.zeros((0, HEARD_WIDTH))
    speeds = np.where(touched, elementwise.hypot(rows[VX], rows[VY]), 0.0)
    loud = np.argsort(-speeds, kind="stable")[:RUBS]
    loud = loud[speeds[loud] > RUB_LEAST]
    return _sounds(time, RUBBING, RUB_SOFT * speeds[loud], rows[X, loud])


def blowing(air: Floats, time: float, dt: float) -> Floats:
    """A grain of the sound of the wind, now and then, by its mean speed at the leaves: (k, HEARD_WIDTH).

    air (WIND, n): its first two rows are the velocity.
    """
    if not air.shape[1] or not _is_due(WIND_EVERY, time, dt):
        return np.zeros((0, HEARD_WIDTH))
    speed = float(np.mean(elementwise.hypot(air[0], air[1])))
    return _sounds(time, WIND, np.full(int(speed > WIND_LEAST), WIND_SOFT * speed), np.zeros(1))


def remembered(heard: Floats, added: list[Floats], time: float) -> Floats:
    """Sounds (k, HEARD_WIDTH) of the last moments before ``time`` (s), and new ones."""
    heard = heard[heard[:, HEARD_TIME] > time - REMEMBERED_S]
    return np.concatenate([heard, *added])[-MOST:]


def _is_due(every: float, time: float, dt: float) -> bool:
    return int(time / every) != int((time - dt) / every)


def _sounds(time: float, kind: int, speeds: Floats, places: Floats) -> Floats:
    found = np.zeros((len(speeds), HEARD_WIDTH))
    found[:, 0], found[:, 1], found[:, 2], found[:, 3] = time, kind, speeds, places[: len(speeds)]
    return found
