"""The card: a racked table from above."""

from __future__ import annotations

import pygame

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen
from game.ui.look.theme import FELT, FELT_LINE, WOOD_DARK

CLOSE_UPS = {"lecture-table": CloseUp(zoom=1.9, across=0.72)}


def draw_lecture_table(pen: Pen) -> None:
    pen.fill(WOOD_DARK)
    pen.box(-80.0, 5.0, 320.0, 94.0, FELT.lerp(pygame.Color("black"), 0.3))
    pen.box(-80.0, 8.0, 320.0, 88.0, FELT)
    pen.line(((30.0, 52.0), (80.0, 52.0)), FELT_LINE, 0.8, dash=3.0)
    pen.ball(26.0, 52.0, 6.2, 0)
    numbers = iter((1, 9, 2, 10, 8, 3, 11, 7, 14, 4, 5, 13, 15, 6, 12))
    for row in range(5):
        for i in range(row + 1):
            pen.ball(90.0 + 10.9 * row, 52.0 + 12.6 * (i - 0.5 * row), 6.2, next(numbers))
