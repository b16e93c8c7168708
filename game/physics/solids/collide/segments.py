"""Segments of chains, one-sided: discs and polygons slide over where segments meet without noticing.

A segment knows the ends of its neighbours ("ghosts"; Box2D, Catto 2013). It answers only for directions that
belong to it: its own normal, and at its first corner those between the normal of the segment before and
its own,
if the chain turns away there. What presses from elsewhere belongs to a neighbour. A ghost that lies on the
end itself marks the end of an open chain, which answers for all directions.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel
from game.physics.solids.collide.discs import touch_points
from game.physics.solids.collide.polygons import clip_faces, facing, keep_points, nearest_on_segments

LEVEL = 1e-9  # sine of an angle that is none


@inner_kernel
def segment_at(corners, start):
    """Ends, unit direction and length of a segment: px, py, qx, qy, ex, ey, length."""
    px, py, qx, qy = (
        corners[start + 1, 0],
        corners[start + 1, 1],
        corners[start + 2, 0],
        corners[start + 2, 1],
    )
    ex, ey = qx - px, qy - py
    length = math.sqrt(ex * ex + ey * ey)
    return px, py, qx, qy, ex / length, ey / length, length


@inner_kernel
def owns_first(corners, start, mx, my):
    """True if a push along (mx, my) on the first corner is this segment's: not the one before's."""
    dx = corners[start + 1, 0] - corners[start, 0]
    dy = corners[start + 1, 1] - corners[start, 1]
    length = math.sqrt(dx * dx + dy * dy)
    return length == 0.0 or mx * dx + my * dy > LEVEL * length


@inner_kernel
def is_open_end(corners, start):
    """True if nothing follows the second corner."""
    return corners[start + 3, 0] == corners[start + 2, 0] and corners[start + 3, 1] == corners[start + 2, 1]


@inner_kernel
def collide_segment_disc(corners, start, x, y, rb, reach, manifold, features):
    """Segment and disc at (x, y) of radius rb: a point on its face, or at a corner that is its own."""
    px, py, qx, qy, ex, ey, length = segment_at(corners, start)
    along = (x - px) * ex + (y - py) * ey
    height = (y - py) * ex - (x - px) * ey
    manifold[8] = abs(height) - rb
    if height < 0.0 or height > reach + rb:
        return 0
    features[0] = 0
    if along < 0.0:
        features[0] = 1
        if not owns_first(corners, start, x - px, y - py):
            return 0
        return touch_points(px, py, 0.0, x, y, rb, reach, manifold)
    if along > length:
        features[0] = 2
        if not is_open_end(corners, start):
            return 0
        return touch_points(qx, qy, 0.0, x, y, rb, reach, manifold)
    half = 0.5 * (height - rb)
    manifold[0], manifold[1] = -ey, ex
    manifold[2], manifold[3] = px + along * ex - half * ey, py + along * ey + half * ex
    manifold[4] = height - rb
    return 1


@inner_kernel
def lowest(c2, count2, px, py, nx, ny):
    """Least height of a polygon above the line through p with normal n, and the height of its middle."""
    low, middle = math.inf, 0.0
    for k in range(count2):
        height = (c2[k, 0] - px) * nx + (c2[k, 1] - py) * ny
        low = min(low, height)
        middle += height
    return low, middle / count2


@inner_kernel
def farthest_face(c2, n2, count2, p, q):
    """The polygon's face that the segment is farthest out of: (distance, face)."""
    best, face = -math.inf, 0
    for k in range(count2):
        nx, ny, x, y = n2[k, 0], n2[k, 1], c2[k, 0], c2[k, 1]
        gap = min((p[0] - x) * nx + (p[1] - y) * ny, (q[0] - x) * nx + (q[1] - y) * ny)
        if gap > best:
            best, face = gap, k
    return best, face


