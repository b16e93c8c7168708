"""The card: a hull that heels, with its weight and lift."""

from __future__ import annotations

import math

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"floating": CloseUp(shown_s=0.3, zoom=2.2, across=0.25, down=0.3)}


def draw_hull(pen: Pen) -> None:
    """Water, a tilted hull, G, B and M."""
    pen.fill("stage")
    pen.area([(12.0, 54.0), (148.0, 54.0), (148.0, 96.0), (12.0, 96.0)], "body")
    hull = [(-44.0, -18.0), (44.0, -18.0), (34.0, 6.0), (0.0, 24.0), (-34.0, 6.0)]
    c, s = math.cos(0.3), math.sin(0.3)
    corners = [(80.0 + c * x - s * y, 52.0 + s * x + c * y) for x, y in hull]
    pen.area(corners, "ghost")
    pen.line([*corners, corners[0]], "text1", 2.0)
    pen.line(((12.0, 54.0), (148.0, 54.0)), "chalk", 2.0)
    pen.arrow((78.0, 50.0), (78.0, 78.0), "amber")
    pen.arrow((90.0, 62.0), (90.0, 26.0), "green")
    pen.disc(78.0, 50.0, 4.0, "amber")
    pen.disc(90.0, 62.0, 4.0, "green")
