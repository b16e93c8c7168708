"""The help figure: a disc on a curved track, with what acts on it."""

from __future__ import annotations

import math

from game.scenes.shared.marks import ahead, dot
from game.ui.canvas.pen import Pen


def draw_rolling(pen: Pen) -> None:
    """A disc rolls down into a bowl: weight, push of the track, friction, and the circle of its centre."""
    middle, bowl, radius, at = (148.0, 20.0), 152.0, 34.0, 232.0
    turns = [200.0 + 1.4 * k for k in range(101)]
    pen.line([ahead(middle, a, bowl) for a in turns], "text2", 2.6)
    pen.line([ahead(middle, a, bowl - radius) for a in turns[8:-8]], "text3", 1.0, dash=4.0)
    centre, touch = ahead(middle, at, bowl - radius), ahead(middle, at, bowl)
    pen.disc(*centre, radius, pen.veiled("chalk", 0.25))
    pen.disc(*centre, radius, "chalk", ring=1.8)
    pen.arrow(centre, (centre[0], centre[1] + 60.0), "amber", 2.4)
    pen.arrow(touch, ahead(touch, at + 180.0, 50.0), "text1", 2.0)
    pen.arrow(touch, ahead(touch, at - 90.0, 34.0), "vermilion", 2.4)
    pen.arrow(centre, ahead(centre, at + 90.0, 62.0), "green", 2.2)
    dot(pen, centre, "text1", 3.0)
    dot(pen, touch, "amber", 3.6)
    pen.formula(r"m \v{g}", centre[0] + 18.0, centre[1] + 62.0, "amber")
    pen.formula("N", *ahead(ahead(touch, at + 180.0, 50.0), at + 90.0, 12.0))
    pen.formula("F", *ahead(ahead(touch, at - 90.0, 34.0), at, 13.0), "vermilion")
    pen.formula(r"\dot{s}", *ahead(ahead(centre, at + 90.0, 62.0), math.degrees(0.6), 12.0), "green")
    pen.words("way of the centre", 214.0, 96.0, "text3")