@inner_kernel
def direction_verdict(corners, start, ex, ey, mx, my):
    """What a push along m from the segment is: 1 its own, 0 a neighbour's, -1 to be turned into its
    normal.
    """
    if mx * ex + my * ey <= 0.0:
        dx = corners[start + 1, 0] - corners[start, 0]
        dy = corners[start + 1, 1] - corners[start, 1]
        length = math.sqrt(dx * dx + dy * dy)
        if length == 0.0:
            return 1
        if dx * ey - dy * ex > -LEVEL * length:  # level, or turning towards what comes
            return -1
        return 1 if mx * dx + my * dy > LEVEL * length else 0
    if is_open_end(corners, start):
        return 1
    dx = corners[start + 3, 0] - corners[start + 2, 0]
    dy = corners[start + 3, 1] - corners[start + 2, 1]
    if ex * dy - ey * dx > -LEVEL * math.sqrt(dx * dx + dy * dy):
        return -1
    return 0


@inner_kernel
def collide_segment_polygon(corners, start, hull, reach, manifold, features):
    """Segment and polygon in the same frame (its hull begins at corner 0): up to two points."""
    c2, n2, count2, rb = hull.corners, hull.normals, hull.size, hull.radius
    px, py, qx, qy, ex, ey, length = segment_at(corners, start)
    nx, ny, p, q = -ey, ex, (px, py), (qx, qy)
    low, middle = lowest(c2, count2, px, py, nx, ny)
    best, face = farthest_face(c2, n2, count2, p, q)
    manifold[8] = max(low, best) - rb
    if middle < 0.0 or manifold[8] > reach:
        return 0
    by_face = best > low + 0.02 * reach
    if max(low, best) > 0.02 * reach:
        j = face if by_face else facing(hull, nx, ny)
        k = j + 1 if j + 1 < count2 else 0
        f1, f2 = nearest_on_segments(p, q, (c2[j, 0], c2[j, 1]), (c2[k, 0], c2[k, 1]))
        if f1 == 0.0 or f1 == 1.0:
            x, y = c2[j, 0] + f2 * (c2[k, 0] - c2[j, 0]), c2[j, 1] + f2 * (c2[k, 1] - c2[j, 1])
            cx, cy = (px, py) if f1 == 0.0 else (qx, qy)
            mx, my = x - cx, y - cy
            along, size = mx * ex + my * ey, math.sqrt(mx * mx + my * my)
            if abs(along) > 1e-6 * size:
                owned = owns_first(corners, start, mx, my) if f1 == 0.0 else is_open_end(corners, start)
                if not owned or mx * nx + my * ny < 0.0:
                    return 0
                features[0] = 1 << 16 | (1 if f1 == 0.0 else 2) << 8 | (j if f2 < 0.5 else k)
                return touch_points(cx, cy, 0.0, x, y, rb, reach, manifold)
    if by_face:
        verdict = direction_verdict(corners, start, ex, ey, -n2[face, 0], -n2[face, 1])
        if verdict == 0:
            return 0
        by_face = verdict == 1
    if by_face:
        k = face + 1 if face + 1 < count2 else 0
        p2, q2 = (c2[face, 0], c2[face, 1]), (c2[k, 0], c2[k, 1])
        mx, my = n2[face, 0], n2[face, 1]
        manifold[0], manifold[1] = -mx, -my
        bits = clip_faces(p2, q2, q, p, (mx, my), (rb, 0.0), reach, manifold)
        return keep_points(bits, 2 << 16 | face, 2 << 16 | 1 << 8 | face, manifold, features)
    j = facing(hull, nx, ny)
    k = j + 1 if j + 1 < count2 else 0
    first = (c2[j, 0] - px) * ex + (c2[j, 1] - py) * ey
    second = (c2[k, 0] - px) * ex + (c2[k, 1] - py) * ey
    if max(first, second) < 0.0 or min(first, second) > length:
        return 0
    manifold[0], manifold[1] = nx, ny
    bits = clip_faces(q, p, (c2[j, 0], c2[j, 1]), (c2[k, 0], c2[k, 1]), (nx, ny), (0.0, rb), reach, manifold)
    return keep_points(bits, k, j, manifold, features)
