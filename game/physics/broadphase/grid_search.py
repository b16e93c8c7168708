"""Search for pairs in a uniform grid: boxes sorted by cell, and runs of cells looked through.

Cells are numbered row by row, with empty guard columns at the right and an empty row above, so that the
run of cells x - 1 .. x + 1 of a row never leaves the matrix. In the sorted boxes such a run is consecutive.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.physics.broadphase.validation import Corners, Store
from game.physics.kernels.jit import kernel

GUARD = 2  # empty columns to the right: the run of cells x - 1 .. x + 1 never leaves the matrix
PADDING = 8  # places after the sorted boxes that may be read but are never counted
NEAR = 1  # cells: up to this reach the short search does
ID_MASK = 0x7FFFFFFF


class Matrix(NamedTuple):
    """The cells of a uniform grid: where they begin, m, how many to a metre, and their numbers."""

    x: float
    y: float
    scale: float
    columns: int
    rows: int


class Sorted(NamedTuple):
    """Boxes sorted by cell (or bucket): where each came from, and the boxes themselves.

    ``order``: (places,) ``cell << 32 | id``. ``boxes``: (places, 4) m. Both have PADDING places more,
    and in a hash table room for copies.
    """

    order: NDArray[np.int64]
    boxes: Corners


@kernel(inline="always", _nrt=False)
def cell_coordinate(x, origin, inverse, last):
    """Column (or row) of a coordinate, clamped to 0 .. ``last`` (a float). Infinities are clamped too."""
    return int(min(max((float(x) - float(origin)) * float(inverse), 0.0), last))


@kernel(_nrt=False)
def place_boxes(store, matrix, cells, start, reach):
    """Find every box's cell and count the boxes of each.

    ``store``, ``matrix``: a `Store` and a `Matrix`, or plain tuples of the same form. ``cells``: (capacity,)
    written, -1 for ids not in use. ``start``: ((rows + 1) stride + 1,) written: boxes per cell.
    ``reach``: (2,) written: the greatest number of columns and rows between a box's two corners.
    """
    boxes, alive, top = store
    origin_x, origin_y, inverse, columns, rows = matrix
    last_column, last_row = columns - 1.0, rows - 1.0
    stride = columns + GUARD
    reach_x = 0
    reach_y = 0
    for cell in range(len(start)):
        start[cell] = 0
    for box in range(top):
        if alive[box] == 0:
            cells[box] = -1
            continue
        column = cell_coordinate(boxes[box, 0], origin_x, inverse, last_column)
        row = cell_coordinate(boxes[box, 1], origin_y, inverse, last_row)
        reach_x = max(reach_x, cell_coordinate(boxes[box, 2], origin_x, inverse, last_column) - column)
        reach_y = max(reach_y, cell_coordinate(boxes[box, 3], origin_y, inverse, last_row) - row)
        cell = row * stride + column
        cells[box] = cell
        start[cell] += 1
    reach[0] = reach_x
    reach[1] = reach_y


@kernel(_nrt=False)
def sort_by_cell(store, cells, start, ordered):
    """Counting sort of the boxes by cell; within a cell by id. Returns their number.

    ``start``: boxes per cell; becomes the first place of each cell. ``ordered``: written.
    """
    boxes, _, top = store
    order, sorted_boxes = ordered
    total = 0
    for cell in range(len(start)):
        total += start[cell]
        start[cell] = total
    for box in range(top - 1, -1, -1):
        cell = cells[box]
        if cell >= 0:
            place = start[cell] - 1
            start[cell] = place
            order[place] = (int(cell) << 32) | box
    for place in range(total):
        box = order[place] & ID_MASK
        sorted_boxes[place, 0] = boxes[box, 0]
        sorted_boxes[place, 1] = boxes[box, 1]
        sorted_boxes[place, 2] = boxes[box, 2]
        sorted_boxes[place, 3] = boxes[box, 3]
    return total


@kernel(_nrt=False)
def search_near(ordered, count, start, stride, keys, tests):
    """All pairs, where no box reaches beyond the next cell: two runs of cells for each box.

    Half of a box's neighbourhood is enough: the rest of its own cell and the next in the row, and three
    cells of the row after. Writes pairs of places, ``p << 32 | q``; returns their number, or -1 if ``keys``
    is too short. The first candidates of each run are tested without asking whether there are any: a
    pair is kept by adding 0 or 1, so that there is no branch to mispredict.
    """
    order, sorted_boxes = ordered
    found = 0
    tested = 0
    for place in range(count):
        x0 = sorted_boxes[place, 0]
        y0 = sorted_boxes[place, 1]
        x1 = sorted_boxes[place, 2]
        y1 = sorted_boxes[place, 3]
        cell = order[place] >> 32
        end = int(start[cell + 2])
        first = int(start[cell + stride - 1])
        last = int(start[cell + stride + 2])
        tested += end - place - 1 + last - first
        if found + end - place + last - first + 4 > len(keys):
            return -1
        tag = place << 32
        other = (place + 1) & ID_MASK
        keys[found] = tag | other
        found += (
            (other < end)
            & (sorted_boxes[other, 0] <= x1)
            & (y0 <= sorted_boxes[other, 3])
            & (sorted_boxes[other, 1] <= y1)
            & (x0 <= sorted_boxes[other, 2])
        )
        for candidate in range(place + 2, end):
            other = candidate & ID_MASK
            keys[found] = tag | other
            found += (
                (sorted_boxes[other, 0] <= x1)
                & (y0 <= sorted_boxes[other, 3])
                & (sorted_boxes[other, 1] <= y1)
                & (x0 <= sorted_boxes[other, 2])
            )
        for step in range(2):
            other = (first + step) & ID_MASK
            keys[found] = tag | other
            found += (
                (other < last)
                & (sorted_boxes[other, 0] <= x1)
                & (x0 <= sorted_boxes[other, 2])
                & (sorted_boxes[other, 1] <= y1)
            )
        for candidate in range(first + 2, last):
            other = candidate & ID_MASK
            keys[found] = tag | other
            found += (
                (sorted_boxes[other, 0] <= x1)
                & (x0 <= sorted_boxes[other, 2])
                & (sorted_boxes[other, 1] <= y1)
            )
    tests[0] = tested
    return found


@kernel(_nrt=False)
def search_far(ordered, count, start, matrix, reach_x, keys, tests):
    """All pairs, for boxes that reach over any number of cells. As ``search_near`` else.

    A row's run begins ``reach_x`` columns before the box's own, where the widest box that could still
    touch it would have its lower corner.
    """
    sorted_boxes = ordered.boxes
    origin_x, origin_y, inverse, columns, rows = matrix
    last_column, last_row = columns - 1.0, rows - 1.0
    stride = columns + GUARD
    found = 0
    tested = 0
    for place in range(count):
        x0 = sorted_boxes[place, 0]
        y0 = sorted_boxes[place, 1]
        x1 = sorted_boxes[place, 2]
        y1 = sorted_boxes[place, 3]
        before = max(cell_coordinate(x0, origin_x, inverse, last_column) - reach_x, 0)
        after = cell_coordinate(x1, origin_x, inverse, last_column) + 1
        row = cell_coordinate(y0, origin_y, inverse, last_row)
        last_of_box = cell_coordinate(y1, origin_y, inverse, last_row)
        tag = place << 32
        first = place + 1
        while True:
            last = int(start[row * stride + after])
            tested += max(last - first, 0)
            if found + last - first + 1 > len(keys):
                return -1
            for candidate in range(first, last):
                other = candidate & ID_MASK
                keys[found] = tag | other
                found += (
                    (sorted_boxes[other, 0] <= x1)
                    & (x0 <= sorted_boxes[other, 2])
                    & (sorted_boxes[other, 1] <= y1)
                    & (y0 <= sorted_boxes[other, 3])
                )
            row += 1
            if row > last_of_box:
                break
            first = int(start[row * stride + before])
    tests[0] = tested
    return found


@kernel(_nrt=False)
def name_pairs(keys, count, order):
    """Turn pairs of places into pairs of ids, the smaller first: ``a << 32 | b``. ``keys``: written."""
    for i in range(count):
        a = order[keys[i] >> 32] & ID_MASK
        b = order[keys[i] & ID_MASK] & ID_MASK
        keys[i] = (min(a, b) << 32) | max(a, b)


@kernel(_nrt=False)
def find_pairs(store, matrix, cells, start, ordered, keys, reach):
    """All overlapping pairs of ids as keys, unsorted; returns their number, or -1 if ``keys`` is too short.

    ``store``, ``matrix``, ``ordered``: in plain tuples. ``reach``: (3,) written: reach in columns and rows,
    and the number of box tests.
    """
    store, matrix, ordered = Store(*store), Matrix(*matrix), Sorted(*ordered)
    place_boxes(store, matrix, cells, start, reach)
    count = sort_by_cell(store, cells, start, ordered)
    if reach[0] <= NEAR and reach[1] <= NEAR:
        found = search_near(ordered, count, start, matrix.columns + GUARD, keys, reach[2:])
    else:
        found = search_far(ordered, count, start, matrix, reach[0], keys, reach[2:])
    if found > 0:
        name_pairs(keys, found, ordered.order)
    return found
