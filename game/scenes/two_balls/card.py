"""The card: two balls at the moment of their collision."""

from __future__ import annotations

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"lecture-balls": CloseUp(shown_s=1.2, zoom=1.8, across=0.33, down=0.52)}


def draw_two_balls(pen: Pen) -> None:
    pen.fill("stage")
    pen.line(((20.0, 88.0), (140.0, 16.0)), "ghost", 0.8, dash=3.0)
    for i, x in enumerate((18.0, 30.0, 44.0)):
        pen.disc(x, 70.0 - 0.25 * i, 13.0, "line" if i < 2 else "line2", ring=0.8)
    pen.disc(64.0, 61.6, 16.0, "body")
    pen.disc(64.0, 61.6, 16.0, "text1", ring=1.6)
    pen.disc(91.4, 45.1, 16.0, "body")
    pen.disc(91.4, 45.1, 16.0, "chalk", ring=1.6)
    pen.disc(77.7, 53.4, 2.6, "amber")
    pen.arrow((64.0, 61.6), (50.0, 40.0), "text1")
    pen.arrow((91.4, 45.1), (132.0, 20.7), "chalk")
