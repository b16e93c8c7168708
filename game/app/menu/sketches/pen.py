"""The pen: draws in a frame of 160 x 104, four times larger, reduced at the end; no kernel is needed."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

import pygame

from game.ui.look import Look
from game.ui.theme import BALL_COLORS, BALL_WHITE

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
