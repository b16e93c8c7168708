"""Two convex polygons with rounding (capsules are polygons of two corners): separating axes, then clipping.

The face of least overlap is the reference; the face of the other one that looks against it is clipped to its
width (Gottschalk, Lin, Manocha 1996; two points and feature ids as in Catto, "Box2D", 2007 and 2023). Cores
that are apart and nearest at two corners touch in one point.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel
from game.physics.kernels import elementary
from game.physics.solids.collide.discs import touch_points

SQUARE = -0.998  # cosine of the angle between normals of faces that look at each other squarely
SLIVER = 0.005  # of the shorter of two faces: what overlaps by less along them has not met face to face


@inner_kernel
def widest_gap(first, second):
    """The face of the first hull that the second's core is farthest out of: (distance, face)."""
    c1, n1, start1, count1, _ = first
    c2, _, start2, count2, _ = second
    best, face = -math.inf, 0
    for i in range(count1):
        k = start1 + i
        nx, ny, x, y = n1[k, 0], n1[k, 1], c1[k, 0], c1[k, 1]
        deepest = math.inf
        for j in range(count2):
            gap = nx * (c2[start2 + j, 0] - x) + ny * (c2[start2 + j, 1] - y)
            if gap < deepest:
                deepest = gap
        if deepest > best:
            best, face = deepest, i
    return best, face


@inner_kernel
def facing(hull, nx, ny):
    """The face whose normal looks most against (nx, ny)."""
    normals, start, count = hull.normals, hull.start, hull.size
    least, face = math.inf, 0
    for i in range(count):
        dot = normals[start + i, 0] * nx + normals[start + i, 1] * ny
        if dot < least:
            least, face = dot, i
    return face


@inner_kernel
def nearest_on_segments(p1, q1, p2, q2):
    """Nearest points of two segments: (fraction of the first, of the second)."""
    d1x, d1y, d2x, d2y = q1[0] - p1[0], q1[1] - p1[1], q2[0] - p2[0], q2[1] - p2[1]
    rx, ry = p1[0] - p2[0], p1[1] - p2[1]
    d11, d22, d12 = d1x * d1x + d1y * d1y, d2x * d2x + d2y * d2y, d1x * d2x + d1y * d2y
    r1, r2 = rx * d1x + ry * d1y, rx * d2x + ry * d2y
    under = d11 * d22 - d12 * d12
    f1 = 0.0
    if under > 1e-12 * d11 * d22:
        f1 = min(1.0, max(0.0, (d12 * r2 - r1 * d22) / under))
    f2 = (d12 * f1 + r2) / d22
    if f2 < 0.0:
        f2, f1 = 0.0, min(1.0, max(0.0, -r1 / d11))
    elif f2 > 1.0:
        f2, f1 = 1.0, min(1.0, max(0.0, (d12 - r1) / d11))
    return f1, f2


@inner_kernel
def clip_faces(p1, q1, p2, q2, normal, radii, reach, manifold):
    """Points between a reference face p1 q1 with this normal and the face p2 q2 that looks against it.

    The lower one belongs to p1 and q2, the upper one to q1 and p2; in manifold they stand in this order, from
    its entry 2. Returns two bits: lower, upper.
    """
    nx, ny = normal
    tx, ty = -ny, nx
    r1, r2 = radii
    width = (q1[0] - p1[0]) * tx + (q1[1] - p1[1]) * ty
    upper = (p2[0] - p1[0]) * tx + (p2[1] - p1[1]) * ty
    lower = (q2[0] - p1[0]) * tx + (q2[1] - p1[1]) * ty
    span = upper - lower
    lx, ly, ux, uy = q2[0], q2[1], p2[0], p2[1]
    tiny = 1e-12 * width
    if lower < 0.0 and span > tiny:
        part = min(1.0, -lower / span)
        lx, ly = q2[0] + part * (p2[0] - q2[0]), q2[1] + part * (p2[1] - q2[1])
    if upper > width and span > tiny:
        part = max(0.0, (width - lower) / span)
        ux, uy = q2[0] + part * (p2[0] - q2[0]), q2[1] + part * (p2[1] - q2[1])
    low = (lx - p1[0]) * nx + (ly - p1[1]) * ny
    high = (ux - p1[0]) * nx + (uy - p1[1]) * ny
    half = 0.5 * (r1 - r2 - low)
    manifold[2], manifold[3], manifold[4] = lx + half * nx, ly + half * ny, low - r1 - r2
    half = 0.5 * (r1 - r2 - high)
    manifold[5], manifold[6], manifold[7] = ux + half * nx, uy + half * ny, high - r1 - r2
    return (1 if low - r1 - r2 <= reach else 0) | (2 if high - r1 - r2 <= reach else 0)


@inner_kernel
def keep_points(bits, lower_feature, upper_feature, manifold, features):
    """Leave the points of the bits, in order; how many."""
    if bits == 2:
        manifold[2], manifold[3], manifold[4] = manifold[5], manifold[6], manifold[7]
        features[0] = upper_feature
        return 1
    features[0], features[1] = lower_feature, upper_feature
    return 2 if bits == 3 else bits


@inner_kernel
def next_corner(hull, i):
    """The corner at which the face i ends."""
    return i + 1 if i + 1 < hull.size else i + 1 - hull.size


