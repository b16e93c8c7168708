"""The card: a lid that moves, and the eddy below it."""

from __future__ import annotations

import math

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"cavity": CloseUp(shown_s=6.0, zoom=1.1, across=0.5, down=0.5)}


def draw_eddy(pen: Pen) -> None:
    """Closed lines about a middle that the lid has drawn to the right."""
    pen.fill("stage")
    left, top, size = 40.0, 14.0, 80.0
    pen.box(left, top, size, size, "body")
    for part, color in ((0.92, "chalk"), (0.68, "chalk"), (0.44, "green"), (0.2, "amber")):
        line = []
        for k in range(61):
            a = 2.0 * math.pi * k / 60.0
            bulge = 1.0 - 0.14 * (1.0 - part) * math.cos(4.0 * a)
            x = left + 0.5 * size + 0.12 * size * (1.0 - part) + 0.46 * size * part * bulge * math.cos(a)
            y = top + 0.46 * size - 0.1 * size * (1.0 - part) + 0.44 * size * part * bulge * math.sin(a)
            line.append((x, y))
        pen.line(line, color, 1.6)
    pen.line(((left, top), (left, top + size), (left + size, top + size), (left + size, top)), "text2", 2.0)
    pen.arrow((left + 8.0, top - 4.0), (left + size - 6.0, top - 4.0), "amber", 2.2)
