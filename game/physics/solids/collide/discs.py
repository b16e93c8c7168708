"""Disc against disc, polygon and capsule: one point."""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel

ALONG = 1e-9  # of the radii: closer centres have no direction


@inner_kernel
def touch_points(ax, ay, ra, bx, by, rb, reach, manifold):
    """One point between two rounded points a and b; 1 or 0."""
    x, y = bx - ax, by - ay
    distance = math.sqrt(x * x + y * y)
    gap = distance - ra - rb
    manifold[8] = gap
    if gap > reach:
        return 0
    if distance > ALONG * (ra + rb) and distance > 0.0:
        x, y = x / distance, y / distance
    else:
        x, y = 0.0, 1.0
    half = 0.5 * (ra + distance - rb)
    manifold[0], manifold[1] = x, y
    manifold[2], manifold[3], manifold[4] = ax + half * x, ay + half * y, gap
    return 1


@inner_kernel
def collide_polygon_disc(hull, x, y, rb, reach, manifold, features):
    """Polygon or capsule and a disc at (x, y) of radius rb."""
    corners, normals, start, count, ra = hull
    best, edge = -math.inf, 0
    for i in range(count):
        k = start + i
        gap = normals[k, 0] * (x - corners[k, 0]) + normals[k, 1] * (y - corners[k, 1])
        if gap > best:
            best, edge = gap, i
    manifold[8] = best - ra - rb
    if best > reach + ra + rb:
        return 0
    i, j = start + edge, start + (edge + 1 if edge + 1 < count else 0)
    px, py, qx, qy = corners[i, 0], corners[i, 1], corners[j, 0], corners[j, 1]
    u = (x - px) * (qx - px) + (y - py) * (qy - py)
    v = (x - qx) * (px - qx) + (y - qy) * (py - qy)
    if best > 0.0 and u <= 0.0:
        features[0] = 2 * edge
        return touch_points(px, py, ra, x, y, rb, reach, manifold)
    if best > 0.0 and v <= 0.0:
        features[0] = 2 * (j - start)
        return touch_points(qx, qy, ra, x, y, rb, reach, manifold)
    nx, ny = normals[i, 0], normals[i, 1]
    half = 0.5 * (ra - best - rb)
    features[0] = 2 * edge + 1
    manifold[0], manifold[1] = nx, ny
    manifold[2], manifold[3], manifold[4] = x + half * nx, y + half * ny, best - ra - rb
    return 1
