"""Drawings of the tables."""

from __future__ import annotations

import pygame

from game.ui.canvas.pen import Pen
from game.ui.look.theme import CUE_BALL, FELT, FELT_COOL, FELT_LINE, FELT_WARM, WOOD_DARK


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


def draw_billiards(pen: Pen) -> None:
    """A cut into the corner: cue, aim, ghost ball, the ways after it."""
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


def draw_three_tables(pen: Pen) -> None:
    pen.fill("stage")
    for left, top in ((10.0, 10.0), (84.0, 10.0), (47.0, 56.0)):
        pen.box(left, top, 66.0, 38.0, WOOD_DARK)
        pen.box(left + 3.0, top + 3.0, 60.0, 32.0, FELT)
        pen.line(
            ((left + 12, top + 27), (left + 50, top + 14), (left + 40, top + 3)), FELT_WARM, 0.9, dash=2.0
        )
        pen.disc(left + 12, top + 27, 2.4, CUE_BALL)
