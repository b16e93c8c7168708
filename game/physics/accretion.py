"""How floors that hang in a row come down when the upper ones fall on them: momentum, floor by floor.

Each floor is at rest until it is struck, and goes on with what struck it (plastically). With nothing that
resists and no mass at the start, the front of an even row falls with a third of gravity (Cayley 1857, "On a
class of dynamical problems"). A mass at the start makes it faster at first.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

STANDARD_GRAVITY = 9.81  # m/s²
LIMIT = 1.0 / 3.0  # of gravity: an even row without a mass at the start


def strike_times(
    moving: float, floors: Sequence[float], drop: float, gravity: float = STANDARD_GRAVITY,
    speed: float = 0.0, fallen: float = 0.0,
) -> list[float]:  # fmt: skip
    """s until each floor is struck.

    moving: kg that fall at first. floors: kg of each, from the first that is struck. drop: m that the front
    falls to the first, and from each to the next. speed, fallen: m/s and m of the front at the beginning.
    ValueError for nonsense.
    """
    if not (moving > 0.0 and drop > 0.0 and gravity > 0.0 and all(mass >= 0.0 for mass in floors)):
        raise ValueError("moving, drop, gravity: expected more than 0; floors: not less")
    if not (speed >= 0.0 and 0.0 <= fallen < drop):
        raise ValueError("speed: expected 0 or more; fallen: expected 0 or more, and less than drop")
    time, mass, found = 0.0, moving, []
    for k, floor in enumerate(floors):
        after = math.sqrt(speed * speed + 2.0 * gravity * (drop - (fallen if k == 0 else 0.0)))
        time += (after - speed) / gravity
        found.append(time)
        speed, mass = after * mass / (mass + floor), mass + floor
    return found
