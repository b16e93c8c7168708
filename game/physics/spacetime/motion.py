"""Bodies that move within a bound of their acceleration, the time at which two may next touch, and bounces.

From place x and velocity v, and an acceleration of at most A, a body of radius R lies at time t within the
circle about x + v t of radius R + A t² / 2: in space and time a parabolic horn (Hubbard 1993). Two of them do
not touch before

    |d + v t| = R_1 + R_2 + A t²,   d and v relative place and velocity.

If their outlines are known to be L apart, they do not touch either before (|v| + |w_1| R_1 + |w_2| R_2) t + A
t² = L. The rates of turning w stay as they are between impacts.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.kernels import elementary
from game.physics.spacetime import refine
from game.physics.spacetime.exact import place_of

X, Y, ANGLE, VX, VY, SPIN = range(6)
FIELDS = 6
MASS, INERTIA, SIZE, PUSH_X, PUSH_Y = range(5)  # columns of makes
HORIZON = 10.0  # s: no farther ahead is looked
APPROACHES = 60  # steps of the root that are taken at most; each is safe
APART_SPEED = 0.1  # m/s: bodies in contact leave each other at least so fast


class Laws(NamedTuple):
    """What all bodies obey."""

    bound: float  # m/s², of each acceleration
    gravity: float  # m/s², downwards
    restitution: float
    half_x: float  # m, half the box
    half_y: float


class Grip(NamedTuple):
    """The hand: the body that it holds or -1, where it is (m), stiffness 1/s²."""

    body: int
    x: float
    y: float
    stiffness: float


@lean_kernel
def horn_time(dx, dy, vx, vy, reach, bound):
    """No earlier than this (s, at most HORIZON) is |d + v t| = reach + bound t².

    The distance is convex in t and so lies above its tangent. Each step goes to where the tangent meets the
    bound, and never past the root.
    """
    t = 0.0
    for _ in range(APPROACHES):
        px, py = dx + vx * t, dy + vy * t
        far = math.sqrt(px * px + py * py)
        gap = far - reach - bound * t * t
        if gap <= 1e-9 * reach or far == 0.0:
            return t
        slope = 2.0 * bound * t - (px * vx + py * vy) / far
        under = slope + math.sqrt(slope * slope + 4.0 * bound * gap)
        if under * HORIZON <= 2.0 * gap:
            return HORIZON
        t += 2.0 * gap / under
        if t >= HORIZON:
            return HORIZON
    return t


@inner_kernel
def _surface_time(apart, speed, bound):
    """When (speed + bound t) t = apart at the earliest, s."""
    under = speed + math.sqrt(speed * speed + 4.0 * bound * apart)
    return HORIZON if under * HORIZON <= 2.0 * apart else 2.0 * apart / under


@lean_kernel
def pair_time(fields, makes, i, j, apart, bound):
    """Seconds before which bodies i and j cannot touch, if their outlines are at least ``apart`` (m) now."""
    vx, vy = fields[VX, j] - fields[VX, i], fields[VY, j] - fields[VY, i]
    early = horn_time(
        fields[X, j] - fields[X, i], fields[Y, j] - fields[Y, i], vx, vy,
        makes[i, SIZE] + makes[j, SIZE], bound,
    )  # fmt: skip
    if apart <= 0.0:
        return early
    turning = abs(fields[SPIN, i]) * makes[i, SIZE] + abs(fields[SPIN, j]) * makes[j, SIZE]
    return max(early, _surface_time(apart, math.sqrt(vx * vx + vy * vy) + turning, bound))


@lean_kernel
def move(fields, makes, poses, laws, grip, dt):
    """All bodies by dt (s), none accelerated by more than the bound; poses become theirs."""
    for i in range(fields.shape[1]):
        ax, ay = makes[i, PUSH_X], makes[i, PUSH_Y] - laws.gravity
        if i == grip.body:
            brake = 2.0 * math.sqrt(grip.stiffness)
            ax += grip.stiffness * (grip.x - fields[X, i]) - brake * fields[VX, i]
            ay += grip.stiffness * (grip.y - fields[Y, i]) - brake * fields[VY, i]
        size = math.sqrt(ax * ax + ay * ay)
        if size > laws.bound:
            ax, ay = ax * laws.bound / size, ay * laws.bound / size
        fields[X, i] += (fields[VX, i] + 0.5 * ax * dt) * dt
        fields[Y, i] += (fields[VY, i] + 0.5 * ay * dt) * dt
        fields[VX, i] += ax * dt
        fields[VY, i] += ay * dt
        fields[ANGLE, i] += fields[SPIN, i] * dt
        place(fields, poses, i)


@lean_kernel
def place(fields, poses, i):
    """The pose of a body: x, y, cosine, sine."""
    poses[i, 0], poses[i, 1] = fields[X, i], fields[Y, i]
    poses[i, 2], poses[i, 3] = elementary.cos(fields[ANGLE, i]), elementary.sin(fields[ANGLE, i])


@lean_kernel
def due_pairs(times, now, pairs):
    """The pairs (k, 2) whose time has come, the longest overdue first; how many."""
    count, n = 0, times.shape[0]
    for i in range(n):
        for j in range(i + 1, n):
            if times[i, j] > now:
                continue
            k = count
            while k > 0 and times[pairs[k - 1, 0], pairs[k - 1, 1]] > times[i, j]:
                pairs[k, 0], pairs[k, 1] = pairs[k - 1, 0], pairs[k - 1, 1]
                k -= 1
            pairs[k, 0], pairs[k, 1] = i, j
            count += 1
    return count


@inner_kernel
def _impulse(fields, makes, i, nx, ny, rx, ry, size):
    fields[VX, i] += size * nx / makes[i, MASS]
    fields[VY, i] += size * ny / makes[i, MASS]
    fields[SPIN, i] += size * (rx * ny - ry * nx) / makes[i, INERTIA]


@inner_kernel
def _give(makes, i, nx, ny, rx, ry):
    """How fast a body's point moves along n by a unit impulse there."""
    arm = rx * ny - ry * nx
    return 1.0 / makes[i, MASS] + arm * arm / makes[i, INERTIA]


