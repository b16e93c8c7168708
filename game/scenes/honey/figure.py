"""The help figure: a particle, those that it feels, and the share of its kernel beyond a wall."""

from __future__ import annotations

import math

from game.ui.canvas.pen import Pen

MIDDLE, SUPPORT, SPACING = (148.0, 104.0), 62.0, 31.0


def draw_kernel(pen: Pen) -> None:
    """Neighbours within the support, linked; a wall that cuts the circle."""
    x, y = MIDDLE
    wall = y + 0.6 * SUPPORT
    pen.box(20.0, wall, 256.0, 40.0, "grid")
    pen.line(((20.0, wall), (276.0, wall)), "text2", 2.0)
    for row in range(-3, 2):
        for column in range(-3, 4):
            at = (
                x + SPACING * (column + 0.12 * math.sin(5.0 * row + column)),
                y + SPACING * (row + 0.1 * column % 0.3),
            )
            if at[1] > wall - 6.0 or (row, column) == (0, 0):
                continue
            near = math.hypot(at[0] - x, at[1] - y) < SUPPORT
            if near:
                pen.line((MIDDLE, at), "line2", 1.0)
            pen.disc(*at, 6.0, "chalk" if near else "body")
    pen.disc(x, y, 7.0, "amber")
    pen.arc(MIDDLE, SUPPORT, 0.0, 360.0, "amber")
    pen.formula("h", x + 30.0, y - 66.0, "amber")
    pen.words("neighbours", 60.0, 20.0, "chalk")
    pen.words("beyond the wall", 148.0, wall + 14.0, "text1")
