"""The help figure: an impact on a stone."""

from __future__ import annotations

import math

from game.ui.canvas.pen import Pen


def draw_impact(pen: Pen) -> None:
    """Newton's law of impact with e = 0.5, drawn to scale."""
    center, radius, hit = (148.0, 244.0), 128.0, 100.0  # the normal's angle, degrees
    turn = math.radians(hit)
    nx, ny = math.cos(turn), -math.sin(turn)
    x, y = center[0] + radius * nx, center[1] + radius * ny
    before = (84.0, 62.0)
    along = before[0] * nx + before[1] * ny
    after = (before[0] - 1.5 * along * nx, before[1] - 1.5 * along * ny)
    pen.disc(*center, radius, pen.veiled("body", 0.2))
    pen.disc(*center, radius, "text1", ring=1.4)
    pen.line(((x, y), (x + 84.0 * nx, y + 84.0 * ny)), "text2", 1.2, dash=3.0)
    pen.arrow((x - before[0], y - before[1]), (x - 5.0, y - 3.6), "chalk", 2.2)
    pen.arrow((x + 4.0, y + 0.3), (x + after[0], y + after[1]), "green", 2.2)
    pen.disc(x, y, 4.5, "amber")
    pen.disc(x, y, 8.0, "amber", ring=1.4)
    pen.formula(r"\v{v}^-", x - before[0] + 2.0, y - before[1] - 12.0, "chalk")
    pen.formula(r"\v{n}", x + 84.0 * nx - 12.0, y + 84.0 * ny + 6.0, "text1")
    pen.formula(r"\v{v}^+", x + after[0] + 4.0, y + after[1] - 13.0, "green")
    pen.formula("e = 0.5", center[0], 186.0, "text1")
