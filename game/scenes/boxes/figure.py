"""The help figures: cells (C05), levels (C06), a swap (C07), costs (the race)."""

from __future__ import annotations

import math

from game.scenes.shared.marks import curve, outline, span
from game.ui.canvas.pen import Pen, Point


def draw_cells(pen: Pen) -> None:
    """A box stands in the cell of its lower corner, and looks into half of the cells around it."""
    left, bottom, cell, columns, rows = 42.0, 176.0, 35.5, 6, 4
    column, row = 2, 1

    def place(x: float, y: float) -> Point:
        return left + cell * x, bottom - cell * y

    def shade(x: int, y: int, veil: float) -> None:
        pen.box(*place(x, y + 1), cell, cell, pen.veiled("amber", veil))

    shade(column, row, 0.6)
    for x, y in ((column + 1, row), (column - 1, row + 1), (column, row + 1), (column + 1, row + 1)):
        shade(x, y, 0.85)
    lines = pen.veiled("line2", 0.35)
    for x in range(columns + 1):
        pen.line((place(x, 0), place(x, rows)), lines, 1.0)
    for y in range(rows + 1):
        pen.line((place(0, y), place(columns, y)), lines, 1.0)
    size = 0.78
    _box(pen, place(1.55, 2.62), 0.7 * cell, "text2")
    _box(pen, place(4.2, 0.3), size * cell, "text2")
    _box(pen, place(2.62, 2.02), 0.72 * cell, "vermilion")
    _box(pen, place(column + 0.4, row + 0.45), size * cell, "vermilion")
    corner = place(column + 0.4, row + 0.45)
    pen.disc(*corner, 3.6, "amber")
    pen.line((corner, (corner[0], bottom + 6.0)), "text2", 1.0, dash=3.0)
    pen.formula("x", corner[0], bottom + 15.0)
    pen.formula("x_0", left, bottom + 16.0, "text2")
    pen.formula(r"i = 2", left + cell * 2.5, bottom - cell * rows - 12.0, "amber")
    span(pen, place(4, rows + 0.2), place(5, rows + 0.2), "text1")
    pen.formula("c", left + cell * 4.5, bottom - cell * rows - 18.0)


def _box(pen: Pen, corner: Point, size: float, color: str) -> None:
    """A square by its lower left corner."""
    x, y = corner
    square = ((x, y), (x + size, y), (x + size, y - size), (x, y - size))
    outline(
        pen, square, color, 1.6, color if color == "vermilion" else "body", 0.72 if color != "text2" else 0.1
    )


COLUMNS, ROWS = 12, 8  # finest cells
QUERY = (6.35, 3.3, 0.8)  # a small box: lower corner and size
OTHERS = {2: (3.2, 1.8, 3.6, "vermilion"), 1: (4.4, 0.35, 1.7, "text2")}


def draw_levels(pen: Pen) -> None:
    """Three grids above each other: a small box, and the cells where it looks on its level and above."""
    tops = {2: 60.0, 1: 122.0, 0: 184.0}  # of the frame: the front edges
    x, y, _ = QUERY
    for level, front in tops.items():
        _draw_sheet(pen, level, front)
        pen.formula(f"k = {level}", 7.0, front - 7.0, "text1", align="left")
    for above, below in ((2, 1), (1, 0)):
        pen.line((_oblique(x, y, tops[above]), _oblique(x, y, tops[below])), "text2", 1.0, dash=3.0)


def _draw_sheet(pen: Pen, level: int, front: float) -> None:
    side = 2**level

    def corners(x: float, y: float, size: float) -> list[Point]:
        ends = ((x, y), (x + size, y), (x + size, y + size), (x, y + size))
        return [_oblique(u, v, front) for u, v in ends]

    for column, row, veil in _visited(level):
        pen.area(corners(side * column, side * row, side), "amber", veil)
    lines = pen.veiled("line2", 0.35)
    for u in range(0, COLUMNS + 1, side):
        pen.line((_oblique(u, 0, front), _oblique(u, ROWS, front)), lines, 1.0)
    for v in range(0, ROWS + 1, side):
        pen.line((_oblique(0, v, front), _oblique(COLUMNS, v, front)), lines, 1.0)
    if level in OTHERS:
        x, y, size, color = OTHERS[level]
        outline(pen, corners(x, y, size), color, 1.5, color, 0.72 if color == "vermilion" else 0.9)
        pen.line((*corners(*QUERY), corners(*QUERY)[0]), "text1", 1.2)
    else:
        outline(pen, corners(*QUERY), "text1", 1.5, "body", 0.0)