@lean_kernel
def bounce_pair(fields, makes, i, j, answer, restitution):
    """A smooth impact of i and j along the answer's normal (from i to j); whether they were closing in."""
    nx, ny = answer[refine.NORMAL_X], answer[refine.NORMAL_X + 1]
    ax, ay = answer[refine.PLACE_X] - fields[X, i], answer[refine.PLACE_X + 1] - fields[Y, i]
    bx, by = answer[refine.PLACE_X] - fields[X, j], answer[refine.PLACE_X + 1] - fields[Y, j]
    ux = fields[VX, j] - fields[SPIN, j] * by - fields[VX, i] + fields[SPIN, i] * ay
    uy = fields[VY, j] + fields[SPIN, j] * bx - fields[VY, i] - fields[SPIN, i] * ax
    speed = ux * nx + uy * ny
    wanted = max(-restitution * speed, APART_SPEED)
    if speed >= wanted:
        return False
    size = (wanted - speed) / (_give(makes, i, nx, ny, ax, ay) + _give(makes, j, nx, ny, bx, by))
    _impulse(fields, makes, i, nx, ny, ax, ay, -size)
    _impulse(fields, makes, j, nx, ny, bx, by, size)
    return speed < 0.0


@lean_kernel
def bounce_walls(fields, makes, poses, outlines, spans, laws, kicked):
    """Bodies off the four walls, at their deepest corner."""
    for i in range(fields.shape[1]):
        for wall in range(4):
            nx, ny = (1.0, -1.0, 0.0, 0.0)[wall], (0.0, 0.0, 1.0, -1.0)[wall]
            half = laws.half_x if wall < 2 else laws.half_y
            if fields[X, i] * nx + fields[Y, i] * ny + half > makes[i, SIZE]:
                continue
            deepest, px, py = 0.0, 0.0, 0.0
            for k in range(spans[i, 0], spans[i, 0] + spans[i, 1]):
                x, y = place_of(outlines, k, poses[i])
                if x * nx + y * ny + half < deepest:
                    deepest, px, py = x * nx + y * ny + half, x, y
            if deepest == 0.0:
                continue
            rx, ry = px - fields[X, i], py - fields[Y, i]
            speed = (fields[VX, i] - fields[SPIN, i] * ry) * nx + (fields[VY, i] + fields[SPIN, i] * rx) * ny
            wanted = max(-laws.restitution * speed, min(-5.0 * deepest, 1.0))
            if speed < wanted:
                _impulse(fields, makes, i, nx, ny, rx, ry, (wanted - speed) / _give(makes, i, nx, ny, rx, ry))
                kicked[i] = True


@lean_kernel
def respond(fields, makes, pairs, answers, laws, kicked):
    """Bounce all pairs that are in contact at the resolution reached; how many were closing in."""
    bounces = 0
    for p in range(pairs.shape[0]):
        i, j = pairs[p, 0], pairs[p, 1]
        if answers[p, refine.LEVEL] == refine.UNTESTED or answers[p, refine.LOWER] > 0.0:
            continue
        before = fields[VX, i]
        before_y = fields[VY, i]
        if bounce_pair(fields, makes, i, j, answers[p], laws.restitution):
            bounces += 1
        if fields[VX, i] != before or fields[VY, i] != before_y:
            kicked[i], kicked[j] = True, True
    return bounces


@lean_kernel
def renew_times(fields, makes, pairs, answers, times, kicked, bound, now):
    """When pairs that were tested, or that have a body with a new velocity, may next touch, s."""
    for p in range(pairs.shape[0]):
        i, j = pairs[p, 0], pairs[p, 1]
        if answers[p, refine.LEVEL] != refine.UNTESTED:
            times[i, j] = now + pair_time(fields, makes, i, j, answers[p, refine.LOWER], bound)
    n = times.shape[0]
    for i in range(n):
        for j in range(i + 1, n):
            if not (kicked[i] or kicked[j]):
                continue
            apart, overdue = 0.0, False
            for p in range(pairs.shape[0]):
                if pairs[p, 0] == i and pairs[p, 1] == j:
                    apart, overdue = answers[p, refine.LOWER], answers[p, refine.LEVEL] == refine.UNTESTED
            if not overdue:
                times[i, j] = now + pair_time(fields, makes, i, j, apart, bound)
