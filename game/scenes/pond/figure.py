"""Figures of wave particles: a front that divides, a hump, a wedge."""

from __future__ import annotations

import math

from game.scenes.shared.marks import dot
from game.ui.canvas.pen import Pen

MIDDLE = (44.0, 150.0)
FIRST, LAST = 70.0, 210.0


def draw_splitting(pen: Pen) -> None:
    """A front of three particles; farther out each of them has become three."""
    for radius in (FIRST, 0.5 * (FIRST + LAST), LAST):
        arc = [_at(radius, degrees) for degrees in range(-4, 50, 2)]
        pen.line(arc, "text3", 1.0, dash=3.0)
    for k in range(3):
        degrees = 5.0 + 18.0 * k
        pen.line((MIDDLE, _at(0.5 * (FIRST + LAST), degrees)), "text3", 1.0)
        dot(pen, _at(FIRST, degrees), "accent", 6.0)
        for m in (-1, 0, 1):
            way = degrees + 6.0 * m
            pen.line((_at(0.5 * (FIRST + LAST), way), _at(LAST, way)), "text3", 1.0)
            dot(pen, _at(0.5 * (FIRST + LAST), way), "amber", 4.0)
            dot(pen, _at(LAST, way), "amber", 4.0)
    pen.formula("a", *_at(FIRST - 16.0, 23.0), "accent")
    pen.formula(r"\frac{a}{3}", *_at(LAST + 24.0, 23.0), "amber")
    pen.formula("d", *_at(0.62 * FIRST, -7.0), "text2")


def draw_hump(pen: Pen) -> None:
    """One particle from the side: a rounded hump of a height and a radius that goes on."""
    left, right, foot, tall = 40.0, 200.0, 140.0, 80.0
    curve = []
    for k in range(61):
        u = k / 30.0 - 1.0
        curve.append(
            (
                0.5 * (left + right) + 0.5 * (right - left) * u,
                foot - 0.5 * tall * (1.0 + math.cos(math.pi * u)),
            )
        )
    pen.area([*curve, (right, foot), (left, foot)], "body")
    pen.line(((20.0, foot), (280.0, foot)), "text3", 1.0)
    pen.line(curve, "accent", 2.2)
    pen.arrow((0.5 * (left + right), foot - tall - 14.0), (196.0, foot - tall - 14.0), "amber", 2.0)
    pen.formula("c", 212.0, foot - tall - 14.0, "amber")
    pen.formula("r", 0.5 * (0.5 * (left + right) + right), foot + 16.0, "text1")
    pen.formula("a", 0.5 * (left + right) + 12.0, foot - 0.5 * tall, "text1")


def draw_wedge(pen: Pen) -> None:
    """Rings that a boat left behind, each as old as the way is long, and their common tangents."""
    bow, y, half = 250.0, 100.0, math.asin(0.5)
    for k in range(1, 8):
        away = 30.0 * k
        _ring(pen, (bow - away, y), 0.5 * away)
    for side in (-1.0, 1.0):
        end = (bow - 235.0 * math.cos(half), y + side * 235.0 * math.cos(half) * math.tan(half))
        pen.line(((bow, y), end), "yellow", 2.0)
    dot(pen, (bow, y), "amber", 6.0)
    pen.arrow((bow + 8.0, y), (bow + 38.0, y), "amber", 2.0)
    pen.formula("U", bow + 26.0, y - 16.0, "amber")
    pen.formula(r"\alpha", bow - 44.0, y - 9.0, "yellow")
    pen.formula("c t", 92.0, y - 24.0, "text2")


def _at(radius: float, degrees: float) -> tuple[float, float]:
    angle = math.radians(degrees)
    return MIDDLE[0] + radius * math.cos(angle), MIDDLE[1] - radius * math.sin(angle)


def _ring(pen: Pen, middle: tuple[float, float], radius: float) -> None:
    points = [
        (middle[0] + radius * math.cos(math.tau * k / 40), middle[1] + radius * math.sin(math.tau * k / 40))
        for k in range(41)
    ]
    pen.line(points, "chalk", 1.2)
