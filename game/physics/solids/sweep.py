"""Continuous collision: what moves farther in a step than it is thick is stopped where it meets something.

Conservative advancement (Mirtich 1996; van den Bergen 2004) along the straight, evenly turning path of the
step: as long as two are apart by a distance, they may go on for that distance over their fastest approach. Of
all its meetings a body stops at the earliest; the next step finds the contact. What forces gave it for the
rest of the step is taken back, so that nothing gains energy by being stopped.
"""

from __future__ import annotations

import math

from game.physics.kernels.lean import inner_kernel
from game.physics.solids.collide.polygons import widest_gap
from game.physics.solids.state import DA, DISC, DX, DY, DYNAMIC, SEGMENT, VX, VY, W

MOST_ADVANCES = 64
THIN = 0.5  # of both cores together: how far two may approach in a step and be left to the contacts


@inner_kernel
def pose_at(bodies, motion, i, t):
    """Place, cosine and sine of a body at the fraction t of the step."""
    turned = motion[i, DA] * t
    c, s = bodies.rotations[i, 0], bodies.rotations[i, 1]
    if turned != 0.0:
        dc, ds = math.cos(turned), math.sin(turned)
        c, s = c * dc - s * ds, s * dc + c * ds
    return bodies.positions[i, 0] + t * motion[i, DX], bodies.positions[i, 1] + t * motion[i, DY], c, s


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
    start_a, start_b = shapes.starts[a], shapes.starts[b]
    count_a, count_b = shapes.counts[a], shapes.counts[b]
    corners, normals = scratch.corners, scratch.normals
    for k in range(count_b):
        px, py = pool.corners[start_b + k, 0], pool.corners[start_b + k, 1]
        corners[k, 0], corners[k, 1] = x + c * px - s * py, y + s * px + c * py
        px, py = pool.normals[start_b + k, 0], pool.normals[start_b + k, 1]
        normals[k, 0], normals[k, 1] = c * px - s * py, s * px + c * py
    rounding = shapes.radii[a] + shapes.radii[b]
    if shapes.kinds[a] == DISC:
        px, py = corners[0, 0] - pool.corners[start_a, 0], corners[0, 1] - pool.corners[start_a, 1]
        return math.sqrt(px * px + py * py) - rounding
    if shapes.kinds[a] == SEGMENT:
        start_a, count_a = start_a + 1, 1
    best, _ = widest_gap(pool.corners, pool.normals, start_a, count_a, corners, 0, count_b)
    if shapes.kinds[a] == SEGMENT:
        best = max(best, beyond_ends(pool.corners, start_a, corners, count_b))
        count_a = 2
    if shapes.kinds[b] == DISC:
        return best - rounding
    other, _ = widest_gap(corners, normals, 0, count_b, pool.corners, start_a, count_a)
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
def meeting_time(bodies, shapes, pool, scratch, a, b, target):
    """Fraction of the step after which two shapes are ``target`` (m) apart; 1 if they do not meet, or
    touch.
    """
    motion, i, j = scratch.motion, shapes.bodies[a], shapes.bodies[b]
    x, y = motion[j, DX] - motion[i, DX], motion[j, DY] - motion[i, DY]
    fastest = math.sqrt(x * x + y * y)
    fastest += abs(motion[i, DA]) * bodies.reaches[i] + abs(motion[j, DA]) * bodies.reaches[j]
    t = 0.0
    for _ in range(MOST_ADVANCES):
        gap = gap_at(
            shapes, pool, scratch, a, b, pose_at(bodies, motion, i, t), pose_at(bodies, motion, j, t)
        )
        if t == 0.0 and gap <= 1.1 * target:
            return 1.0
        if gap <= 1.1 * target:
            return t
        t += (gap - target) / fastest
        if t >= 1.0:
            return 1.0
    return t


@inner_kernel
def stop_fast_bodies(bodies, shapes, pool, contacts, scratch, numbers):
    """Cut short the motion of bodies that would pass through others; how many were stopped."""
    motion, fractions = scratch.motion, scratch.fractions
    fractions[:] = 1.0
    for p in range(contacts.count[0]):
        i, j = contacts.bodies[p, 0], contacts.bodies[p, 1]
        x, y = motion[j, DX] - motion[i, DX], motion[j, DY] - motion[i, DY]
        approach = (
            abs(x) + abs(y) + abs(motion[i, DA]) * bodies.reaches[i] + abs(motion[j, DA]) * bodies.reaches[j]
        )
        cores = bodies.cores[i] + bodies.cores[j]
        if approach <= THIN * cores:
            continue
        a, b = contacts.shapes[p, 0], contacts.shapes[p, 1]
        size = min(shapes.sizes[a], shapes.sizes[b])
        target = min(0.1 * min(numbers.near, 0.25 * size), 0.25 * cores)
        t = meeting_time(bodies, shapes, pool, scratch, a, b, target)
        if t < 1.0:
            for k in (i, j):
                if bodies.flags[k] & DYNAMIC:
                    fractions[k] = min(fractions[k], t)
    return cut_motion(bodies, motion, scratch.accelerations, fractions, numbers.dt)


@inner_kernel
def cut_motion(bodies, motion, pulls, fractions, dt):
    """Let bodies go only a fraction of their way; how many."""
    stopped = 0
    for i in range(fractions.shape[0]):
        t = fractions[i]
        bodies.late[i] = (1.0 - t) * dt
        if t < 1.0:
            stopped += 1
            motion[i, DX] *= t
            motion[i, DY] *= t
            motion[i, DA] *= t
            motion[i, VX] -= (1.0 - t) * dt * pulls[i, 0]
            motion[i, VY] -= (1.0 - t) * dt * pulls[i, 1]
            motion[i, W] -= (1.0 - t) * dt * pulls[i, 2]
    return stopped
