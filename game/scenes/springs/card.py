"""The cards: a hanging cloth (C14), a jelly (C15)."""

from __future__ import annotations

import math
from itertools import pairwise

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen, Point

CLOSE_UPS = {
    "c14": CloseUp(zoom=1.4, down=0.55),
    "c15": CloseUp(shown_s=2.4, zoom=1.15, down=0.68),
}

CLOTH = (15, 8)  # cells across and down
JELLY = (9, 5)


def draw_cloth(pen: Pen) -> None:
    """A cloth held at two corners, moved by the wind."""
    pen.fill("stage")
    across, down = CLOTH
    knots = [[_knot(i / across, j / down) for i in range(across + 1)] for j in range(down + 1)]
    for row in knots:
        pen.line(row, "text1", 0.7)
    for column in zip(*knots, strict=True):
        pen.line(column, "text1", 0.7)
    for row in knots:
        for knot in row:
            pen.disc(*knot, 1.1, "text1")
    for x, y in (knots[0][0], knots[0][-1]):
        pen.box(x - 3.2, y - 3.2, 6.4, 6.4, "amber")


def _knot(u: float, v: float) -> Point:
    """Where a knot hangs; u across, v down, 0 to 1."""
    sag = 4.0 * u * (1.0 - u)
    wave = 3.0 * math.sin(7.0 * u + 3.0 * v) * v
    return 22.0 + 116.0 * u + 5.0 * v * (0.5 - u) + wave, 16.0 + 60.0 * v + 17.0 * sag * (0.55 + 0.45 * v)


def draw_jelly(pen: Pen) -> None:
    """A block of springs that a ball has just met: pressed below it, bulged beside."""
    pen.fill("stage")
    across, down = JELLY
    knots = [[_pressed(i / across, j / down) for i in range(across + 1)] for j in range(down + 1)]
    for above, below in pairwise(knots):
        for i in range(across):
            pen.line((above[i], below[i + 1]), "ghost", 0.6)
            pen.line((above[i + 1], below[i]), "ghost", 0.6)
    for j, row in enumerate(knots):
        for i, (a, b) in enumerate(pairwise(row)):
            pen.line((a, b), "vermilion" if j < 2 and 2 < i < 6 else "text1", 0.9)
    for column in zip(*knots, strict=True):
        for j, (a, b) in enumerate(pairwise(column)):
            pen.line((a, b), "chalk" if j < 2 and 60.0 < a[0] < 100.0 else "text1", 0.9)
    for row in knots:
        for knot in row:
            pen.disc(*knot, 1.5, "text1")
    for y, tone in ((10.0, "line"), (18.0, "line2")):
        pen.disc(80.0, y, 9.0, tone, ring=0.9)
    pen.disc(80.0, 32.0, 9.5, "body")
    pen.disc(80.0, 32.0, 9.5, "amber", ring=1.6)
    pen.line(((0.0, 95.0), (160.0, 95.0)), "line2", 1.0)


def _pressed(u: float, v: float) -> Point:
    """Where a knot of the pressed block is; u across, v down, 0 to 1."""
    dent = math.exp(-(((u - 0.5) / 0.17) ** 2))
    bulge = 9.0 * math.sin(math.pi * (0.15 + 0.85 * v)) * (2.0 * u - 1.0)
    return 36.0 + 88.0 * u + bulge, 36.0 + 58.0 * v + 9.0 * dent * (1.0 - v) - 3.0 * (1.0 - dent) * (1.0 - v)