def _visited(level: int) -> list[tuple[int, int, float]]:
    """Column, row and paleness of the cells where the small box looks: half of those around it on its own
    level, and on coarser ones all that it covers and the ones before them.
    """
    side = 2**level
    x, y, size = QUERY
    column, row = int(x // side), int(y // side)
    if not level:
        others = ((1, 0), (-1, 1), (0, 1), (1, 1))
        return [(column, row, 0.5), *((column + i, row + j, 0.8) for i, j in others)]
    columns = range(max(column - 1, 0), int((x + size) // side) + 1)
    rows = range(max(row - 1, 0), int((y + size) // side) + 1)
    return [(i, j, 0.8) for i in columns for j in rows]


def _oblique(x: float, y: float, front: float) -> Point:
    return 52.0 + 15.2 * x + 6.4 * y, front - 6.0 * y


BOXES = {"A": (46.0, 112.0, 22.0, 62.0), "B": (138.0, 200.0, 50.0, 90.0), "C": (222.0, 274.0, 26.0, 62.0)}
MOVE = 46.0  # of box A


def draw_swap(pen: Pen) -> None:
    """A box moves: its upper end and a lower one change places in the order, and a pair may begin."""
    first, second = 126.0, 178.0
    for y, name in ((first, "t"), (second, r"t + \Delta t")):
        pen.line(((34.0, y), (288.0, y)), "text3", 1.1)
        pen.formula(name, 6.0, y - (0.0 if name == "t" else 14.0), "text2", align="left")
    for name, (x0, x1, top, bottom) in BOXES.items():
        outline(pen, ((x0, top), (x1, top), (x1, bottom), (x0, bottom)))
        pen.words(name, x0 + 13.0, 0.5 * (top + bottom), "text1", size=13, weight="semibold")
        for x, inwards in ((x0, 1.0), (x1, -1.0)):
            pen.line(((x, bottom), (x, first)), "text3", 1.0, dash=3.0)
            _draw_ways(pen, name, x, inwards, first, second)
    x0, x1, top, bottom = BOXES["A"]
    corners = [(x0 + MOVE, top), (x1 + MOVE, top), (x1 + MOVE, bottom), (x0 + MOVE, bottom)]
    curve(pen, [*corners, corners[0]], "chalk", 1.4, 4.0)
    middle = 0.5 * (top + bottom)
    pen.arrow((x1, middle), (x1 + MOVE, middle), "chalk", 2.0)
    pen.formula(r"v \Delta t", x1 + 0.45 * MOVE, top - 11.0, "chalk")
    pen.words("one swap", 158.0, second + 17.0, "amber")


def _draw_ways(pen: Pen, name: str, x: float, inwards: float, first: float, second: float) -> None:
    """An end point in both orders, and its path from one to the other."""
    later = x + (MOVE if name == "A" else 0.0)
    swapped = (name, inwards) in (("A", -1.0), ("B", 1.0))
    color = "amber" if swapped else "text3"
    pen.line(((x, first), (later, second)), color, 1.8 if swapped else 1.2)
    for at, y in ((x, first), (later, second)):
        ends = ((at + 4.0 * inwards, y - 7.0), (at, y - 7.0), (at, y + 7.0), (at + 4.0 * inwards, y + 7.0))
        pen.line(ends, "amber" if swapped else "text1", 2.0)


def draw_costs(pen: Pen) -> None:
    """Operations of a step against the number of boxes, both logarithmic."""
    left, right, bottom, top = 46.0, 250.0, 178.0, 28.0

    def place(boxes: float, count: float) -> Point:
        x = left + (right - left) * (math.log10(boxes) - 1.0) / 4.0
        return x, bottom - (bottom - top) * (math.log10(count) - 1.0) / 9.0

    for power in range(1, 6):
        pen.line((place(10.0**power, 10.0), place(10.0**power, 1e10)), "grid2", 1.0)
        pen.formula(f"10^{power}", *_below(place(10.0**power, 10.0)), "text2", size=13)
    for power in (1, 4, 7, 10):
        pen.line((place(10.0, 10.0**power), place(1e5, 10.0**power)), "grid2", 1.0)
        if power > 1:
            x, y = place(10.0, 10.0**power)
            pen.formula(f"10^{{{power}}}", x - 8.0, y, "text2", align="right", size=13)
    pen.line((place(10.0, 1e10), place(10.0, 10.0), place(1e5, 10.0)), "text2", 1.2)
    sizes = [10.0 ** (1.0 + 0.1 * i) for i in range(41)]
    share = 2.0 * 8.0 / math.pi**2 * 2.0 * STEP  # in a square world
    laws = (
        ("vermilion", [0.5 * n * (n - 1.0) for n in sizes]),
        ("chalk", [share * n * n for n in sizes]),
        ("green", [4.0 * n for n in sizes]),
    )
    for color, counts in laws:
        line = [place(n, count) for n, count in zip(sizes, counts, strict=True) if count >= 10.0]
        pen.line(line, color, 2.0)
    pen.formula(r"\frac{n(n-1)}{2}", *place(6e2, 3e7), "vermilion")
    pen.words("tests, swaps", left - 2.0, top - 13.0, "text2", align="left")
    pen.words("swaps", *place(8e3, 2.2e3), "chalk", align="left", size=13)
    pen.formula("O(n)", right + 23.0, place(1e5, 4e5)[1] + 1.0, "green")
    pen.formula("n", right + 14.0, bottom)


STEP = 1e-4  # of the world's breadth: the mean displacement of a box in a step


def _below(at: Point) -> Point:
    return at[0], at[1] + 14.0
