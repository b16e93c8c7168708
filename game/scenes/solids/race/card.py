"""The card: three columns, one straight, one sunk, one leaning."""

from __future__ import annotations

import math

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"solver-race": CloseUp(shown_s=1.5)}
BOXES = 6


def draw_columns(pen: Pen) -> None:
    """The better the solver, the straighter."""
    pen.fill("stage")
    pen.box(0.0, 92.0, 160.0, 12.0, "body")
    pen.line(((0.0, 92.0), (160.0, 92.0)), "line2", 1.0)
    for x, color, height, lean in (
        (32.0, "green", 12.5, 0.0),
        (80.0, "chalk", 10.6, 0.0),
        (122.0, "vermilion", 12.2, 1.0),
    ):
        for k in range(BOXES):
            middle, y, turn = x + lean * 0.35 * k * k, 92.0 - height * (k + 0.5), lean * 0.03 * k
            corners = []
            for u, v in ((-6.0, -0.5), (6.0, -0.5), (6.0, 0.5), (-6.0, 0.5)):
                dx, dy = u, v * height
                across = dx * math.cos(turn) - dy * math.sin(turn)
                corners.append((middle + across, y + dx * math.sin(turn) + dy * math.cos(turn)))
            pen.area(corners, color, 0.3)
            pen.line((*corners, corners[0]), color, 1.3)
