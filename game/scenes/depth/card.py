"""The card: a bar that leaves a slot with a turn."""

from __future__ import annotations

import math

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"p32": CloseUp(shown_s=0.5, zoom=1.7, across=0.36, down=0.5)}


def draw_way_out(pen: Pen) -> None:
    """A slot, a bar askew in it, and where a turn takes it."""
    pen.fill("stage")
    walls = ((34.0, 26.0, 34.0, 66.0), (92.0, 26.0, 34.0, 66.0), (34.0, 78.0, 92.0, 14.0))
    for left, top, wide, high in walls:
        pen.box(left, top, wide, high, "body")
    for angle, color, x, y in ((66.0, "chalk", 80.0, 42.0), (90.0, "green", 80.0, 38.0)):
        c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
        corners = [
            (x + c * u + s * v, y - s * u + c * v) for u, v in ((-32, -7), (32, -7), (32, 7), (-32, 7))
        ]
        pen.line((*corners, corners[0]), color, 2.0)
    pen.disc(80.0, 42.0, 2.6, "amber")
