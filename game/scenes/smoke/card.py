"""The card: two whirls, and smoke that they roll up."""

from __future__ import annotations

import math

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"smoke": CloseUp(shown_s=3.0, zoom=1.5, across=0.4, down=0.5)}


def draw_whirls(pen: Pen) -> None:
    """Two spirals from one stem."""
    pen.fill("stage")
    for side, color in ((-1.0, "chalk"), (1.0, "text2")):
        points = [(80.0, 98.0), (80.0, 64.0)]
        for k in range(64):
            angle = 0.5 * math.pi + k * 0.17
            radius = 27.0 * (1.0 - k / 70.0)
            points.append((80.0 + side * (29.0 - radius * math.sin(angle)), 40.0 - radius * math.cos(angle)))
        pen.line(points[2:], color, 3.0)
    pen.line(((80.0, 98.0), (80.0, 44.0)), "text1", 3.0)
