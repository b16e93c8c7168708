"""The first contact of a stroke: how thin it is, and how far friction throws the object ball off the line.

Beside what is measured on the paths stands the law of Alciatore (2006), technical proof A.14: the tangent of
the throw is the friction at the speed of the slip. Where the slip ends during the contact, it is a seventh of
the slip over the closing speed. The table rubs by the same friction, Alciatore's fit to Marlow's figures: so
the law is a check of the computed contact, not of how real balls rub.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.billiards.game.frame import Played
from game.billiards.game.rules import CUE_BALL
from game.billiards.laws.state import BALL_BALL, IN_RADIUS
from game.billiards.shot.trajectory import Trajectory
from game.physics.kernels import elementary
from game.stage import Comparison

BEFORE_S, AFTER_S = 1e-6, 1e-6  # s to each side of a contact at which the motion is looked at
THINNEST = math.radians(80.0)  # rad; to there the law is drawn
POINTS = 41
FRICTION = (0.009951, 0.108, 1.088)  # A.14, eq. 13: a + b exp(-c slip), slip in m/s
STICKING = 1.0 / 7.0  # of the slip, for solid spheres alike


class Contact(NamedTuple):
    """The first contact of the cue ball with another one.

    time: s since the hit. ball: its number. place, other: middles of both, m. cut: rad, from the path of the
    cue ball to the line of centres. throw: rad, from that line to the path of the ball, positive where it
    is dragged along. speed: of the cue ball, m/s. roll, side: speeds of its surface, m/s, forwards at the
    top, and at the equator towards where it cuts.
    """

    time: float
    ball: int
    place: Floats
    other: Floats
    cut: float
    throw: float
    speed: float
    roll: float
    side: float


def first_contact(played: Played, numbers: tuple[int, ...]) -> Contact | None:
    """That of a stroke; None if the cue ball meets no other, or as one of several at a time.

    numbers: of the balls in the order of its paths.
    """
    trajectory, cue = played.trajectory, numbers.index(CUE_BALL)
    for time, code, one, two in trajectory.rows.tolist():
        if int(code) == BALL_BALL and cue in (int(one), int(two)):
            other = int(two) if int(one) == cue else int(one)
            alike = np.abs(trajectory.times - time) <= BEFORE_S + AFTER_S
            if np.count_nonzero(alike & (trajectory.rows[:, 1] == BALL_BALL)) > 1:
                return None
            return _contact(trajectory, time, cue, other, numbers[other])
    return None


def _contact(trajectory: Trajectory, time: float, cue: int, other: int, number: int) -> Contact | None:
    before, after = trajectory.state_at(time - BEFORE_S), trajectory.state_at(time + AFTER_S)
    velocity, struck = before.velocities[cue], after.velocities[other]
    speed = elementary.hypot(*velocity.tolist())
    line = before.positions[other] - before.positions[cue]
    line = line / elementary.hypot(*line.tolist())
    if speed <= 0.0 or not struck.any() or before.velocities[other].any():
        return None
    cut = _angle(velocity, line)
    sense = 1.0 if cut < 0.0 else -1.0  # the ball is dragged along the way of the cue ball
    radius = float(trajectory.end[cue, IN_RADIUS])
    wx, wy, wz = before.spins[cue].tolist()
    way = velocity / speed
    return Contact(
        time, number, before.positions[cue].copy(), before.positions[other].copy(), abs(cut),
        sense * _angle(line, struck), speed, radius * float(way[0] * wy - way[1] * wx), -sense * radius * wz,
    )  # fmt: skip


def _angle(first: Floats, second: Floats) -> float:
    """rad, counter-clockwise from one direction to the other."""
    (ax, ay), (bx, by) = first.tolist(), second.tolist()
    return float(elementary.atan2(ax * by - ay * bx, ax * bx + ay * by))


def throw_by_law(cut: float, speed: float, roll: float, side: float) -> float:
    """Throw (rad) at a cut angle (rad), for the speeds of a `Contact`: Alciatore (2006), A.14, eq. 17."""
    closing = speed * elementary.cos(cut)
    across = speed * elementary.sin(cut) - side
    slip = elementary.hypot(across, roll * elementary.cos(cut))
    if closing <= 0.0 or slip <= 0.0:
        return 0.0
    level, fall, rate = FRICTION
    friction = level + fall * elementary.exp(-rate * slip)
    return float(elementary.atan(min(friction / slip, STICKING / closing) * across))


def throw_chart(contact: Contact | None) -> Comparison:
    """Throw over cut angle, degrees: the law at the speed and spin of a contact, and what it came to."""
    names, nothing = ("this stroke", "by the law"), np.zeros((0, 2))
    if contact is None:
        return Comparison(nothing, nothing, names, "°", "cut angle", "°", single=True)
    cuts = [THINNEST * i / (POINTS - 1) for i in range(POINTS)]
    law = [throw_by_law(cut, contact.speed, contact.roll, contact.side) for cut in cuts]
    return Comparison(
        np.degrees([[contact.cut, contact.throw]]), np.degrees(np.stack([cuts, law], axis=1)), names, "°",
        "cut angle", "°", single=True,
    )  # fmt: skip
