"""The point nearest to the origin that lies inside none of several convex polygons.

It is the origin itself, or lies on an edge: the foot on its line, an end, or a crossing with the border of
another polygon. So each edge that is near enough is walked from its nearest point both ways, past all that
others cover of it.
"""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel
from game.physics.narrowphase.depth.sums import NX, NY, OFFSET

PARALLEL = 1e-14  # sine below which a line does not cross an edge
NO_STEP = 1e-3  # of the slack: what is covered by less is rounding


@inner_kernel
def _holds_origin(differences, slack):
    """Whether the origin lies deeper than ``slack`` (m) inside a polygon."""
    planes = differences.planes
    for q in range(differences.shrunk.shape[0]):
        margin = differences.shrunk[q] + slack
        inside = True
        for k in range(differences.starts[q], differences.starts[q + 1]):
            if planes[k, OFFSET] <= margin:
                inside = False
                break
        if inside:
            return True
    return False


@inner_kernel
def _clipped(differences, q, own, line, slack):
    """The part of a line within polygon q, from first to last (m); first > last if there is none.

    line: a point of it (m) and its direction, along plane ``own`` of q, which does not cut it.
    """
    x, y, dx, dy = line
    planes, first, last = differences.planes, -math.inf, math.inf
    margin = differences.shrunk[q] - slack
    for k in range(differences.starts[q], differences.starts[q + 1]):
        if k == own:
            continue
        room = planes[k, OFFSET] - margin - planes[k, NX] * x - planes[k, NY] * y
        rate = planes[k, NX] * dx + planes[k, NY] * dy
        if abs(rate) < PARALLEL:
            if room < 0.0:
                return 1.0, -1.0
        elif rate > 0.0:
            last = min(last, room / rate)
        else:
            first = max(first, room / rate)
        if first > last:
            break
    return first, last


@inner_kernel
def _exit(differences, q, line, s, sign, slack):
    """How far (m) it is along a line from place s, the way of ``sign``, out of polygon q eroded by ``slack``
    more; 0 outside."""
    x, y, dx, dy = line
    planes, out = differences.planes, math.inf
    margin, px, py = differences.shrunk[q] + slack, x + s * dx, y + s * dy
    for k in range(differences.starts[q], differences.starts[q + 1]):
        room = planes[k, OFFSET] - margin - planes[k, NX] * px - planes[k, NY] * py
        if room <= NO_STEP * slack:
            return 0.0
        rate = sign * (planes[k, NX] * dx + planes[k, NY] * dy)
        if rate > PARALLEL:
            out = min(out, room / rate)
    return out


@inner_kernel
def _walk(differences, own, line, s, sign, farthest, slack):
    """The nearest place from s on, the way of ``sign`` (m), that no other polygon covers, or one beyond
    ``farthest``."""
    count = differences.shrunk.shape[0]
    q, clear = own, 0
    while clear < count and sign * (farthest - s) >= 0.0:
        step = 0.0 if q == own else _exit(differences, q, line, s, sign, slack)
        s += sign * step
        clear = 1 if step > 0.0 else clear + 1
        q = q + 1 if q + 1 < count else 0
    return s


@inner_kernel
def nearest_free(differences, slack, most):
    """Distance (m) from the origin to the nearest point that is inside no polygon, and that point.

    slack: m, above 0, by how much a point may be inside others and yet count as free. most: m; beyond it
    nothing is looked for, and (most, 0, 0) is the answer if nothing nearer is free.
    """
    if not _holds_origin(differences, slack):
        return 0.0, 0.0, 0.0
    planes, best, bx, by = differences.planes, most, 0.0, 0.0
    for q in range(differences.shrunk.shape[0]):
        for k in range(differences.starts[q], differences.starts[q + 1]):
            nx, ny = planes[k, NX], planes[k, NY]
            away = planes[k, OFFSET] - differences.shrunk[q]
            if abs(away) >= best:
                continue
            line = (nx * away, ny * away, -ny, nx)
            first, last = _clipped(differences, q, k, line, slack)
            start = min(max(0.0, first), last)
            if first > last or away * away + start * start >= best * best:
                continue
            for side in range(2):
                sign = 1.0 if side == 0 else -1.0
                widest = math.sqrt(max(best * best - away * away, 0.0))
                end = min(last, widest) if side == 0 else max(first, -widest)
                s = _walk(differences, q, line, start, sign, end, slack)
                far = math.sqrt(away * away + s * s)
                if sign * (end - s) >= 0.0 and far < best:
                    best, bx, by = far, nx * away - s * ny, ny * away + s * nx
    return best, bx, by
