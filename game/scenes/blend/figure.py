"""The help figure: two runs as sheets in place and time, and points that belong together."""

from __future__ import annotations

import math

from game.ui.canvas.pen import Pen


def _sheet(pen: Pen, left: float, peak: float, color: str) -> list[tuple[float, float]]:
    """Heights of a splash at five times, one behind the other; the crests of all."""
    crests = []
    for k in range(5):
        low, back = 170.0 - 24.0 * k, left + 12.0 * k
        high = 34.0 * math.sin(math.pi * min(max((k + 1.0) / 6.0 + 0.1 * peak, 0.0), 1.0))
        line = [
            (back + x, low - high * math.exp(-(((x - 20.0 - 24.0 * peak) / 8.0) ** 2)))
            for x in range(0, 76, 3)
        ]
        pen.line(line, color, 1.6)
        crests.append((back + 20.0 + 24.0 * peak, low - high))
    return crests


def draw_sheets(pen: Pen) -> None:
    """Both sheets, and links between their crests."""
    first, other = _sheet(pen, 12.0, 0.0, "chalk"), _sheet(pen, 160.0, 1.0, "green")
    for start, end in zip(first, other, strict=True):
        pen.line((start, end), "amber", 1.2, dash=3.0)
        pen.disc(*start, 3.4, "amber")
        pen.disc(*end, 3.4, "amber")
    pen.words("time", 26.0, 60.0, "text2")
    pen.words("place", 56.0, 188.0, "text2")
