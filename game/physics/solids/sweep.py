"""Continuous collision: what moves farther in a step than it is thick is stopped where it meets something.

Conservative advancement (Mirtich 1996; van den Bergen 2004) along the straight, evenly turning path of the
step: as long as two are apart by a distance, they may go on for that distance over their fastest approach. Of
all its meetings a body stops at the earliest; the next step finds the contact. What forces gave it for the
rest of the step is taken back, so that nothing gains energy by being stopped.
"""

from __future__ import annotations

import math

import numpy as np

from game.compiler.decorator import inner_kernel
from game.physics.kernels import elementary
from game.physics.solids.arrays import state
from game.physics.solids.collide.hull import Hull
from game.physics.solids.collide.polygons import widest_gap
from game.physics.solids.contacts import bring_shape

MOST_ADVANCES = 64
LOOKS, MOST_LOOKS = 16, 4096  # at the way of two that touch, at least and at most
PACE = 0.5  # of what is deep: how far they may go between two looks
FAST = 4.0  # times what is deep: slower motion of two that touch is left to the contacts
SWIFT = 8.0  # times that: what lies flat in something thin is through before it is deeper than both are thick
SLOW = 0.999  # a little less than all: sums of two are rounded otherwise than each
THIN = 0.5  # of both cores together: how far two may approach in a step and be left to the contacts


@inner_kernel
def pose_at(bodies, motion, i, t):
    """Place, cosine and sine of a body at the fraction t of the step."""
    turned = motion[i, state.DA] * t
    c, s = bodies.rotations[i, 0], bodies.rotations[i, 1]
    if turned != 0.0:
        dc, ds = elementary.cos(turned), elementary.sin(turned)
        c, s = c * dc - s * ds, s * dc + c * ds
    return (
        bodies.positions[i, 0] + t * motion[i, state.DX],
        bodies.positions[i, 1] + t * motion[i, state.DY],
        c,
        s,
    )


@inner_kernel
def gap_at(shapes, pool, scratch, a, b, place_a, place_b):
    """At least how far two shapes are apart with their bodies at these places, m."""
    ax, ay, ca, sa = place_a
    bx, by, cb, sb = place_b
    x, y, c, s = (
        ca * (bx - ax) + sa * (by - ay),
        ca * (by - ay) - sa * (bx - ax),
        ca * cb + sa * sb,
        ca * sb - sa * cb,
    )
    bring_shape(shapes, pool, scratch, b, (x, y, c, s))
    start, kind, rounding = np.int64(shapes.starts[a]), shapes.kinds[a], shapes.radii[a] + shapes.radii[b]
    if kind == state.DISC:
        px, py = (
            scratch.corners[0, 0] - pool.corners[start, 0],
            scratch.corners[0, 1] - pool.corners[start, 1],
        )
        return math.sqrt(px * px + py * py) - rounding
    count_a, count_b = np.int64(shapes.counts[a]), np.int64(shapes.counts[b])
    second = Hull(scratch.corners, scratch.normals, np.int64(0), count_b, shapes.radii[b])
    if kind == state.SEGMENT:
        face = Hull(pool.corners, pool.normals, start + 1, np.int64(1), 0.0)
        core = Hull(pool.corners, pool.normals, start + 1, np.int64(2), 0.0)
        best, _ = widest_gap(face, second)
        best = max(best, beyond_ends(pool.corners, start + 1, scratch.corners, count_b))
    else:
        core = Hull(pool.corners, pool.normals, start, count_a, shapes.radii[a])
        best, _ = widest_gap(core, second)
    if shapes.kinds[b] == state.DISC:
        return best - rounding
    other, _ = widest_gap(second, core)
    return max(best, other) - rounding


@inner_kernel
def beyond_ends(corners, start, others, count):
    """How far all of the other corners are beyond one end of a segment; negative if they are not."""
    ex, ey = corners[start + 1, 0] - corners[start, 0], corners[start + 1, 1] - corners[start, 1]
    length = math.sqrt(ex * ex + ey * ey)
    low, high = math.inf, -math.inf
    for k in range(count):
        along = ((others[k, 0] - corners[start, 0]) * ex + (others[k, 1] - corners[start, 1]) * ey) / length
        low, high = min(low, along), max(high, along)
    return max(-high, low - length)


@inner_kernel
def meeting_time(bodies, shapes, pool, scratch, pair, target, deep):
    """Fraction of the step after which two shapes (pair) are ``target`` (m) apart; 1 if they do not meet.

    Two that are as near as that to begin with touch, and contacts hold them: they are only stopped where they
    would get deeper into each other than ``deep`` (m) on their way, as an end of something that turns fast.
    """
    a, b = pair
    motion, i, j = scratch.motion, shapes.bodies[a], shapes.bodies[b]
    x, y = motion[j, state.DX] - motion[i, state.DX], motion[j, state.DY] - motion[i, state.DY]
    fastest = math.sqrt(x * x + y * y)
    fastest += abs(motion[i, state.DA]) * bodies.reaches[i] + abs(motion[j, state.DA]) * bodies.reaches[j]
    t = 0.0
    for _ in range(MOST_ADVANCES):
        gap = gap_at(
            shapes, pool, scratch, a, b, pose_at(bodies, motion, i, t), pose_at(bodies, motion, j, t)
        )
        if t == 0.0 and gap <= 1.1 * target:
            if fastest <= FAST * deep:
                return 1.0
            share = 0.5 if fastest > SWIFT * deep else 1.0
            return first_deep(bodies, shapes, pool, scratch, pair, share * deep, target, fastest)
        if gap <= 1.1 * target:
            return t
        t += (gap - target) / fastest
        if t >= 1.0:
            return 1.0
    return t


