"""The cards: water in a glass with a ball afloat; a dam drawn twice."""

from __future__ import annotations

import math

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {
    "liquid": CloseUp(shown_s=0.6, zoom=1.3, across=0.45, down=0.6),
    "dam": CloseUp(shown_s=0.5, zoom=1.3, across=0.4, down=0.5),
}


def draw_glass(pen: Pen) -> None:
    """A tank, waves, a ball, a jet."""
    pen.fill("stage")
    left, right, low = 22.0, 138.0, 92.0
    top = [(left + (right - left) * k / 40, 52.0 + 5.0 * math.sin(0.32 * k)) for k in range(41)]
    pen.area([*top, (right, low), (left, low)], "body")
    pen.line(top, "chalk", 2.0)
    pen.area([(48.0, 12.0), (56.0, 12.0), (54.0, 56.0), (50.0, 56.0)], "chalk")
    pen.disc(102.0, 54.0, 11.0, "amber")
    pen.line(((left, 24.0), (left, low), (right, low), (right, 24.0)), "text2", 2.0)


def draw_dams(pen: Pen) -> None:
    """A column that falls, above; the fan of shallow water, below."""
    pen.fill("stage")
    for low, power in ((50.0, 1.0), (94.0, 2.0)):
        top = [(16.0, low - 34.0), (40.0, low - 34.0)]
        top += [(40.0 + 4.0 * k, low - 34.0 * (1.0 - k / 25.0) ** power) for k in range(26)]
        pen.area([*top, (16.0, low)], "body")
        pen.line(top, "chalk", 1.8)
        pen.line(((12.0, low), (148.0, low)), "text2", 1.6)
    pen.line(((112.0, 8.0), (112.0, 98.0)), "amber", 1.2, dash=3.0)
