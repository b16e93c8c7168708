"""The swaps of one step of sweep and prune, one by one: which ends pass each other, and what comes of it.

``endpoints.insertion_sort`` does the same for all and keeps the pairs alone.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

Boxes = Sequence[Sequence[float]]
ALIKE, BEGINS, APART, PARTS = "alike", "begins", "apart", "parts"


class Swap(NamedTuple):
    """Two end points that change places on an axis (0: x, 1: y).

    ``mover`` was the later one and is now before ``other``; each is an id, with whether it is an upper end.
    ``result``: ALIKE (two lower or two upper ends: nothing to test), BEGINS (they overlap on both axes now),
    APART (on this axis they overlap, not on the other). Last, PARTS: on this axis they overlap no more.
    """

    axis: int
    mover: int
    mover_upper: bool
    other: int
    other_upper: bool
    result: str


def walk_swaps(ends: Sequence[tuple[int, bool]], boxes: Boxes, axis: int) -> list[Swap]:
    """The swaps by which insertion sort brings an axis in order, in the order in which it makes them.

    ``ends``: end points in their order before the step, as id and whether it is an upper one. ``boxes``: rows
    x0 y0 x1 y1 (m) by id, after it.
    """
    order: list[tuple[float, bool, int]] = []
    swaps = []
    for box, upper in ends:
        point = boxes[box][axis + 2 * upper], upper, box  # at equal places lower ends come first, then ids
        j = len(order)
        while j > 0 and order[j - 1] > point:
            swaps.append(_swap(axis, point, order[j - 1], boxes))
            j -= 1
        order.insert(j, point)
    return swaps


def _swap(axis: int, point: tuple[float, bool, int], passed: tuple[float, bool, int], boxes: Boxes) -> Swap:
    """What it means that an end point is now before another one."""
    (_, upper, mover), (_, other_upper, other) = point, passed
    if upper == other_upper:
        result = ALIKE
    elif upper:
        result = PARTS
    else:
        result = BEGINS if _overlap(boxes[mover], boxes[other]) else APART
    return Swap(axis, mover, upper, other, other_upper, result)


def _overlap(a: Sequence[float], b: Sequence[float]) -> bool:
    return a[0] <= b[2] and b[0] <= a[2] and a[1] <= b[3] and b[1] <= a[3]
