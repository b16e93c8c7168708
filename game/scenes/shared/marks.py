"""Marks that figures have in common: points in a direction, outlines, spans, angles, dashed curves."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

import pygame

from game.ui.canvas.pen import Pen, Point

__all__ = ["ahead", "between", "curve", "dot", "outline", "right_angle", "spaced", "span", "turn"]

Color = str | pygame.Color


def ahead(start: Point, degrees: float, length: float) -> Point:
    """The point at that distance in a direction, counter-clockwise from the right."""
    angle = math.radians(degrees)
    return start[0] + length * math.cos(angle), start[1] - length * math.sin(angle)


def between(a: Point, b: Point, part: float) -> Point:
    """The point at that part of the way from a to b."""
    return a[0] + part * (b[0] - a[0]), a[1] + part * (b[1] - a[1])


def spaced(start: float, end: float, count: int) -> list[float]:
    """``count`` numbers evenly spaced from start to end, both included."""
    return [start + (end - start) * i / (count - 1) for i in range(count)]


def outline(
    pen: Pen, points: Sequence[Point], color: Color = "text1", width: float = 1.6,
    ground: Color = "body", veil: float = 0.2,
) -> None:  # fmt: skip
    """A filled polygon and its border, with round corners."""
    pen.area(points, ground, veil)
    pen.line((*points, *points[:2]), color, width)


def curve(pen: Pen, points: Sequence[Point], color: Color, width: float = 1.4, dash: float = 4.0) -> None:
    """A dashed line through many near points: strokes and gaps run on across them."""
    pending = [points[0]]
    way = 0.0  # since the present stroke or gap began
    drawing = True
    for a, b in pairwise(points):
        length = math.dist(a, b)
        done = 0.0
        while way + length - done >= dash:
            done += dash - way
            cut = between(a, b, done / length)
            if drawing:
                pen.line((*pending, cut), color, width)
            pending, drawing, way = [cut], not drawing, 0.0
        way += length - done
        pending.append(b)
    if drawing and way > 0.0:
        pen.line(pending, color, width)


def right_angle(pen: Pen, corner: Point, degrees: float, size: float = 7.0, color: Color = "text3") -> None:
    """The sign of a right angle, between that direction and the one 90 degrees further."""
    first, last = ahead(corner, degrees, size), ahead(corner, degrees + 90.0, size)
    pen.line((first, ahead(first, degrees + 90.0, size), last), color, 1.0)


def span(pen: Pen, a: Point, b: Point, color: Color = "text2", width: float = 1.2, bar: float = 4.0) -> None:
    """A length: a line with a bar across each end."""
    degrees = math.degrees(math.atan2(a[1] - b[1], b[0] - a[0])) + 90.0
    pen.line((a, b), color, width)
    for end in (a, b):
        pen.line((ahead(end, degrees, bar), ahead(end, degrees, -bar)), color, width)


def turn(
    pen: Pen, center: Point, radius: float, start: float, end: float, color: Color, width: float = 1.6
) -> None:
    """An arc with a head at its end; angles in degrees, counter-clockwise from the right."""
    sense = 1.0 if end > start else -1.0
    head = 4.5 * width
    cut = math.degrees(head / radius)
    pen.arc(center, radius, start, end - sense * cut, color, width)
    tip = ahead(center, end, radius)
    back = end - sense * 90.0 - 0.5 * sense * cut
    pen.arrow(ahead(tip, back, 1.001 * head), tip, color, width)


def dot(pen: Pen, at: Point, color: Color = "text1", radius: float = 3.0, ring: float = 0.0) -> None:
    """A point that is meant; with ``ring`` it is hollow, and nothing shines through."""
    if ring:
        pen.disc(*at, radius, "stage")
    pen.disc(*at, radius, color, ring)
