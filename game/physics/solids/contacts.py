"""Contacts kept from step to step: manifolds found, or kept where two have hardly moved; rows for solvers.

A manifold is kept ("recycled") while the two have moved less than a bound against each other: its points
stay fixed to both bodies, and their gap follows to first order. Points are known again by the features that
made them, and begin with the impulses of the last substep (warm start, Catto 2005).
"""

from __future__ import annotations

import math

import numpy as np

from game.compiler.decorator import inner_kernel
from game.physics.kernels.lanes import fetch
from game.physics.solids.arrays import state
from game.physics.solids.collide.discs import collide_polygon_disc, touch_points
from game.physics.solids.collide.hull import Hull
from game.physics.solids.collide.polygons import collide_polygons
from game.physics.solids.collide.segments import collide_segment_disc, collide_segment_polygon
from game.physics.solids.islands import is_moving
from game.physics.solids.rows import add_row, finish_batch, frames_of, limits_of, note_places, start_batches

FETCHED = 8  # pairs ahead, of which the memory is asked for


@inner_kernel
def bring_shape(shapes, pool, scratch, b, place):
    """Corners and normals of shape b to scratch, its body at place (x, y, cosine, sine)."""
    x, y, c, s = place
    start, corners, normals = shapes.starts[b], scratch.corners, scratch.normals
    for k in range(shapes.counts[b]):
        px, py = pool.corners[start + k, 0], pool.corners[start + k, 1]
        corners[k, 0], corners[k, 1] = x + c * px - s * py, y + s * px + c * py
        px, py = pool.normals[start + k, 0], pool.normals[start + k, 1]
        normals[k, 0], normals[k, 1] = c * px - s * py, s * px + c * py


@inner_kernel
def find_manifold(shapes, pool, scratch, a, b, place, near, reach):
    """Points of two shapes, b's body at place (x, y, cosine, sine) in the frame of a's; see collide."""
    bring_shape(shapes, pool, scratch, b, place)
    start_a, kind = np.int64(shapes.starts[a]), shapes.kinds[a]
    ra, rb = shapes.radii[a], shapes.radii[b]
    first = Hull(pool.corners, pool.normals, start_a, np.int64(shapes.counts[a]), ra)
    second = Hull(scratch.corners, scratch.normals, np.int64(0), np.int64(shapes.counts[b]), rb)
    manifold, features = scratch.manifold, scratch.features
    if shapes.kinds[b] == state.DISC:
        x, y = scratch.corners[0, 0], scratch.corners[0, 1]
        features[0] = 0
        if kind == state.DISC:
            cx, cy = pool.corners[start_a, 0], pool.corners[start_a, 1]
            return touch_points(cx, cy, ra, x, y, rb, near, manifold)
        if kind == state.SEGMENT:
            return collide_segment_disc(pool.corners, start_a, x, y, rb, reach, manifold, features)
        return collide_polygon_disc(first, x, y, rb, reach, manifold, features)
    if kind == state.SEGMENT:
        return collide_segment_polygon(pool.corners, start_a, second, reach, manifold, features)
    return collide_polygons(first, second, reach, manifold, features)


@inner_kernel
def keep_manifold(contacts, p, points, place, angle, scratch, slop):
    """Write a manifold that was found; points that were there before keep their impulses."""
    manifold, features, marks, kept = scratch.manifold, scratch.features, contacts.marks, contacts.manifolds
    x, y, c, s = place
    n0, t0, n1, t1 = 0.0, 0.0, 0.0, 0.0
    f0, f1, before = marks[p, state.FEATURE_0], marks[p, state.FEATURE_1], marks[p, state.POINTS]
    if before > 0:
        n0, t0 = (
            kept[p, state.FIRST_POINT + state.NORMAL_IMPULSE],
            kept[p, state.FIRST_POINT + state.TANGENT_IMPULSE],
        )
    if before > 1:
        second = state.FIRST_POINT + state.POINT_WIDTH
        n1, t1 = kept[p, second + state.NORMAL_IMPULSE], kept[p, second + state.TANGENT_IMPULSE]
    kept[p, state.NORMAL_X] = manifold[0] if points > 0 else 0.0  # else the memory holds that of another pair
    kept[p, state.NORMAL_Y] = manifold[1] if points > 0 else 0.0
    deepest = 0.0
    for k in range(points):
        at = state.FIRST_POINT + k * state.POINT_WIDTH
        px, py = manifold[2 + 3 * k], manifold[3 + 3 * k]
        deepest = min(deepest, manifold[4 + 3 * k])
        kept[p, at + state.IN_A_X], kept[p, at + state.IN_A_Y] = px, py
        kept[p, at + state.IN_B_X] = c * (px - x) + s * (py - y)
        kept[p, at + state.IN_B_Y] = c * (py - y) - s * (px - x)
        kept[p, at + state.GAP] = manifold[4 + 3 * k]
        feature = features[k]
        jn, jt = 0.0, 0.0
        if before > 0 and feature == f0:
            jn, jt = n0, t0
        elif before > 1 and feature == f1:
            jn, jt = n1, t1
        kept[p, at + state.NORMAL_IMPULSE], kept[p, at + state.TANGENT_IMPULSE] = jn, jt
        marks[p, state.FEATURE_0 + k] = feature
    if points == 0:
        kept[p, state.FIRST_POINT + state.GAP] = manifold[8]
    if marks[p, state.FOUND] == 0 and deepest < -slop:
        marks[p, state.GIVEN] = 1
    elif deepest > -slop:
        marks[p, state.GIVEN] = 0
    marks[p, state.POINTS] = points
    marks[p, state.FOUND] = 1
    kept[p, state.PLACE_X], kept[p, state.PLACE_Y], kept[p, state.PLACE_ANGLE] = x, y, angle


