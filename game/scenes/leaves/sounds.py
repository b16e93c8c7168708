"""What is heard of leaves: how they land, rub on what they lie on, and the wind about them."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats
from game.physics.kernels import elementwise
from game.physics.plates.law import VX, VY, X
from game.worlds.hearing import HEARD_WIDTH, is_due, rows_of

LANDING, RUBBING, WIND = range(3)
NAMES = {LANDING: "rustle", RUBBING: "rustle", WIND: "wind"}
HALF = 3.0  # m to either side, from the left to the right
SOFT = 0.125  # of the speed of a landing, as leaves weigh next to nothing
RUBS_EVERY, RUBS, RUB_LEAST, RUB_SOFT = 0.06, 3, 0.15, 0.06  # s between them; most; m/s; of the speed
WIND_EVERY, WIND_LEAST, WIND_SOFT = 0.2, 0.08, 0.16  # s between grains; m/s; of the speed of the wind
NOTHING: Floats = np.zeros((0, HEARD_WIDTH))


def landings(landed: NDArray[np.int64], before: Floats, rows: Floats, time: float) -> Floats:
    """Leaves that touch down, by their speed before: (k, HEARD_WIDTH). before, rows: (STATE, n)."""
    speeds = elementwise.hypot(before[VX, landed], before[VY, landed])
    return rows_of(time, LANDING, SOFT * speeds, rows[X, landed])


def rubbing(touched: NDArray[np.bool_], rows: Floats, time: float, dt: float) -> Floats:
    """The fastest of the leaves that move while they touch something, now and then: (k, HEARD_WIDTH)."""
    if not is_due(RUBS_EVERY, time, dt):
        return NOTHING
    speeds = np.where(touched, elementwise.hypot(rows[VX], rows[VY]), 0.0)
    loud = np.argsort(-speeds, kind="stable")[:RUBS]
    loud = loud[speeds[loud] > RUB_LEAST]
    return rows_of(time, RUBBING, RUB_SOFT * speeds[loud], rows[X, loud])


def blowing(air: Floats, time: float, dt: float) -> Floats:
    """A grain of the sound of the wind, now and then, by its mean speed at the leaves: (k, HEARD_WIDTH).

    air (WIND, n): its first two rows are the velocity.
    """
    if not air.shape[1] or not is_due(WIND_EVERY, time, dt):
        return NOTHING
    speed = float(np.mean(elementwise.hypot(air[0], air[1])))
    return rows_of(
        time, WIND, np.full(int(speed > WIND_LEAST), WIND_SOFT * speed), np.zeros(int(speed > WIND_LEAST))
    )
