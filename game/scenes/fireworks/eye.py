"""The eye that sees the show: it stands off the middle of the fleet, and goes round it by a bearing.

x to the right along the fleet, y up, z away from the audience, m. The picture is a plane through the middle,
square to the line of sight. What lies in it has its true size; the nearer is larger, the farther smaller.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.compiler.decorator import inner_kernel
from game.physics.kernels import elementary, elementwise

EYE = 6.0  # m above the lake
AWAY = 420.0  # m from the middle of the fleet
NEAREST = 20.0  # m before the eye, within which nothing is seen


class Seen(NamedTuple):
    """middle: where the eye aims, m beside the middle of the fleet. time: the moment that is shown, s; back:
    how long before now it is, s. cosine and sine of the bearing.
    """

    middle: float
    time: float
    back: float
    cosine: float = 1.0
    sine: float = 0.0


def seen_from(middle: float, time: float, back: float, bearing_deg: float) -> Seen:
    """What the eye sees from a bearing (degrees; to the right above 0)."""
    turn = math.radians(bearing_deg)
    return Seen(middle, time, back, elementary.cos(turn), elementary.sin(turn))


@inner_kernel
def turned(seen, x, z):
    """Across the line of sight and along it, m from the middle of the fleet."""
    return x * seen.cosine + z * seen.sine, z * seen.cosine - x * seen.sine


@inner_kernel
def nearness(along):
    """How much larger than in the middle a thing is seen that lies so far (m) behind it."""
    return AWAY / max(AWAY + along, NEAREST)


def projected(seen: Seen, x: float, y: float, z: float) -> tuple[float, float, float]:
    """Where a place (m) is seen, m in the plane through the middle, and how much larger than there."""
    across, along = x * seen.cosine + z * seen.sine, z * seen.cosine - x * seen.sine
    near = AWAY / max(AWAY + along, NEAREST)
    return seen.middle + near * (across - seen.middle), EYE + near * (y - EYE), near


def on_circle(seen: Seen, radius: float, azimuths: Floats) -> tuple[Floats, Floats, Floats]:
    """Where points of a circle about the middle are seen: across (n,) m, nearness (n,), along (n,) m.

    radius: m; azimuths: (n,) radians from the direction away from the audience, to the right.
    """
    own = azimuths + elementary.atan2(seen.sine, seen.cosine)
    along = radius * elementwise.cos(own)
    near = AWAY / np.maximum(AWAY + along, NEAREST)
    return seen.middle + near * (radius * elementwise.sin(own) - seen.middle), near, along


def at_infinity(seen: Seen, azimuth: Floats, height: Floats) -> tuple[Floats, Floats, Floats]:
    """Where what is very far off is seen, m, and whether it is before the eye. Both angles in radians."""
    own = azimuth + elementary.atan2(seen.sine, seen.cosine)
    ahead = elementwise.cos(own)
    far = AWAY / np.maximum(ahead, 0.05)
    return seen.middle + far * elementwise.sin(own), EYE + far * elementwise.tan(height), ahead > 0.2
