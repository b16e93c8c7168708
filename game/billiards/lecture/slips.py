"""The slips in the printed listing of a collision: what stands there, what should, what comes of it.

The rule ``as-printed`` computes all three. Its loss, which shortens both whole velocities, is no slip but a
choice, and takes the momentum with it: the rule ``scaled`` is the listing without slips, with that loss.
"""

from __future__ import annotations

from typing import NamedTuple


class Slip(NamedTuple):
    """A mistake in the printed listing."""

    name: str
    printed: str
    right: str
    effect: str


SLIPS = (
    Slip(
        "turning in",
        "py1 = cosa*vx1 - sina*vy1",
        "py1 = cosa*vy1 - sina*vx1",
        "x and y are not swapped in the tangential part. With the centres side by side it becomes a copy of "
        "the normal part, and the motion across the line of centres is forgotten.",
    ),
    Slip(
        "exchange",
        "pnewy1 = py2;  pnewy2 = py1",
        "pnewy1 = py1;  pnewy2 = py2",
        "The tangential parts are exchanged like the normal ones. Even with right rotations the balls would "
        "swap their whole velocities, however they meet: a grazing hit like a full one.",
    ),
    Slip(
        "turning back",
        "vynew = cosa*pnewx1 + sina*pnewy1",
        "vynew = cosa*pnewy1 + sina*pnewx1",
        "x and y are not swapped on the way back either. A head-on hit along x at speed v sends the other "
        "ball off with (v, v): at 45 degrees, with twice the energy.",
    ),
)
