"""The help figure: how a small difference grows from ball to ball."""

from __future__ import annotations

import math

from game.scenes.shared.marks import ahead, between, dot, span
from game.ui.canvas.pen import Pen, Point

RADIUS = 15.0
Path = tuple[Point, Point]


def _ball(pen: Pen, x: float, y: float, color: str = "text1", veil: float = 0.2) -> None:
    pen.disc(x, y, RADIUS, pen.veiled("body", veil))
    pen.disc(x, y, RADIUS, color, ring=1.5)


def draw_chaos(pen: Pen) -> None:
    """A combination of three balls, and the same one begun 2.4 px beside it."""
    aim, free, last = 27.0, 62.0, 76.0
    start = (30.0, 160.0)
    second = ahead(ahead(start, aim, 62.0), aim + 16.0, 2.0 * RADIUS)
    third = ahead(ahead(second, aim + 16.0, free), aim - 14.0, 2.0 * RADIUS)
    true = _combination(start, aim, second, third, last)
    other = _combination(ahead(start, aim - 90.0, 2.4), aim, second, third, last)
    for center in (start, second, third):
        _ball(pen, *center)
    for paths, color, dash in ((other, "vermilion", 0.0), (true, "text1", 4.0)):
        for a, b in paths:
            pen.line((a, b), color, 1.5, dash)
            dot(pen, b, color, 2.2)
        for _, b in paths[:2]:
            pen.disc(*b, RADIUS, color, ring=1.0)
    upper, lower = (ahead(paths[2][1], 0.0, 12.0) for paths in (true, other))
    span(pen, upper, lower, "amber", 1.4)
    pen.formula(r"\delta_0", start[0] + 27.0, start[1] + 6.0, "amber")
    pen.formula(r"\delta_1", true[1][1][0] - 12.0, true[1][1][1] - 27.0, "amber")
    pen.formula(r"\delta_2", true[2][1][0] + 27.0, true[2][1][1] + 9.0, "amber")
    pen.formula("l", *ahead(between(true[1][0], true[1][1], 0.6), aim + 106.0, 12.0))
    pen.formula(r"\delta_{i+1} \approx \frac{l}{2R} \delta_i", 210.0, 160.0)


def _combination(start: Point, aim: float, second: Point, third: Point, last: float) -> list[Path]:
    """The paths of three equal balls' centres, each to its impact; the last one ``last`` px."""
    paths = []
    for at, target in ((start, second), (second, third)):
        met, aim = _impact(at, aim, target)
        paths.append((at, met))
    return [*paths, (third, ahead(third, aim, last))]


def _impact(start: Point, aim: float, target: Point) -> tuple[Point, float]:
    """Where a ball that rolls from ``start`` meets another one, and the direction which that one takes."""
    angle = math.radians(aim)
    dx, dy = target[0] - start[0], start[1] - target[1]
    near = dx * math.cos(angle) + dy * math.sin(angle)
    aside = dy * math.cos(angle) - dx * math.sin(angle)
    met = ahead(start, aim, near - math.sqrt(4.0 * RADIUS * RADIUS - aside * aside))
    return met, math.degrees(math.atan2(met[1] - target[1], target[0] - met[0]))
