"""Drawings of bounding volumes and of the closest points of two polygons."""

from __future__ import annotations

import math

from game.ui.canvas.pen import Pen, Point

BAY = (
    (14, 58),
    (20, 36),
    (38, 28),
    (52, 34),
    (64, 26),
    (76, 38),
    (70, 52),
    (78, 66),
    (62, 80),
    (40, 84),
    (22, 76),
)


CAPE = (
    (84, 50),
    (92, 34),
    (108, 22),
    (126, 28),
    (144, 42),
    (148, 60),
    (138, 78),
    (116, 84),
    (98, 74),
    (86, 66),
)


def _outlines(pen: Pen) -> None:
    pen.fill("stage")
    for points, color in ((BAY, "text1"), (CAPE, "chalk")):
        pen.line((*points, points[0]), color, 1.6)


def _turned_box(pen: Pen, x: float, y: float, size: Point, angle: float, color: str, dash: float) -> None:
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    a, b = 0.5 * size[0], 0.5 * size[1]
    corners = [
        (x + c * u - s * v, y + s * u + c * v) for u, v in ((-a, -b), (a, -b), (a, b), (-a, b), (-a, -b))
    ]
    pen.line(corners, color, 1.1, dash)


def draw_oriented_boxes(pen: Pen) -> None:
    _outlines(pen)
    _turned_box(pen, 46.0, 55.0, (72.0, 58.0), 12.0, "green", 2.5)
    _turned_box(pen, 116.0, 53.0, (72.0, 62.0), -8.0, "green", 2.5)
    _turned_box(pen, 64.0, 52.0, (32.0, 56.0), -6.0, "line2", 0.0)
    _turned_box(pen, 94.0, 58.0, (26.0, 46.0), 14.0, "line2", 0.0)
    _turned_box(pen, 75.0, 58.0, (9.0, 30.0), -14.0, "vermilion", 0.0)
    _turned_box(pen, 86.0, 57.0, (9.0, 26.0), 8.0, "vermilion", 0.0)


def _round_box(pen: Pen, a: Point, b: Point, radius: float, color: str) -> None:
    turn = math.atan2(b[1] - a[1], b[0] - a[0])
    points = [
        (
            x + radius * math.cos(turn + start + math.pi * k / 12),
            y + radius * math.sin(turn + start + math.pi * k / 12),
        )
        for (x, y), start in ((b, -0.5 * math.pi), (a, 0.5 * math.pi))
        for k in range(13)
    ]
    pen.line((*points, points[0]), color, 1.1)


def draw_capsules(pen: Pen) -> None:
    _outlines(pen)
    _round_box(pen, (38.0, 56.0), (52.0, 57.0), 33.0, "line2")
    _round_box(pen, (112.0, 54.0), (122.0, 53.0), 33.0, "line2")
    _round_box(pen, (72.0, 40.0), (72.0, 66.0), 9.0, "vermilion")
    _round_box(pen, (90.0, 44.0), (88.0, 64.0), 9.0, "vermilion")
    pen.line(((72.0, 40.0), (72.0, 66.0)), "amber", 1.2)
    pen.line(((90.0, 44.0), (88.0, 64.0)), "amber", 1.2)


def draw_voronoi_walk(pen: Pen) -> None:
    """Two polygons, a region of each, and the line between their closest features."""
    pen.fill("stage")
    a = ((22.0, 34.0), (46.0, 26.0), (64.0, 44.0), (60.0, 70.0), (34.0, 80.0), (16.0, 60.0))
    b = ((112.0, 20.0), (140.0, 30.0), (146.0, 58.0), (122.0, 78.0), (98.0, 62.0))
    for tail, tip in (
        ((64.0, 44.0), (160.0, -52.0)), ((64.0, 44.0), (170.0, 60.3)), ((60.0, 70.0), (180.0, 88.5)),
        ((60.0, 70.0), (84.0, 132.0)), ((98.0, 62.0), (-22.0, 22.0)), ((98.0, 62.0), (62.0, 116.0)),
        ((112.0, 20.0), (-8.0, -20.0)), ((122.0, 78.0), (84.0, 135.0)),
    ):  # fmt: skip
        pen.line((tail, tip), "line2", 0.7)
    for corners, color in ((a, "text1"), (b, "chalk")):
        pen.line((*corners, corners[0], corners[1]), color, 1.6)
    pen.line(((64.0, 44.0), (60.0, 70.0)), "green", 3.0)
    pen.line(((61.9, 57.0), (98.0, 62.0)), "amber", 1.5)
    pen.disc(61.9, 57.0, 2.8, "amber")
    pen.disc(98.0, 62.0, 2.8, "amber")


def draw_simplexes(pen: Pen) -> None:
    """A Minkowski difference, a few simplexes, and the way from the origin."""
    pen.fill("stage")
    hull = (
        (30.0, 30.0),
        (58.0, 14.0),
        (92.0, 22.0),
        (112.0, 48.0),
        (104.0, 76.0),
        (72.0, 92.0),
        (38.0, 82.0),
    )
    pen.line((*hull, hull[0], hull[1]), "violet", 1.6)
    for corner in hull:
        pen.disc(*corner, 2.0, "violet")
    pen.line(((58.0, 14.0), (104.0, 76.0)), "line2", 1.2)
    pen.line(((92.0, 22.0), (104.0, 76.0)), "ghost", 1.2)
    pen.line(((112.0, 48.0), (104.0, 76.0)), "amber", 2.6)
    for corner in ((112.0, 48.0), (104.0, 76.0)):
        pen.disc(*corner, 3.2, "amber")
    pen.line(((132.0, 70.0), (146.0, 70.0)), "text1", 1.4)
    pen.line(((139.0, 63.0), (139.0, 77.0)), "text1", 1.4)
    pen.arrow((139.0, 70.0), (110.2, 61.8), "green")
