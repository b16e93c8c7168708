"""The help figure: forces on a plate that slides through the air."""

from __future__ import annotations

import math

from game.ui.canvas.pen import Pen


def draw_forces(pen: Pen) -> None:
    """A tilted plate, its velocity, lift, drag and weight, and the air that turns about it."""
    x, y, tilt = 132.0, 104.0, math.radians(24.0)
    dx, dy = 84.0 * math.cos(tilt), -84.0 * math.sin(tilt)
    pen.line(((x - dx, y - dy), (x + dx, y + dy)), "text1", 5.0)
    pen.arc((x, y), 52.0, 200.0, 470.0, "line2", 1.4)
    pen.formula(r"\Gamma", x - 62.0, y - 40.0, "text2")
    pen.arrow((x, y), (x - 74.0, y + 62.0), "chalk")
    pen.formula(r"\v{u}", x - 84.0, y + 58.0, "chalk")
    pen.arrow((x, y), (x + 46.0, y - 38.0), "vermilion")
    pen.formula(r"\v{F}", x + 58.0, y - 42.0, "vermilion")
    pen.arrow((x, y), (x - 38.0, y - 52.0), "green")
    pen.words("lift", x - 48.0, y - 62.0, "green")
    pen.arrow((x, y), (x, y + 66.0), "amber")
    pen.words("weight", x + 30.0, y + 62.0, "amber")
    pen.words("α", x - 62.0, y + 34.0, "text2")
    pen.words("drag", x + 92.0, y - 26.0, "vermilion")
