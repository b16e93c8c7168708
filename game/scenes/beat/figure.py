"""The help page's figure: a ball laid where one that moves will just meet it on the beat."""

from __future__ import annotations

import math

from game.scenes.shared.marks import ahead, dot
from game.ui.canvas.pen import Pen, Point

RADIUS = 15.0


def draw_laying(pen: Pen) -> None:
    """A path with its places at two beats, and the places that the next ball may take."""
    start = (28.0, 150.0)
    met = ahead(start, 22.0, 118.0)
    pen.line((start, met), "text1", 1.5, 4.0)
    _ball(pen, start, "text1")
    dot(pen, start, "amber", 2.6)
    pen.disc(*met, RADIUS, "text1", ring=1.4)
    dot(pen, met, "amber", 2.6)
    for turn in (-62.0, -38.0, 38.0, 62.0):
        pen.disc(*ahead(met, 22.0 + turn, 2.0 * RADIUS), RADIUS, "text3", ring=1.0)
    laid = ahead(met, 36.0, 2.0 * RADIUS)
    _ball(pen, laid, "vermilion")
    pen.arrow(laid, ahead(laid, 36.0, 62.0), "vermilion")
    after = 22.0 - 54.0
    pen.arrow(met, ahead(met, after, 44.0), "text1")
    pen.formula("t_k", start[0], start[1] + 27.0, "amber")
    pen.formula("t_{k+1}", met[0] - 22.0, met[1] + 22.0, "amber")
    pen.formula(r"2 R", *_beside(met, laid), "text1")


def _beside(a: Point, b: Point) -> Point:
    """A place a little off the middle of two points."""
    middle = 0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])
    across = math.atan2(b[0] - a[0], b[1] - a[1])
    return middle[0] - 13.0 * math.cos(across) - 6.0, middle[1] + 13.0 * math.sin(across) - 8.0


def _ball(pen: Pen, at: Point, color: str) -> None:
    pen.disc(*at, RADIUS, pen.veiled("body", 0.2))
    pen.disc(*at, RADIUS, color, ring=1.5)
