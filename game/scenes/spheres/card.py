"""The card: a cradle of spheres."""

from __future__ import annotations

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"c13": CloseUp(shown_s=1.2, zoom=1.5, across=0.6, down=0.4)}


def draw_cradle(pen: Pen) -> None:
    """Newton's cradle, the first ball coming down."""
    pen.fill("stage")
    pen.line(((46.0, 18.0), (126.0, 18.0)), "line2", 2.4)
    balls = [(62.0 + 16.0 * i, 76.0, 62.0 + 16.0 * i) for i in range(1, 4)]
    balls.append((62.0 - 44.0 * 0.68, 18.0 + 58.0 * 0.87, 62.0))
    for x, y, tie in balls:
        pen.line(((tie, 18.0), (x, y)), "ghost", 0.8)
    for i, (x, y, _) in enumerate(balls):
        tone = "chalk" if i == 3 else "text1"
        pen.disc(x, y, 8.0, "body")
        pen.disc(x, y, 8.0, tone, ring=1.5)
        pen.line(((x, y), (x + 7.0, y)), tone, 1.1)
    pen.arrow((40.0, 76.0), (58.0, 83.0), "chalk")
    pen.arrow((120.0, 76.0), (142.0, 76.0), "amber")
    pen.disc(118.0, 76.0, 2.2, "amber")
