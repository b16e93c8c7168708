"""Do two volumes overlap, and if not, what separates them.

Boxes by separating axes (Gottschalk, Lin and Manocha 1996): in the plane the four side directions are all
that can separate, nothing is divided, parallel sides are no special case. Capsules by the distance of their
cores. Closed volumes: touching overlaps.

Arrays: va, vb (m, 6), volumes as rows (see `boxes` and `capsules`).
"""

from __future__ import annotations

import math

from game.compiler.decorator import lean_kernel
from game.physics.bounds.building import CAPSULE
from game.physics.bounds.segments import nearest_points


@lean_kernel
def gap_of_boxes(va, a, vb, b, c, s, x, y):
    """Widest gap on the four side directions of two boxes, m (negative: they overlap), and its axis.

    Box ``b`` of ``vb`` is turned by (c, s) and moved by (x, y). The axis is a unit vector from a to b.
    """
    ux, uy = c * vb[b, 2] - s * vb[b, 3], s * vb[b, 2] + c * vb[b, 3]
    dx = c * vb[b, 0] - s * vb[b, 1] + x - va[a, 0]
    dy = s * vb[b, 0] + c * vb[b, 1] + y - va[a, 1]
    tx, ty = va[a, 2], va[a, 3]
    long_a, broad_a, long_b, broad_b = va[a, 4], va[a, 5], vb[b, 4], vb[b, 5]
    even = abs(ux * tx + uy * ty)
    odd = abs(uy * tx - ux * ty)
    along = dx * tx + dy * ty
    gap = abs(along) - (long_a + long_b * even + broad_b * odd)
    nx, ny, way = tx, ty, along
    across = dy * tx - dx * ty
    other = abs(across) - (broad_a + long_b * odd + broad_b * even)
    if other > gap:
        gap, nx, ny, way = other, -ty, tx, across
    along = dx * ux + dy * uy
    other = abs(along) - (long_b + long_a * even + broad_a * odd)
    if other > gap:
        gap, nx, ny, way = other, ux, uy, along
    across = dy * ux - dx * uy
    other = abs(across) - (broad_b + long_a * odd + broad_a * even)
    if other > gap:
        gap, nx, ny, way = other, -uy, ux, across
    if way < 0.0:
        nx, ny = -nx, -ny
    return gap, nx, ny


@lean_kernel
def gap_of_capsules(va, a, vb, b, c, s, x, y):
    """Gap between two capsules, m (negative: they overlap), and the unit vector from a to b along it."""
    px, py, qx, qy = nearest_points(
        va[a, 0], va[a, 1], va[a, 2], va[a, 3],
        c * vb[b, 0] - s * vb[b, 1] + x, s * vb[b, 0] + c * vb[b, 1] + y,
        c * vb[b, 2] - s * vb[b, 3] + x, s * vb[b, 2] + c * vb[b, 3] + y,
    )  # fmt: skip
    dx, dy = qx - px, qy - py
    distance = math.sqrt(dx * dx + dy * dy)
    gap = distance - (va[a, 4] + vb[b, 4])
    if distance > 0.0:
        return gap, dx / distance, dy / distance
    return gap, 1.0, 0.0


@lean_kernel(inline="always")
def gap_of_volumes(kind, va, a, vb, b, place):
    """Gap and axis of two volumes of one kind; ``place`` (4,): cosine, sine, x, y of the second's frame."""
    if kind == CAPSULE:
        return gap_of_capsules(va, a, vb, b, place[0], place[1], place[2], place[3])
    return gap_of_boxes(va, a, vb, b, place[0], place[1], place[2], place[3])
