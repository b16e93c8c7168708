"""Outlines made fit for a walk: duplicates merged, flat corners dropped, turned counterclockwise, or refused.

Hill climbing and Voronoi walks are right only on outlines that turn left at every corner. One vertex given
twice makes an edge of no length, both of whose Voronoi planes hold for every point. A clockwise outline turns
every test round. So the cure stands where polygons come in, and the walks need no tolerances of their own.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel

MERGED = 2.0**-40  # of the extent: vertices nearer to each other are one
FLAT = 2.0**-45  # of the extent: a corner that sticks out no more than this is dropped
ROUNDED = 2.0**-50  # of the largest coordinate: how far a corner may be dented by rounding alone
NOT_CONVEX = -1


@inner_kernel
def sagitta(points, a, b, c):
    """How far corner ``b`` sticks out (to the right) of the chord from ``a`` to ``c``; rows of (n, 2)."""
    ux, uy = points[c, 0] - points[a, 0], points[c, 1] - points[a, 1]
    vx, vy = points[b, 0] - points[a, 0], points[b, 1] - points[a, 1]
    length = math.sqrt(ux * ux + uy * uy)
    if length == 0.0:
        return -math.sqrt(vx * vx + vy * vy)
    return (vx * uy - vy * ux) / length


@inner_kernel
def merge(points, tolerance, kept):
    """Write the rows of (n, 2) that do not repeat the one before them; return how many."""
    count = 0
    for k in range(points.shape[0]):
        if count > 0:
            last = kept[count - 1]
            if (
                abs(points[k, 0] - points[last, 0]) <= tolerance
                and abs(points[k, 1] - points[last, 1]) <= tolerance
            ):
                continue
        kept[count] = k
        count += 1
    while count > 1:
        first, last = kept[0], kept[count - 1]
        if (
            abs(points[first, 0] - points[last, 0]) > tolerance
            or abs(points[first, 1] - points[last, 1]) > tolerance
        ):
            break
        count -= 1
    return count


@inner_kernel
def extreme_rows(points, kept, count):
    """Places in ``kept`` of the leftmost (then lowest) and rightmost (then highest) rows."""
    low, high = 0, 0
    for k in range(1, count):
        x, y = points[kept[k], 0], points[kept[k], 1]
        xl, yl = points[kept[low], 0], points[kept[low], 1]
        xh, yh = points[kept[high], 0], points[kept[high], 1]
        if x < xl or (x == xl and y < yl):
            low = k
        if x > xh or (x == xh and y > yh):
            high = k
    return low, high


@inner_kernel
def turns_once(points, kept, count):
    """True if the edges of an outline that only turns left point every way just once."""
    changes = 0
    for axis in range(2):
        before = 0.0
        for k in range(2 * count):
            a, b = kept[k % count], kept[(k + 1) % count]
            way = points[b, axis] - points[a, axis]
            if way == 0.0:
                continue
            if k >= count and before * way < 0.0:
                changes += 1
            before = way
    return changes <= 4


@lean_kernel
def clean_outline(points, kept, ordered):
    """Find the corners of a convex outline among (n, 2) points given in order, either way round.

    Writes their rows counterclockwise into ``kept`` (n,), uses ``ordered`` (n,), and returns (count,
    row): count 1 for a point, 2 for a segment, or NOT_CONVEX with a row at which the outline turns the
    wrong way.
    """
    n = points.shape[0]
    extent, largest = 0.0, 0.0
    for k in range(n):
        for axis in range(2):
            extent = max(extent, abs(points[k, axis] - points[0, axis]))
            largest = max(largest, abs(points[k, axis]))
    count = merge(points, MERGED * extent, kept)
    if count <= 2:
        return count, 0
    dent = MERGED * extent + ROUNDED * largest
    low, high = extreme_rows(points, kept, count)
    if is_thin(points, kept, count, low, high, MERGED * extent):
        first, second = kept[min(low, high)], kept[max(low, high)]
        kept[0], kept[1] = first, second
        return 2, 0
    order_leftward(points, kept, count, low, ordered)
    return turn_left(points, ordered, count, FLAT * extent, dent, kept)


@inner_kernel
def is_thin(points, kept, count, low, high, tolerance):
    """True if all rows lie on the line between the extreme ones."""
    for k in range(count):  # noqa: SIM110  a kernel has no generators
        if abs(sagitta(points, kept[low], kept[k], kept[high])) > tolerance:
            return False
    return True


@inner_kernel
def order_leftward(points, kept, count, first, ordered):
    """Write the rows in ``kept`` from place ``first`` on, turned round if their signed area is negative."""
    area = 0.0
    base = kept[0]
    for k in range(1, count - 1):
        a, b = kept[k], kept[k + 1]
        area += (points[a, 0] - points[base, 0]) * (points[b, 1] - points[base, 1])
        area -= (points[a, 1] - points[base, 1]) * (points[b, 0] - points[base, 0])
    way = 1 if area >= 0.0 else -1
    for k in range(count):
        ordered[k] = kept[(first + way * k) % count]


@inner_kernel
def turn_left(points, ordered, n, flat, dent, kept):
    """Corners of an outline that begins at its leftmost point; see `clean_outline`."""
    count = 0
    for k in range(n + 1):
        row = ordered[k % n]
        while count > 1:
            out = sagitta(points, kept[count - 2], kept[count - 1], row)
            if out > flat:
                break
            if out < -dent:
                return NOT_CONVEX, kept[count - 1]
            count -= 1
        if k < n:
            kept[count] = row
            count += 1
    if count > 3 and sagitta(points, kept[count - 1], kept[0], kept[1]) <= flat:
        for k in range(1, count):
            kept[k - 1] = kept[k]
        count -= 1
    if count > 2 and not turns_once(points, kept, count):
        return NOT_CONVEX, kept[0]
    lowest = 0
    for k in range(1, count):
        if kept[k] < kept[lowest]:
            lowest = k
    for k in range(count):
        ordered[k] = kept[(lowest + k) % count]
    for k in range(count):
        kept[k] = ordered[k]
    return count, 0