@inner_kernel
def ends_of(hull, i):
    """Both ends of the face i."""
    k, m = hull.start + i, hull.start + next_corner(hull, i)
    return (hull.corners[k, 0], hull.corners[k, 1]), (hull.corners[m, 0], hull.corners[m, 1])


@inner_kernel
def normal_of(hull, i):
    """Outward normal of the face i."""
    return hull.normals[hull.start + i, 0], hull.normals[hull.start + i, 1]


@inner_kernel
def clip_chosen(first, second, faces, flip, reach, manifold, features):
    """Clip the faces (i, j) that look at each other; flip: the second's is the one that clips.

    Returns points and how far they spread, as part of the shorter face.
    """
    i, j = faces
    i_next, j_next = next_corner(first, i), next_corner(second, j)
    p1, q1 = ends_of(first, i)
    p2, q2 = ends_of(second, j)
    ra, rb = first.radius, second.radius
    if flip:
        nx, ny = normal_of(second, j)
        manifold[0], manifold[1] = -nx, -ny
        bits = clip_faces(p2, q2, p1, q1, (nx, ny), (rb, ra), reach, manifold)
        lower, upper = i_next << 8 | j, i << 8 | j_next
    else:
        nx, ny = normal_of(first, i)
        manifold[0], manifold[1] = nx, ny
        bits = clip_faces(p1, q1, p2, q2, (nx, ny), (ra, rb), reach, manifold)
        lower, upper = i << 8 | j_next, i_next << 8 | j
    spread = abs((manifold[5] - manifold[2]) * ny - (manifold[6] - manifold[3]) * nx)
    spread /= min(
        elementary.hypot(q1[0] - p1[0], q1[1] - p1[1]), elementary.hypot(q2[0] - p2[0], q2[1] - p2[1])
    )
    return keep_points(bits, lower, upper, manifold, features), spread


@inner_kernel
def faces_graze(first, second, faces, normal):
    """True if two faces that look at each other squarely pass or overlap only by a sliver of the shorter."""
    (nx, ny), (ax, ay), (bx, by) = normal, normal_of(first, faces[0]), normal_of(second, faces[1])
    if ax * bx + ay * by > SQUARE:
        return False
    p1, q1 = ends_of(first, faces[0])
    p2, q2 = ends_of(second, faces[1])
    a, b = p1[1] * nx - p1[0] * ny, q1[1] * nx - q1[0] * ny
    c, d = p2[1] * nx - p2[0] * ny, q2[1] * nx - q2[0] * ny
    shared = min(max(a, b), max(c, d)) - max(min(a, b), min(c, d))
    lengths = elementary.hypot(q1[0] - p1[0], q1[1] - p1[1]), elementary.hypot(q2[0] - p2[0], q2[1] - p2[1])
    return abs(shared) < SLIVER * min(lengths[0], lengths[1])


@inner_kernel
def meets_at_corners(first, second, faces, reach, manifold, features):
    """Cores that are apart: points (0 or 1) if they are nearest at two corners, else -1. faces: i, j."""
    i, j = faces
    i_next, j_next = next_corner(first, i), next_corner(second, j)
    p1, q1 = ends_of(first, i)
    p2, q2 = ends_of(second, j)
    f1, f2 = nearest_on_segments(p1, q1, p2, q2)
    if not ((f1 == 0.0 or f1 == 1.0) and (f2 == 0.0 or f2 == 1.0)):
        return -1
    a, b = (p1 if f1 == 0.0 else q1), (p2 if f2 == 0.0 else q2)
    features[0] = (i if f1 == 0.0 else i_next) << 8 | (j if f2 == 0.0 else j_next)
    return touch_points(a[0], a[1], first.radius, b[0], b[1], second.radius, reach, manifold)


@inner_kernel
def collide_polygons(first, second, reach, manifold, features):
    """Manifold of two hulls whose corners and normals are in one frame. See the package for the rest.

    Where they meet in a sliver, corner beside corner, there is no telling which face it is, and none answers
    until they overlap by more: so boxes pass over the gaps of tiles of equal height, though they sag.
    """
    rounding = first.radius + second.radius
    gap1, i = widest_gap(first, second)
    manifold[8] = gap1 - rounding
    if gap1 > reach + rounding:
        return 0
    gap2, j = widest_gap(second, first)
    manifold[8] = max(gap1, gap2) - rounding
    if gap2 > reach + rounding:
        return 0
    flip = gap2 > gap1 + 0.02 * reach  # the first one's face is kept where both are nearly as good
    if flip:
        nx, ny = normal_of(second, j)
        i = facing(first, nx, ny)
    else:
        nx, ny = normal_of(first, i)
        j = facing(second, nx, ny)
    if faces_graze(first, second, (i, j), (nx, ny)):
        manifold[8] = -1.0  # nothing yet, but look again in the next step
        return 0
    if max(gap1, gap2) > 0.02 * reach:
        points = meets_at_corners(first, second, (i, j), reach, manifold, features)
        if points >= 0:
            return points
    points, spread = clip_chosen(first, second, (i, j), flip, reach, manifold, features)
    if points < 2 or spread > SLIVER:
        return points
    manifold[8] = -1.0  # nothing yet, but look again in the next step
    return 0
