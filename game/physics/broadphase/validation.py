"""The checks of all broad phases: what is no box, no corner and no id is refused here, in one line.

A box is axis-aligned and closed, ``[x0, x1] x [y0, y1]``. Corners may be infinite outwards and a box may have
no size; what is not a number is refused.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from game.arrays import Floats, Longs
from game.compiler.decorator import kernel

MAX_BOXES = 1 << 30  # ids are kept as 32 bit integers, with one bit to spare for sweep and prune


class Store(NamedTuple):
    """Boxes by id, as kernels take them.

    ``boxes``: (capacity, 4) m, rows x0 y0 x1 y1. ``alive``: (capacity,) 1 where an id is in use.
    ``top``: above all ids in use.
    """

    boxes: Floats
    alive: NDArray[np.uint8]
    top: int


@kernel(_nrt=False)
def first_bad_box(lowers, uppers):
    """Index of the first box that is none (lower above upper, not a number, wholly at infinity), or -1.

    ``lowers``, ``uppers``: (n, 2) m. Nothing is written.
    """
    for i in range(len(lowers)):
        for axis in range(2):
            low = lowers[i, axis]
            high = uppers[i, axis]
            if not (low <= high and low < np.inf and high > -np.inf):
                return i
    return -1


@kernel(_nrt=False)
def all_alive(alive, ids):
    """Whether all ids (n,) are in use, quickly if they are in a row. ``alive``: (capacity,) 1 in use."""
    apart = 0
    for i in range(len(ids)):
        apart |= ids[i] - ids[0] - i
    if apart == 0 and len(ids) > 0 and ids[0] >= 0 and ids[0] + len(ids) <= len(alive):
        dead = 0
        row = alive[ids[0] : ids[0] + len(ids)]
        for i in range(len(row)):
            dead |= row[i] == 0
        return dead == 0
    unknown = 0
    for i in range(len(ids)):
        unknown += ids[i] < 0 or ids[i] >= len(alive) or alive[ids[i]] == 0
    return unknown == 0


@kernel(_nrt=False)
def store_boxes(boxes, alive, ids, lowers, uppers):
    """Check all boxes and ids, then write the boxes; nothing is written if one of them is bad.

    ``boxes``: (capacity, 4) m, rows x0 y0 x1 y1, written. ``alive``: (capacity,) 1 where an id is in use.
    ``ids``: (n,). ``lowers``, ``uppers``: (n, 2) m. Returns the index of the first bad one, or -1.
    """
    bad = 0
    low, high = lowers.reshape(-1), uppers.reshape(-1)  # as one row, compared in vectors
    for i in range(len(low)):
        bad += not ((low[i] <= high[i]) & (low[i] < np.inf) & (high[i] > -np.inf))
    if bad > 0 or not all_alive(alive, ids):
        for i in range(len(ids)):
            box = ids[i]
            if box < 0 or box >= len(alive) or alive[box] == 0:
                return i
        return first_bad_box(lowers, uppers)
    for i in range(len(ids)):
        box = ids[i]
        boxes[box, 0] = lowers[i, 0]
        boxes[box, 1] = lowers[i, 1]
        boxes[box, 2] = uppers[i, 0]
        boxes[box, 3] = uppers[i, 1]
    return -1


@kernel(_nrt=False)
def overlap(boxes, a, b):
    """Whether the closed boxes ``a`` and ``b`` have a point in common. ``boxes``: (n, 4) m."""
    return (
        boxes[a, 0] <= boxes[b, 2]
        and boxes[b, 0] <= boxes[a, 2]
        and boxes[a, 1] <= boxes[b, 3]
        and boxes[b, 1] <= boxes[a, 3]
    )


def corners(values: ArrayLike, name: str) -> Floats:
    """Corner points as a (n, 2) array that kernels take; ValueError if they are no such thing."""
    given = values
    if not (type(given) is np.ndarray and given.dtype == np.float64 and given.flags.carray):
        try:
            given = np.array(given, dtype=np.float64, order="C")
        except (TypeError, ValueError):
            raise ValueError(f"{name}: expected an (n, 2) array of numbers") from None
    if given.ndim != 2 or given.shape[1] != 2:
        if given.size == 0:
            return np.empty((0, 2))
        raise ValueError(f"{name}: expected shape (n, 2), not {given.shape}")
    return given


def corner(values: ArrayLike, name: str) -> tuple[float, float]:
    """A corner (2,) m as two numbers; ValueError, by its name, if it is none."""
    try:
        x, y = values  # type: ignore[misc,str-unpack,unused-ignore]
        return float(x), float(y)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        raise ValueError(f"{name}: expected two numbers, not {values!r}") from None


def id_array(values: ArrayLike) -> Longs:
    """Ids (n,) as an array that kernels take; ValueError if they are no integers."""
    given = values
    if not (type(given) is np.ndarray and given.dtype == np.int64 and given.flags.carray and given.ndim == 1):
        given = np.array(given, order="C")
        if given.size == 0:
            return np.empty(0, dtype=np.int64)
        if given.ndim != 1 or given.dtype.kind not in "iu":
            raise ValueError(f"ids: expected a row of integers, not {given.dtype} of shape {given.shape}")
        given = given.astype(np.int64)
    return given


def all_differ(ids: Longs) -> bool:
    """True if no id of an array (n,) comes twice."""
    ascending = np.sort(ids)
    return not (ascending[1:] == ascending[:-1]).any()


def grown(array: NDArray[Any], capacity: int, fill: float = 0) -> NDArray[Any]:
    """A longer copy of an array along its first axis, the new part filled."""
    longer = np.full((capacity, *array.shape[1:]), fill, dtype=array.dtype)
    longer[: len(array)] = array
    return longer
