"""The record of the last collision: one row of numbers in the state, and the names of its parts."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.billiards.lecture.ball import Ball, Overshoot
from game.billiards.lecture.ball_collision import Collision
from game.billiards.lecture.settings import RULES
from game.physics.kernels import elementary

WIDTH = 36
ANGLE, OVERLAP, RULE, EXCHANGED = range(4)
CONTACT = slice(4, 6)  # px
POSITIONS, NEW_POSITIONS = (
    slice(6, 10),
    slice(10, 14),
)  # of both balls, before and after they are separated
VELOCITIES, NEW_VELOCITIES = slice(14, 18), slice(18, 22)
PARTS, NEW_PARTS = slice(22, 26), slice(26, 30)  # along and across the line of centres
MOMENTA = slice(30, 34)  # of both balls together: before x, y, after x, y
ENERGY, NEW_ENERGY = 34, 35

ROUNDING = 1e-12  # of the momenta: what is lost of them by rounding is nothing lost


def write_collision(row: Floats, c: Collision) -> None:
    """Fill the record (36,) with all that a collision computed."""
    row[ANGLE], row[OVERLAP] = c.angle, c.overlap
    row[RULE], row[EXCHANGED] = RULES.index(c.rule), c.exchanged
    row[CONTACT] = c.contact
    row[POSITIONS] = np.ravel(c.positions_before)
    row[NEW_POSITIONS] = np.ravel(c.positions_after)
    row[VELOCITIES] = np.ravel(c.velocities_before)
    row[NEW_VELOCITIES] = np.ravel(c.velocities_after)
    row[PARTS] = np.ravel(c.parts_before)
    row[NEW_PARTS] = np.ravel(c.parts_after)
    row[MOMENTA] = *c.momentum_before, *c.momentum_after
    row[ENERGY], row[NEW_ENERGY] = c.energy_before, c.energy_after


def momentum_lost(momenta: Floats | tuple[float, ...]) -> float:
    """Size of the difference of two momenta (before x, y, after x, y); 0 if it is no more than rounding."""
    px, py, qx, qy = momenta
    lost = math.sqrt(elementary.square(qx - px) + elementary.square(qy - py))
    size = math.sqrt(px * px + py * py) + math.sqrt(qx * qx + qy * qy)
    return lost if lost > ROUNDING * size else 0.0


# walls (2, 5): of a ball's last overshoot its depth in x and y (px), its age (s), and the place put back to
DEPTH_X, DEPTH_Y, AGE, PLACE = 0, 1, 2, slice(3, 5)
LONG_AGO = 9.0  # s


def write_overshoot(row: Floats, ball: Ball, overshoot: Overshoot) -> bool:
    """Remember how deep a ball was beyond the walls, on which sides, and where; False if it was not."""
    deep_x, deep_y = max(overshoot.left, overshoot.right, 0.0), max(overshoot.low, overshoot.high, 0.0)
    if deep_x == 0.0 and deep_y == 0.0:
        return False
    row[DEPTH_X] = -deep_x if overshoot.left > 0.0 else deep_x
    row[DEPTH_Y] = -deep_y if overshoot.low > 0.0 else deep_y
    row[AGE] = 0.0
    row[PLACE] = ball.position
    return True
