"""The protractor: the angle between two arms about a point."""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np
import pygame

from game.app.scene.tools.instrument import Instrument, Point
from game.ui import raster
from game.ui.canvas.camera import Camera
from game.ui.look.look import Look
from game.ui.raster import packed

RADIUS, LEAST_RADIUS = 0.55, 26  # of the shorter arm; design px


class Protractor(Instrument):
    """Points: where it stands, and the ends of its arms."""

    name: ClassVar[str] = "protractor"
    handles: ClassVar[int] = 3

    @property
    def angle(self) -> float:
        """Between the arms, degrees, 0 to 180."""
        (x, y), (ax, ay), (bx, by) = self.points
        a, b = (ax - x, ay - y), (bx - x, by - y)
        return math.degrees(abs(math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1])))

    def drag(self, grip: int, point: Point, by: Point, even: bool) -> None:
        """Its foot takes all of it along."""
        if grip == 0:
            x, y = self.points[0]
            self.points = [(px + point[0] - x, py + point[1] - y) for px, py in self.points]
        else:
            super().drag(grip, point, by, even)

    def words(self, unit: str) -> str:
        return f"{self.angle:.1f}°"

    def draw(
        self, surface: pygame.Surface, look: Look, camera: Camera, unit: str, place: pygame.Rect
    ) -> None:
        (x, y), a, b = self.seen(camera)
        pixels, k = raster.pixels_of(surface), look.k
        clip = np.array((place.x, place.y, place.right, place.bottom), np.int64)
        cover, _, _ = raster.scratch_for(pixels)
        amber, ground = packed(look.color("amber")), packed(look.theme.panel)
        shorter = min(math.hypot(a[0] - x, a[1] - y), math.hypot(b[0] - x, b[1] - y))
        radius = max(RADIUS * shorter, LEAST_RADIUS * k)
        start = math.atan2(a[1] - y, a[0] - x)
        sweep = math.remainder(math.atan2(b[1] - y, b[0] - x) - start, math.tau)
        for ink, width in ((ground, 5.0), (amber, 2.0)):  # on a halo, to be seen on any ground
            for end in (a, b):
                line = np.array(((x, y), end))
                raster.stroke_polyline(pixels, clip, cover, line, width * k, False, ink, 0.9)
            raster.stroke_arc(pixels, clip, x, y, radius, width * k, start, sweep, ink, 0.9)
        self._draw_ticks(pixels, clip, cover, (x, y), radius, (start, sweep), k, amber)
        self.draw_handles(surface, look, camera)
        middle = start + 0.5 * sweep
        away = radius + 56.0 * k
        center = (x + away * math.cos(middle), y + away * math.sin(middle))
        self.draw_label(surface, look, self.words(unit), center, place)

    @staticmethod
    def _draw_ticks(
        pixels: np.ndarray, clip: np.ndarray, cover: np.ndarray, center: Point, radius: float,
        arc: tuple[float, float], k: float, ink: int,
    ) -> None:  # fmt: skip
        """A tick every ten degrees from the first arm on, longer every thirty."""
        start, sweep = arc
        for i in range(1, math.floor(math.degrees(abs(sweep)) / 10.0 + 1e-9) + 1):
            angle = start + math.copysign(math.radians(10.0 * i), sweep)
            inner = radius - (10.0 if i % 3 == 0 else 6.0) * k
            cos, sin = math.cos(angle), math.sin(angle)
            line = np.array(
                ((center[0] + inner * cos, center[1] + inner * sin),
                 (center[0] + radius * cos, center[1] + radius * sin))
            )  # fmt: skip
            raster.stroke_polyline(pixels, clip, cover, line, 1.2 * k, False, ink, 0.9)
