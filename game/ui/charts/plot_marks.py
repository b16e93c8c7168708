"""Lines and marks of a plot: the raster kernels bound to one surface, one clip and one look."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pygame

from game.ui import raster
from game.ui.look.look import Look
from game.ui.raster import packed

MARK = 4.2  # design px, half the size of a mark
_CORNERS = {
    "square": ((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)),
    "diamond": ((0.0, -1.3), (1.3, 0.0), (0.0, 1.3), (-1.3, 0.0)),
    "triangle-up": ((0.0, -1.2), (1.25, 0.95), (-1.25, 0.95)),
    "triangle-down": ((0.0, 1.2), (-1.25, -0.95), (1.25, -0.95)),
}


class Brush:
    """Kernels bound to one surface and look."""

    def __init__(self, surface: pygame.Surface, clip: pygame.Rect, look: Look) -> None:
        self.look = look
        self.pixels = raster.pixels_of(surface)
        left, top = surface.get_abs_offset()
        self.offset = (float(left), float(top))
        place = clip.move(left, top)
        self.clip = np.array((place.x, place.y, place.right, place.bottom), np.int64)
        self.cover, self.area, self.extent = raster.scratch_for(self.pixels)

    def _ink(self, token: str) -> int:
        return packed(self.look.color(token))

    def chain(self, points: Sequence[tuple[float, float]], width: float, color: str) -> None:
        if len(points) > 1:
            array = np.array(points) + self.offset
            w = float(width * self.look.k)
            raster.stroke_polyline(self.pixels, self.clip, self.cover, array, w, False, self._ink(color), 1.0)

    def dots(self, points: Sequence[tuple[float, float]], color: str) -> None:
        """Many small faint dots."""
        if points:
            array = np.array(points) + self.offset
            inks = np.full(len(points), self._ink(color), np.uint32)
            raster.fill_particles(self.pixels, self.clip, array, inks, min(1.6 * self.look.k, 3.5), 0.4)

    def dashes(
        self, a: tuple[float, float], b: tuple[float, float], width: float,
        dash: tuple[float, float], color: str, alpha: float,
    ) -> None:  # fmt: skip
        self.dashed_chain((a, b), width, dash, color, alpha)

    def dashed_chain(
        self, points: Sequence[tuple[float, float]], width: float, dash: tuple[float, float], color: str,
        alpha: float = 1.0,
    ) -> None:  # fmt: skip
        """Dashes that go on from each line to the next."""
        if len(points) < 2:
            return
        array, k = np.array(points) + self.offset, self.look.k
        raster.stroke_dashes(
            self.pixels, self.clip, self.cover, array, float(width * k), False, dash[0] * k, dash[1] * k, 0.0,
            self._ink(color), float(alpha),
        )  # fmt: skip

    def ring(self, x: float, y: float, radius: float, color: str, width: float) -> None:
        x, y = x + self.offset[0], y + self.offset[1]
        k = self.look.k
        raster.stroke_ring(self.pixels, self.clip, x, y, radius * k, width * k, self._ink(color), 1.0)

    def mark(self, shape: str, x: float, y: float, color: str, hollow: bool = False) -> None:
        """A mark about a pixel, on a thin halo of the stage; hollow ones are outlines."""
        x, y, k = x + self.offset[0], y + self.offset[1], self.look.k
        ink, ground = self._ink(color), packed(self.look.theme.stage)
        size = MARK * k
        if shape in ("cross", "plus"):
            d = 0.75 * size
            ends = ((d, d), (d, -d)) if shape == "cross" else ((1.2 * d, 0.0), (0.0, 1.2 * d))
            for dx, dy in ends:
                array = np.array(((x - dx, y - dy), (x + dx, y + dy)))
                raster.stroke_polyline(self.pixels, self.clip, self.cover, array, 1.5 * k, False, ink, 1.0)
            return
        if shape in ("disc", "ring"):
            raster.fill_disc(self.pixels, self.clip, x, y, size + 1.2 * k, ground, 1.0)
            if hollow or shape == "ring":
                raster.stroke_ring(self.pixels, self.clip, x, y, size, 1.2 * k, ink, 0.7 if hollow else 1.0)
            else:
                raster.fill_disc(self.pixels, self.clip, x, y, size, ink, 1.0)
            return
        corners = np.array(_CORNERS[shape])
        halo, body = corners * (size + 1.5 * k) + (x, y), corners * size + (x, y)
        raster.fill_polygon(self.pixels, self.clip, self.area, self.extent, halo, ground, 1.0)
        if hollow:
            raster.stroke_polyline(self.pixels, self.clip, self.cover, body, 1.2 * k, True, ink, 0.7)
        else:
            raster.fill_polygon(self.pixels, self.clip, self.area, self.extent, body, ink, 1.0)
