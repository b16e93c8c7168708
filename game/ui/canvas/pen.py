"""A pen for small drawings, of the menu's cards and the help pages: no kernel is needed.

Everything is drawn four times larger in a frame of its own measures and reduced at the end. Words and
formulas are set after that, at their true size.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

import pygame

from game.ui.look.look import Look
from game.ui.look.theme import BALL_COLORS, BALL_WHITE
from game.ui.text.formula import render_formula

CARD = (160.0, 104.0)  # the frame of a card's picture
FIGURE = (296.0, 208.0)  # the frame of a help page's figure: design px
FINE = 4

Point = tuple[float, float]


class Pen:
    """Draws in a frame, x to the right and y down, that covers the middle of a picture of any shape."""

    def __init__(self, size: tuple[int, int], look: Look, frame: Point = CARD):
        self.look = look
        self.size = size
        self.large = pygame.Surface((FINE * size[0], FINE * size[1]), 0, 32)
        self._scale = FINE * max(size[0] / frame[0], size[1] / frame[1])
        self._left = 0.5 * (FINE * size[0] - frame[0] * self._scale)
        self._top = 0.5 * (FINE * size[1] - frame[1] * self._scale)
        self._words: list[tuple[pygame.Surface, Point, str]] = []

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
                pygame.draw.polygon(self.large, shade, _stroke(self.at(*p), self.at(*q), thick))
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

    def area(self, points: Sequence[Point], color: str | pygame.Color, veil: float = 0.0) -> None:
        """A filled polygon; ``veil`` sinks its colour into the stage, 0 to 1."""
        shade = self.veiled(color, veil)
        pygame.draw.polygon(self.large, shade, [self.at(*point) for point in points])

    def veiled(self, color: str | pygame.Color, veil: float) -> pygame.Color:
        """A colour sunk into the stage, 0 not at all to 1 wholly."""
        return self.look.color(color).lerp(self.look.color("stage"), veil)

    def arc(
        self, center: Point, radius: float, start: float, end: float, color: str | pygame.Color,
        width: float = 1.2, dash: float = 0.0,
    ) -> None:  # fmt: skip
        """Part of a circle from one angle to another, degrees, counter-clockwise from the right."""
        count = max(2, math.ceil(abs(end - start) / 4.0))
        turns = [math.radians(start + (end - start) * i / count) for i in range(count + 1)]
        points = [(center[0] + radius * math.cos(t), center[1] - radius * math.sin(t)) for t in turns]
        self.line(points, color, width, dash)

    def words(
        self, text: str, x: float, y: float, color: str | pygame.Color = "text2", align: str = "center",
        size: float = 12, weight: str = "medium",
    ) -> None:  # fmt: skip
        """Words; ``align``: center, left or right, which end of the line's middle is at (x, y)."""
        shown = self.look.fonts.render(text, size, weight, self.look.color(color, words=True))
        self._words.append((shown, self.at(x, y), align))

    def formula(
        self, markup: str, x: float, y: float, color: str | pygame.Color = "text1", align: str = "center",
        size: float = 16.0,
    ) -> None:  # fmt: skip
        """A formula (its markup: ui/text/formula.py); ``align`` as for words."""
        shown = render_formula(self.look.fonts, markup, self.look.color(color, words=True), size)
        self._words.append((shown, self.at(x, y), align))

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

    def word_places(self) -> list[pygame.Rect]:
        """Where words and formulas will stand in the picture."""
        places = []
        for shown, (x, y), align in self._words:
            place = shown.get_rect(center=(round(x / FINE), round(y / FINE)))
            if align != "center":
                place.x = round(x / FINE) - (place.w if align == "right" else 0)
            places.append(place)
        return places

    def finished(self) -> pygame.Surface:
        """The picture in its true size."""
        picture = pygame.transform.smoothscale(self.large, self.size)
        for (shown, _, _), place in zip(self._words, self.word_places(), strict=True):
            picture.blit(shown, place)
        return picture


def _stroke(a: Point, b: Point, thick: float) -> tuple[Point, Point, Point, Point]:
    """The corners of a line that is as thick in every direction; pygame's own is thinner when it slants.

    A filled polygon covers its border too, a pixel in all; where that slants it is mostly lost to rounding.
    """
    dx, dy = b[0] - a[0], b[1] - a[1]
    covered = thick - 1.0 if min(abs(dx), abs(dy)) < 1.0 else thick + 0.2
    half = 0.5 * covered / max(math.sqrt(dx * dx + dy * dy), 1e-9)
    x, y = -dy * half, dx * half
    return (a[0] + x, a[1] + y), (b[0] + x, b[1] + y), (b[0] - x, b[1] - y), (a[0] - x, a[1] - y)


def _strokes(a: Point, b: Point, dash: float) -> list[tuple[Point, Point]]:
    if not dash:
        return [(a, b)]
    dx, dy = b[0] - a[0], b[1] - a[1]
    length = math.sqrt(dx * dx + dy * dy)
    count = max(1, round(length / (2.0 * dash)))
    marks = [(i / count, (i + 0.5) / count) for i in range(count)]
    return [((a[0] + dx * s, a[1] + dy * s), (a[0] + dx * t, a[1] + dy * t)) for s, t in marks]
