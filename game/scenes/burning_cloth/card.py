"""The card: a cloth between two hooks, and four letters of fire in it."""

from __future__ import annotations

import math

import pygame

from game.scenes.burning_cloth.letters import _L, GAP, NARROW, WIDE
from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"a10": CloseUp(level="burning", shown_s=5.0, zoom=1.45, across=0.5, down=0.42)}
UNIT, LEFT, LOW = 4.9, 33.0, 72.0


def draw_cloth(pen: Pen) -> None:
    """The word in flame colours on linen."""
    pen.fill("stage")
    pen.line(((10.0, 12.0), (150.0, 12.0)), "text3", 4.0)
    upper = [(20.0 + 120.0 * k / 20.0, 22.0 + 9.0 * math.sin(math.pi * k / 20.0)) for k in range(21)]
    lower = [(x + 0.02 * (x - 80.0), y + 62.0) for x, y in reversed(upper)]
    pen.area(upper + lower, pygame.Color(214, 202, 178))
    for x in (20.0, 140.0):
        pen.line(((x, 12.0), (x, 22.0)), "text2", 2.0)
    left = LEFT
    for sign in "FIRE":
        for line in _L[sign]:
            places = [
                (left + UNIT * x, LOW - UNIT * y + 4.0 * math.sin(math.pi * (left - 20.0) / 120.0))
                for x, y in line
            ]
            pen.line(places, pygame.Color(70, 36, 20), 8.5)
            pen.line(places, pygame.Color(226, 92, 18), 5.5)
            pen.line(places, pygame.Color(255, 206, 96), 2.2)
        left += UNIT * (NARROW.get(sign, WIDE) + GAP)
