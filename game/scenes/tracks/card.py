"""The card: a ball in a loop."""

from __future__ import annotations

import math

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"tracks": CloseUp(shown_s=0.4, zoom=1.1, across=0.55, down=0.6)}


def draw_loop(pen: Pen) -> None:
    """A ramp, a loop, a way on; a ball high up inside."""
    pen.fill("stage")
    ground, radius, middle = 88.0, 30.0, 88.0
    ramp = [(8.0 + 80.0 * t, 16.0 + 72.0 * (1.0 - (1.0 - t) ** 2)) for t in (k / 20.0 for k in range(21))]
    turns = [2.0 * math.pi * k / 60.0 for k in range(61)]
    loop = [(middle + radius * math.sin(a), ground - radius + radius * math.cos(a)) for a in turns]
    pen.line((*ramp, *loop, (152.0, ground)), "text2", 2.4)
    angle = math.radians(60.0)
    x, y = middle + (radius - 7.0) * math.sin(angle), ground - radius - (radius - 7.0) * math.cos(angle)
    pen.disc(x, y, 7.0, "chalk")
    pen.disc(x, y, 7.0, "text1", ring=1.4)
    pen.arrow((x, y), (x - 20.0, y - 13.0), "amber", 2.0)
