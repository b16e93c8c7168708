"""Contacts kept from step to step: manifolds found, or kept where two have hardly moved; rows for solvers.

A manifold is kept ("recycled") while the two have moved less than a bound against each other: its points
stay fixed to both bodies, and their gap follows to first order. Points are known again by the features that
made them, and begin with the impulses of the last substep (warm start, Catto 2005).
"""

from __future__ import annotations

import math

import numpy as np

from game.physics.kernels.lean import inner_kernel
from game.physics.solids.collide.discs import collide_polygon_disc, touch_points
from game.physics.solids.collide.hull import Hull
from game.physics.solids.collide.polygons import collide_polygons
from game.physics.solids.collide.segments import collide_segment_disc, collide_segment_polygon
from game.physics.solids.islands import is_moving
from game.physics.solids.state import (
    APPROACH_0,
    ASLEEP,
    COUPLING,
    CROSS_A,
    CROSS_B,
    DISC,
    DOT_A,
    DOT_B,
    DYNAMIC,
    END_A,
    END_B,
    END_PAIR,
    END_POINTS,
    FEATURE_0,
    FEATURE_1,
    FIRST_POINT,
    FOUND,
    GAP,
    GIVEN,
    IN_A_X,
    IN_A_Y,
    IN_B_X,
    IN_B_Y,
    JN,
    JT,
    MASS_T,
    MOST_0,
    MOST_1,
    NORMAL_IMPULSE,
    NORMAL_X,
    NORMAL_Y,
    PLACE_ANGLE,
    PLACE_X,
    PLACE_Y,
    POINT_WIDTH,
    POINTS,
    RESTITUTION,
    ROUND_A,
    ROUND_B,
    ROW_COLD,
    ROW_HARD,
    ROW_IIA,
    ROW_IIB,
    ROW_IMA,
    ROW_IMB,
    ROW_MU,
    ROW_NX,
    ROW_NY,
    ROW_POINT,
    ROW_POINT_WIDTH,
    SEGMENT,
    SEP,
    STIFF_N,
    TANGENT_IMPULSE,
)

COLD = 30.0  # m/s², what closes faster than that in a step hits, it does not rest
MOST_COUPLING = 0.98  # of two points, as part of their own entries of K


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
    if shapes.kinds[b] == DISC:
        x, y = scratch.corners[0, 0], scratch.corners[0, 1]
        features[0] = 0
        if kind == DISC:
            cx, cy = pool.corners[start_a, 0], pool.corners[start_a, 1]
            return touch_points(cx, cy, ra, x, y, rb, near, manifold)
        if kind == SEGMENT:
            return collide_segment_disc(pool.corners, start_a, x, y, rb, reach, manifold, features)
        return collide_polygon_disc(first, x, y, rb, reach, manifold, features)
    if kind == SEGMENT:
        return collide_segment_polygon(pool.corners, start_a, second, reach, manifold, features)
    return collide_polygons(first, second, reach, manifold, features)


@inner_kernel
def keep_manifold(contacts, p, points, place, angle, scratch, slop):
    """Write a manifold that was found; points that were there before keep their impulses."""
    manifold, features, marks, kept = scratch.manifold, scratch.features, contacts.marks, contacts.manifolds
    x, y, c, s = place
    n0, t0, n1, t1 = 0.0, 0.0, 0.0, 0.0
    f0, f1, before = marks[p, FEATURE_0], marks[p, FEATURE_1], marks[p, POINTS]
    if before > 0:
        n0, t0 = kept[p, FIRST_POINT + NORMAL_IMPULSE], kept[p, FIRST_POINT + TANGENT_IMPULSE]
    if before > 1:
        second = FIRST_POINT + POINT_WIDTH
        n1, t1 = kept[p, second + NORMAL_IMPULSE], kept[p, second + TANGENT_IMPULSE]
    kept[p, NORMAL_X] = manifold[0] if points > 0 else 0.0  # else the memory holds that of another pair
    kept[p, NORMAL_Y] = manifold[1] if points > 0 else 0.0
    deepest = 0.0
    for k in range(points):
        at = FIRST_POINT + k * POINT_WIDTH
        px, py = manifold[2 + 3 * k], manifold[3 + 3 * k]
        deepest = min(deepest, manifold[4 + 3 * k])
        kept[p, at + IN_A_X], kept[p, at + IN_A_Y] = px, py
        kept[p, at + IN_B_X] = c * (px - x) + s * (py - y)
        kept[p, at + IN_B_Y] = c * (py - y) - s * (px - x)
        kept[p, at + GAP] = manifold[4 + 3 * k]
        feature = features[k]
        jn, jt = 0.0, 0.0
        if before > 0 and feature == f0:
            jn, jt = n0, t0
        elif before > 1 and feature == f1:
            jn, jt = n1, t1
        kept[p, at + NORMAL_IMPULSE], kept[p, at + TANGENT_IMPULSE] = jn, jt
        marks[p, FEATURE_0 + k] = feature
    if points == 0:
        kept[p, FIRST_POINT + GAP] = manifold[8]
    if marks[p, FOUND] == 0 and deepest < -slop:
        marks[p, GIVEN] = 1
    elif deepest > -slop:
        marks[p, GIVEN] = 0
    marks[p, POINTS] = points
    marks[p, FOUND] = 1
    kept[p, PLACE_X], kept[p, PLACE_Y], kept[p, PLACE_ANGLE] = x, y, angle


