"""The help figure: particles and the faces of cells between which speeds go to and fro."""

from __future__ import annotations

from game.ui.canvas.pen import Pen

LEFT, TOP, CELL = 52.0, 28.0, 64.0
DOTS = (
    *((0.3, 2.2), (0.7, 1.7), (1.3, 1.4), (1.8, 1.9), (2.3, 1.2), (2.7, 1.7)),
    *((0.3, 1.4), (1.2, 2.3), (2.2, 2.4), (1.7, 2.7), (2.7, 2.6), (0.7, 2.7)),
)


def draw_cells(pen: Pen) -> None:
    """Nine cells, the surface, particles, speeds at two faces, pressure in one cell."""
    for k in range(4):
        pen.line(((LEFT + k * CELL * 0.9, TOP), (LEFT + k * CELL * 0.9, TOP + 2.7 * CELL)), "grid", 1.2)
        pen.line(((LEFT, TOP + k * CELL * 0.9), (LEFT + 2.7 * CELL, TOP + k * CELL * 0.9)), "grid", 1.2)
    for x, y in DOTS:
        pen.disc(LEFT + 0.9 * CELL * x, TOP + 0.9 * CELL * y, 3.4, "chalk")
    surface = [(0.0, 1.2), (0.7, 1.35), (1.3, 1.1), (2.0, 1.15), (2.4, 0.95), (3.0, 1.3)]
    pen.line([(LEFT + 0.9 * CELL * x, TOP + 0.9 * CELL * y) for x, y in surface], "green", 2.0)
    side, mid = LEFT + 0.9 * CELL, TOP + 1.35 * CELL
    pen.arrow((side, mid), (side + 26.0, mid), "amber", 2.2)
    pen.formula("u", side + 34.0, mid - 8.0, "amber")
    pen.arrow(
        (LEFT + 1.35 * CELL, TOP + 1.8 * CELL), (LEFT + 1.35 * CELL, TOP + 1.8 * CELL - 22.0), "amber", 2.2
    )
    pen.formula("v", LEFT + 1.35 * CELL + 10.0, TOP + 1.62 * CELL, "amber")
    pen.formula("p", LEFT + 1.35 * CELL, TOP + 2.25 * CELL, "vermilion")
    pen.words("surface", LEFT + 2.3 * CELL, TOP + 14.0, "green")


def draw_fall(pen: Pen) -> None:
    """A column, how it falls as a liquid and as shallow water, and its front."""
    low, left, wide, high = 172.0, 28.0, 52.0, 104.0
    pen.line(((left, low - high), (left + wide, low - high), (left + wide, low)), "text3", 1.2, dash=3.0)
    liquid = [
        (left, low - 86.0),
        (left + 30.0, low - 76.0),
        (left + 56.0, low - 44.0),
        (left + 90.0, low - 16.0),
    ]
    liquid += [(left + 122.0, low - 8.0), (left + 128.0, low)]
    pen.area([*liquid, (left, low)], "body")
    pen.line(liquid, "chalk", 2.0)
    fan = [(left + 220.0 * k / 30.0, low - high * (1.0 - k / 30.0) ** 2 * 0.8) for k in range(31)]
    pen.line(fan, "vermilion", 1.8)
    pen.line(((left, 40.0), (left, low), (left + 244.0, low)), "text1", 2.0)
    pen.words("liquid", left + 78.0, low - 58.0, "chalk")
    pen.words("shallow water", left + 190.0, low - 34.0, "vermilion")
    pen.formula("a", left + 0.5 * wide, low + 14.0, "text1")
    pen.formula("2 a", left + 14.0, low - high - 12.0, "text1")
