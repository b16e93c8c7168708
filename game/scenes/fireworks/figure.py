"""The help figure: how far stars of a burst fly, with and without air."""

from __future__ import annotations

import math

from game.ui.canvas.pen import Pen

SPEED, DRAG, SECONDS = 60.0, 0.022, 2.0  # m/s, 1/m, s
LEFT, RIGHT, BOTTOM, TOP = 40.0, 280.0, 176.0, 24.0
FARTHEST = 130.0  # m, at the upper edge


def draw_ballistics(pen: Pen) -> None:
    """r = ln(1 + c v t)/c over two seconds, below the straight line of empty space."""

    def at(t: float, r: float) -> tuple[float, float]:
        return LEFT + (RIGHT - LEFT) * t / SECONDS, BOTTOM - (BOTTOM - TOP) * r / FARTHEST

    times = [SECONDS * i / 60.0 for i in range(61)]
    pen.line((at(0.0, 0.0), at(SECONDS, 0.0)), "line2", 1.0)
    pen.line((at(0.0, 0.0), at(0.0, FARTHEST)), "line2", 1.0)
    pen.line((at(0.0, 0.0), at(SECONDS, SPEED * SECONDS)), "text2", 1.4, dash=4.0)
    pen.line([at(t, math.log1p(DRAG * SPEED * t) / DRAG) for t in times], "chalk", 2.4)
    for t in (0.5, 1.0, 1.5, 2.0):
        pen.disc(*at(t, math.log1p(DRAG * SPEED * t) / DRAG), 4.0, "amber")
    pen.words("radius", 34.0, 16.0, "text2", "left")
    pen.words("2 s", RIGHT, BOTTOM + 14.0, "text2", "right")
    pen.words("without air", 206.0, 46.0, "text2", "right")
    pen.formula(r"r = \frac{1}{c} \ln (1 + c v_0 t)", 196.0, 138.0, "chalk")
