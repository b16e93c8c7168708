"""The card: a dam that has broken."""

from __future__ import annotations

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"waves": CloseUp(shown_s=1.2, zoom=1.4, across=0.5, down=0.6)}


def draw_dam(pen: Pen) -> None:
    """Deep water, the fan, the front on dry ground."""
    pen.fill("stage")
    left, right, low = 12.0, 148.0, 92.0
    surface = [(left, 34.0), (52.0, 34.0)]
    for k in range(25):
        share = k / 24.0
        surface.append((52.0 + 84.0 * share, low - (low - 34.0) * (1.0 - share) ** 2))
    pen.area([*surface, (right, low), (left, low)], "body")
    pen.line(surface, "chalk", 2.0)
    pen.line(((left, low), (right, low)), "text2", 2.0)
    pen.line(((80.0, 20.0), (80.0, low)), "text3", 1.0, dash=3.0)
    pen.arrow((112.0, 70.0), (140.0, 70.0), "amber", 2.2)
