"""The card: a splash on the left, one on the right, and one between them."""

from __future__ import annotations

import math

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"splash-blend": CloseUp(shown_s=0.4, zoom=1.2, across=0.5, down=0.5)}


def draw_between(pen: Pen) -> None:
    """Three heaps of water, the middle one between the others."""
    pen.fill("stage")
    for left, share, color in ((6.0, 0.0, "body"), (58.0, 0.5, "chalk"), (110.0, 1.0, "body")):
        low = 84.0
        top = []
        for k in range(23):
            x = 2.0 * k
            crest = 8.0 + 28.0 * share
            top.append((left + x, low - 14.0 - (38.0 - 14.0 * share) * math.exp(-(((x - crest) / 7.0) ** 2))))
        pen.area([*top, (left + 44.0, low), (left, low)], color)
        pen.line([*top], "text1", 1.4)
    pen.line(((12.0, 96.0), (148.0, 96.0)), "text3", 2.0)
    pen.disc(80.0, 96.0, 4.0, "amber")
