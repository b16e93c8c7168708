"""The cards of the broad phases (C05 to C07) and of their race."""

from __future__ import annotations

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {
    "c05": CloseUp(zoom=3.0, across=0.7, down=0.4),
    "c06": CloseUp(zoom=2.2, across=0.84, down=0.35),
    "c07": CloseUp(zoom=1.7, across=0.6, down=0.68),
    "broad-phase-race": CloseUp(zoom=2.4, across=0.25, down=0.6),
}

Box = tuple[float, float, float]  # left, top, side
SMALL: tuple[Box, ...] = (
    (14, 12, 13), (22, 19, 13), (48, 9, 13), (70, 26, 13), (64, 34, 13), (98, 12, 13), (126, 20, 13),
    (134, 28, 13), (12, 56, 13), (36, 44, 13), (44, 76, 13), (86, 56, 13), (93, 64, 13), (112, 46, 13),
    (126, 66, 13), (104, 84, 13), (20, 82, 13), (66, 84, 13), (140, 84, 13),
)  # fmt: skip
MIXED: tuple[Box, ...] = (
    (22, 14, 40), (96, 44, 46), (70, 18, 7), (84, 30, 7), (12, 70, 7), (28, 78, 7), (46, 66, 7), (64, 84, 7),
    (78, 58, 7), (112, 14, 7), (130, 24, 7), (142, 12, 7), (86, 76, 7), (10, 40, 7), (55, 47, 7), (91, 84, 7),
    (136, 84, 7), (20, 26, 7), (148, 66, 7), (76, 90, 7),
)  # fmt: skip
SWEPT: tuple[Box, ...] = ((20, 34, 17), (46, 14, 17), (56, 24, 17), (66, 16, 17), (94, 42, 17), (122, 22, 17))


def draw_grid(pen: Pen) -> None:
    """A grid whose cells are the darker the more boxes have their corner there."""
    pen.fill("stage")
    for left, top, _ in SMALL:
        pen.box(20.0 * (left // 20), 20.0 * (top // 20) + 2.0, 20.0, 20.0, pen.veiled("chalk", 0.78))
    _draw_lines(pen, 20.0, "line", 2.0)
    _draw_boxes(pen, SMALL)


def draw_grids_of_sizes(pen: Pen) -> None:
    """Coarse cells for large boxes, fine ones for small."""
    pen.fill("stage")
    _draw_lines(pen, 10.0, "grid", 2.0)
    for left, top in ((0, 2), (40, 2), (80, 42), (120, 42)):
        pen.box(left, top, 40.0, 40.0, pen.veiled("green", 0.84))
    _draw_lines(pen, 40.0, "line2", 2.0)
    _draw_boxes(pen, MIXED)


def draw_sweep(pen: Pen) -> None:
    """Boxes, their ends carried down to an axis, and the stretches where they overlap."""
    pen.fill("stage")
    meeting = _overlapping(SWEPT)
    for box in SWEPT:
        for x in (box[0], box[0] + box[2]):
            pen.line(((x, box[1] + box[2]), (x, 78.0)), "line2", 0.7, dash=1.6)
    _draw_boxes(pen, SWEPT)
    pen.line(((8.0, 78.0), (152.0, 78.0)), "ghost", 1.0)
    for k, box in enumerate(SWEPT):
        y = 85.0 + 4.6 * (k % 3 if box in meeting else 0)
        color = "vermilion" if box in meeting else "chalk"
        pen.line(((box[0], y), (box[0] + box[2], y)), color, 2.4)


def draw_race(pen: Pen) -> None:
    """Bars of five contestants, the first of them hopelessly long."""
    pen.fill("stage")
    bars = (("vermilion", 132.0), ("chalk", 46.0), ("violet", 60.0), ("green", 36.0), ("pink", 70.0))
    for k, (color, length) in enumerate(bars):
        y = 20.0 + 16.0 * k
        pen.line(((14.0, y), (146.0, y)), "line", 6.0)
        pen.line(((14.0, y), (14.0 + length, y)), color, 6.0)
    for k in range(9):
        pen.box(136.0 + 5.0 * (k % 2), 8.0 + 10.0 * k, 5.0, 5.0, "line2")
        pen.box(136.0 + 5.0 * ((k + 1) % 2), 13.0 + 10.0 * k, 5.0, 5.0, "line2")


def _draw_lines(pen: Pen, cell: float, color: str, top: float) -> None:
    """A grid over the picture and beyond it."""
    count = int(240.0 // cell)
    for k in range(-count, count + 1):
        pen.line(((k * cell, -80.0), (k * cell, 200.0)), color, 0.6)
        pen.line(((-80.0, top + k * cell), (240.0, top + k * cell)), color, 0.6)


def _draw_boxes(pen: Pen, boxes: tuple[Box, ...]) -> None:
    meeting = _overlapping(boxes)
    for box in boxes:
        color = "vermilion" if box in meeting else "chalk"
        pen.box(box[0], box[1], box[2], box[2], pen.veiled(color, 0.55))
        pen.box(box[0], box[1], box[2], box[2], color, ring=1.1)


def _overlapping(boxes: tuple[Box, ...]) -> set[Box]:
    """Those that overlap another."""
    return {
        box for box in boxes for other in boxes
        if other is not box
        and max(box[0], other[0]) <= min(box[0] + box[2], other[0] + other[2])
        and max(box[1], other[1]) <= min(box[1] + box[2], other[1] + other[2])
    }  # fmt: skip
