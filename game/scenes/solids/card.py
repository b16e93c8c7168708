"""The card: an arch of voussoirs that stands."""

from __future__ import annotations

import math

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen, Point

CLOSE_UPS = {"solids": CloseUp(shown_s=1.0, zoom=1.15, down=0.6, level="default")}
BLOCKS = 9


def draw_arch(pen: Pen) -> None:
    """A semicircle of blocks on the ground, one ball on top."""
    pen.fill("stage")
    pen.box(0.0, 90.0, 160.0, 14.0, "body")
    pen.line(((0.0, 90.0), (160.0, 90.0)), "line2", 1.0)
    for k in range(BLOCKS):
        a, b = math.pi * k / BLOCKS, math.pi * (k + 1) / BLOCKS
        corners = [_at(38.0, a), _at(58.0, a), _at(58.0, b), _at(38.0, b)]
        pen.area(corners, "chalk" if k == BLOCKS // 2 else "text3", 0.55)
        pen.line((*corners, corners[0]), "text1", 1.4)
    pen.disc(80.0, 22.0, 9.0, "body")
    pen.disc(80.0, 22.0, 9.0, "amber", ring=1.6)


def _at(radius: float, angle: float) -> Point:
    return 80.0 + radius * math.cos(angle), 90.0 - radius * math.sin(angle)
