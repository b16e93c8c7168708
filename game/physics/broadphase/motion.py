"""Coherent motion of boxes, as the tasks have it: explicit Euler, the velocity negated at the boundary."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

from game.compiler.decorator import kernel
from game.physics.broadphase.effects import BOUNDARY, BOXES, MOTION

MOTION_BIT, BOUNDARY_BIT = BOXES.bit(MOTION), BOXES.bit(BOUNDARY)


@cache
def move_boxes_kernel(mask: int) -> Callable[..., Any]:
    """The kernel that moves boxes, for the effects of ``mask``; what is off is not in it.

    ``move_boxes(lowers, uppers, velocities, growth, alive, lower, upper, dt)``: x + v dt for both corners,
    which also part by ``growth`` dt on each side. Then v = -v on an axis where a box is beyond the boundary
    and its velocity leads on outwards. One that leads back already is not negated again, so a box comes back
    by itself however far out it is. A growing box shrinks again once it is larger than the world on both
    axes, and a shrinking one grows before it vanishes on either. ``lowers``, ``uppers``, ``velocities``: (n,
    2) m, m/s, written. ``growth``: (n,) m/s, written. ``alive``: (n,). ``lower``, ``upper``: (2,) the world,
    m.
    """

    @kernel(_nrt=False)
    def move_boxes(lowers, uppers, velocities, growth, alive, lower, upper, dt):
        for box in range(len(alive)):
            if alive[box] == 0:
                continue
            if mask & MOTION_BIT and growth[box] != 0.0:
                size = min(uppers[box, 0] - lowers[box, 0], uppers[box, 1] - lowers[box, 1])
                way = 2.0 * growth[box] * dt  # that the size grows in this step
                if (way > 0.0 and size > upper[0] - lower[0] and size > way) or (
                    way < 0.0 and size + 2.0 * way <= 0.0
                ):
                    growth[box] = -growth[box]
            for axis in range(2):
                if mask & MOTION_BIT:
                    lowers[box, axis] += (velocities[box, axis] - growth[box]) * dt
                    uppers[box, axis] += (velocities[box, axis] + growth[box]) * dt
                if mask & BOUNDARY_BIT:
                    speed = velocities[box, axis]
                    if (lowers[box, axis] < lower[axis] and speed < 0.0) or (
                        uppers[box, axis] > upper[axis] and speed > 0.0
                    ):
                        velocities[box, axis] = -speed

    return move_boxes
