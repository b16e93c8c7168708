"""The card: a loop, three balls of steel, a funnel's edge."""

from __future__ import annotations

import math

import pygame

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"a22": CloseUp(shown_s=0.5, zoom=2.6, across=0.22, down=0.5)}


STEEL = tuple(pygame.Color(one) for one in ("#4d5760", "#76828d", "#a3aeb8", "#f3f6f8"))


def _ball(pen: Pen, x: float, y: float, r: float) -> None:
    """Steel, lit from the upper left."""
    rim, dark, steel, light = STEEL
    pen.disc(x, y, r, rim)
    pen.disc(x - 0.03 * r, y - 0.04 * r, 0.92 * r, dark)
    pen.disc(x - 0.12 * r, y - 0.16 * r, 0.74 * r, steel)
    pen.disc(x - 0.3 * r, y - 0.38 * r, 0.26 * r, light)


def draw_balls(pen: Pen) -> None:
    """A ramp, a loop with a ball near its top, one that follows, one that hangs."""
    pen.fill("stage")
    ground, radius, middle = 90.0, 28.0, 92.0
    ramp = [(6.0 + 86.0 * t, 12.0 + 78.0 * (1.0 - (1.0 - t) ** 2)) for t in (k / 24.0 for k in range(25))]
    turns = [2.0 * math.pi * k / 60.0 for k in range(61)]
    loop = [(middle + radius * math.sin(a), ground - radius + radius * math.cos(a)) for a in turns]
    way = (*ramp, *loop, (154.0, ground))
    pen.line([(x + 3.0, y + 4.0) for x, y in way], "ghost", 2.0)
    pen.line(way, "text2", 3.0)
    angle = math.radians(68.0)
    _ball(
        pen,
        middle + (radius - 8.0) * math.sin(angle),
        ground - radius - (radius - 8.0) * math.cos(angle),
        8.0,
    )
    _ball(pen, 34.0, 45.0, 7.0)
    pen.line(((142.0, 0.0), (142.0, 34.0)), "text3", 1.0)
    _ball(pen, 142.0, 42.0, 9.0)
