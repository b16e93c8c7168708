"""The card and the help figure of the splash."""

from __future__ import annotations

import math

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"splash": CloseUp(level="default", shown_s=0.26, zoom=2.2, across=0.5, down=0.6)}


def _crown(pen: Pen, x: float, y: float, k: float) -> None:
    """Pool, crater and crown about a place on the level, so many times as large."""
    left, right, low = x - 74.0 * k, x + 74.0 * k, y + 44.0 * k
    half = [
        (74.0, 0.0), (50.0, -1.0), (38.0, -7.0), (33.0, -20.0), (37.0, -30.0), (29.0, -22.0), (24.0, -4.0),
        (17.0, 14.0), (8.0, 20.0), (0.0, 21.5),
    ]  # fmt: skip
    top = [(x - k * a, y + k * b) for a, b in half] + [(x + k * a, y + k * b) for a, b in reversed(half[:-1])]
    pen.area([*top, (right, low), (left, low)], "body")
    pen.line(top, "chalk", 2.0)
    for a, b, size in ((40.0, -37.0, 1.6), (45.0, -41.0, 1.1)):
        pen.disc(x - k * a, y + k * b, k * size, "chalk")
        pen.disc(x + k * a, y + k * b, k * size, "chalk")


def draw_crown(pen: Pen) -> None:
    """The crater with its crown."""
    pen.fill("stage")
    _crown(pen, 80.0, 56.0, 1.0)


def draw_limit(pen: Pen) -> None:
    """The half round crater that energy allows, around the one that is there."""
    _crown(pen, 148.0, 96.0, 1.8)
    arc = [(148.0 + 66.0 * math.cos(0.1 * k), 96.0 + 66.0 * math.sin(0.1 * k)) for k in range(32)]
    pen.line(arc, "amber", 1.6, dash=4.0)
    pen.formula("R", 182.0, 118.0, "text1")
    pen.arrow((148.0, 96.0), (148.0 + 66.0 * 0.8, 96.0 + 66.0 * 0.6), "amber")
    pen.disc(148.0, 30.0, 12.0, "chalk")
    pen.arrow((148.0, 46.0), (148.0, 74.0), "text2")
    pen.formula("U", 162.0, 58.0, "text1")
