"""The help figure: a gust and its image below the lawn, and a bent leaf."""

from __future__ import annotations

import math

from game.ui.canvas.pen import Pen


def draw_gust(pen: Pen) -> None:
    """The air blows through the middle of a gust and comes back round both sides."""
    x, y = 96.0, 84.0
    for side in (-1.0, 1.0):
        for size in (14.0, 26.0, 38.0):
            ring = [
                (x + 0.95 * size * math.cos(t), y + side * (24.0 + 0.62 * size * math.sin(t)))
                for t in [math.tau * k / 40.0 for k in range(41)]
            ]
            pen.line(ring, "line2", 1.2)
    pen.arrow((x - 34.0, y), (x + 34.0, y), "chalk", 2.6)
    pen.formula(r"\v{S}", x + 48.0, y, "chalk")
    pen.line(((8.0, 150.0), (288.0, 150.0)), "text2", 1.6)
    pen.words("lawn", 30.0, 162.0, "text2")
    pen.line(((8.0, 184.0), (288.0, 184.0)), "text3", 1.0, dash=4.0)
    pen.words("mirror of the gust", 226.0, 196.0, "text3")
    pen.line(((206.0, 96.0), (232.0, 112.0), (258.0, 96.0)), "amber", 3.4)
    pen.arc((232.0, 112.0), 20.0, 0.0, 32.0, "text2", 1.4)
    pen.formula("q", 262.0, 112.0, "text2")
    pen.words("a leaf bends", 232.0, 70.0, "amber")
