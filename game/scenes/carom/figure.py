"""The help figure: a point at three-cushion, counted."""

from __future__ import annotations

from game.scenes.shared.marks import dot
from game.ui.canvas.pen import Pen, Point

LEFT, TOP, WIDTH, HEIGHT = 22.0, 30.0, 252.0, 126.0
RADIUS = 8.0


def draw_three_cushions(pen: Pen) -> None:
    """Red ball, long, short, long, yellow ball: three cushions before the second object ball."""
    right, bottom = LEFT + WIDTH, TOP + HEIGHT
    pen.line(((LEFT, TOP), (right, TOP), (right, bottom), (LEFT, bottom), (LEFT, TOP)), "text1", 2.0)
    for k in range(1, 8):
        for y in (TOP - 6.0, bottom + 6.0):
            pen.disc(LEFT + WIDTH * k / 8.0, y, 1.6, "text3")
    for k in range(1, 4):
        for x in (LEFT - 6.0, right + 6.0):
            pen.disc(x, TOP + HEIGHT * k / 4.0, 1.6, "text3")
    cue, red, yellow = (62.0, 124.0), (150.0, 72.0), (112.0, 104.0)
    ghost = (142.0, 84.5)
    bounces = [(192.0, TOP + RADIUS), (right - RADIUS, 76.0), (210.0, bottom - RADIUS)]
    end = (yellow[0] + 13.0, yellow[1] + 7.0)
    path: list[Point] = [cue, ghost, *bounces, end]
    pen.line(path[:-1], "chalk", 1.8)
    pen.arrow(path[-2], path[-1], "chalk", 1.8)
    pen.arrow(red, (122.0, 46.0), "vermilion", 1.4)
    pen.disc(*ghost, RADIUS, "text2", ring=1.0)
    for at, color in ((cue, "text1"), (red, "vermilion"), (yellow, "yellow")):
        pen.disc(*at, RADIUS, pen.veiled("body", 0.2))
        pen.disc(*at, RADIUS, color, ring=1.8)
    for number, (at, off) in enumerate(zip(bounces, ((0.0, 15.0), (-14.0, 0.0), (0.0, -14.0)), strict=True)):
        dot(pen, at, "amber", 3.0)
        pen.words(str(number + 1), at[0] + off[0], at[1] + off[1], "amber", "center")
    pen.words("cue ball", cue[0], cue[1] + 19.0, "text2", "center")
    pen.words("red, long, short, long, yellow", LEFT + 0.5 * WIDTH, bottom + 26.0, "text1", "center")
