"""The cards: two coasts in oriented boxes (C08) and in capsules (C09)."""

from __future__ import annotations

import math

from game.stage.catalogue import CloseUp
from game.ui.canvas.pen import Pen, Point

CLOSE_UPS = {
    "c08": CloseUp(zoom=1.15),
    "c09": CloseUp(zoom=1.15),
}

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
