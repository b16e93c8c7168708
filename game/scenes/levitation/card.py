"""The card: a standing wave between two rows, and grains in its nodes."""

from __future__ import annotations

import math

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"p28": CloseUp(shown_s=1.2, zoom=2.2, across=0.5, down=0.5)}


def draw_nodes(pen: Pen) -> None:
    """Two rows of transducers, the wave between them, three grains."""
    pen.fill("stage")
    for y, way in ((92.0, -1.0), (12.0, 1.0)):
        for k in range(9):
            pen.box(32.0 + 11.0 * k, y - (5.0 if way < 0 else 3.0), 8.0, 8.0, "body")
    middle = 80.0
    for side in (-1.0, 1.0):
        wave = [
            (middle + side * 26.0 * math.sin(math.pi * (y - 20.0) / 16.0), 1.0 * y) for y in range(20, 85)
        ]
        pen.line(wave, "chalk", 1.5)
    for y in (36.0, 52.0, 68.0):
        pen.disc(middle, y, 4.4, "yellow")
        pen.disc(middle, y, 4.4, "text1", ring=1.0)
    pen.arrow((100.0, 52.0), (128.0, 52.0), "amber", 1.8)
