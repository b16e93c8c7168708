"""The help figure: a ball high up in a loop, with what acts on it."""

from __future__ import annotations

import math

from game.scenes.shared.marks import ahead, dot
from game.ui.canvas.pen import Pen


def draw_forces(pen: Pen) -> None:
    """A disc in the upper right of a loop: weight, push of the track, speed; the ramp that it came from."""
    centre, loop, radius, at = (196.0, 112.0), 72.0, 16.0, 52.0
    foot = centre[1] + loop
    ramp = [(6.0 + 190.0 * t, foot - 146.0 * (1.0 - t) ** 2) for t in (k / 40.0 for k in range(41))]
    turns = [-90.0 + 3.6 * k for k in range(101)]
    pen.line((*ramp, *[ahead(centre, a, loop) for a in turns], (290.0, foot)), "text2", 2.6)
    pen.line([ahead(centre, a, loop - radius) for a in turns], "text3", 1.0, dash=4.0)
    ball, touch = ahead(centre, at, loop - radius), ahead(centre, at, loop)
    pen.disc(*ball, radius, pen.veiled("chalk", 0.25))
    pen.disc(*ball, radius, "chalk", ring=1.8)
    pen.arrow(ball, (ball[0], ball[1] + 46.0), "amber", 2.4)
    pen.arrow(touch, ahead(touch, at + 180.0, 40.0), "text1", 2.0)
    pen.arrow(ball, ahead(ball, at + 90.0, 56.0), "green", 2.2)
    dot(pen, ball, "text1", 3.0)
    start = ahead((15.0, foot - 134.0), math.degrees(math.atan2(1.0, 1.4)), 13.0)
    pen.disc(*start, 13.0, pen.veiled("text2", 0.2))
    pen.disc(*start, 13.0, "text2", ring=1.2)
    pen.formula(r"m \v{g}", ball[0] - 2.0, ball[1] + 58.0, "amber")
    pen.formula("N", *ahead(ahead(touch, at + 180.0, 46.0), at - 90.0, 8.0))
    pen.formula(r"\v{v}", *ahead(ahead(ball, at + 90.0, 58.0), 140.0, 12.0), "green")
    pen.formula("R", centre[0] - 36.0, centre[1] + 2.0, "text2")
    pen.line((centre, ahead(centre, 200.0, loop)), "text3", 1.0, dash=3.0)
    dot(pen, centre, "text2", 2.4)
