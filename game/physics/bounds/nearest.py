"""How far two polylines are apart: the same two trees, asked for the least distance instead of an overlap.

A pair of volumes whose gap is no less than the best distance so far cannot hold a nearer pair of segments.
Of two parts the nearer one is looked into first.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from game.compiler.decorator import lean_kernel
from game.physics.bounds.building import BEGIN, CHILD, END, Nodes
from game.physics.bounds.overlap import gap_of_volumes
from game.physics.bounds.segments import nearest_points
from game.physics.bounds.tree import BoundingTree
from game.physics.bounds.validation import as_angle, as_vector
from game.physics.kernels import elementary


class Nearest(NamedTuple):
    """distance m, 0 where the lines meet; the nearest points m, in the first tree's frame; tests made."""

    distance: float
    point_a: tuple[float, float]
    point_b: tuple[float, float]
    volume_tests: int
    segment_tests: int


@lean_kernel
def nearest_of_leaves(first, a, second, b, place, best):
    """Improve ``best`` (7,): square of the distance, points, counts; by all segments of two leaves."""
    la, ends_a, order_a = first.links, first.ends, first.order
    lb, ends_b, order_b = second.links, second.ends, second.order
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


@lean_kernel
def search_nearest(first, second, place, stack, bounds, best):
    """Walk both trees, `Nodes` as plain tuples; ``best`` (7,) begins with inf in front.

    stack (d, 2), bounds (d,): overwritten.
    """
    first, second = Nodes(*first), Nodes(*second)
    kind, va, la, sizes_a = first.kind, first.volumes, first.links, first.sizes
    vb, lb, sizes_b = second.volumes, second.links, second.sizes
    stack[0, 0], stack[0, 1], bounds[0] = 0, 0, -math.inf
    top = 1
    while top > 0:
        top -= 1
        a, b, bound = stack[top, 0], stack[top, 1], bounds[top]
        if bound > 0.0 and bound * bound >= best[0]:
            continue
        if la[a, CHILD] < 0 and lb[b, CHILD] < 0:
            nearest_of_leaves(first, a, second, b, place, best)
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
        raise ValueError(f"trees: expected two of one kind, not {tree_a.kind} and {tree_b.kind}")
    x, y = as_vector(offset_b, "offset_b")
    turn = as_angle(turn_b, "turn_b")
    if tree_a.kind == "aabb" and turn != 0.0:
        tree_b, turn = tree_b.turned(turn), 0.0
    capacity = tree_a.depth + tree_b.depth + 3
    best = np.zeros(7)
    best[0] = math.inf
    place = np.array([elementary.cos(turn), elementary.sin(turn), x, y])
    stack, bounds = np.zeros((capacity, 2), dtype=np.int64), np.zeros(capacity)
    search_nearest(tree_a.nodes, tree_b.nodes, place, stack, bounds, best)
    square, px, py, qx, qy, volumes, segments = best.tolist()
    return Nearest(math.sqrt(square), (px, py), (qx, qy), int(volumes), int(segments))
