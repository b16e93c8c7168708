"""The card: honey that folds as it lands."""

from __future__ import annotations

import math

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"honey": CloseUp(shown_s=2.0, zoom=1.2, across=0.5, down=0.6)}


def draw_drops(pen: Pen) -> None:
    """A thread that winds up to a heap, and a drop."""
    pen.fill("stage")
    heap = [
        (80.0 + 46.0 * math.cos(k * math.pi / 24.0), 92.0 - 30.0 * math.sin(k * math.pi / 24.0))
        for k in range(25)
    ]
    pen.area(heap, "amber")
    thread = [(80.0 + 9.0 * math.sin(0.09 * y) * y / 60.0, float(y)) for y in range(8, 66, 2)]
    pen.line(thread, "amber", 9.0)
    pen.line([(x - 2.0, y) for x, y in thread], "text1", 1.2)
    pen.line(((20.0, 92.0), (140.0, 92.0)), "text2", 2.0)
    pen.disc(128.0, 60.0, 7.0, "chalk")
    pen.disc(126.0, 57.0, 2.0, "text1")
