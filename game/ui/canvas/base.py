"""What a canvas stands on: surface, camera, colours, world points to pixels, strokes and pictures there."""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any

import numpy as np
import pygame

from game.ui import raster
from game.ui.canvas.camera import Camera
from game.ui.look.look import Look
from game.ui.raster import packed
from game.ui.raster.projection import PointBuffer, as_points, map_points
from game.ui.text.label_places import Box, LabelPlaces

Point = Sequence[float] | np.ndarray  # (2,)
Token = str | pygame.Color
Dash = tuple[float, float]
_FAR = 30_000.0  # px; a blit takes 16 bit places


class CanvasBase:
    """A part of a surface between ``begin`` and ``end``, seen through a camera."""

    def __init__(self, look: Look) -> None:
        self.look = look
        self.theme, self.fonts, self.k = look.theme, look.fonts, look.k
        self.surface = pygame.Surface((1, 1), 0, 32)
        self.rect = pygame.Rect(0, 0, 1, 1)
        self.camera = Camera()
        self.unit = "m"
        self.words = True  # whether labels and formulas are drawn; a small picture has no space for them
        self.teaching = True  # whether what explains is drawn: grids, handles, vectors, their words
        self.asked = False  # whether marks are asked for, whatever the scene's own switch for them says
        self.covered = False  # what is drawn covers all, so that no ground is laid
        self.fresh = True  # measured numbers are those of now; else those of the last picture stay
        self._figures: dict[Hashable, str] = {}
        self.halo: pygame.Color = look.theme.stage  # behind labels
        self.insets = (0, 0, 0, 0)  # px covered at left, top, right, bottom, for labels that keep clear of it
        self._inks: dict[Token, tuple[int, float]] = {}
        self._mapped, self._second, self._colors = PointBuffer(), PointBuffer(), np.empty(64, np.uint32)
        self._pair = np.empty((2, 2))
        self._labels = LabelPlaces()
        self._old_clip = pygame.Rect(0, 0, 1, 1)

    def marks(self, own: bool) -> bool:
        """Whether marks are drawn that the scene shows by a switch of its own (``own``)."""
        return self.asked or (self.teaching and own)

    def begin(self, surface: pygame.Surface, rect: pygame.Rect, camera: Camera) -> None:
        """Draw on this part of a 32-bit surface, through this camera, until ``end``; it is cleared first."""
        self.surface = surface
        self.rect = pygame.Rect(rect).clip(surface.get_rect())
        self._old_clip = surface.get_clip()
        surface.set_clip(self.rect)
        self.halo = self.theme.stage
        self._labels.clear()
        if self.fresh:
            self._figures.clear()
        self._pixels = raster.pixels_of(surface)
        self._clip = raster.clip_of(surface)
        if not self.covered:
            self.fill()
        self._cover, self._area, self._extent = raster.scratch_for(self._pixels)
        self._origin = surface.get_abs_offset()
        self._look_through(camera)

    def _look_through(self, camera: Camera) -> None:
        """Take over a camera's map."""
        self.camera = camera
        self._a, self._b, self._c, self._d, self._e, self._f = camera.affine()
        self._scale = camera.scale
        self._e, self._f = self._e + self._origin[0], self._f + self._origin[1]

    @contextmanager
    def at_home(self) -> Iterator[bool]:
        """What is drawn meanwhile stands where the fitted view has it, however the picture is moved.

        Gives whether the picture is moved.
        """
        before = self.camera
        self._look_through(before.fitted())
        try:
            yield before.affine() != self.camera.affine()
        finally:
            self._look_through(before)

    def end(self) -> None:
        """Give the surface back as it was."""
        self.surface.set_clip(self._old_clip)

    def figure(self, place: Hashable, words: str) -> str:
        """Words with a measured number: those written at this place when numbers last were taken again."""
        return self._figures.setdefault(place, words)

    @contextmanager
    def within(self, corner: Point, opposite: Point) -> Iterator[None]:
        """What is drawn meanwhile stays within a box between two corners in the world."""
        before = self.surface.get_clip()
        (ax, ay), (bx, by) = (self.camera.to_screen(*point) for point in (corner, opposite))
        left, top, right, bottom = min(ax, bx), min(ay, by), max(ax, bx), max(ay, by)
        box = pygame.Rect(round(left), round(top), round(right) - round(left), round(bottom) - round(top))
        self.surface.set_clip(box.clip(before))
        self._clip = raster.clip_of(self.surface)
        try:
            yield
        finally:
            self.surface.set_clip(before)
            self._clip = raster.clip_of(self.surface)

    @contextmanager
    def magnified(self, corner: Point, opposite: Point, center: Point, times: float) -> Iterator[None]:
        """What is drawn meanwhile is seen ``times`` as large, without words, in a box between two corners
        in the world, with the point ``center`` in its middle."""
        camera, rect, words = self.camera, self.rect, self.words
        with self.within(corner, opposite):
            self.rect = self.surface.get_clip()
            (ax, ay), (bx, by) = (camera.to_screen(*point) for point in (corner, opposite))
            box = pygame.Rect(
                round(min(ax, bx)), round(min(ay, by)), round(abs(bx - ax)), round(abs(by - ay))
            )
            self._look_through(camera.magnified(box, (float(center[0]), float(center[1])), times))
            self.words = False
            try:
                yield
            finally:
                self.rect, self.words = rect, words
                self._look_through(camera)

    def fill(self, color: Token = "stage") -> None:
        """Fill the whole part with one colour, in the array: three times as quick as the surface does it."""
        ink, (left, top, right, bottom) = self.color(color), self._clip
        self._pixels[top:bottom, left:right] = ink.a << 24 | packed(ink)

    # -- small conversions --------------------------------------------------------------------------

    def color(self, token: Token) -> pygame.Color:
        """A colour by its name in the theme; a Color is given back as it is."""
        return self.look.color(token)

    def ink(self, token: Token) -> int:
        """A colour as 0xRRGGBB, for arrays of colours."""
        return self._ink(token)[0]

    def px(self, length_px: float) -> float:
        """A design length in world units."""
        return length_px * self.k / self._scale

    @property
    def pixels_per_unit(self) -> float:
        """Window px to a world unit."""
        return self._scale

    @property
    def raster_target(self) -> tuple[np.ndarray, np.ndarray]:
        """Pixels and clip as the raster kernels take them, for painters with kernels of their own."""
        return self._pixels, self._clip

    def place(self, point: Point) -> tuple[float, float]:
        """Place of a world point in ``raster_target``, px."""
        return self._place(point)

    def place_all(self, points: Any) -> np.ndarray:
        """Places (n, 2) of world points in ``raster_target``, px; good until the next call of any kind."""
        return self._map(points)

    def _ink(self, token: Token) -> tuple[int, float]:
        key = token if isinstance(token, str) else tuple(token)
        found = self._inks.get(key)  # type: ignore[arg-type]
        if found is None:
            color = self.look.color(token)
            found = self._inks[key] = (packed(color), color.a / 255.0)  # type: ignore[index]
        return found

    def _place(self, point: Point) -> tuple[float, float]:
        x, y = float(point[0]), float(point[1])
        return self._a * x + self._b * y + self._e, self._c * x + self._d * y + self._f

    def _map(self, points: Any) -> np.ndarray:
        points = as_points(points)
        mapped = self._mapped.take(points.shape[0])
        map_points(points, self._a, self._b, self._c, self._d, self._e, self._f, mapped)
        return mapped

    def _stroke(
        self, mapped: np.ndarray, color: Token, width: float, closed: bool, dash: Dash | None, alpha: float
    ) -> None:
        ink, opacity = self._ink(color)
        w, share = float(width * self.k), float(opacity * alpha)
        if dash is None:
            raster.stroke_polyline(self._pixels, self._clip, self._cover, mapped, w, closed, ink, share)
        else:
            self._dashes(mapped, w, closed, dash, ink, share)

    def _dashes(
        self, mapped: np.ndarray, width: float, closed: bool, dash: Dash, ink: int, alpha: float
    ) -> None:
        on, off = float(dash[0] * self.k), float(dash[1] * self.k)
        raster.stroke_dashes(
            self._pixels, self._clip, self._cover, mapped, width, closed, on, off, 0.0, ink, float(alpha)
        )

    def _blit_at(
        self, picture: pygame.Surface, x: float, y: float, share_x: float, share_y: float, flags: int = 0
    ) -> None:
        x -= share_x * picture.get_width() + self._origin[0]
        y -= share_y * picture.get_height() + self._origin[1]
        if -_FAR < x < _FAR and -_FAR < y < _FAR:
            self.surface.blit(picture, (round(x), round(y)), None, flags)

    def _label_place(
        self, x: float, y: float, width: float, height: float, share_x: float, share_y: float, clear: bool
    ) -> tuple[float, float]:
        """Where the anchor of a label's box goes: (x, y), or a free place near it; that is then taken."""
        left, top = x - share_x * width, y - share_y * height
        box = Box(left, top, left + width, top + height)
        if clear:
            (x0, y0), (w, h), edge = self.rect.topleft, self.rect.size, 4.0 * self.k
            x0, y0 = x0 + self._origin[0], y0 + self._origin[1]
            box = self._labels.free(box, Box(x0 + edge, y0 + edge, x0 + w - edge, y0 + h - edge))
        self._labels.claim(box)
        return box.left + share_x * width, box.top + share_y * height

    def _color_buffer(self, n: int) -> np.ndarray:
        if n > self._colors.shape[0]:
            self._colors = np.empty(max(n, 2 * self._colors.shape[0]), np.uint32)
        return self._colors[:n]

    def _color_array(self, colors: Any, n: int) -> tuple[np.ndarray, float]:
        """Colours (n,) and the opacity of a single one."""
        if isinstance(colors, (str, pygame.Color)):
            ink, opacity = self._ink(colors)
            array = self._color_buffer(n)
            array.fill(ink)
            return array, opacity
        return np.ascontiguousarray(colors, np.uint32)[:n], 1.0