@inner_kernel(inline="always")
def update_pair(bodies, shapes, pool, contacts, p, scratch, numbers):
    """Bring the manifold of a pair up to date; its number of points."""
    # inline, and left at its end only: by calls with so many arrays a third of a step would go
    a, b = contacts.shapes[p, 0], contacts.shapes[p, 1]
    i, j = contacts.bodies[p, 0], contacts.bodies[p, 1]
    dx, dy = bodies.positions[j, 0] - bodies.positions[i, 0], bodies.positions[j, 1] - bodies.positions[i, 1]
    ca, sa = bodies.rotations[i, 0], bodies.rotations[i, 1]
    x, y = ca * dx + sa * dy, ca * dy - sa * dx
    angle = bodies.angles[j] - bodies.angles[i]
    size = min(shapes.sizes[a], shapes.sizes[b])
    near = min(numbers.near, 0.25 * size)
    vx = bodies.velocities[j, 0] - bodies.velocities[i, 0]
    vy = bodies.velocities[j, 1] - bodies.velocities[i, 1]
    speed = math.sqrt(vx * vx + vy * vy) + abs(bodies.spins[i]) * bodies.reaches[i]
    speed += abs(bodies.spins[j]) * bodies.reaches[j]
    reach = near + min(1.5 * numbers.dt * speed, 0.5 * size)
    kept, points = contacts.manifolds, contacts.marks[p, POINTS]
    moved = abs(x - kept[p, PLACE_X]) + abs(y - kept[p, PLACE_Y])
    moved += abs(angle - kept[p, PLACE_ANGLE]) * bodies.reaches[j]
    keep = contacts.marks[p, FOUND] == 1
    if points == 0:
        keep = keep and moved < kept[p, FIRST_POINT + GAP] - reach
    else:
        keep = keep and shapes.kinds[b] != DISC and moved <= numbers.recycle * near
        keep = keep and speed * numbers.dt < near
    if not keep:
        cb, sb = bodies.rotations[j, 0], bodies.rotations[j, 1]
        place = (x, y, ca * cb + sa * sb, ca * sb - sa * cb)
        points = find_manifold(shapes, pool, scratch, a, b, place, near, reach)
        keep_manifold(contacts, p, points, place, angle, scratch, numbers.slop)
    return points


