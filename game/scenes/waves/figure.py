"""The help figure: a broken dam, its fan, and the speeds of its ends."""

from __future__ import annotations

from game.ui.canvas.pen import Pen

LEFT, RIGHT, LOW, HIGH, DAM = 16.0, 284.0, 160.0, 60.0, 118.0
SCALE = 46.0  # px for a wave's way


def draw_fan(pen: Pen) -> None:
    """Ritter's parabola between a wave that goes back and a front that goes twice as fast."""
    back, front = DAM - SCALE, DAM + 2.0 * SCALE
    surface = [(LEFT, HIGH), (back, HIGH)]
    for k in range(41):
        share = k / 40.0
        surface.append((back + (front - back) * share, LOW - (LOW - HIGH) * (1.0 - share) ** 2))
    pen.area([*surface, (RIGHT, LOW), (LEFT, LOW)], "body")
    pen.line(surface, "chalk", 2.0)
    pen.line(((LEFT, LOW), (RIGHT, LOW)), "text1", 2.0)
    pen.line(((DAM, 34.0), (DAM, LOW)), "text3", 1.0, dash=3.0)
    pen.words("dam", DAM, 26.0, "text2")
    pen.arrow((back + 16.0, 46.0), (back - 10.0, 46.0), "vermilion", 2.0)
    pen.formula("c_0", back - 22.0, 46.0, "vermilion")
    pen.arrow((front - 6.0, 146.0), (front + 26.0, 146.0), "amber", 2.0)
    pen.formula("2 c_0", front + 42.0, 146.0, "amber")
    pen.disc(DAM, LOW - (LOW - HIGH) * 4.0 / 9.0, 3.0, "amber")
    pen.formula(r"\frac{4}{9} h_0", DAM + 24.0, LOW - (LOW - HIGH) * 4.0 / 9.0 - 16.0, "amber")
    pen.formula("h_0", LEFT + 16.0, 0.5 * (LOW + HIGH), "text1")
