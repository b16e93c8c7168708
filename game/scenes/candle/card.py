"""The card and the help figure of the candle."""

from __future__ import annotations

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen

CLOSE_UPS = {"candle": CloseUp(shown_s=3.0, zoom=2.4, across=0.5, down=0.75)}


def _candle(pen: Pen, x: float, y: float, k: float) -> None:
    """Candle and flame on a table at (x, y), so many times as large."""
    pen.box(x - 7.0 * k, y - 30.0 * k, 14.0 * k, 30.0 * k, "chalk")
    pen.line(((x, y - 30.0 * k), (x, y - 36.0 * k)), "text3", 1.6 * k)
    for size, lift, ink in ((6.0, 40.0, "vermilion"), (4.4, 39.0, "amber"), (2.6, 38.0, "yellow")):
        pen.disc(x, y - lift * k, size * k, ink)
    pen.line(((x, y - 44.0 * k), (x, y - 54.0 * k)), "amber", 3.0 * k)


def draw_candle(pen: Pen) -> None:
    """The flame under its glass."""
    pen.fill("stage")
    pen.box(0.0, 90.0, 160.0, 4.0, "ghost")
    _candle(pen, 80.0, 90.0, 0.9)
    pen.line(((50.0, 90.0), (50.0, 22.0), (110.0, 22.0), (110.0, 90.0)), "text2", 3.0)


def draw_glass(pen: Pen) -> None:
    """What goes in and out of the glass: nothing; what the flame takes and gives."""
    pen.line(((0.0, 176.0), (296.0, 176.0)), "line2", 1.4)
    _candle(pen, 148.0, 176.0, 1.4)
    pen.line(((80.0, 176.0), (80.0, 44.0), (216.0, 44.0), (216.0, 176.0)), "text2", 2.4)
    pen.formula("A", 100.0, 62.0, "text1")
    pen.arrow((104.0, 150.0), (138.0, 134.0), "chalk", 2.0)
    pen.formula("s m", 104.0, 162.0, "text1")
    pen.arrow((148.0, 92.0), (148.0, 60.0), "vermilion", 2.0)
    pen.formula("P", 164.0, 76.0, "text1")
