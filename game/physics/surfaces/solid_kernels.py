"""Distance, normal and velocity of the nearest shape of a world of solids, for many points."""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.kernels import elementary
from game.physics.solids.arrays.state import NONE, SEGMENT


@inner_kernel
def to_polygon(corners, normals, start, count, x, y):
    """Signed distance of (x, y) from a polygon's core, and its outward direction (negative inside)."""
    best, edge = -math.inf, 0
    for i in range(count):
        k = start + i
        gap = normals[k, 0] * (x - corners[k, 0]) + normals[k, 1] * (y - corners[k, 1])
        if gap > best:
            best, edge = gap, i
    if best <= 0.0 and count > 2:
        return best, normals[start + edge, 0], normals[start + edge, 1]
    least, nx, ny = math.inf, 0.0, 1.0
    for i in range(count):
        k, m = start + i, start + (i + 1 if i + 1 < count else 0)
        d, ux, uy = to_segment(corners[k, 0], corners[k, 1], corners[m, 0], corners[m, 1], x, y)
        if d < least:
            least, nx, ny = d, ux, uy
            if d == 0.0:
                nx, ny = normals[k, 0], normals[k, 1]
    return least, nx, ny


@inner_kernel
def to_segment(px, py, qx, qy, x, y):
    """Distance of (x, y) from a segment, and the direction there (zero on the segment)."""
    dx, dy = qx - px, qy - py
    square = dx * dx + dy * dy
    part = min(1.0, max(0.0, ((x - px) * dx + (y - py) * dy) / square)) if square > 0.0 else 0.0
    ux, uy = x - px - part * dx, y - py - part * dy
    distance = math.sqrt(ux * ux + uy * uy)
    if distance > 0.0:
        return distance, ux / distance, uy / distance
    return 0.0, 0.0, 0.0


@inner_kernel
def to_shape(shapes, pool, s, x, y):
    """Signed distance of (x, y), in the frame of the body, and outward direction. Chains are thin: both
    sides.
    """
    start, count = shapes.starts[s], shapes.counts[s]
    if shapes.kinds[s] == SEGMENT:
        px, py = pool.corners[start + 1, 0], pool.corners[start + 1, 1]
        qx, qy = pool.corners[start + 2, 0], pool.corners[start + 2, 1]
        d, ux, uy = to_segment(px, py, qx, qy, x, y)
        nx, ny = pool.normals[start + 1, 0], pool.normals[start + 1, 1]
        if d == 0.0:
            return 0.0, nx, ny
        side = (x - px) * nx + (y - py) * ny
        along = (x - px) * ny - (y - py) * nx
        length = (qx - px) * ny - (qy - py) * nx
        if side < 0.0 and 0.0 <= along <= length:
            return -d, nx, ny
        return d, ux, uy
    d, nx, ny = to_polygon(pool.corners, pool.normals, start, count, x, y)
    return d - shapes.radii[s], nx, ny


@lean_kernel
def sample_solids(points, bodies, shapes, pool, distance, normal, velocity, friction, nearest):
    """Write distance (n,), normal (n, 2), velocity (n, 2), friction (n,) and body (n,) of the nearest
    shapes.
    """
    for m in range(points.shape[0]):
        distance[m], friction[m], nearest[m] = math.inf, 0.0, -1
        normal[m, 0], normal[m, 1], velocity[m, 0], velocity[m, 1] = 0.0, 0.0, 0.0, 0.0
    for s in range(shapes.kinds.shape[0]):
        if shapes.kinds[s] == NONE:
            continue
        i = shapes.bodies[s]
        c, sine = bodies.rotations[i, 0], bodies.rotations[i, 1]
        for m in range(points.shape[0]):
            x, y = points[m, 0] - bodies.positions[i, 0], points[m, 1] - bodies.positions[i, 1]
            reach = bodies.reaches[i]
            if x * x + y * y > elementary.square(reach + abs(distance[m])) and distance[m] < math.inf:
                continue
            d, nx, ny = to_shape(shapes, pool, s, c * x + sine * y, c * y - sine * x)
            if d < distance[m]:
                distance[m], friction[m], nearest[m] = d, shapes.frictions[s], i
                normal[m, 0], normal[m, 1] = c * nx - sine * ny, sine * nx + c * ny
                velocity[m, 0] = bodies.velocities[i, 0] - bodies.spins[i] * y
                velocity[m, 1] = bodies.velocities[i, 1] + bodies.spins[i] * x