@inner_kernel(inline="always")
def write_row(bodies, shapes, contacts, p, rows, c, numbers):
    """Make a solver's row of a pair that has points."""
    i, j = contacts.bodies[p, 0], contacts.bodies[p, 1]
    a, b = contacts.shapes[p, 0], contacts.shapes[p, 1]
    kept, row, rare, ends = contacts.manifolds, rows.rows, rows.rare, rows.ends
    points = contacts.marks[p, POINTS]
    ends[c, END_A], ends[c, END_B], ends[c, END_POINTS], ends[c, END_PAIR] = i, j, points, p
    ima, imb = bodies.inverse_masses[i], bodies.inverse_masses[j]
    iia, iib = bodies.inverse_inertias[i], bodies.inverse_inertias[j]
    ca, sa, cb, sb = (
        bodies.rotations[i, 0],
        bodies.rotations[i, 1],
        bodies.rotations[j, 0],
        bodies.rotations[j, 1],
    )
    lx, ly = kept[p, NORMAL_X], kept[p, NORMAL_Y]
    nx, ny = ca * lx - sa * ly, sa * lx + ca * ly
    row[c, ROW_NX], row[c, ROW_NY] = nx, ny
    row[c, ROW_MU] = numbers.friction * math.sqrt(shapes.frictions[a] * shapes.frictions[b])
    row[c, ROW_HARD] = 1.0 if ima == 0.0 or imb == 0.0 else 0.0
    row[c, ROW_IMA], row[c, ROW_IIA], row[c, ROW_IMB], row[c, ROW_IIB] = ima, iia, imb, iib
    rare[c, MOST_0], rare[c, MOST_1] = 0.0, 0.0  # also of a point that is not there: both are read
    rare[c, RESTITUTION] = max(shapes.restitutions[a], shapes.restitutions[b])
    dx, dy = bodies.positions[j, 0] - bodies.positions[i, 0], bodies.positions[j, 1] - bodies.positions[i, 1]
    vx = bodies.velocities[j, 0] - bodies.velocities[i, 0]
    vy = bodies.velocities[j, 1] - bodies.velocities[i, 1]
    wa, wb = bodies.spins[i], bodies.spins[j]
    rare[c, MOST_1] = 0.0  # also where there is no second point: ends of steps ask for both
    fastest, deepest = 0.0, 0.0
    row[c, ROUND_A], row[c, ROUND_B] = -shapes.radii[a], shapes.radii[b]
    for k in range(points):
        at, to = FIRST_POINT + k * POINT_WIDTH, ROW_POINT + k * ROW_POINT_WIDTH
        px, py, qx, qy = (
            kept[p, at + IN_A_X],
            kept[p, at + IN_A_Y],
            kept[p, at + IN_B_X],
            kept[p, at + IN_B_Y],
        )
        ax, ay = ca * px - sa * py, sa * px + ca * py
        bx, by = dx + cb * qx - sb * qy, dy + sb * qx + cb * qy
        gap = kept[p, at + GAP] + (bx - ax) * nx + (by - ay) * ny
        row[c, to + SEP] = gap
        mx, my = 0.5 * (ax + bx), 0.5 * (ay + by)
        ex, ey = mx - dx, my - dy
        cross_a, cross_b = mx * ny - my * nx, ex * ny - ey * nx
        open_half = 0.5 * max(gap, 0.0)  # what is still apart will meet surface to surface
        dot_a, dot_b = mx * nx + my * ny - open_half, ex * nx + ey * ny + open_half
        row[c, to + CROSS_A], row[c, to + CROSS_B] = cross_a, cross_b
        row[c, to + DOT_A], row[c, to + DOT_B] = dot_a, dot_b
        row[c, to + STIFF_N] = ima + imb + iia * cross_a * cross_a + iib * cross_b * cross_b
        row[c, to + MASS_T] = 1.0 / (ima + imb + iia * dot_a * dot_a + iib * dot_b * dot_b)
        row[c, to + JN], row[c, to + JT] = kept[p, at + NORMAL_IMPULSE], kept[p, at + TANGENT_IMPULSE]
        rare[c, APPROACH_0 + k] = vx * nx + vy * ny + wb * cross_b - wa * cross_a
        fastest, deepest = min(fastest, rare[c, APPROACH_0 + k]), min(deepest, gap)
    violent = fastest < -COLD * numbers.dt or numbers.contact_rate * deepest < -numbers.push
    row[c, ROW_COLD] = 1.0 if violent else 0.0
    if points == 2:
        to = ROW_POINT + ROW_POINT_WIDTH
        crosses = iia * row[c, ROW_POINT + CROSS_A] * row[c, to + CROSS_A]
        crosses += iib * row[c, ROW_POINT + CROSS_B] * row[c, to + CROSS_B]
        # two points that nearly coincide would make K singular: a little less coupling, the same solution
        most = MOST_COUPLING * math.sqrt(row[c, ROW_POINT + STIFF_N] * row[c, to + STIFF_N])
        row[c, COUPLING] = min(most, max(-most, ima + imb + crosses))


@inner_kernel
def is_computed(bodies, i, j):
    """True if one of two bodies is dynamic and awake, or sleeps while the other one is led against it."""
    flags = bodies.flags
    if flags[i] & (DYNAMIC | ASLEEP) == DYNAMIC or flags[j] & (DYNAMIC | ASLEEP) == DYNAMIC:
        return True
    return is_moving(bodies, i) or is_moving(bodies, j)


@inner_kernel
def update_contacts(bodies, shapes, pool, contacts, rows, scratch, numbers):
    """Manifolds of all pairs, and rows of those that have points."""
    made = 0
    for place in range(contacts.count[0]):
        p = contacts.order[place]
        if not is_computed(bodies, contacts.bodies[p, 0], contacts.bodies[p, 1]):
            continue
        if update_pair(bodies, shapes, pool, contacts, p, scratch, numbers) > 0:
            write_row(bodies, shapes, contacts, p, rows, made, numbers)
            made += 1
    rows.count[0] = made
