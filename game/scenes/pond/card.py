"""The card: rings on water and a float."""

from __future__ import annotations

import math

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"p15": CloseUp(shown_s=2.0, zoom=1.3, across=0.55, down=0.5)}


def draw_pond(pen: Pen) -> None:
    """Two sets of rings that cross, a buoy in one of them."""
    pen.fill("stage")
    for x, y, count in ((58.0, 62.0, 5), (118.0, 40.0, 4)):
        for k in range(1, count + 1):
            radius = 10.0 * k
            points = [
                (x + radius * math.cos(math.tau * j / 48), y + 0.72 * radius * math.sin(math.tau * j / 48))
                for j in range(49)
            ]
            pen.line(points, "chalk" if k % 2 else "accent", 2.4 - 0.3 * k)
    pen.disc(118.0, 40.0, 7.0, "vermilion")
    pen.disc(118.0, 40.0, 3.5, "chalk")
