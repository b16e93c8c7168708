"""A hash table of the cells of an endless grid (Teschner and others 2003, section 3).

    slot = (i p₁ xor j p₂) mod m,   i = floor(x / l), j = floor(y / l)

with the large primes of the paper. The table is never cleared: a slot counts as empty unless it has the stamp
of the present pass. A first look over all things counts how many each slot gets. A second one gives each slot
a stretch of one list, in the order in which slots are met. So what hangs in a slot lies side by side.

About the origin the print has a weakness: -a xor -b is a xor b where a and b end in as many zero bits, as a
third of all pairs do. Cells (i, j) and (-i, -j) then share slots however long the table is. That costs tests,
and no errors.

slots (m, 4) int32: stamp, first place in the list, how many, how many so far.
"""

from __future__ import annotations

import math

import numpy as np

from game.compiler.decorator import lean_kernel

FIRST_PRIME, SECOND_PRIME = 73_856_093, 19_349_663
STAMP, FIRST, LOAD, FILLED = range(4)  # columns of a slot
SLOT_COLUMNS = 4
FARTHEST_CELL = 1e9  # cells beyond are counted as one
WORD = 0xFFFF_FFFF


@lean_kernel
def cell_at(x, scale):
    """The cell (whole number) of a coordinate (m); scale: cells in a metre. Never falls where x grows."""
    return math.floor(min(max(x * scale, -FARTHEST_CELL), FARTHEST_CELL))


@lean_kernel
def slot_of(i, j, size):
    """The slot of a cell in a table of so many (uint32)."""
    return np.int64(np.uint32(((i * FIRST_PRIME) ^ (j * SECOND_PRIME)) & WORD) % size)


@lean_kernel
def announce(slots, slot, stamp):
    """One more thing for a slot."""
    if slots[slot, STAMP] != stamp:
        slots[slot, STAMP] = stamp
        slots[slot, LOAD] = 0
        slots[slot, FILLED] = 0
    slots[slot, LOAD] += 1


@lean_kernel
def take_place(slots, slot, free):
    """A place in the list for one of the things announced; ``free`` is where the next stretch may begin.

    Returns the place, and where the next stretch may begin now.
    """
    if slots[slot, FILLED] == 0:
        slots[slot, FIRST] = free
        free += slots[slot, LOAD]
    place = slots[slot, FIRST] + slots[slot, FILLED]
    slots[slot, FILLED] += 1
    return place, free


@lean_kernel
def cells_of(a, b, scale):
    """(left, bottom, right, top) cells of the box of two points (2,)."""
    return (
        cell_at(min(a[0], b[0]), scale),
        cell_at(min(a[1], b[1]), scale),
        cell_at(max(a[0], b[0]), scale),
        cell_at(max(a[1], b[1]), scale),
    )
