"""The card: soft bodies on a grid, one vertex inside another body."""

from __future__ import annotations

import math

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"p04": CloseUp(shown_s=1.2, zoom=1.8, across=0.5, down=0.75)}


def draw_pile(pen: Pen) -> None:
    """Three blobs of triangles over a grid, and the vertices that are inside others."""
    pen.fill("stage")
    for k in range(10):
        pen.line(((16.0 * k, 0.0), (16.0 * k, 104.0)), "line2", 0.8)
        pen.line(((0.0, 16.0 * k - 8.0), (160.0, 16.0 * k - 8.0)), "line2", 0.8)
    for x, y, r, turn, color in ((58.0, 66.0, 25.0, 0.2, "chalk"), (100.0, 64.0, 25.0, 0.5, "green"),
                                 (80.0, 29.0, 23.0, 0.1, "violet")):  # fmt: skip
        rim = [
            (x + r * math.cos(turn + math.pi * k / 5.0), y + r * math.sin(turn + math.pi * k / 5.0))
            for k in range(10)
        ]
        pen.area(rim, color, 0.45)
        pen.line((*rim, rim[0]), "text1", 1.4)
        for point in rim:
            pen.line(((x, y), point), "text2", 0.7)
    for x, y in ((78.5, 60.0), (77.0, 70.5), (70.0, 48.0)):
        pen.disc(x, y, 3.2, "vermilion")
