"""The ruler: a distance in the world's unit, with its parts along both axes."""

from __future__ import annotations

import math
from typing import ClassVar

import numpy as np
import pygame

from game.app.scene.tools.instrument import Instrument
from game.ui import raster
from game.ui.canvas.camera import Camera
from game.ui.look.look import Look
from game.ui.look.numerals import format_si
from game.ui.raster import packed

WIDTH = 20  # design px
TICK = 7  # design px between two ticks, at least
MOST_TICKS = 400


def tick_step(per_unit: float, least: float) -> float:
    """World units between two ticks: 1, 2 or 5 times a power of ten, at least ``least`` px (``per_unit`` px
    a unit) apart.
    """
    wanted = least / per_unit
    power = 10.0 ** math.floor(math.log10(wanted))
    return next(factor * power for factor in (1.0, 2.0, 5.0, 10.0) if factor * power >= wanted * (1.0 - 1e-9))


class Ruler(Instrument):
    """From its first point to its second."""

    name: ClassVar[str] = "ruler"

    @property
    def length(self) -> float:
        """Distance of the two points, world units."""
        (x0, y0), (x1, y1) = self.points
        return math.hypot(x1 - x0, y1 - y0)

    def near(self, position: tuple[int, int], camera: Camera, look: Look) -> bool:
        (x0, y0), (x1, y1) = self.seen(camera)
        dx, dy = x1 - x0, y1 - y0
        square = dx * dx + dy * dy
        if square < 1.0:
            return False
        along = ((position[0] - x0) * dx + (position[1] - y0) * dy) / square
        across = ((position[0] - x0) * dy - (position[1] - y0) * dx) / math.sqrt(square)
        return 0.0 <= along <= 1.0 and abs(across) <= 0.5 * WIDTH * look.k

    def words(self, unit: str) -> str:
        (x0, y0), (x1, y1) = self.points
        parts = f"Δx {format_si(x1 - x0, unit)}, Δy {format_si(y1 - y0, unit)}"
        return f"{format_si(self.length, unit, 4)}   ({parts})"

    def draw(
        self, surface: pygame.Surface, look: Look, camera: Camera, unit: str, place: pygame.Rect
    ) -> None:
        (x0, y0), (x1, y1) = self.seen(camera)
        length = math.hypot(x1 - x0, y1 - y0)
        nx, ny = (-(y1 - y0) / length, (x1 - x0) / length) if length > 0.0 else (0.0, 1.0)
        if length >= 1.0:
            self._draw_strip(surface, look, camera, place, (nx, ny))
        self.draw_handles(surface, look, camera)
        side = -1.0 if ny > 0.0 or (ny == 0.0 and nx > 0.0) else 1.0  # above it
        away = side * 34.0 * look.k
        center = (0.5 * (x0 + x1) + nx * away, 0.5 * (y0 + y1) + ny * away)
        self.draw_label(surface, look, self.words(unit), center, place)

    def _draw_strip(
        self,
        surface: pygame.Surface,
        look: Look,
        camera: Camera,
        place: pygame.Rect,
        normal: tuple[float, float],
    ) -> None:
        """The strip, and its ticks from the first point on."""
        (x0, y0), (x1, y1) = self.seen(camera)
        nx, ny = (0.5 * WIDTH * look.k * part for part in normal)
        pixels = raster.pixels_of(surface)
        clip = np.array((place.x, place.y, place.right, place.bottom), np.int64)
        cover, area, extent = raster.scratch_for(pixels)
        corners = np.array(
            ((x0 + nx, y0 + ny), (x1 + nx, y1 + ny), (x1 - nx, y1 - ny), (x0 - nx, y0 - ny))
        )  # fmt: skip
        raster.fill_polygon(pixels, clip, area, extent, corners, packed(look.theme.panel), 0.82)
        amber = packed(look.color("amber"))
        raster.stroke_polyline(pixels, clip, cover, corners, float(look.border), True, amber, 0.9)
        ink, step = packed(look.theme.text1), tick_step(camera.scale, TICK * look.k)
        total = self.length
        count = min(math.floor(total / step + 1e-9), MOST_TICKS)
        for i in range(1, count + 1):
            share = i * step / total
            x, y = x0 + share * (x1 - x0), y0 + share * (y1 - y0)
            reach = 1.1 if i % 10 == 0 else 0.8 if i % 5 == 0 else 0.45
            line = np.array(((x + nx, y + ny), (x + nx * (1.0 - reach), y + ny * (1.0 - reach))))
            raster.stroke_polyline(pixels, clip, cover, line, float(look.border), False, ink, 0.9)
