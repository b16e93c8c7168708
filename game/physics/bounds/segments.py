"""Two segments: do they meet, exactly; how far are they apart.

Orientation: Shewchuk 1997, "Adaptive precision floating-point arithmetic and fast robust geometric
predicates": a filter, and where it fails a sum without any rounding. Distance: Ericson, Real-Time Collision
Detection (2005), 5.1.9, but by end points, which has no 0/0 for parallel segments.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from game.compiler.decorator import lean_kernel
from game.physics.bounds.validation import as_points

FILTER = (3.0 + 16.0 * 2.0**-53) * 2.0**-53  # relative error of the rounded determinant
SPLITTER = 2.0**27 + 1.0
SCRATCH = 16  # numbers that an exact sum takes


@lean_kernel
def orientation(ax, ay, bx, by, cx, cy, scratch):
    """1.0, 0.0 or -1.0: c lies left of the line from a to b, on it, right of it.

    Exact for coordinates that are 0 or between 1e-140 and 1e140 m: no product underflows.

    ``scratch`` (16,): overwritten where rounding could decide.
    """
    left = (ax - cx) * (by - cy)
    right = (ay - cy) * (bx - cx)
    determinant = left - right
    if abs(determinant) <= FILTER * (abs(left) + abs(right)):
        determinant = exact_orientation(ax, ay, bx, by, cx, cy, scratch)
    return 1.0 if determinant > 0.0 else -1.0 if determinant < 0.0 else 0.0


@lean_kernel
def exact_orientation(ax, ay, bx, by, cx, cy, parts):
    """A number of the sign of the determinant: six products and their errors, summed without rounding.

    Products are split in two (Dekker 1971), and grow an expansion one by one (Shewchuk's grow-expansion).
    ``parts`` (16,): overwritten.
    """
    count = 0
    p, q = ax, by
    for k in range(6):
        if k == 1:
            p, q = -ax, cy
        elif k == 2:
            p, q = -cx, by
        elif k == 3:
            p, q = -ay, bx
        elif k == 4:
            p, q = ay, cx
        elif k == 5:
            p, q = cy, bx
        product = p * q
        spread = SPLITTER * p
        p_high = spread - (spread - p)
        p_low = p - p_high
        spread = SPLITTER * q
        q_high = spread - (spread - q)
        q_low = q - q_high
        rest = p_low * q_low - (((product - p_high * q_high) - p_low * q_high) - p_high * q_low)
        for half in range(2):
            if half == 1:
                rest = product
            for i in range(count):
                total = rest + parts[i]
                virtual = total - rest
                parts[i] = (rest - (total - virtual)) + (parts[i] - virtual)
                rest = total
            parts[count] = rest
            count += 1
    for i in range(count - 1, -1, -1):
        if parts[i] != 0.0:
            return parts[i]
    return 0.0


@lean_kernel
def segments_meet(ax, ay, bx, by, cx, cy, dx, dy, scratch):
    """Whether the closed segments ab and cd have a point in common; exact for the numbers given."""
    if max(ax, bx) < min(cx, dx) or max(cx, dx) < min(ax, bx):
        return False
    if max(ay, by) < min(cy, dy) or max(cy, dy) < min(ay, by):
        return False
    before = 0.0
    for k in range(4):  # one call in a loop is compiled once, not four times
        if k == 0:
            px, py, qx, qy, x, y = cx, cy, dx, dy, ax, ay
        elif k == 1:
            px, py, qx, qy, x, y = cx, cy, dx, dy, bx, by
        elif k == 2:
            px, py, qx, qy, x, y = ax, ay, bx, by, cx, cy
        else:
            px, py, qx, qy, x, y = ax, ay, bx, by, dx, dy
        side = orientation(px, py, qx, qy, x, y, scratch)
        if side == 0.0 and min(px, qx) <= x <= max(px, qx) and min(py, qy) <= y <= max(py, qy):
            return True
        if k % 2 == 1:
            level = side == 0.0 and before == 0.0  # all on one line, or the other segment is a point
            if (level and k == 3) or (not level and side * before >= 0.0):
                return False
        before = side
    return True


@lean_kernel
def nearest_on_segment(ax, ay, bx, by, x, y):
    """The point of the segment ab nearest to (x, y)."""
    dx, dy = bx - ax, by - ay
    length = dx * dx + dy * dy
    if not length > 0.0:
        return ax, ay
    t = ((x - ax) * dx + (y - ay) * dy) / length
    if t <= 0.0:
        return ax, ay
    if t >= 1.0:
        return bx, by
    return ax + t * dx, ay + t * dy


@lean_kernel
def nearest_points(ax, ay, bx, by, cx, cy, dx, dy):
    """Nearest points of the segments ab and cd: px, py on the first, qx, qy on the second.

    They cross, or one of the four ends is the nearest: the least of four distances has no small divisor.
    """
    ux, uy, vx, vy = bx - ax, by - ay, dx - cx, dy - cy
    wx, wy = cx - ax, cy - ay
    across = ux * vy - uy * vx
    along = wx * vy - wy * vx
    other = wx * uy - wy * ux
    if across < 0.0:
        across, along, other = -across, -along, -other
    if across > 0.0 and 0.0 < along < across and 0.0 < other < across:
        t = along / across
        px, py = ax + t * ux, ay + t * uy
        return px, py, px, py
    px, py, qx, qy, best = ax, ay, cx, cy, math.inf
    for k in range(4):
        if k == 0:
            x, y = ax, ay
        elif k == 1:
            x, y = bx, by
        elif k == 2:
            x, y = cx, cy
        else:
            x, y = dx, dy
        if k < 2:
            nx, ny = nearest_on_segment(cx, cy, dx, dy, x, y)
        else:
            nx, ny = nearest_on_segment(ax, ay, bx, by, x, y)
        square = (nx - x) * (nx - x) + (ny - y) * (ny - y)
        if square < best:
            best = square
            px, py, qx, qy = (x, y, nx, ny) if k < 2 else (nx, ny, x, y)
    return px, py, qx, qy


def segment_distance(first: ArrayLike, second: ArrayLike) -> float:
    """Distance of two segments, each (2, 2) m; a segment may be a point. 0 where they meet.

    ValueError for other shapes, or numbers that are not finite.
    """
    a, b = as_points(first, "first"), as_points(second, "second")
    if a.shape != (2, 2) or b.shape != (2, 2):
        raise ValueError("segments: expected two ends each, shape (2, 2)")
    px, py, qx, qy = nearest_points(*a.ravel().tolist(), *b.ravel().tolist())
    return math.sqrt((qx - px) * (qx - px) + (qy - py) * (qy - py))


def do_segments_meet(first: ArrayLike, second: ArrayLike) -> bool:
    """Whether two closed segments, each (2, 2) m, have a point in common; exact.

    ValueError for other shapes, or numbers that are not finite.
    """
    a, b = as_points(first, "first"), as_points(second, "second")
    if a.shape != (2, 2) or b.shape != (2, 2):
        raise ValueError("segments: expected two ends each, shape (2, 2)")
    return bool(segments_meet(*a.ravel().tolist(), *b.ravel().tolist(), np.zeros(SCRATCH)))
