"""The help figure: a cavity, its lid, and the two profiles that are compared."""

from __future__ import annotations

from game.scenes.cavity.published import GHIA_U, GHIA_V, HEIGHTS, PLACES
from game.ui.canvas.pen import Pen

LEFT, TOP, SIZE = 66.0, 26.0, 164.0


def draw_profiles(pen: Pen) -> None:
    """u along the vertical and v along the horizontal centre line, at Re 400 (Ghia and others 1982)."""
    pen.box(LEFT, TOP, SIZE, SIZE, "body")
    middle = LEFT + 0.5 * SIZE, TOP + 0.5 * SIZE
    pen.line(((middle[0], TOP), (middle[0], TOP + SIZE)), "text3", 1.0, dash=3.0)
    pen.line(((LEFT, middle[1]), (LEFT + SIZE, middle[1])), "text3", 1.0, dash=3.0)
    along = [
        (middle[0] + 0.4 * SIZE * u, TOP + SIZE * (1.0 - y))
        for y, u in zip(HEIGHTS, GHIA_U[400], strict=True)
    ]
    upright = [
        (LEFT + SIZE * x, middle[1] - 0.4 * SIZE * v) for x, v in zip(PLACES, GHIA_V[400], strict=True)
    ]
    pen.line(along, "chalk", 2.0)
    pen.line(upright, "amber", 2.0)
    for points, color in ((along, "chalk"), (upright, "amber")):
        for x, y in points:
            pen.disc(x, y, 2.4, color)
    pen.line(((LEFT, TOP), (LEFT, TOP + SIZE), (LEFT + SIZE, TOP + SIZE), (LEFT + SIZE, TOP)), "text1", 2.0)
    pen.arrow((LEFT + 20.0, TOP - 6.0), (LEFT + SIZE - 20.0, TOP - 6.0), "text1", 2.0)
    pen.words("lid", LEFT + SIZE + 14.0, TOP - 6.0, "text2")
    pen.formula("u(y)", 40.0, 60.0, "chalk")
    pen.formula("v(x)", 256.0, 128.0, "amber")