@inner_kernel(inline="always")
def update_pair(bodies, shapes, pool, contacts, p, scratch, numbers):
    """Bring the manifold of a pair up to date; its number of points."""
    # inline, and left at its end only: by calls with so many arrays a third of a step would go
    a, b = np.uint64(contacts.shapes[p, 0]), np.uint64(contacts.shapes[p, 1])
    i, j = np.uint64(contacts.bodies[p, 0]), np.uint64(contacts.bodies[p, 1])
    motion = scratch.motion
    dx, dy = motion[j, state.DX] - motion[i, state.DX], motion[j, state.DY] - motion[i, state.DY]
    ca, sa = motion[i, state.DC], motion[i, state.DS]
    x, y = ca * dx + sa * dy, ca * dy - sa * dx
    angle = motion[j, state.DA] - motion[i, state.DA]
    size = min(shapes.sizes[a], shapes.sizes[b])
    near = min(numbers.near, 0.25 * size)
    vx, vy = motion[j, state.VX] - motion[i, state.VX], motion[j, state.VY] - motion[i, state.VY]
    speed = math.sqrt(vx * vx + vy * vy) + abs(motion[i, state.W]) * bodies.reaches[i]
    speed += abs(motion[j, state.W]) * bodies.reaches[j]
    reach = near + min(1.5 * numbers.dt * speed, 0.5 * size)
    kept, points = contacts.manifolds, contacts.marks[p, state.POINTS]
    moved = abs(x - kept[p, state.PLACE_X]) + abs(y - kept[p, state.PLACE_Y])
    moved += abs(angle - kept[p, state.PLACE_ANGLE]) * bodies.reaches[j]
    keep = contacts.marks[p, state.FOUND] == 1
    if points == 0:
        keep = keep and moved < kept[p, state.FIRST_POINT + state.GAP] - reach
    else:
        keep = keep and shapes.kinds[b] != state.DISC and moved <= numbers.recycle * near
        keep = keep and speed * numbers.dt < near
    if not keep:
        cb, sb = motion[j, state.DC], motion[j, state.DS]
        place = (x, y, ca * cb + sa * sb, ca * sb - sa * cb)
        points = find_manifold(shapes, pool, scratch, a, b, place, near, reach)
        keep_manifold(contacts, p, points, place, angle, scratch, numbers.slop)
    return points


@inner_kernel
def is_computed(bodies, i, j):
    """True if one of two bodies is dynamic and awake, or sleeps while the other one is led against it."""
    flags = bodies.flags
    if (
        flags[i] & (state.DYNAMIC | state.ASLEEP) == state.DYNAMIC
        or flags[j] & (state.DYNAMIC | state.ASLEEP) == state.DYNAMIC
    ):
        return True
    return is_moving(bodies, i) or is_moving(bodies, j)


@inner_kernel
def fetch_manifold(kept, p, lines):
    """Let the first lines of memory of a manifold come, that will be asked for before long."""
    for line in range(lines):
        fetch(kept, p * state.MANIFOLD_WIDTH + line * state.LINE)


@inner_kernel
def update_contacts(bodies, shapes, pool, contacts, rows, scratch, numbers):
    """Manifolds of all pairs, and rows of those that have points."""
    batches, motion = scratch.batches, scratch.motion
    note_places(bodies, motion)
    rows.count[:] = 0
    start_batches(batches)
    count = contacts.count[0]
    for place in range(count):
        fetch_manifold(contacts.manifolds, contacts.order[min(place + FETCHED, count - 1)], 3)
        p = np.uint64(contacts.order[place])
        if not is_computed(bodies, np.uint64(contacts.bodies[p, 0]), np.uint64(contacts.bodies[p, 1])):
            continue
        if update_pair(bodies, shapes, pool, contacts, p, scratch, numbers) > 0:
            add_row(bodies, shapes, contacts, p, rows, batches, motion, numbers)
    finish_batch(frames_of(bodies, motion), contacts.manifolds, batches, limits_of(numbers))
