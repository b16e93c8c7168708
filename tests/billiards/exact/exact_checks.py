"""What must hold of every trajectory of the exact table, checked by going through its segments."""

import math
from typing import NamedTuple

import numpy as np

from game.billiards.laws.lean import inner_kernel, lean_kernel
from game.billiards.laws.orientation import spin_in_segment
from game.billiards.laws.state import (
    BALL_BALL,
    BALL_CUSHION,
    BALL_JAW,
    BALL_POCKET,
    POCKETED,
    SEG_AX,
    SEG_AY,
    SEG_BALL,
    SEG_MOTION,
    SEG_TIME,
    SEG_VX,
    SEG_VY,
    SEG_X,
    SEG_Y,
)


class Audit(NamedTuple):
    """Deepest overlap (m), largest rise of energy (J) and change of momentum (kg m/s) at an event, energy at
    the start (J), and how far a ball's path jumps (m)."""

    overlap: float
    energy_rise: float
    momentum_change: float
    energy: float
    jump: float


@inner_kernel
def _place(segment, time):
    t = time - segment[SEG_TIME]
    x = segment[SEG_X] + t * (segment[SEG_VX] + t * segment[SEG_AX])
    y = segment[SEG_Y] + t * (segment[SEG_VY] + t * segment[SEG_AY])
    return x, y


@inner_kernel
def _totals(segments, current, time, radii, masses, physics):
    """Energy and momentum of all balls."""
    energy = 0.0
    px = 0.0
    py = 0.0
    for i in range(current.shape[0]):
        segment = segments[current[i]]
        t = time - segment[SEG_TIME]
        vx = segment[SEG_VX] + 2.0 * t * segment[SEG_AX]
        vy = segment[SEG_VY] + 2.0 * t * segment[SEG_AY]
        wx, wy, wz = spin_in_segment(segment, t, radii[i], physics)
        spin = 0.4 * radii[i] * radii[i] * (wx * wx + wy * wy + wz * wz)
        energy += 0.5 * masses[i] * (vx * vx + vy * vy + spin)
        px += masses[i] * vx
        py += masses[i] * vy
    return energy, px, py


@inner_kernel
def _deepest(segments, current, time, radii):
    """Deepest overlap of two balls."""
    worst = -1.0
    n = current.shape[0]
    for i in range(n):
        if segments[current[i], SEG_MOTION] == POCKETED:
            continue
        xi, yi = _place(segments[current[i]], time)
        for j in range(i):
            if segments[current[j], SEG_MOTION] == POCKETED:
                continue
            xj, yj = _place(segments[current[j]], time)
            distance = math.sqrt((xi - xj) * (xi - xj) + (yi - yj) * (yi - yj))
            worst = max(worst, 2.0 * math.sqrt(radii[i] * radii[j]) - distance)
    return worst


@lean_kernel
def _go_through(segments, rows, radii, masses, physics, current, samples, found):
    """found (5,): as in `Audit`."""
    n = current.shape[0]
    for i in range(n):
        current[i] = i
    found[3] = _totals(segments, current, 0.0, radii, masses, physics)[0]
    found[0] = _deepest(segments, current, 0.0, radii)
    s = n
    e = 0
    last = 0.0
    while s < segments.shape[0]:
        now = segments[s, SEG_TIME]
        for k in range(1, samples + 1):
            found[0] = max(found[0], _deepest(segments, current, last + (now - last) * k / samples, radii))
        energy, px, py = _totals(segments, current, now, radii, masses, physics)
        inner = True
        while e < rows.shape[0] and rows[e, 0] <= now:
            inner = (
                inner and rows[e, 1] != BALL_CUSHION and rows[e, 1] != BALL_JAW and rows[e, 1] != BALL_POCKET
            )
            e += 1
        while s < segments.shape[0] and segments[s, SEG_TIME] <= now:
            ball = int(segments[s, SEG_BALL])
            x, y = _place(segments[current[ball]], now)
            jump = math.sqrt((segments[s, SEG_X] - x) ** 2 + (segments[s, SEG_Y] - y) ** 2)
            found[4] = max(found[4], jump)
            current[ball] = s
            s += 1
        after, qx, qy = _totals(segments, current, now, radii, masses, physics)
        found[1] = max(found[1], after - energy)
        if inner:
            found[2] = max(found[2], math.sqrt((qx - px) * (qx - px) + (qy - py) * (qy - py)))
        last = now


def audit(trajectory, samples=3):
    """Go through a trajectory, looking `samples` times between each two events."""
    shot = trajectory.shot
    found = np.zeros(5)
    current = np.zeros(len(shot.balls), np.int64)
    radii = np.ascontiguousarray(shot.balls[:, 7])
    masses = np.ascontiguousarray(shot.balls[:, 8])
    _go_through(trajectory.segments, trajectory.rows, radii, masses, shot.constants, current, samples, found)
    return Audit(*found.tolist())


def cushion_hits(trajectory):
    """How many rails and jaws were hit."""
    return int(np.isin(trajectory.rows[:, 1], (BALL_CUSHION, BALL_JAW)).sum())


def ball_hits(trajectory):
    """How many times two balls met."""
    return int((trajectory.rows[:, 1] == BALL_BALL).sum())
