"""The help figure: de Casteljau's corners."""

from __future__ import annotations

from itertools import pairwise

from game.scenes.shared.marks import between, dot, spaced
from game.ui.canvas.pen import Pen, Point


def draw_casteljau(pen: Pen) -> None:
    """A cubic Bezier curve and de Casteljau's construction of its point at u = 0.4."""
    corners: list[Point] = [(34.0, 168.0), (70.0, 42.0), (204.0, 34.0), (262.0, 164.0)]
    u = 0.4
    levels = [corners]
    while len(levels[-1]) > 1:
        levels.append([between(a, b, u) for a, b in pairwise(levels[-1])])
    path = [_bezier(corners, s) for s in spaced(0.0, 1.0, 60)]
    pen.line(corners, "text3", 1.2)
    pen.line(levels[1], "chalk", 1.4)
    pen.line(levels[2], "green", 1.8)
    pen.line(path, "text1", 2.2)
    for points, color in zip(levels[1:], ("chalk", "green"), strict=False):
        for point in points:
            dot(pen, point, color, 3.2)
    for corner in corners:
        dot(pen, corner, "accent", 4.2, ring=1.6)
    dot(pen, levels[3][0], "amber", 4.5)
    names = ((-4.0, 17.0), (-16.0, -8.0), (16.0, -8.0), (4.0, 17.0))
    for i, ((x, y), (dx, dy)) in enumerate(zip(corners, names, strict=True)):
        pen.formula(f"P_{i}", x + dx, y + dy)
    first, last = levels[1][0], corners[1]
    pen.formula("u", *_beside(corners[0], first, 11.0), "text2")
    pen.formula("1-u", *_beside(first, last, 22.0), "text2")
    pen.formula("B(u)", levels[3][0][0] + 3.0, levels[3][0][1] + 18.0, "amber")


def _bezier(corners: list[Point], u: float) -> Point:
    while len(corners) > 1:
        corners = [between(a, b, u) for a, b in pairwise(corners)]
    return corners[0]


def _beside(a: Point, b: Point, gap: float) -> Point:
    """A point at the left of the middle of a line that goes up."""
    x, y = between(a, b, 0.5)
    return x - gap, y
