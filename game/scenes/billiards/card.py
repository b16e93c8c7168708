"""The card: a cue behind its ball."""

from __future__ import annotations

import pygame

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen
from game.ui.look.theme import FELT, FELT_COOL, FELT_LINE, WOOD_DARK

CLOSE_UPS = {"billiards": CloseUp(shown_s=4.1, zoom=2.2, across=0.7, down=0.48)}


def draw_billiards(pen: Pen) -> None:
    """A cut into the corner: cue, aim, ghost ball, the paths after it."""
    pen.fill(WOOD_DARK)
    pen.box(-80.0, 7.0, 226.0, 90.0, FELT.lerp(pygame.Color("black"), 0.3))
    pen.box(-80.0, 10.0, 223.0, 84.0, FELT)
    for x, y in ((148.0, 10.0), (148.0, 94.0), (70.0, 5.0), (70.0, 99.0)):
        pen.disc(x, y, 8.5, pygame.Color("#0A0B0C"))
    pen.line(((-60.0, 97.0), (36.0, 62.0)), pygame.Color("#D8AE74"), 2.6)
    pen.line(((36.0, 62.0), (39.0, 60.9)), pygame.Color("#3E8FD0"), 2.6)
    pen.line(((48.0, 57.6), (96.0, 40.0)), FELT_LINE, 1.0)
    pen.line(((104.5, 36.0), (142.0, 14.0)), FELT_COOL, 1.3, dash=3.0)
    pen.line(((96.0, 40.0), (108.0, 66.0), (124.0, 92.0), (100.0, 76.0)), FELT_LINE, 1.0, dash=3.0)
    pen.disc(96.0, 40.0, 6.2, FELT_LINE, ring=1.0)
    pen.ball(48.0, 57.6, 6.2, 0)
    pen.ball(106.6, 33.6, 6.2, 11)
    pen.ball(70.0, 26.0, 6.2, 8)
    pen.ball(24.0, 30.0, 6.2, 2)
    pen.ball(66.0, 80.0, 6.2, 14)
