"""A table made ready for the kernels: moved so that its middle is the origin, with its free rectangle.

About the middle, a mirror-symmetric table and rack have coordinates that differ in sign only, and so every
sum in a mirror-symmetric shot does: it stays symmetric to the last bit.

The free rectangle is bounded by the straight rails along x and y. Inset by a ball's radius it is where the
ball's centre can be without any contact. Jaws, pockets and slanted cushions must keep off it.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from game.arrays import Floats
from game.billiards.laws.state import EDGE, NO_EDGE
from game.billiards.table.table import Table

FAR = 1e9  # m; where a side of the table has no rail
TOLERANCE = 1e-9  # m


class Layout(NamedTuple):
    """elements (e, 7) about the middle, m: cushions, then the jaws, then the pockets (x, y, radius first).

    counts: of the three. middle (x, y) m in the table's frame. free (left, right, lower, upper) m: the free
    rectangle about the middle.
    """

    elements: Floats
    counts: tuple[int, int, int]
    middle: tuple[float, float]
    free: tuple[float, float, float, float]


def layout_of(table: Table) -> Layout:
    """Layout of a table; the same object for equal tables."""
    return _layout(table.cushions.tobytes(), table.jaws.tobytes(), table.pockets.tobytes())


@lru_cache(maxsize=64)
def _layout(cushion_bytes: bytes, jaw_bytes: bytes, pocket_bytes: bytes) -> Layout:
    rails = np.frombuffer(cushion_bytes).reshape(-1, 6)
    left, right, lower, upper = _free_rectangle(rails)
    middle_x = 0.5 * (left + right) if left > -FAR and right < FAR else 0.0
    middle_y = 0.5 * (lower + upper) if lower > -FAR and upper < FAR else 0.0
    shift = np.array([middle_x, middle_y])
    discs = [np.frombuffer(data).reshape(-1, 3) for data in (jaw_bytes, pocket_bytes)]
    counts = (len(rails), len(discs[0]), len(discs[1]))
    elements = np.zeros((sum(counts), 7))
    cushions = elements[: counts[0]]
    cushions[:, :6] = rails
    cushions[:, 0:2] -= shift
    cushions[:, 2:4] -= shift
    free = (left - middle_x, right - middle_x, lower - middle_y, upper - middle_y)
    cushions[:, EDGE] = [_edge_of(row, free) for row in cushions]
    elements[counts[0] :, :3] = np.concatenate(discs)
    elements[counts[0] :, :2] -= shift
    elements.setflags(write=False)
    return Layout(elements, counts, (float(middle_x), float(middle_y)), free)


def _free_rectangle(rails: Floats) -> tuple[float, float, float, float]:
    """Innermost straight rails on the four sides: left, right, lower, upper."""
    left, right, lower, upper = -FAR, FAR, -FAR, FAR
    for x, y, _, _, normal_x, normal_y in rails.tolist():
        if (normal_x, normal_y) == (1.0, 0.0):
            left = max(left, x)
        elif (normal_x, normal_y) == (-1.0, 0.0):
            right = min(right, x)
        elif (normal_x, normal_y) == (0.0, 1.0):
            lower = max(lower, y)
        elif (normal_x, normal_y) == (0.0, -1.0):
            upper = min(upper, y)
    return left, right, lower, upper


def _edge_of(row: Floats, free: tuple[float, float, float, float]) -> float:
    """Edge of the free rectangle on which a cushion lies, as the kernels number them."""
    normals = ((1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0))
    for edge, normal in enumerate(normals):
        axis = edge // 2
        if (row[4], row[5]) == normal and row[axis] == row[2 + axis] == free[edge]:
            return float(edge)
    return NO_EDGE


@lru_cache(maxsize=256)
def _clear(cushion_bytes: bytes, jaw_bytes: bytes, pocket_bytes: bytes, radius: float) -> bool:
    layout = _layout(cushion_bytes, jaw_bytes, pocket_bytes)
    left, right, lower, upper = layout.free
    box = (left + radius, right - radius, lower + radius, upper - radius)
    if box[0] > box[1] or box[2] > box[3]:
        return False
    cushions, jaws, _ = layout.counts
    for k, row in enumerate(layout.elements.tolist()):
        if k < cushions:
            if row[EDGE] == NO_EDGE and _segment_distance_to_box(row, box) < radius - TOLERANCE:
                return False
        elif (
            _distance_to_box(row[0], row[1], box)
            < row[2] + (radius if k < cushions + jaws else 0.0) - TOLERANCE
        ):
            return False
    return True


def is_clear(table: Table, radius: float) -> bool:
    """True if a ball of this radius can meet only straight rails within the inset free rectangle."""
    return _clear(table.cushions.tobytes(), table.jaws.tobytes(), table.pockets.tobytes(), float(radius))


def _distance_to_box(x: float, y: float, box: tuple[float, float, float, float]) -> float:
    dx = max(box[0] - x, 0.0, x - box[1])
    dy = max(box[2] - y, 0.0, y - box[3])
    return math.sqrt(dx * dx + dy * dy)


def _segment_distance_to_box(row: list[float], box: tuple[float, float, float, float]) -> float:
    """Least distance of a cushion's line piece from the box (a convex function along it: ternary search)."""
    low, high = 0.0, 1.0

    def distance(s: float) -> float:
        return _distance_to_box(row[0] + s * (row[2] - row[0]), row[1] + s * (row[3] - row[1]), box)

    for _ in range(120):
        third = (high - low) / 3.0
        if distance(low + third) <= distance(high - third):
            high -= third
        else:
            low += third
    return min(distance(low), distance(0.0), distance(1.0))
