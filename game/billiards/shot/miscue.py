"""The miscue: a tip that strikes too far out slips, and the ball goes another way, slower.

The cue pushes along its axis as long as that lies in the cone of friction of tip and ball: sin(phi) = a, the
offset in ball radii, and tan(phi) <= mu. (Alciatore, technical proof 2.1; Cross 2008, American Journal of
Physics 76, 205.) With chalk mu is 0.6 to 0.7, and the limit about half a radius.

Beyond it the force lies on the edge of that cone, turned towards the middle of the ball. Then the ball moves
as one that is struck at the same point by a cue along that force. Its tip is just at the limit. The cue
speed of that stroke is the largest that makes no energy: J = 2 V (u d) / (d K d). Here u is the axis of the
cue, d the direction of the force. K is the inverse mass of ball, cue and the cue's end, which gives way.
What is left out: the work of friction, a second contact, and the hop of a ball that is scooped up.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from game.billiards.shot.cue import CUE_END_MASS, CUE_MASS
from game.billiards.table.rack import BALL_MASS
from game.physics.kernels import elementary


class TipStroke(NamedTuple):
    """A stroke of the cue: speed m/s, azimuth and elevation rad, offsets of the tip in ball radii."""

    cue_speed: float
    azimuth: float
    elevation: float
    tip_left: float
    tip_up: float


def slip_limit(friction: float) -> float:
    """Largest offset, ball radii, at which a tip of that coefficient of friction holds."""
    return friction / math.sqrt(1.0 + friction * friction)


def slips(tip_left: float, tip_up: float, friction: float) -> bool:
    """True if a tip slips that strikes so far out, in ball radii."""
    limit = slip_limit(friction)
    return tip_left * tip_left + tip_up * tip_up > limit * limit


def miscue(stroke: TipStroke, friction: float, ball_mass: float = BALL_MASS) -> TipStroke:
    """The stroke by which a ball moves as it does after this one: the same if the tip holds.

    friction: coefficient of tip and ball, above 0; ball_mass kg. ValueError if the tip misses the ball.
    """
    a, b = stroke.tip_left, stroke.tip_up
    off_2, limit = a * a + b * b, slip_limit(friction)
    if off_2 >= 1.0:
        raise ValueError("miscue tip_left, tip_up: the tip misses the ball")
    if off_2 <= limit * limit:
        return stroke
    off, deep = math.sqrt(off_2), math.sqrt(1.0 - off_2)
    inside = math.sqrt(1.0 - limit * limit)
    # the force is turned by phi - atan(mu) from the axis towards the middle of the ball
    cosine, sine = deep * inside + off * limit, off * inside - deep * limit
    low, high = elementary.sin(stroke.elevation), elementary.cos(stroke.elevation)
    along = cosine * high - sine * b / off * low  # of the force, level and to the left of the azimuth
    aside = -sine * a / off
    down = cosine * low + sine * b / off * high
    elevation = max(elementary.asin(min(down, 1.0)), 0.0)
    turned = elementary.atan2(aside, along)
    left, up = _offset(a, b, deep, stroke.elevation, turned, elevation)
    shrink = limit / math.sqrt(left * left + up * up)
    ratio, spun = ball_mass / CUE_MASS, 2.5 * limit * limit
    held = 1.0 + ratio + spun
    slipped = 1.0 + ratio * cosine * cosine + spun + ball_mass / CUE_END_MASS * sine * sine
    speed = stroke.cue_speed * cosine * held / slipped
    return TipStroke(speed, stroke.azimuth + turned, elevation, left * shrink, up * shrink)


def _offset(
    a: float, b: float, deep: float, raised: float, turned: float, elevation: float
) -> tuple[float, float]:
    """Where the tip touches (left, up), ball radii, seen along a cue that is turned and raised otherwise.

    a, b: the same seen along the first one, raised by ``raised`` rad; deep: how far behind the middle it is.
    """
    low, high = elementary.sin(raised), elementary.cos(raised)
    x, y, z = b * low - deep * high, a, b * high + deep * low  # along the azimuth, to its left, up
    cosine, sine = elementary.cos(turned), elementary.sin(turned)
    forward, left = cosine * x + sine * y, cosine * y - sine * x
    return left, elementary.sin(elevation) * forward + elementary.cos(elevation) * z
