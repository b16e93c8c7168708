"""Edges that cross the rim: the same table with a new stamp, the rim's edges in all cells of their boxes.

Looked up are the edges that matter: those of the rim, and those of which one end is in a triangle and the
other is not. Two edges that share several cells are compared in one of them, that of the lower left corner of
what their boxes have in common.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import lean_kernel
from game.physics.deformables.hashing import (
    FIRST,
    LOAD,
    STAMP,
    announce,
    cell_at,
    cells_of,
    slot_of,
    take_place,
)
from game.physics.deformables.predicates import edges_cross
from game.physics.deformables.vertices import wanted

LONG = 64  # cells; a rim edge of more is compared with every edge


class RimTable(NamedTuple):
    """slots: see `hashing`; the list: number, cell and box of each rim edge, as often as it has cells."""

    slots: NDArray[np.int32]
    names: NDArray[np.int32]  # (k,)
    cells: NDArray[np.int32]  # (k, 2)
    boxes: NDArray[np.float64]  # (k, 4) m
    near: NDArray[np.int32]  # (k + 1,), scratch


@lean_kernel
def is_searched(store, inside, e):
    """Whether an edge is one of those that are looked up."""
    return store.beyond[e] >= 0 or inside[store.edges[e, 0]] != inside[store.edges[e, 1]]


@lean_kernel
def is_crossing(mask, points, store, e, f):
    """Whether edge e crosses the rim edge f and is to be reported; two of the rim only as e < f."""
    if e == f or (store.beyond[e] >= 0 and f < e):
        return False
    a = store.edges[e, 0]
    b = store.edges[e, 1]
    c = store.edges[f, 0]
    d = store.edges[f, 1]
    if (a == c) | (a == d) | (b == c) | (b == d):
        return False
    if not wanted(mask, store.mesh_of[a] == store.mesh_of[c]):
        return False
    return edges_cross(points[a], points[b], points[c], points[d])


@lean_kernel
def place_rim(points, store, table, scale, stamp):
    """The rim's edges into the cells of their boxes; the long ones at the list's end, the last one first.

    Returns (places used, long ones), or (-needed, 0) if the list is too short.
    """
    size = np.uint32(table.slots.shape[0])
    needed = 0
    for r in range(store.rim.shape[0]):
        e = store.rim[r]
        left, bottom, right, top = cells_of(points[store.edges[e, 0]], points[store.edges[e, 1]], scale)
        cells = (right - left + 1) * (top - bottom + 1)
        needed += 1 if cells > LONG else cells
        if cells <= LONG:
            for j in range(bottom, top + 1):
                for i in range(left, right + 1):
                    announce(table.slots, slot_of(i, j, size), stamp)
    if needed > table.names.shape[0]:
        return -needed, 0
    free = 0
    long = 0
    for r in range(store.rim.shape[0]):
        e = store.rim[r]
        left, bottom, right, top = cells_of(points[store.edges[e, 0]], points[store.edges[e, 1]], scale)
        if (right - left + 1) * (top - bottom + 1) > LONG:
            long += 1
            table.names[table.names.shape[0] - long] = e
            continue
        for j in range(bottom, top + 1):
            for i in range(left, right + 1):
                place, free = take_place(table.slots, slot_of(i, j, size), free)
                table.names[place] = e
                table.cells[place, 0] = i
                table.cells[place, 1] = j
                write_box(points, store, e, table.boxes[place])
    return free, long


@lean_kernel
def write_box(points, store, e, box):
    """left, bottom, right, top (m) of an edge into box (4,)."""
    a = store.edges[e, 0]
    b = store.edges[e, 1]
    box[0] = min(points[a, 0], points[b, 0])
    box[1] = min(points[a, 1], points[b, 1])
    box[2] = max(points[a, 0], points[b, 0])
    box[3] = max(points[a, 1], points[b, 1])


@lean_kernel
def note(keys, hits, e, f):
    """One more crossing, if there is space; the number of them."""
    if hits < keys.shape[0]:
        keys[hits] = (e << 32) | f
    return hits + 1


@lean_kernel
def look_up(box, cells, table, stamp, scale):
    """The rim's edges whose boxes meet an edge's: writes table.near, returns their number.

    box (m) and cells of the edge, each left, bottom, right, top. Listed without a branch to guess.
    """
    left, bottom, right, top = box
    slots, _, homes, boxes, near = table
    size = np.uint32(slots.shape[0])
    count = 0
    for j in range(cells[1], cells[3] + 1):
        for i in range(cells[0], cells[2] + 1):
            slot = slot_of(i, j, size)
            if slots[slot, STAMP] != stamp:
                continue
            first = np.uint32(slots[slot, FIRST])
            for place in range(first, first + np.uint32(slots[slot, LOAD])):
                near[count] = place
                count += (
                    (left <= boxes[place, 2]) & (boxes[place, 0] <= right)
                    & (bottom <= boxes[place, 3]) & (boxes[place, 1] <= top)
                    & (homes[place, 0] == i) & (homes[place, 1] == j)
                )  # fmt: skip
    kept = 0
    for k in range(count):
        place = near[k]
        near[kept] = place
        kept += (cell_at(max(left, boxes[place, 0]), scale) == homes[place, 0]) & (
            cell_at(max(bottom, boxes[place, 1]), scale) == homes[place, 1]
        )
    return kept


@lean_kernel
def find_crossings(mask, points, inside, store, table, scale, stamp, keys):
    """Crossings of the edges that matter with the rim, as keys; inside (n,): 1 for vertices in a triangle.

    Returns how many there are, or below 0 how many places the table's list needs.
    """
    used, long = place_rim(points, store, table, scale, stamp)
    if used < 0:
        return used
    hits = 0
    for e in range(store.edges.shape[0]):
        if not is_searched(store, inside, e):
            continue
        a = store.edges[e, 0]
        b = store.edges[e, 1]
        cells = cells_of(points[a], points[b], scale)
        if (cells[2] - cells[0] + 1) * (cells[3] - cells[1] + 1) > store.rim.shape[0]:
            for r in range(store.rim.shape[0]):
                f = np.int64(store.rim[r])
                if is_crossing(mask, points, store, e, f):
                    hits = note(keys, hits, e, f)
            continue
        for k in range(long):
            f = np.int64(table.names[table.names.shape[0] - 1 - k])
            if is_crossing(mask, points, store, e, f):
                hits = note(keys, hits, e, f)
        box = (
            min(points[a, 0], points[b, 0]), min(points[a, 1], points[b, 1]),
            max(points[a, 0], points[b, 0]), max(points[a, 1], points[b, 1]),
        )  # fmt: skip
        for k in range(look_up(box, cells, table, stamp, scale)):
            f = np.int64(table.names[table.near[k]])
            if is_crossing(mask, points, store, e, f):
                hits = note(keys, hits, e, f)
    return hits
