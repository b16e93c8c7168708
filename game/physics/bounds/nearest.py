"""How far two polylines are apart: the same two trees, asked for the least distance instead of an overlap.

A pair of volumes whose gap is no less than the best distance so far cannot hold a nearer pair of segments.
Of two parts the nearer one is looked into first.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.physics.bounds.building import BEGIN, CHILD, END
from game.physics.bounds.overlap import gap_of_volumes
from game.physics.bounds.segments import nearest_points
from game.physics.bounds.tree import BoundingTree
from game.physics.bounds.validation import as_angle, as_vector
from game.physics.kernels.jit import kernel


class Nearest(NamedTuple):
    """distance m, 0 where the lines meet; the nearest points m, in the first tree's frame; tests made."""

    distance: float
    point_a: tuple[float, float]
    point_b: tuple[float, float]
    volume_tests: int
    segment_tests: int


@kernel
def nearest_of_leaves(la, ends_a, order_a, a, lb, ends_b, order_b, b, place, best):
    """Improve ``best`` (7,): square of the distance, points, counts; by all segments of two leaves."""
    c, s, x, y = place[0], place[1], place[2], place[3]
    for k in range(lb[b, BEGIN], lb[b, END]):
        j = order_b[k]
        cx, cy = c * ends_b[j, 0] - s * ends_b[j, 1] + x, s * ends_b[j, 0] + c * ends_b[j, 1] + y
        dx, dy = c * ends_b[j, 2] - s * ends_b[j, 3] + x, s * ends_b[j, 2] + c * ends_b[j, 3] + y
        for m in range(la[a, BEGIN], la[a, END]):
            i = order_a[m]
            px, py, qx, qy = nearest_points(
                ends_a[i, 0], ends_a[i, 1], ends_a[i, 2], ends_a[i, 3], cx, cy, dx, dy
            )
            best[6] += 1.0
            square = (qx - px) * (qx - px) + (qy - py) * (qy - py)
            if square < best[0]:
                best[0], best[1], best[2], best[3], best[4] = square, px, py, qx, qy


@kernel
def search_nearest(
    kind, va, la, sizes_a, ends_a, order_a, vb, lb, sizes_b, ends_b, order_b, place, stack, bounds, best
):
    """Walk both trees; ``best`` (7,) begins with inf in front. stack (d, 2), bounds (d,): overwritten."""
    stack[0, 0], stack[0, 1], bounds[0] = 0, 0, -math.inf
    top = 1
    while top > 0:
        top -= 1
        a, b, bound = stack[top, 0], stack[top, 1], bounds[top]
        if bound > 0.0 and bound * bound >= best[0]:
            continue
        if la[a, CHILD] < 0 and lb[b, CHILD] < 0:
            nearest_of_leaves(la, ends_a, order_a, a, lb, ends_b, order_b, b, place, best)
            continue
        open_a = lb[b, CHILD] < 0 or (la[a, CHILD] >= 0 and sizes_a[a] >= sizes_b[b])
        for side in range(2):
            stack[top + side, 0] = la[a, CHILD] + side if open_a else a
            stack[top + side, 1] = b if open_a else lb[b, CHILD] + side
            gap, _, _ = gap_of_volumes(kind, va, stack[top + side, 0], vb, stack[top + side, 1], place)
            bounds[top + side] = gap
            best[5] += 1.0
        if bounds[top] < bounds[top + 1]:  # the nearer one comes off the stack first
            for column in range(2):
                kept = stack[top, column]
                stack[top, column] = stack[top + 1, column]
                stack[top + 1, column] = kept
            gap = bounds[top]
            bounds[top] = bounds[top + 1]
            bounds[top + 1] = gap
        top += 2


def nearest(
    tree_a: BoundingTree, tree_b: BoundingTree, offset_b: ArrayLike = (0.0, 0.0), turn_b: float = 0.0
) -> Nearest:
    """The least distance of two polylines and where it is; the second one turned (rad), then moved (2,) m.

    ValueError for trees of different kinds, or what is no place.
    """
    if tree_a.kind != tree_b.kind:
        raise ValueError(f"trees: of one kind are wanted, not {tree_a.kind} and {tree_b.kind}")
    x, y = as_vector(offset_b, "offset_b")
    turn = as_angle(turn_b, "turn_b")
    if tree_a.kind == "aabb" and turn != 0.0:
        tree_b, turn = tree_b.turned(turn), 0.0
    a, b = tree_a, tree_b
    room = a.depth + b.depth + 3
    best = np.zeros(7)
    best[0] = math.inf
    search_nearest(
        a.kind_number, a.volumes, a.links, a.sizes, a.ends, a.order, b.volumes, b.links, b.sizes, b.ends,
        b.order, np.array([math.cos(turn), math.sin(turn), x, y]), np.zeros((room, 2), dtype=np.int64),
        np.zeros(room), best,
    )  # fmt: skip
    square, px, py, qx, qy, volumes, segments = best.tolist()
    return Nearest(math.sqrt(square), (px, py), (qx, qy), int(volumes), int(segments))
