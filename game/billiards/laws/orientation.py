"""How balls turn between events, for drawing them.

The rotation vector w(t) of a phase is known in closed form. Where its axis stays (rolling without side spin,
a straight slide) so is the rotation. Else it is integrated in steps of at most STEP by the fourth-order
Magnus expansion (Blanes, Casas, Oteo, Ros 2009, eq. 253): with w at the two Gauss points, theta = h/2 (w1 +
w2) + sqrt(3) h^2/12 w2 x w1. Quaternions are scalar first.
"""

from __future__ import annotations

import math

from game.billiards.laws import state as col
from game.billiards.laws.lean import inner_kernel, lean_kernel
from game.billiards.laws.motion import spin_after
from game.physics.kernels import elementary

STEP = 0.02  # s
GAUSS = 0.5 - math.sqrt(3.0) / 6.0


@inner_kernel
def spin_in_segment(segment, elapsed, radius, physics):
    """Rotation vector `elapsed` s into a segment, rad/s."""
    wx = segment[col.SEG_WX]
    wy = segment[col.SEG_WY]
    motion = int(segment[col.SEG_MOTION])
    if motion == col.ROLLING:
        wx = -(segment[col.SEG_VY] + 2.0 * elapsed * segment[col.SEG_AY]) / radius
        wy = (segment[col.SEG_VX] + 2.0 * elapsed * segment[col.SEG_AX]) / radius
    elif motion == col.SLIDING:
        wx += 5.0 * elapsed * segment[col.SEG_AY] / radius
        wy -= 5.0 * elapsed * segment[col.SEG_AX] / radius
    elif motion == col.AIRBORNE:
        return wx, wy, segment[col.SEG_WZ]
    return wx, wy, spin_after(segment[col.SEG_WZ], elapsed, radius, physics)


@inner_kernel
def turn(q, tx, ty, tz):
    """Turn the quaternion q (4,), in place, by the rotation vector t, rad."""
    angle = math.sqrt(tx * tx + ty * ty + tz * tz)
    if angle == 0.0:
        return
    s = elementary.sin(0.5 * angle) / angle
    w = elementary.cos(0.5 * angle)
    x = s * tx
    y = s * ty
    z = s * tz
    q0 = w * q[0] - x * q[1] - y * q[2] - z * q[3]
    q1 = w * q[1] + x * q[0] + y * q[3] - z * q[2]
    q2 = w * q[2] + y * q[0] + z * q[1] - x * q[3]
    q3 = w * q[3] + z * q[0] + x * q[2] - y * q[1]
    length = math.sqrt(q0 * q0 + q1 * q1 + q2 * q2 + q3 * q3)
    q[0] = q0 / length
    q[1] = q1 / length
    q[2] = q2 / length
    q[3] = q3 / length


@inner_kernel
def turn_through(segment, start, end, radius, physics, q):
    """Turn q by what the ball turns from `start` to `end` s into its segment, in one Magnus step."""
    h = end - start
    ax, ay, az = spin_in_segment(segment, start + GAUSS * h, radius, physics)
    bx, by, bz = spin_in_segment(segment, end - GAUSS * h, radius, physics)
    k = math.sqrt(3.0) / 12.0 * h * h
    turn(
        q,
        0.5 * h * (ax + bx) + k * (by * az - bz * ay),
        0.5 * h * (ay + by) + k * (bz * ax - bx * az),
        0.5 * h * (az + bz) + k * (bx * ay - by * ax),
    )


@inner_kernel
def turn_in_segment(segment, elapsed, radius, physics, q):
    """Turn q by what the ball turns in the first `elapsed` s of a segment."""
    wx, wy, wz = spin_in_segment(segment, 0.0, radius, physics)
    ax, ay, az = spin_in_segment(segment, elapsed, radius, physics)
    cx = wy * az - wz * ay
    cy = wz * ax - wx * az
    cz = wx * ay - wy * ax
    crossed = cx * cx + cy * cy + cz * cz
    if crossed <= 1e-24 * (wx * wx + wy * wy + wz * wz) * (ax * ax + ay * ay + az * az) and wz == az:
        turn_through(segment, 0.0, elapsed, radius, physics, q)
        return
    steps = int(elapsed / STEP)
    for k in range(steps):
        turn_through(segment, k * STEP, (k + 1) * STEP, radius, physics, q)
    turn_through(segment, steps * STEP, elapsed, radius, physics, q)


@lean_kernel
def turns_at_starts(segments, order, starts, radii, physics, turns):
    """Quaternion of each ball at the start of each of its segments, seen from time 0, to turns (s, 4).

    order (s,): rows of segments ball by ball; starts (n + 1,): where each ball's rows begin in it.
    """
    for ball in range(starts.shape[0] - 1):
        for place in range(starts[ball], starts[ball + 1]):
            row = order[place]
            if place == starts[ball]:
                turns[row, 0] = 1.0
                for k in range(1, 4):
                    turns[row, k] = 0.0
                continue
            before = order[place - 1]
            for k in range(4):
                turns[row, k] = turns[before, k]
            elapsed = segments[row, col.SEG_TIME] - segments[before, col.SEG_TIME]
            turn_in_segment(segments[before], elapsed, radii[ball], physics, turns[row])
