"""How fast a row of dominoes falls, and how far a block slides: what a world of solids is compared with.

The wave is that of van Leeuwen 2010, "The domino effect" (American Journal of Physics 78, 721): each domino
turns about the lower edge of its face, without sliding. The one struck stays with the one that struck it, so
that all behind the front lean on each other; friction acts between them. Then all angles follow from the
front's, and there is one degree of freedom between two impacts. Lengths here are in heights of a domino.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.physics.kernels import elementary, elementwise

STANDARD_GRAVITY = 9.81  # m/s²
PIECES = 200  # of the front's way from upright to the next domino
NEGLIGIBLE = 1e-10  # weight of a domino in the train, beside that of the front
LONGEST_TRAIN = 2_000


class _Train(NamedTuple):
    """Sums over the train for angles of the front: inertia (m h²), its rate with the angle, and the torque of
    gravity (m g h). Each domino counts so much that forces between dominoes cancel.
    """

    inertia: Floats
    rate: Floats
    torque: Floats


def _train(pitch: float, thickness: float, friction: float, angles: Floats) -> _Train:
    """Sums over all behind the front and the front itself, at ``angles`` (k,) rad."""
    own = _inertia(thickness)
    theta, slope, bend = angles.copy(), np.ones_like(angles), np.zeros_like(angles)
    weight = np.ones_like(angles)
    inertia, rate, torque = np.zeros((3, *angles.shape))
    for _ in range(LONGEST_TRAIN):
        inertia += weight * own * slope
        rate += weight * own * bend
        torque += weight * 0.5 * (elementwise.sin(theta) - thickness * elementwise.cos(theta))
        sine, cosine = elementwise.sin(theta), elementwise.cos(theta)
        lean = pitch * cosine - thickness  # sine of the angle between it and the next one back
        flat = np.sqrt(np.maximum(1.0 - lean * lean, 1e-30))
        turn = -pitch * sine / flat  # rate of that angle
        bend_of = -pitch * cosine / flat - pitch * sine * lean * turn / (flat * flat)
        lever, reach = flat - pitch * sine - friction * thickness, flat + friction * lean
        weight = weight * lever / reach
        theta = theta + elementwise.arcsin(lean)
        bend = bend_of * slope * slope + (1.0 + turn) * bend
        slope = (1.0 + turn) * slope
        if np.abs(weight * slope).max() < NEGLIGIBLE:
            break
    return _Train(inertia, rate, torque)


@lru_cache(maxsize=256)
def domino_wave_speed(spacing: float, thickness: float, friction: float) -> float:
    """Speed of a steady domino wave over the square root of g h (h: height).

    spacing: gap between two over h, above 0 and below 1. thickness over h. friction: between two dominoes; on
    the floor none slides. NaN where no wave goes on (a thick or a rubbing row). ValueError for nonsense.
    """
    for name, value, most in (("spacing", spacing, 1.0), ("thickness", thickness, 10.0)):
        if not 0.0 < value < most:
            raise ValueError(f"{name} = {value!r}: expected above 0 and below {most:g}, in heights")
    if not 0.0 <= friction <= 10.0:
        raise ValueError(f"friction = {friction!r}: expected 0 to 10")
    meeting = elementary.asin(spacing)
    angles = np.linspace(0.0, meeting, 2 * PIECES + 1)
    train = _train(spacing + thickness, thickness, friction, angles)
    if not (train.inertia > 0.0).all():
        return math.nan
    # the one struck joins at angle 0: the sum of weight, inertia and spin is kept, and its own begins at none
    joined = float(train.inertia[0])
    ratio = elementary.square(1.0 - _inertia(thickness) / joined)
    of_start, added = _half_squares(train, meeting / PIECES)
    start = ratio * added[-1] / (1.0 - ratio * of_start[-1])
    course = start * of_start + added
    if not (ratio * of_start[-1] < 1.0 and (course > 0.0).all()):
        return math.nan
    weights = np.full(len(course), 2.0)
    weights[1::2], weights[0], weights[-1] = 4.0, 1.0, 1.0
    time = meeting / PIECES / 6.0 * float((weights / np.sqrt(2.0 * course)).sum())
    return (spacing + thickness) / time


def _inertia(thickness: float) -> float:
    """Of one about the lower edge of its face, in m h²."""
    return (1.0 + thickness * thickness) / 3.0


def _half_squares(train: _Train, piece: float) -> tuple[Floats, Floats]:
    """Half the front's squared rate of angle at the ends and middles of pieces: u = u0 a + b; a and b (k,).

    inertia u' + 2 rate u = torque, by Runge and Kutta's method over each piece.
    """
    damping, drive = 2.0 * train.rate / train.inertia, train.torque / train.inertia
    found = np.zeros((2, len(damping)))
    found[0, 0] = 1.0
    for k in range(0, len(damping) - 2, 2):
        for row, source in ((0, 0.0), (1, 1.0)):
            u = float(found[row, k])

            def slope(at: int, value: float, source: float = source) -> float:
                return source * float(drive[at]) - float(damping[at]) * value

            k1 = slope(k, u)
            k2 = slope(k + 1, u + 0.5 * piece * k1)
            k3 = slope(k + 1, u + 0.5 * piece * k2)
            k4 = slope(k + 2, u + piece * k3)
            found[row, k + 2] = u + piece / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4)
            ends = slope(k, u), slope(k + 2, float(found[row, k + 2]))
            middle = 0.5 * (u + float(found[row, k + 2])) + piece / 8.0 * (ends[0] - ends[1])
            found[row, k + 1] = middle  # of the cubic through both ends with their slopes
    return found[0], found[1]


def stopping_distance(
    speed: float, friction: float, slope: float, gravity: float = STANDARD_GRAVITY
) -> float:
    """How far (m) a block slides down a slope (rad) from a speed (m/s) on; infinite where it never stops.

    v² / (2 g (mu cos - sin)). ValueError for a negative speed, friction or gravity, a slope beyond upright.
    """
    if not (speed >= 0.0 and friction >= 0.0 and gravity >= 0.0 and abs(slope) <= 0.5 * math.pi):
        raise ValueError(
            f"speed {speed!r}, friction {friction!r}, gravity {gravity!r}, slope {slope!r}: out of range"
        )
    slowing = gravity * (friction * elementary.cos(slope) - elementary.sin(slope))
    if slowing <= 0.0:
        return math.inf if speed > 0.0 or slowing < 0.0 else 0.0
    return speed * speed / (2.0 * slowing)
