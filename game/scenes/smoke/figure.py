"""Figures: tracing back, and what a projection takes out."""

from __future__ import annotations

import math

from game.scenes.shared.marks import dot
from game.ui.canvas.pen import Pen


def draw_trace(pen: Pen) -> None:
    """A cell, the place one step back along the flow, and the four cells around it."""
    left, top, step = 40.0, 22.0, 36.0
    for k in range(7):
        pen.line(((left + k * step, top), (left + k * step, top + 4.5 * step)), "grid", 1.0)
    for k in range(5):
        pen.line(((left, top + k * step), (left + 6.0 * step, top + k * step)), "grid", 1.0)
    for row in range(4):
        for column in range(6):
            x, y = left + (column + 0.5) * step, top + (row + 0.5) * step
            pen.disc(x, y, 1.6, "text3")
    cell, origin = (left + 4.5 * step, top + 0.5 * step), (left + 1.82 * step, top + 2.28 * step)
    way = [
        (
            cell[0] + (origin[0] - cell[0]) * k / 20.0 + 12.0 * math.sin(math.pi * k / 20.0),
            cell[1] + (origin[1] - cell[1]) * k / 20.0 + 14.0 * math.sin(math.pi * k / 20.0),
        )
        for k in range(21)
    ]
    pen.line(way, "chalk", 2.0)
    for column, row in ((1, 1), (2, 1), (1, 2), (2, 2)):
        dot(pen, (left + (column + 0.5) * step, top + (row + 0.5) * step), "green", 4.0)
    dot(pen, cell, "amber", 5.0)
    dot(pen, origin, "vermilion", 4.5)
    pen.words("now", cell[0] + 10.0, cell[1] - 2.0, "amber", "left")
    pen.words("a step ago", origin[0] - 8.0, origin[1] + 18.0, "vermilion", "center")


def draw_projection(pen: Pen) -> None:
    """A flow as a sum: one that turns, and one that comes from somewhere."""
    for k, (middle, color, kind) in enumerate(
        ((56.0, "text1", "both"), (150.0, "chalk", "turns"), (242.0, "vermilion", "spreads"))
    ):
        for row in range(4):
            for column in range(4):
                x, y = (column - 1.5) * 18.0, (row - 1.5) * 18.0
                turn, spread = (-y, x), (x, y)
                vx = 0.26 * (
                    (turn[0] if kind != "spreads" else 0.0) + (spread[0] if kind != "turns" else 0.0)
                )
                vy = 0.26 * (
                    (turn[1] if kind != "spreads" else 0.0) + (spread[1] if kind != "turns" else 0.0)
                )
                pen.arrow((middle + x, 96.0 + y), (middle + x + vx, 96.0 + y + vy), color, 1.4)
        if k < 2:
            pen.words("=" if k == 0 else "+", middle + 47.0, 96.0, "text1")
    pen.words("carried along", 56.0, 158.0, "text2")
    pen.words("kept", 150.0, 158.0, "chalk")
    pen.formula(r"\nabla p", 242.0, 158.0, "vermilion")
