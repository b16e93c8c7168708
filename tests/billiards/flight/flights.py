"""Shots with balls in the air, and what must hold of each, looked at through its segments."""

import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from game.billiards import Physics, Table, make_shot, simulate
from game.billiards.laws.lean import lean_kernel
from game.billiards.laws.orientation import spin_in_segment as _spin_in_segment
from game.billiards.laws.state import (
    AIRBORNE,
    BALL_BALL,
    BALL_SLATE,
    EVENTS,
    OFF_TABLE,
    POCKETED,
    SEG_AX,
    SEG_AY,
    SEG_BALL,
    SEG_MOTION,
    SEG_TIME,
    SEG_VX,
    SEG_VY,
    SEG_VZ,
    SEG_X,
    SEG_Y,
    SEG_Z,
)

G = 9.81
R = 0.028575
POOL = Table.pool()
OPEN = Table.open()
TABLE = Physics()
SMOOTH = Physics("elastic", "restitution", sliding=0.0, rolling=0.0, spinning=0.0, ball_friction=0.0)


def thrown(velocity, height, spin=(0.0, 0.0, 0.0), *, table=OPEN, physics=TABLE, others=(), at=(0.6, 0.6)):
    """A shot with ball 0 in the air."""
    return make_shot(table, [at, *others], physics=physics).in_air(0, velocity, height, spin)


def put(shot, ball, place):
    """The shot with a ball elsewhere, (x, y) m; over another too, where none could lie on the slate."""
    balls = shot.balls.copy()
    balls[ball, :2] = np.asarray(place) - shot.layout.middle
    return replace(shot, balls=balls)


def with_flight_kernel(shot):
    """The shot as the kernel for flights plays it, though nothing flies."""
    balls = shot.balls
    if balls.shape[1] < 13:
        balls = np.concatenate([balls, np.zeros((len(balls), 2))], axis=1)
    return replace(shot, balls=balls, flies=True)


def events(trajectory):
    """(time, kind, ball, other) of the contacts of a played shot."""
    return [
        (t, EVENTS[int(e)], int(i), int(j))
        for t, e, i, j in trajectory.rows.tolist()
        if int(e) <= 3 or int(e) >= BALL_SLATE
    ]


def kinds(trajectory):
    """The kinds of its contacts, in order."""
    return [kind for _, kind, _, _ in events(trajectory)]


@lean_kernel
def spin_in_segment(segment, elapsed, radius, physics):
    """`orientation.spin_in_segment`, called from Python."""
    return _spin_in_segment(segment, elapsed, radius, physics)


class Audit(NamedTuple):
    """Deepest overlap of two balls, m; largest rise of energy at an event, J; how far a path jumps, m."""

    overlap: float
    rise: float
    jump: float


def _state(segment, time, gravity):
    t = time - segment[SEG_TIME]
    flies = segment[SEG_MOTION] == AIRBORNE
    place = np.array(
        [
            segment[SEG_X] + t * (segment[SEG_VX] + t * segment[SEG_AX]),
            segment[SEG_Y] + t * (segment[SEG_VY] + t * segment[SEG_AY]),
            segment[SEG_Z] + (t * (segment[SEG_VZ] - 0.5 * gravity * t) if flies else 0.0),
        ]
    )
    velocity = np.array(
        [
            segment[SEG_VX] + 2.0 * t * segment[SEG_AX],
            segment[SEG_VY] + 2.0 * t * segment[SEG_AY],
            segment[SEG_VZ] - gravity * t if flies else 0.0,
        ]
    )
    return place, velocity


def audit(trajectory, looks=4):
    """Go through a trajectory, looking so many times between each two events."""
    shot = trajectory.shot
    gravity = shot.physics.gravity
    radii, masses = shot.balls[:, 7], shot.balls[:, 8]
    n = len(radii)
    rows = trajectory.segments
    if rows.shape[1] < 14:
        rows = np.concatenate([rows, np.zeros((len(rows), 2))], axis=1)
    current = dict(enumerate(rows[:n]))
    overlap, jump = -1.0, 0.0

    def energy(segment, time):
        ball = int(segment[SEG_BALL])
        if segment[SEG_MOTION] in (POCKETED, OFF_TABLE):
            return 0.0
        place, v = _state(segment, time, gravity)
        w = np.array(spin_in_segment(segment, time - segment[SEG_TIME], radii[ball], shot.constants))
        spin = 0.2 * radii[ball] ** 2 * (w @ w)
        return float(masses[ball] * (0.5 * (v @ v) + spin + gravity * place[2]))

    def deepest(time):
        worst = -1.0
        there = [k for k in range(n) if current[k][SEG_MOTION] not in (POCKETED, OFF_TABLE)]
        places = {k: _state(current[k], time, gravity)[0] + (0.0, 0.0, radii[k]) for k in there}
        for a in there:
            for b in there:
                if a < b:
                    apart = float(np.linalg.norm(places[a] - places[b]))
                    worst = max(worst, radii[a] + radii[b] - apart)
        return worst

    rise, last = 0.0, 0.0
    k = n
    while k < len(rows):
        now = rows[k, SEG_TIME]
        for look in range(1, looks + 1):
            overlap = max(overlap, deepest(last + (now - last) * look / looks))
        group = []
        while k < len(rows) and rows[k, SEG_TIME] == now:
            group.append(rows[k])
            k += 1
        changed = {int(row[SEG_BALL]) for row in group}
        before = sum(energy(current[ball], now) for ball in changed)
        for row in group:
            ball = int(row[SEG_BALL])
            if row[SEG_MOTION] not in (POCKETED, OFF_TABLE):
                place, _ = _state(current[ball], now, gravity)
                there = np.array([row[SEG_X], row[SEG_Y], row[SEG_Z]])
                jump = max(jump, float(np.linalg.norm(place - there)))
            current[ball] = row
        rise = max(rise, sum(energy(current[ball], now) for ball in changed) - before)
        last = now
    return Audit(overlap, rise, jump)


def play(shot, until=math.inf):
    """Play a shot and check what must hold of every one."""
    trajectory = simulate(shot, until=until)
    found = audit(trajectory)
    assert found.overlap < 1e-9, found
    assert found.rise < 1e-12, found
    assert found.jump < 1e-9, found
    return trajectory


def hits(trajectory, code=BALL_BALL):
    """Times of the events of a kind, s."""
    rows = trajectory.rows
    return rows[rows[:, 1] == code, 0]
