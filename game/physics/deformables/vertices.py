"""The two passes for vertices in triangles: all into cells, then each triangle looks through its own."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import lean_kernel
from game.physics.deformables.effects import MESH_CONTACTS_BIT, SELF_CONTACTS_BIT
from game.physics.deformables.hashing import FIRST, LOAD, STAMP, announce, cell_at, slot_of, take_place
from game.physics.deformables.predicates import in_triangle, on_one_side

# what is counted: slots in use, cells looked at, vertices of other cells met there, vertices tested, the most
# vertices in a slot
USED, VISITED, STRANGERS, TESTED, LONGEST = range(5)
COUNTERS = 5


class VertexTable(NamedTuple):
    """slots: see `hashing`; the list: number, cell and place of each vertex; which: scratch."""

    slots: NDArray[np.int32]
    names: NDArray[np.int32]  # (n,)
    cells: NDArray[np.int32]  # (n, 2)
    places: NDArray[np.float64]  # (n, 2) m
    which: NDArray[np.int32]  # (n,) slot of each vertex


@lean_kernel
def wanted(mask, same):
    """Whether contacts of a mesh with itself (same) or of two are asked for."""
    return mask & (SELF_CONTACTS_BIT if same else MESH_CONTACTS_BIT) != 0


@lean_kernel
def is_contact(mask, points, store, triangle, vertex):
    """Whether a vertex lies in a triangle that it is no corner of, and is to be reported."""
    a = store.triangles[triangle, 0]
    b = store.triangles[triangle, 1]
    c = store.triangles[triangle, 2]
    if (vertex == a) | (vertex == b) | (vertex == c):
        return False
    if not wanted(mask, store.mesh_of[a] == store.mesh_of[vertex]):
        return False
    return in_triangle(points[vertex], points[a], points[b], points[c])


@lean_kernel
def place_vertices(points, table, scale, stamp):
    """First pass: each vertex (n, 2) m into its cell."""
    size = np.uint32(table.slots.shape[0])
    for v in range(points.shape[0]):
        slot = slot_of(cell_at(points[v, 0], scale), cell_at(points[v, 1], scale), size)
        table.which[v] = slot
        announce(table.slots, slot, stamp)
    free = 0
    for v in range(points.shape[0]):
        place, free = take_place(table.slots, table.which[v], free)
        table.names[place] = v
        table.places[place, 0] = points[v, 0]
        table.places[place, 1] = points[v, 1]
        table.cells[place, 0] = cell_at(points[v, 0], scale)
        table.cells[place, 1] = cell_at(points[v, 1], scale)


@lean_kernel
def box_of(points, a, b, c):
    """(left, bottom, right, top) m of a triangle."""
    return (
        min(points[a, 0], points[b, 0], points[c, 0]),
        min(points[a, 1], points[b, 1], points[c, 1]),
        max(points[a, 0], points[b, 0], points[c, 0]),
        max(points[a, 1], points[b, 1], points[c, 1]),
    )


@lean_kernel
def look_through(points, corners, box, scale, table, stamp, candidates):
    """The vertices in a triangle's cells that lie in it, corners apart: writes them, returns their number.

    corners: a, b, c; box: `box_of` them. First all that lie in the box are listed, without a branch that the
    processor would have to guess. What other cells have left in the same slot is told apart by its cell.
    """
    a, b, c = corners
    left, bottom, right, top = box
    slots, names, cells, places, _ = table
    size = np.uint32(slots.shape[0])
    near = 0
    for j in range(cell_at(bottom, scale), cell_at(top, scale) + 1):
        for i in range(cell_at(left, scale), cell_at(right, scale) + 1):
            slot = slot_of(i, j, size)
            if slots[slot, STAMP] != stamp:
                continue
            first = np.uint32(slots[slot, FIRST])
            for place in range(first, first + np.uint32(slots[slot, LOAD])):
                px = places[place, 0]
                py = places[place, 1]
                v = names[place]
                candidates[near] = place
                near += (
                    (left <= px) & (px <= right) & (bottom <= py) & (py <= top)
                    & (v != a) & (v != b) & (v != c) & (cells[place, 0] == i) & (cells[place, 1] == j)
                )  # fmt: skip
    ax, ay, bx, by = points[a, 0], points[a, 1], points[b, 0], points[b, 1]
    cx, cy = points[c, 0], points[c, 1]
    hits = 0
    for k in range(near):
        place = candidates[k]
        candidates[hits] = names[place]
        hits += on_one_side(places[place, 0], places[place, 1], ax, ay, bx, by, cx, cy)
    return hits


@lean_kernel
def find_vertices(mask, points, store, table, scale, stamp, keys):
    """Both passes. Writes keys of contacts, triangle << 32 | vertex, unsorted within a triangle.

    Returns how many there are; if keys is too short, those that found no space are missing. A triangle with
    more cells than there are vertices looks at all vertices instead: never worse than testing all pairs. The
    last n + 1 of keys are scratch.
    """
    place_vertices(points, table, scale, stamp)
    n = points.shape[0]
    room = keys.shape[0] - n - 1
    candidates = keys[room:]
    hits = 0
    for t in range(store.triangles.shape[0]):
        a = store.triangles[t, 0]
        b = store.triangles[t, 1]
        c = store.triangles[t, 2]
        box = box_of(points, a, b, c)
        if cells_in(box, scale) > n:
            for v in range(n):
                if is_contact(mask, points, store, t, v):
                    if hits < room:
                        keys[hits] = (t << 32) | v
                    hits += 1
            continue
        for k in range(look_through(points, (a, b, c), box, scale, table, stamp, candidates)):
            v = candidates[k]
            if wanted(mask, store.mesh_of[a] == store.mesh_of[v]):
                if hits < room:
                    keys[hits] = (t << 32) | v
                hits += 1
    return hits


@lean_kernel
def cells_in(box, scale):
    """How many cells a box (left, bottom, right, top) m has."""
    across = cell_at(box[2], scale) - cell_at(box[0], scale) + 1
    return across * (cell_at(box[3], scale) - cell_at(box[1], scale) + 1)


@lean_kernel
def count_work(points, store, table, scale, stamp, counters):
    """What the second pass of ``stamp`` did, counted; counters (COUNTERS,) written."""
    slots = table.slots
    size = np.uint32(slots.shape[0])
    counters[:] = 0
    for slot in range(slots.shape[0]):
        if slots[slot, STAMP] == stamp:
            counters[USED] += 1
            counters[LONGEST] = max(counters[LONGEST], slots[slot, LOAD])
    for t in range(store.triangles.shape[0]):
        box = box_of(points, store.triangles[t, 0], store.triangles[t, 1], store.triangles[t, 2])
        if cells_in(box, scale) > points.shape[0]:
            counters[TESTED] += points.shape[0]
            continue
        for j in range(cell_at(box[1], scale), cell_at(box[3], scale) + 1):
            for i in range(cell_at(box[0], scale), cell_at(box[2], scale) + 1):
                slot = slot_of(i, j, size)
                counters[VISITED] += 1
                if slots[slot, STAMP] == stamp:
                    first = slots[slot, FIRST]
                    for place in range(first, first + slots[slot, LOAD]):
                        strange = table.cells[place, 0] != i or table.cells[place, 1] != j
                        counters[STRANGERS if strange else TESTED] += 1
