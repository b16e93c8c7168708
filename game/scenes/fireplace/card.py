"""The card: logs on a grate, and flames."""

from __future__ import annotations

import math

import pygame

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"a26": CloseUp(shown_s=0.5, zoom=1.6, across=0.5, down=0.62)}
TONGUES = ((80.0, 62.0, 20.0, 0xC8460A), (62.0, 40.0, 13.0, 0xE0701A), (98.0, 46.0, 14.0, 0xE0701A),
           (80.0, 40.0, 12.0, 0xFFC452))  # fmt: skip


def draw_hearth(pen: Pen) -> None:
    """Two logs, and four tongues of flame, the inner one the brightest."""
    pen.fill("stage")
    pen.box(20.0, 88.0, 120.0, 7.0, "ghost")
    for x, tall, half, ink in TONGUES:
        points = []
        for k in range(25):
            share = k / 24.0
            wide = half * math.sin(math.pi * share**0.62) * (1.0 - 0.25 * share)
            points.append((share, wide))
        lean = 3.0 * math.sin(x)
        left = [(x - w + lean * s * s * 3.0, 80.0 - tall * s) for s, w in points]
        right = [(x + w + lean * s * s * 3.0, 80.0 - tall * s) for s, w in reversed(points)]
        pen.area(left + right, pygame.Color(ink >> 16 & 255, ink >> 8 & 255, ink & 255))
    for y, x0, x1 in ((82.0, 36.0, 124.0), (72.0, 46.0, 112.0)):
        pen.area([(x0, y - 5.0), (x1, y - 5.0), (x1, y + 5.0), (x0, y + 5.0)], pygame.Color(74, 48, 32))
        pen.disc(x1, y, 5.0, pygame.Color(168, 122, 80))
    for x in (44.0, 116.0):
        pen.line(((x, 88.0), (x, 60.0)), "text3", 2.0)
