"""The exact distance of two polygons, naively: every edge against every edge, and one inside the other."""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, kernel

FAR = 1e300


@inner_kernel
def _point_to_edge(px, py, ax, ay, bx, by):
    """Square of the distance of a point to a line segment."""
    ux, uy = bx - ax, by - ay
    along = ux * ux + uy * uy
    share = 0.0
    if along > 0.0:
        share = min(max(((px - ax) * ux + (py - ay) * uy) / along, 0.0), 1.0)
    dx, dy = px - ax - share * ux, py - ay - share * uy
    return dx * dx + dy * dy


@inner_kernel
def _side(ax, ay, bx, by, cx, cy):
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)


@inner_kernel
def place_of(corners, k, pose):
    """A corner in the world; pose: x, y, cosine, sine."""
    x, y = corners[k, 0], corners[k, 1]
    return pose[0] + pose[2] * x - pose[3] * y, pose[1] + pose[3] * x + pose[2] * y


@inner_kernel
def _holds(corners, first, count, pose, px, py):
    """Whether a polygon holds a point: crossings of a ray."""
    odd = False
    ax, ay = place_of(corners, first + count - 1, pose)
    for k in range(count):
        bx, by = place_of(corners, first + k, pose)
        if (ay > py) != (by > py) and px < ax + (py - ay) / (by - ay) * (bx - ax):
            odd = not odd
        ax, ay = bx, by
    return odd


@inner_kernel
def polygon_distance(corners, first_a, count_a, pose_a, first_b, count_b, pose_b):
    """Distance (m) of two filled polygons among corners (k, 2), 0 where they meet."""
    least = FAR
    ax, ay = place_of(corners, first_a + count_a - 1, pose_a)
    for i in range(count_a):
        bx, by = place_of(corners, first_a + i, pose_a)
        cx, cy = place_of(corners, first_b + count_b - 1, pose_b)
        for j in range(count_b):
            dx, dy = place_of(corners, first_b + j, pose_b)
            c_side, d_side = _side(ax, ay, bx, by, cx, cy), _side(ax, ay, bx, by, dx, dy)
            a_side, b_side = _side(cx, cy, dx, dy, ax, ay), _side(cx, cy, dx, dy, bx, by)
            if (c_side > 0.0) != (d_side > 0.0) and (a_side > 0.0) != (b_side > 0.0):
                least = 0.0
            least = min(least, _point_to_edge(bx, by, cx, cy, dx, dy))
            least = min(least, _point_to_edge(dx, dy, ax, ay, bx, by))
            cx, cy = dx, dy
        ax, ay = bx, by
    if least > 0.0:
        ax, ay = place_of(corners, first_a, pose_a)
        cx, cy = place_of(corners, first_b, pose_b)
        if _holds(corners, first_b, count_b, pose_b, ax, ay) or _holds(
            corners, first_a, count_a, pose_a, cx, cy
        ):
            least = 0.0
    return math.sqrt(least)


@kernel
def exact_distance(corners, spans, a, b, poses):
    """Distance of bodies a and b; spans: (bodies, 2) first corner and how many; poses: (bodies, 4)."""
    return polygon_distance(corners, spans[a, 0], spans[a, 1], poses[a], spans[b, 0], spans[b, 1], poses[b])