@inner_kernel
def first_deep(bodies, shapes, pool, scratch, pair, deep, target, fastest):
    """Fraction of the step before two that touch are deeper in each other than ``deep`` (m), or meet again.

    They are looked at so often that no point goes farther than a part of ``deep`` in between: a body that a
    hit at its corner has set spinning comes round with the next one. fastest: m that a point may go.
    """
    a, b = pair
    i, j = shapes.bodies[a], shapes.bodies[b]
    look, opened = min(1.0 / LOOKS, PACE * deep / fastest), False
    t, before = 0.0, 0.0
    for _ in range(MOST_LOOKS):
        if t >= 1.0:
            return 1.0
        before, t = t, min(1.0, t + look)
        place_a, place_b = pose_at(bodies, scratch.motion, i, t), pose_at(bodies, scratch.motion, j, t)
        gap = gap_at(shapes, pool, scratch, a, b, place_a, place_b)
        if gap < -deep or (opened and gap <= target):
            return before
        if gap > target + PACE * deep:
            opened = True
            t += (gap - target - PACE * deep) / fastest
    return t


@inner_kernel
def all_slow(bodies, motion):
    """True if no body goes far enough to be stopped, whatever it meets: then no pair need be looked at."""
    for i in range(motion.shape[0]):
        gone = (
            abs(motion[i, state.DX]) + abs(motion[i, state.DY]) + abs(motion[i, state.DA]) * bodies.reaches[i]
        )
        if not gone <= SLOW * THIN * bodies.cores[i]:
            return False
    return True


@inner_kernel
def stop_fast_bodies(bodies, shapes, pool, contacts, scratch, numbers):
    """Cut short the motion of bodies that would pass through others; how many were stopped."""
    motion, fractions, count = scratch.motion, scratch.fractions, contacts.count[0]
    fractions[:] = 1.0
    if all_slow(bodies, motion):
        count = 0
    for p in range(count):
        i, j = contacts.bodies[p, 0], contacts.bodies[p, 1]
        x, y = motion[j, state.DX] - motion[i, state.DX], motion[j, state.DY] - motion[i, state.DY]
        approach = (
            abs(x)
            + abs(y)
            + abs(motion[i, state.DA]) * bodies.reaches[i]
            + abs(motion[j, state.DA]) * bodies.reaches[j]
        )
        cores = bodies.cores[i] + bodies.cores[j]
        if approach <= THIN * cores:
            continue
        a, b = contacts.shapes[p, 0], contacts.shapes[p, 1]
        size = min(shapes.sizes[a], shapes.sizes[b])
        target = min(0.1 * min(numbers.near, 0.25 * size), 0.25 * cores)
        t = meeting_time(bodies, shapes, pool, scratch, (a, b), target, cores)
        if t < 1.0:
            for k in (i, j):
                if bodies.flags[k] & state.DYNAMIC:
                    fractions[k] = min(fractions[k], t)
    return cut_motion(bodies, scratch, fractions, numbers.dt)


@inner_kernel
def cut_motion(bodies, scratch, fractions, dt):
    """Let bodies go only a fraction of their way; how many."""
    motion, pulls, stopped = scratch.motion, scratch.accelerations, 0
    for i in range(fractions.shape[0]):
        t = fractions[i]
        bodies.late[i] = (1.0 - t) * dt
        if t < 1.0:
            stopped += 1
            before = motion[i, state.VX], motion[i, state.VY], motion[i, state.W]
            gone = motion[i, state.DX], motion[i, state.DY], motion[i, state.DA]
            motion[i, state.DX] *= t
            motion[i, state.DY] *= t
            motion[i, state.DA] *= t
            for k in range(3):
                scratch.going[i, k] *= t
            motion[i, state.VX] -= (1.0 - t) * dt * pulls[i, 0]
            motion[i, state.VY] -= (1.0 - t) * dt * pulls[i, 1]
            motion[i, state.W] -= (1.0 - t) * dt * pulls[i, 2]
            if bodies.inverse_masses[i] > 0.0:
                slow_down(bodies, motion, pulls, i, before, gone)
    return stopped


@inner_kernel
def slow_down(bodies, motion, pulls, i, before, gone):
    """Take motion from a body that was stopped, where it has more energy than it would at the step's end.

    What has bounced in the step already would gain by having the forces of the rest of it taken back. before:
    velocity and spin, gone: way and turn at the step's end.
    """
    m, inertia = 1.0 / bodies.inverse_masses[i], 1.0 / bodies.inverse_inertias[i]
    x, y, w = before
    gained = m * (
        (motion[i, state.VX] - x) * (motion[i, state.VX] + x)
        + (motion[i, state.VY] - y) * (motion[i, state.VY] + y)
    )
    gained = 0.5 * (gained + inertia * (motion[i, state.W] - w) * (motion[i, state.W] + w))
    gained -= m * (
        pulls[i, 0] * (motion[i, state.DX] - gone[0]) + pulls[i, 1] * (motion[i, state.DY] - gone[1])
    )
    gained -= inertia * pulls[i, 2] * (motion[i, state.DA] - gone[2])
    if gained <= 0.0:
        return
    x, y, w = motion[i, state.VX], motion[i, state.VY], motion[i, state.W]
    now = 0.5 * (m * (x * x + y * y) + inertia * w * w)
    keep = math.sqrt(max(0.0, 1.0 - gained / now)) if now > 0.0 else 0.0
    motion[i, state.VX], motion[i, state.VY], motion[i, state.W] = keep * x, keep * y, keep * w
