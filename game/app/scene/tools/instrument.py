"""What ruler and protractor have in common: points of the world that are dragged, a label with a cross."""

from __future__ import annotations

import math
from typing import ClassVar

import pygame

from game.ui.canvas.camera import Camera
from game.ui.look.icons import icon
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box, draw_disc

REACH, HANDLE = 12, 7  # design px: of a pointer about a handle; radius of a handle
LABEL, CROSS = 26, 22  # design px: height of a label, width of its cross
TURN = math.pi / 12.0  # to whole multiples of which Shift turns
Point = tuple[float, float]


class Instrument:
    """Points in world coordinates; subclasses say what they mean and draw it."""

    name: ClassVar[str] = ""
    handles: ClassVar[int] = 2

    def __init__(self, points: list[Point]) -> None:
        self.points = points
        self.cross = pygame.Rect(0, 0, 0, 0)
        self.label = pygame.Rect(0, 0, 0, 0)

    def seen(self, camera: Camera) -> list[Point]:
        """Pixels of the points."""
        return [camera.to_screen(*point) for point in self.points]

    def hit(self, position: tuple[int, int], camera: Camera, look: Look) -> int | None:
        """Number of the point under a pixel; -1 if it is the rest of it; None if it is nothing."""
        for i, (x, y) in reversed(list(enumerate(self.seen(camera)))):
            if math.hypot(x - position[0], y - position[1]) <= REACH * look.k:
                return i
        return -1 if self.label.collidepoint(position) or self.near(position, camera, look) else None

    def near(self, position: tuple[int, int], camera: Camera, look: Look) -> bool:
        """Whether a pixel lies on what it is carried by."""
        return False

    def drag(self, grip: int, point: Point, by: Point, even: bool) -> None:
        """A point goes to a place of the world, or (-1) all go ``by`` as much; ``even``: in whole turns."""
        if grip < 0:
            self.points = [(x + by[0], y + by[1]) for x, y in self.points]
        else:
            self.points[grip] = self.turned(grip, point) if even else point

    def turned(self, grip: int, point: Point) -> Point:
        """The place next to it that lies at a whole multiple of TURN from the point it turns about."""
        x, y = self.points[0 if grip else 1]
        length = math.hypot(point[0] - x, point[1] - y)
        angle = round(math.atan2(point[1] - y, point[0] - x) / TURN) * TURN
        return x + length * math.cos(angle), y + length * math.sin(angle)

    def words(self, unit: str) -> str:
        """What is measured."""
        raise NotImplementedError

    def draw(
        self, surface: pygame.Surface, look: Look, camera: Camera, unit: str, place: pygame.Rect
    ) -> None:
        """Draw it over the picture in ``place``."""
        raise NotImplementedError

    def draw_handles(self, surface: pygame.Surface, look: Look, camera: Camera) -> None:
        """The points."""
        for x, y in self.seen(camera):
            draw_disc(surface, (x, y), HANDLE * look.k, look.theme.panel, look.color("amber"), 2.0 * look.k)

    def draw_label(
        self, surface: pygame.Surface, look: Look, words: str, center: Point, place: pygame.Rect
    ) -> None:
        """What is measured, and a cross that puts it away; kept within the stage."""
        px = look.px
        width = look.fonts.size(words, 13, "semibold")[0] + px(20 + CROSS)
        self.label = pygame.Rect(0, 0, width, px(LABEL))
        self.label.center = (round(center[0]), round(center[1]))
        self.label.clamp_ip(place)
        draw_box(surface, self.label, px(7), look.theme.panel, look.color("amber"), look.border)
        look.text(surface, words, (self.label.x + px(10), self.label.centery), 13, "semibold", "text1")
        self.cross = pygame.Rect(self.label.right - px(CROSS), self.label.y, px(CROSS), self.label.h)
        sign = icon("close", px(12), look.theme.text2)
        surface.blit(sign, sign.get_rect(center=self.cross.center))
