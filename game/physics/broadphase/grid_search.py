"""Search for pairs in a uniform grid: boxes sorted by cell, and runs of cells looked through.

Cells are numbered row by row, with empty guard columns at the right and an empty row above, so that the
run of cells x - 1 .. x + 1 of a row never leaves the matrix. In the sorted boxes such a run is consecutive.
"""

from __future__ import annotations

from typing import NamedTuple

from game.compiler.decorator import inner_kernel, kernel
from game.physics.broadphase.runs import (
    HALF,
    MANY,
    NONE,
    ONE,
    SHORT,
    UNSIGNED,
    Sorted,
    copy_boxes,
    name_pairs,
    note_run,
    test_noted,
    test_rest,
)
from game.physics.broadphase.validation import Store

GUARD = 2  # empty columns to the right: the run of cells x - 1 .. x + 1 never leaves the matrix
NEAR = 1  # cells: up to this reach the short search does


class Matrix(NamedTuple):
    """The cells of a uniform grid: where they begin, m, how many to a metre, and their numbers."""

    x: float
    y: float
    scale: float
    columns: int
    rows: int


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
    corners = boxes.reshape(-1)  # as one row, and counted in a loop of its own: so cells come in vectors
    origin_x, origin_y, inverse, columns, rows = matrix
    last_column, last_row = columns - 1.0, rows - 1.0
    stride = columns + GUARD
    reach_x = 0
    reach_y = 0
    for box in range(top):
        column = cell_coordinate(corners[4 * box], origin_x, inverse, last_column)
        row = cell_coordinate(corners[4 * box + 1], origin_y, inverse, last_row)
        wide = cell_coordinate(corners[4 * box + 2], origin_x, inverse, last_column) - column
        high = cell_coordinate(corners[4 * box + 3], origin_y, inverse, last_row) - row
        here = alive[box] != 0
        reach_x = max(reach_x, wide if here else 0)
        reach_y = max(reach_y, high if here else 0)
        cells[box] = row * stride + column if here else -1
    for cell in range(len(start)):
        start[cell] = 0
    for box in range(top):
        if cells[box] >= 0:
            start[cells[box]] += 1
    reach[0] = reach_x
    reach[1] = reach_y


@inner_kernel
def sort_by_cell(store, cells, start, ordered):
    """Counting sort of the boxes by cell; within a cell by id. Returns their number.

    ``start``: boxes per cell; becomes the first place of each cell. ``ordered``: written.
    """
    boxes, _, top = store
    order = ordered.order
    total = 0
    for cell in range(len(start)):
        total += start[cell]
        start[cell] = total
    for box in range(top - 1, -1, -1):
        if cells[box] >= 0:
            own = UNSIGNED(cells[box])
            place = start[own] - 1
            start[own] = place
            order[UNSIGNED(place)] = (int(cells[box]) << 32) | box
    copy_boxes(boxes, ordered, total)
    return total


@inner_kernel
def search_near(ordered, count, start, stride, keys, tests):
    """All pairs, where no box reaches beyond the next cell: two runs of cells for each box.

    Half of a box's neighbourhood is enough: the rest of its own cell and the next in the row, and three
    cells of the row after. Writes pairs of places, ``p << 32 | q``; returns their number, or -1 if ``keys``
    is too short. ``tests``: (1,) box tests, written.
    """
    order, noted = ordered.order, ordered.noted
    to_left, to_right = UNSIGNED(stride - 1), UNSIGNED(stride + 2)
    found = 0
    tested = NONE
    many = NONE
    for box in range(count):
        place = UNSIGNED(box)
        cell = UNSIGNED(order[place]) >> HALF
        own, end = place + ONE, UNSIGNED(start[cell + UNSIGNED(2)])
        first, last = UNSIGNED(start[cell + to_left]), UNSIGNED(start[cell + to_right])
        tested += end - own + last - first
        many = note_run(noted, many, place, own, end)
        many = note_run(noted, many, place, first, last)
        if max(end - own, last - first) > UNSIGNED(SHORT):
            found = test_rest(ordered, place, own, end, keys, found)
            found = test_rest(ordered, place, first, last, keys, found)
            if found < 0:
                return -1
        if many > UNSIGNED(MANY):
            found = test_noted(ordered, many, keys, found)
            if found < 0:
                return -1
            many = NONE
    tests[0] = tested
    return test_noted(ordered, many, keys, found)


@inner_kernel
def search_far(ordered, count, start, matrix, reach_x, keys, tests):
    """All pairs, for boxes that reach over any number of cells. As `search_near` else.

    A row's run begins ``reach_x`` columns before the box's own, where the widest box that could still
    touch it would have its lower corner.
    """
    boxes, noted = ordered.boxes, ordered.noted
    origin_x, origin_y, inverse, columns, rows = matrix
    last_column, last_row = columns - 1.0, rows - 1.0
    stride = columns + GUARD
    found = 0
    tested = NONE
    many = NONE
    for box in range(count):
        place = UNSIGNED(box)
        before = max(cell_coordinate(boxes[box, 0], origin_x, inverse, last_column) - reach_x, 0)
        after = cell_coordinate(boxes[box, 2], origin_x, inverse, last_column) + 1
        row = cell_coordinate(boxes[box, 1], origin_y, inverse, last_row)
        last_of_box = cell_coordinate(boxes[box, 3], origin_y, inverse, last_row)
        first = place + ONE
        while True:
            last = UNSIGNED(start[UNSIGNED(row * stride + after)])
            tested += last - first
            many = note_run(noted, many, place, first, last)
            found = test_rest(ordered, place, first, last, keys, found)
            if found < 0:
                return -1
            if many > UNSIGNED(MANY):
                found = test_noted(ordered, many, keys, found)
                if found < 0:
                    return -1
                many = NONE
            row += 1
            if row > last_of_box:
                break
            first = UNSIGNED(start[UNSIGNED(row * stride + before)])
    tests[0] = tested
    return test_noted(ordered, many, keys, found)


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
    name_pairs(keys, found, ordered.order)
    return found
