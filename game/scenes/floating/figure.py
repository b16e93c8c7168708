"""The help figure: a heeled hull, G, B and M, and the righting arm."""

from __future__ import annotations

import math

from game.ui.canvas.pen import Pen

MIDDLE, LEVEL = 148.0, 112.0


def draw_heel(pen: Pen) -> None:
    """Weight at G, lift at B; where lift crosses the hull's middle line is M."""
    pen.area([(16.0, LEVEL), (280.0, LEVEL), (280.0, 196.0), (16.0, 196.0)], "body")
    hull = [(-92.0, -36.0), (92.0, -36.0), (76.0, 12.0), (0.0, 52.0), (-76.0, 12.0)]
    c, s = math.cos(0.32), math.sin(0.32)
    corners = [(MIDDLE + c * x - s * y, LEVEL - 4.0 + s * x + c * y) for x, y in hull]
    pen.line([*corners, corners[0]], "text1", 2.0)
    pen.line(((16.0, LEVEL), (280.0, LEVEL)), "chalk", 2.0)
    g, b = (MIDDLE - 2.0, LEVEL), (MIDDLE + 22.0, LEVEL + 22.0)
    m = (b[0], LEVEL - 72.0)
    pen.line((g, m), "text3", 1.4, dash=4.0)
    pen.arrow(g, (g[0], g[1] + 58.0), "amber", 2.2)
    pen.arrow(b, (b[0], b[1] - 58.0), "green", 2.2)
    pen.line((b, m), "violet", 1.4, dash=4.0)
    for (x, y), color, name in ((g, "amber", "G"), (b, "green", "B"), (m, "violet", "M")):
        pen.disc(x, y, 4.0, color)
        pen.formula(name, x + (12.0 if name != "G" else -12.0), y - 2.0, "text1")
    pen.line((g, (b[0], g[1])), "vermilion", 2.4)
    pen.words("righting arm", g[0] - 12.0, g[1] - 14.0, "vermilion", "right")
