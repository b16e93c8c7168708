"""Errors of stepping: a ball jumps over another one in a step; a small error grows from hit to hit."""

from __future__ import annotations

import math

from game.scenes.figures.marks import ahead, between, dot, span
from game.ui.canvas.pen import Pen, Point

RADIUS = 15.0
Way = tuple[Point, Point]


def _ball(pen: Pen, x: float, y: float, color: str = "text1", veil: float = 0.2) -> None:
    pen.disc(x, y, RADIUS, pen.veiled("body", veil))
    pen.disc(x, y, RADIUS, color, ring=1.5)


def draw_tunnelling(pen: Pen) -> None:
    """One step over another ball, and the same way in four substeps."""
    start, step, other = 42.0, 186.0, 141.0
    high, low = 62.0, 152.0
    for y in (high, low):
        _ball(pen, other, y)
    _ball(pen, start, high)
    pen.disc(start + step, high, RADIUS, "vermilion", ring=1.5)
    pen.arrow((start, high), (start + step, high), "chalk", 2.2)
    part = step / 4.0
    overlapping = start + 2.0 * part
    pen.disc(overlapping, low, RADIUS, pen.veiled("vermilion", 0.72))
    _ball(pen, start, low)
    pen.disc(start + part, low, RADIUS, "ghost", ring=1.2)
    pen.disc(other, low, RADIUS, "text1", ring=1.5)
    pen.disc(overlapping, low, RADIUS, "vermilion", ring=1.5)
    for i in range(2):
        pen.arrow((start + i * part, low), (start + (i + 1) * part, low), "chalk", 2.2)
    pen.formula(r"\v{x}_n", start, high - 29.0)
    pen.formula(r"\v{x}_{n+1}", start + step, high - 29.0, "vermilion")
    pen.formula(r"\v{v}_n \Delta t", 0.5 * (start + other) + 1.0, high - 12.0, "chalk")
    pen.formula(r"\frac{1}{4} \v{v}_n \Delta t", start + 0.5 * part, low + 36.0, "chalk")
    pen.words("no overlap, no hit", other, high + 30.0, "text2")
    pen.words("found in the second", other + 28.0, low - 4.0, "text2", align="left")
    pen.words("of four substeps", other + 28.0, low + 12.0, "text2", align="left")


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
    for ways, color, dash in ((other, "vermilion", 0.0), (true, "text1", 4.0)):
        for a, b in ways:
            pen.line((a, b), color, 1.5, dash)
            dot(pen, b, color, 2.2)
        for _, b in ways[:2]:
            pen.disc(*b, RADIUS, color, ring=1.0)
    upper, lower = (ahead(ways[2][1], 0.0, 12.0) for ways in (true, other))
    span(pen, upper, lower, "amber", 1.4)
    pen.formula(r"\delta_0", start[0] + 27.0, start[1] + 6.0, "amber")
    pen.formula(r"\delta_1", true[1][1][0] - 12.0, true[1][1][1] - 27.0, "amber")
    pen.formula(r"\delta_2", true[2][1][0] + 27.0, true[2][1][1] + 9.0, "amber")
    pen.formula("l", *ahead(between(true[1][0], true[1][1], 0.6), aim + 106.0, 12.0))
    pen.formula(r"\delta_{i+1} \approx \frac{l}{2R} \delta_i", 210.0, 160.0)


def _combination(start: Point, aim: float, second: Point, third: Point, last: float) -> list[Way]:
    """The ways of three equal balls' centres, each from its place to its impact; the last one ``last`` px."""
    ways = []
    for at, target in ((start, second), (second, third)):
        met, aim = _impact(at, aim, target)
        ways.append((at, met))
    return [*ways, (third, ahead(third, aim, last))]


def _impact(start: Point, aim: float, target: Point) -> tuple[Point, float]:
    """Where a ball that rolls from ``start`` meets another one, and the direction which that one takes."""
    angle = math.radians(aim)
    dx, dy = target[0] - start[0], start[1] - target[1]
    near = dx * math.cos(angle) + dy * math.sin(angle)
    aside = dy * math.cos(angle) - dx * math.sin(angle)
    met = ahead(start, aim, near - math.sqrt(4.0 * RADIUS * RADIUS - aside * aside))
    return met, math.degrees(math.atan2(met[1] - target[1], target[0] - met[0]))
