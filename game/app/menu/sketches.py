"""Quiet drawings for the cards of scenes whose kernels are not compiled yet.

Drawn four times larger in a frame of 160 x 104 and reduced, without any kernel.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import pairwise

import pygame

from game.ui.look import Look
from game.ui.theme import (
    BALL_COLORS,
    BALL_WHITE,
    CUE_BALL,
    FELT,
    FELT_COOL,
    FELT_LINE,
    FELT_WARM,
    WOOD_DARK,
)

WIDTH, HEIGHT, FINE = 160.0, 104.0, 4

Point = tuple[float, float]


class Pen:
    """Draws in the frame of 160 x 104, which covers the middle of the picture whatever its shape."""

    def __init__(self, size: tuple[int, int], look: Look):
        self.look = look
        self.size = size
        self.large = pygame.Surface((FINE * size[0], FINE * size[1]), 0, 32)
        self._scale = FINE * max(size[0] / WIDTH, size[1] / HEIGHT)
        self._left = 0.5 * (FINE * size[0] - WIDTH * self._scale)
        self._top = 0.5 * (FINE * size[1] - HEIGHT * self._scale)

    def fill(self, color: str | pygame.Color) -> None:
        """The ground."""
        self.large.fill(self.look.color(color))

    def at(self, x: float, y: float) -> Point:
        """Pixel of a point of the frame."""
        return self._left + x * self._scale, self._top + y * self._scale

    def line(
        self, points: Sequence[Point], color: str | pygame.Color, width: float = 1.5, dash: float = 0.0
    ) -> None:
        """A line through points; ``dash`` is the length of strokes and gaps."""
        shade, thick = self.look.color(color), max(1, round(width * self._scale))
        for a, b in pairwise(points):
            for p, q in _strokes(a, b, dash):
                pygame.draw.line(self.large, shade, self.at(*p), self.at(*q), thick)
        if not dash:
            for point in points[1:-1]:
                pygame.draw.circle(self.large, shade, self.at(*point), 0.5 * thick)

    def disc(self, x: float, y: float, radius: float, color: str | pygame.Color, ring: float = 0.0) -> None:
        """A disc, or a ring of that width."""
        width = max(1, round(ring * self._scale)) if ring else 0
        pygame.draw.circle(self.large, self.look.color(color), self.at(x, y), radius * self._scale, width)

    def box(
        self,
        left: float,
        top: float,
        width: float,
        height: float,
        color: str | pygame.Color,
        ring: float = 0.0,
    ) -> None:
        """A rectangle, or its outline."""
        thick = max(1, round(ring * self._scale)) if ring else 0
        rect = pygame.Rect(self.at(left, top), (width * self._scale, height * self._scale))
        pygame.draw.rect(self.large, self.look.color(color), rect, thick)

    def arrow(self, tail: Point, tip: Point, color: str | pygame.Color, width: float = 1.8) -> None:
        """A line with a solid head."""
        dx, dy = tip[0] - tail[0], tip[1] - tail[1]
        length = math.sqrt(dx * dx + dy * dy)
        ux, uy = dx / length, dy / length
        neck = (tip[0] - ux * 4.5 * width, tip[1] - uy * 4.5 * width)
        self.line((tail, neck), color, width)
        side = 1.6 * width
        corners = (
            tip,
            (neck[0] - uy * side, neck[1] + ux * side),
            (neck[0] + uy * side, neck[1] - ux * side),
        )
        pygame.draw.polygon(self.large, self.look.color(color), [self.at(*corner) for corner in corners])

    def ball(self, x: float, y: float, radius: float, number: int) -> None:
        """A billiard ball in flat colours."""
        self.disc(x + 0.25 * radius, y + 0.4 * radius, radius, pygame.Color("#14504A"))
        self.disc(x, y, radius, BALL_COLORS[number])
        if number > 8:
            for top in (y - radius, y + 0.55 * radius):
                left, right = self.at(x - radius, top), self.at(x + radius, top + 0.45 * radius)
                self.large.set_clip(pygame.Rect(left, (right[0] - left[0], right[1] - left[1])))
                self.disc(x, y, radius, BALL_WHITE)
            self.large.set_clip(None)
        if number:
            self.disc(x, y, 0.45 * radius, BALL_WHITE)
        else:
            self.disc(x + 0.3 * radius, y - 0.2 * radius, 0.16 * radius, pygame.Color("#9E2112"))

    def finished(self) -> pygame.Surface:
        """The picture in its true size."""
        return pygame.transform.smoothscale(self.large, self.size)


def _strokes(a: Point, b: Point, dash: float) -> list[tuple[Point, Point]]:
    if not dash:
        return [(a, b)]
    dx, dy = b[0] - a[0], b[1] - a[1]
    length = math.sqrt(dx * dx + dy * dy)
    count = max(1, round(length / (2.0 * dash)))
    marks = [(i / count, (i + 0.5) / count) for i in range(count)]
    return [((a[0] + dx * s, a[1] + dy * s), (a[0] + dx * t, a[1] + dy * t)) for s, t in marks]


def _lecture_balls(pen: Pen) -> None:
    pen.fill("stage")
    pen.line(((20.0, 88.0), (140.0, 16.0)), "ghost", 0.8, dash=3.0)
    for i, x in enumerate((18.0, 30.0, 44.0)):
        pen.disc(x, 70.0 - 0.25 * i, 13.0, "line" if i < 2 else "line2", ring=0.8)
    pen.disc(64.0, 61.6, 16.0, "body")
    pen.disc(64.0, 61.6, 16.0, "text1", ring=1.6)
    pen.disc(91.4, 45.1, 16.0, "body")
    pen.disc(91.4, 45.1, 16.0, "chalk", ring=1.6)
    pen.disc(77.7, 53.4, 2.6, "amber")
    pen.arrow((64.0, 61.6), (50.0, 40.0), "text1")
    pen.arrow((91.4, 45.1), (132.0, 20.7), "chalk")


def _table(pen: Pen) -> None:
    pen.fill(WOOD_DARK)
    pen.box(-80.0, 5.0, 320.0, 94.0, FELT.lerp(pygame.Color("black"), 0.3))
    pen.box(-80.0, 8.0, 320.0, 88.0, FELT)
    pen.line(((30.0, 52.0), (80.0, 52.0)), FELT_LINE, 0.8, dash=3.0)
    pen.ball(26.0, 52.0, 6.2, 0)
    numbers = iter((1, 9, 2, 10, 8, 3, 11, 7, 14, 4, 5, 13, 15, 6, 12))
    for row in range(5):
        for i in range(row + 1):
            pen.ball(90.0 + 10.9 * row, 52.0 + 12.6 * (i - 0.5 * row), 6.2, next(numbers))


def _billiards(pen: Pen) -> None:
    """A cut into the corner: cue, aim, ghost ball, the ways after it."""
    pen.fill(WOOD_DARK)
    pen.box(-80.0, 7.0, 226.0, 90.0, FELT.lerp(pygame.Color("black"), 0.3))
    pen.box(-80.0, 10.0, 223.0, 84.0, FELT)
    for x, y in ((148.0, 10.0), (148.0, 94.0), (70.0, 5.0), (70.0, 99.0)):
        pen.disc(x, y, 8.5, pygame.Color("#0A0B0C"))
    pen.line(((-60.0, 97.0), (36.0, 62.0)), pygame.Color("#D8AE74"), 2.6)
    pen.line(((36.0, 62.0), (39.0, 60.9)), pygame.Color("#3E8FD0"), 2.6)
    pen.line(((48.0, 57.6), (96.0, 40.0)), FELT_LINE, 1.0)
    pen.line(((104.5, 36.0), (142.0, 14.0)), FELT_COOL, 1.3, dash=3.0)
    pen.line(((96.0, 40.0), (108.0, 66.0), (124.0, 92.0), (100.0, 76.0)), FELT_LINE, 1.0, dash=3.0)
    pen.disc(96.0, 40.0, 6.2, FELT_LINE, ring=1.0)
    pen.ball(48.0, 57.6, 6.2, 0)
    pen.ball(106.6, 33.6, 6.2, 11)
    pen.ball(70.0, 26.0, 6.2, 8)
    pen.ball(24.0, 30.0, 6.2, 2)
    pen.ball(66.0, 80.0, 6.2, 14)


def _three_tables(pen: Pen) -> None:
    pen.fill("stage")
    for left, top in ((10.0, 10.0), (84.0, 10.0), (47.0, 56.0)):
        pen.box(left, top, 66.0, 38.0, WOOD_DARK)
        pen.box(left + 3.0, top + 3.0, 60.0, 32.0, FELT)
        pen.line(
            ((left + 12, top + 27), (left + 50, top + 14), (left + 40, top + 3)), FELT_WARM, 0.9, dash=2.0
        )
        pen.disc(left + 12, top + 27, 2.4, CUE_BALL)


def _vclip(pen: Pen) -> None:
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


def _gjk(pen: Pen) -> None:
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


def _key_frames(pen: Pen) -> None:
    pen.fill("stage")
    path = []
    for i in range(61):
        t = 2.0 * math.pi * i / 60.0
        path.append((80.0 - 58.0 * math.cos(t), 42.0 - 24.0 * math.sin(2.0 * t)))
    pen.line([*path, path[1]], "chalk", 1.8)
    for i, strength in ((4, "line"), (8, "line2"), (12, "ghost")):
        pen.line(_box_on_path(path[i], path[i + 1]), strength, 0.9)
    for i in (0, 20, 30, 40, 52):
        pen.disc(*path[i], 3.0, "stage")
        pen.disc(*path[i], 3.0, "accent", ring=1.3)
    corners = _box_on_path(path[16], path[17])
    pygame.draw.polygon(pen.large, pen.look.color("body"), [pen.at(*corner) for corner in corners])
    pen.line(corners, "text1", 1.6)
    pen.disc(*path[16], 2.4, "amber")
    pen.line(((14.0, 90.0), (146.0, 90.0)), "line2", 1.0)
    for x in (14.0, 50.0, 80.0, 104.0, 132.0):
        pen.disc(x, 90.0, 2.2, "accent")
    pen.line(((57.0, 76.0), (57.0, 90.0)), "amber", 1.4)


def _box_on_path(place: Point, ahead: Point) -> list[Point]:
    """Corners of a box that looks the way of a path, the first one again at the end."""
    angle = math.atan2(ahead[1] - place[1], ahead[0] - place[0])
    cos, sin = math.cos(angle), math.sin(angle)
    sides = ((-10.0, -6.0), (10.0, -6.0), (10.0, 6.0), (-10.0, 6.0), (-10.0, -6.0))
    return [(place[0] + a * cos - b * sin, place[1] + a * sin + b * cos) for a, b in sides]


def _skinning(pen: Pen) -> None:
    pen.fill("stage")
    pen.line(((0.0, 96.0), (160.0, 96.0)), "line", 1.0)
    limbs = (
        ((80.0, 32.0), (80.0, 60.0)), ((86.0, 33.0), (104.0, 42.0)), ((104.0, 42.0), (114.0, 22.0)),
        ((74.0, 33.0), (60.0, 48.0)), ((60.0, 48.0), (52.0, 64.0)), ((84.0, 60.0), (90.0, 78.0)),
        ((90.0, 78.0), (90.0, 94.0)), ((76.0, 60.0), (70.0, 78.0)), ((70.0, 78.0), (68.0, 94.0)),
    )  # fmt: skip
    for a, b in limbs:
        for width, color in ((13.0, "chalk"), (11.0, "body")):
            if color == "chalk":
                pen.disc(*a, 0.5 * width, color)
                pen.disc(*b, 0.5 * width, color)
                pen.line((a, b), color, width)
    pen.disc(80.0, 18.0, 10.5, "chalk")
    for a, b in limbs:
        pen.disc(*a, 5.4, "body")
        pen.disc(*b, 5.4, "body")
        pen.line((a, b), "body", 10.8)
    pen.disc(80.0, 18.0, 9.4, "body")
    for a, b in (*limbs, ((80.0, 28.0), (80.0, 14.0))):
        _bone(pen, a, b, "amber" if b == (114.0, 22.0) else "text1")


def _bone(pen: Pen, a: Point, b: Point, color: str) -> None:
    dx, dy = b[0] - a[0], b[1] - a[1]
    x, y = a[0] + 0.2 * dx, a[1] + 0.2 * dy
    length = math.sqrt(dx * dx + dy * dy)
    side = 2.4 / length
    corners = (a, (x - side * dy, y + side * dx), b, (x + side * dy, y - side * dx), a)
    pen.line(corners, color, 0.9)
    pen.disc(*a, 1.5, color)
    pen.disc(*b, 1.5, color)


def _reaching(pen: Pen) -> None:
    pen.fill("stage")
    root, target = (34.0, 84.0), (118.0, 30.0)
    arms = (
        ("chalk", ((34.0, 84.0), (24.0, 50.0), (52.0, 28.0), (87.0, 20.0), (118.0, 30.0))),
        ("violet", ((34.0, 84.0), (58.0, 58.0), (94.0, 66.0), (122.0, 60.0), (118.0, 30.0))),
        ("text1", ((34.0, 84.0), (46.0, 50.0), (76.0, 42.0), (96.0, 54.0), (118.0, 30.0))),
    )
    for color, joints in arms:
        if color == "text1":
            for a, b in pairwise(joints):
                _bone(pen, a, b, color)
        else:
            pen.line(joints, color, 1.4, dash=2.6)
    pen.disc(*root, 3.4, "text1")
    pen.disc(*target, 8.0, "amber", ring=1.6)
    pen.disc(*target, 2.6, "amber")


def _rigid_body(pen: Pen) -> None:
    """A hammer in its box, and the outline of where it will be when it has turned over."""
    pen.fill("stage")
    for left, middle, right in ((26, 14, 26), (92, 84, 92)):
        pen.line(((18, left), (106, middle), (146, right)), "line2", 0.8)
    for x, top, low in ((18, 26, 92), (106, 14, 84), (146, 26, 92)):
        pen.line(((x, top), (x, low)), "line2", 0.8)
    for k in range(6):
        pen.disc(102.0 + 6.4 * k, 53.0 + 3.4 * k, 5.2, "ghost", ring=0.7)
    for k in range(6):
        _ball_of_body(pen, 40.0 + 6.6 * k, 69.0 - 3.4 * k, 5.4, pygame.Color("#E9E0CF"))
    for k in (-2, 2, -1, 1, 0):
        _ball_of_body(pen, 84.0 + 4.2 * k, 47.0 + 10.8 * k, 11.5, pygame.Color("#5FBAF9"))
    pen.arrow((84.0, 47.0), (132.0, 22.0), "pink")


def _ball_of_body(pen: Pen, x: float, y: float, radius: float, color: pygame.Color) -> None:
    """A sphere: shade, colour, light."""
    pen.disc(x, y, radius, color.lerp(pygame.Color("black"), 0.45))
    pen.disc(x - 0.06 * radius, y - 0.08 * radius, 0.9 * radius, color)
    pen.disc(x - 0.3 * radius, y - 0.36 * radius, 0.28 * radius, color.lerp(pygame.Color("white"), 0.6))


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


def _oriented_boxes(pen: Pen) -> None:
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


def _capsules(pen: Pen) -> None:
    _outlines(pen)
    _round_box(pen, (38.0, 56.0), (52.0, 57.0), 33.0, "line2")
    _round_box(pen, (112.0, 54.0), (122.0, 53.0), 33.0, "line2")
    _round_box(pen, (72.0, 40.0), (72.0, 66.0), 9.0, "vermilion")
    _round_box(pen, (90.0, 44.0), (88.0, 64.0), 9.0, "vermilion")
    pen.line(((72.0, 40.0), (72.0, 66.0)), "amber", 1.2)
    pen.line(((90.0, 44.0), (88.0, 64.0)), "amber", 1.2)


def _unknown(pen: Pen) -> None:
    """A thrown ball in a grid: for a scene that has no drawing of its own."""
    pen.fill("stage")
    for x in range(-80, 241, 20):
        pen.line(((x, -40.0), (x, 144.0)), "grid", 0.6)
    for y in range(-38, 144, 20):
        pen.line(((-80.0, y), (240.0, y)), "grid", 0.6)
    path = [(20.0 + 6.0 * t, 84.0 - 9.6 * t + 0.42 * t * t) for t in range(21)]
    pen.line(path, "ghost", 1.0)
    for t in (3, 7, 11):
        pen.disc(*path[t], 6.0, "line2", ring=0.9)
    pen.disc(*path[15], 6.5, "body")
    pen.disc(*path[15], 6.5, "chalk", ring=1.5)


def _collisions(pen: Pen) -> None:
    """Newton's cradle, the first ball coming down."""
    pen.fill("stage")
    pen.line(((46.0, 18.0), (126.0, 18.0)), "line2", 2.4)
    balls = [(62.0 + 16.0 * i, 76.0, 62.0 + 16.0 * i) for i in range(1, 4)]
    balls.append((62.0 - 44.0 * 0.68, 18.0 + 58.0 * 0.87, 62.0))
    for x, y, tie in balls:
        pen.line(((tie, 18.0), (x, y)), "ghost", 0.8)
    for i, (x, y, _) in enumerate(balls):
        tone = "chalk" if i == 3 else "text1"
        pen.disc(x, y, 8.0, "body")
        pen.disc(x, y, 8.0, tone, ring=1.5)
        pen.line(((x, y), (x + 7.0, y)), tone, 1.1)
    pen.arrow((40.0, 76.0), (58.0, 83.0), "chalk")
    pen.arrow((120.0, 76.0), (142.0, 76.0), "amber")
    pen.disc(118.0, 76.0, 2.2, "amber")


SKETCHES: dict[str, Callable[[Pen], None]] = {
    "lecture-balls": _lecture_balls,
    "lecture-table": _table,
    "billiards": _billiards,
    "three-tables": _three_tables,
    "c08": _oriented_boxes,
    "c09": _capsules,
    "c01": _key_frames,
    "c02": _skinning,
    "c03": _reaching,
    "c10": _vclip,
    "c11": _gjk,
    "c12": _rigid_body,
    "c13": _collisions,
}


def sketch(name: str, size: tuple[int, int], look: Look) -> pygame.Surface:
    """The drawing of a scene in that size, window px."""
    pen = Pen((max(1, size[0]), max(1, size[1])), look)
    SKETCHES.get(name, _unknown)(pen)
    return pen.finished()
