"""Rounded boxes, discs and shadows of the interface: crisp, cached, and without a compiled kernel.

Everything around the stage must be drawn while kernels are still compiling. So these are small numpy pictures
of the exact distance to the outline, made once for each size and colour and then copied.
"""

from __future__ import annotations

import math
from collections import OrderedDict
from collections.abc import Callable

import numpy as np
import pygame

Color = pygame.Color
KEPT_PIXELS = 8_000_000  # about 32 MB of finished pictures
LARGEST = 16_384  # px, of either side
FARTHEST = 30_000.0  # px; a blit takes 16 bit places


class SurfaceStore:
    """Finished pictures by key; the least recently used go first when they become too many pixels."""

    def __init__(self, most_pixels: int = KEPT_PIXELS) -> None:
        self._most = most_pixels
        self._pixels = 0
        self._kept: OrderedDict[tuple[object, ...], pygame.Surface] = OrderedDict()

    def get(self, key: tuple[object, ...], make: Callable[[], pygame.Surface]) -> pygame.Surface:
        """The picture of that key, made if it is not there."""
        found = self._kept.get(key)
        if found is not None:
            self._kept.move_to_end(key)
            return found
        made = self._kept[key] = make()
        self._pixels += made.get_width() * made.get_height()
        while self._pixels > self._most and len(self._kept) > 1:
            _, old = self._kept.popitem(last=False)
            self._pixels -= old.get_width() * old.get_height()
        return made


_store = SurfaceStore()


def box(
    size: tuple[int, int],
    radius: float,
    fill: Color | None,
    outline: Color | None = None,
    border: float = 1.0,
) -> pygame.Surface:
    """A rounded box on a transparent surface; kept, so do not draw on it. ``fill`` None leaves a frame."""
    width, height = (min(LARGEST, max(1, int(side))) for side in size)
    radius = min(max(radius, 0.0), 0.5 * width, 0.5 * height)
    key = ("box", width, height, radius, _rgba(fill), _rgba(outline), border)
    return _store.get(key, lambda: _make_box(width, height, radius, fill, outline, border))


def draw_box(
    surface: pygame.Surface,
    rect: pygame.Rect,
    radius: float,
    fill: Color | None,
    outline: Color | None = None,
    border: float = 1.0,
) -> None:
    """Draw a rounded box; nothing if it has no area."""
    if rect.w > 0 and rect.h > 0:
        surface.blit(box(rect.size, radius, fill, outline, border), rect)


def draw_disc(
    surface: pygame.Surface,
    center: tuple[float, float],
    radius: float,
    fill: Color | None,
    outline: Color | None = None,
    border: float = 1.0,
) -> None:
    """Draw a disc at a place between pixels (to a quarter); ``fill`` None leaves a ring."""
    if not (abs(center[0]) < FARTHEST and abs(center[1]) < FARTHEST and 0.0 < radius < 0.5 * LARGEST):
        return
    x, y = round(center[0] * 4.0) / 4.0, round(center[1] * 4.0) / 4.0
    left, top = math.floor(x - radius) - 1, math.floor(y - radius) - 1
    side = math.ceil(2.0 * radius) + 3
    key = ("disc", radius, x - left, y - top, _rgba(fill), _rgba(outline), border)
    surface.blit(
        _store.get(key, lambda: _make_disc(side, x - left, y - top, radius, fill, outline, border)),
        (left, top),
    )


def shadow(size: tuple[int, int], blur: float, opacity: float) -> pygame.Surface:
    """A soft black shadow of a box, larger than it by 3 x ``blur`` px all round (blur is the deviation)."""
    width, height = (min(LARGEST, max(1, int(side))) for side in size)
    key = ("shadow", width, height, blur, opacity)
    return _store.get(key, lambda: _make_shadow(width, height, blur, opacity))


def draw_shadow(surface: pygame.Surface, rect: pygame.Rect, blur: float, down: float, opacity: float) -> None:
    """Draw the shadow of ``rect``, shifted down."""
    reach = math.ceil(3.0 * blur)
    surface.blit(shadow(rect.size, blur, opacity), (rect.x - reach, rect.y - reach + round(down)))


def draw_gradient(
    surface: pygame.Surface, rect: pygame.Rect, radius: float, left: Color, right: Color
) -> None:
    """A rounded bar whose colour goes from left to right."""
    if rect.w < 1 or rect.h < 1:
        return
    key = ("gradient", rect.w, rect.h, radius, _rgba(left), _rgba(right))
    surface.blit(_store.get(key, lambda: _make_gradient(rect.w, rect.h, radius, left, right)), rect)


def draw_polygon(surface: pygame.Surface, points: list[tuple[float, float]], fill: Color) -> None:
    """A small filled polygon with soft edges, for marks (diamonds, triangles, ticks)."""
    left = math.floor(min(x for x, _ in points)) - 1
    top = math.floor(min(y for _, y in points)) - 1
    right = math.ceil(max(x for x, _ in points)) + 1
    bottom = math.ceil(max(y for _, y in points)) + 1
    if right - left > 512 or bottom - top > 512:
        return
    shifted = tuple((round((x - left) * 4), round((y - top) * 4)) for x, y in points)
    key = ("polygon", shifted, _rgba(fill))

    def make() -> pygame.Surface:
        large = pygame.Surface((4 * (right - left), 4 * (bottom - top)), pygame.SRCALPHA, 32)
        large.fill((fill.r, fill.g, fill.b, 0))
        pygame.draw.polygon(large, fill, shifted)
        return pygame.transform.smoothscale(large, (right - left, bottom - top))

    surface.blit(_store.get(key, make), (left, top))


def draw_line(
    surface: pygame.Surface, color: Color, a: tuple[float, float], b: tuple[float, float], width: float = 1.0
) -> None:
    """A short soft line with square ends of any width, for icons and leaders."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    length = math.sqrt(dx * dx + dy * dy)
    if not 0.0 < length < 4000.0:
        return
    nx, ny = -dy / length * 0.5 * width, dx / length * 0.5 * width
    corners = [(a[0] + nx, a[1] + ny), (b[0] + nx, b[1] + ny), (b[0] - nx, b[1] - ny), (a[0] - nx, a[1] - ny)]
    draw_polygon(surface, corners, color)


def _rgba(color: Color | None) -> tuple[int, ...] | None:
    return None if color is None else (color.r, color.g, color.b, color.a)


def _make_box(
    width: int, height: int, radius: float, fill: Color | None, outline: Color | None, border: float
) -> pygame.Surface:
    """The box; only its corners are computed, for all between two of them is alike."""
    corner = math.ceil(radius + border) + 2
    columns, rows = _stretched(width, corner), _stretched(height, corner)
    small = _make_small_box(columns[-1] + 1, rows[-1] + 1, radius, fill, outline, border)
    picture = pygame.Surface((width, height), pygame.SRCALPHA, 32)
    pixels, few = pygame.surfarray.pixels2d(picture), pygame.surfarray.pixels2d(small)
    np.take(few[columns], rows, axis=1, out=pixels)
    del pixels, few
    return picture


def _stretched(length: int, corner: int) -> np.ndarray:
    """Which pixel of a shorter side each pixel of a side (length,) is like: the middle one is repeated."""
    repeated = max(1, length - 2 * corner)
    counts = np.ones(length - repeated + 1, dtype=np.int64)
    counts[min(corner, len(counts) // 2)] = repeated
    return np.repeat(np.arange(len(counts)), counts)


def _make_small_box(
    width: int, height: int, radius: float, fill: Color | None, outline: Color | None, border: float
) -> pygame.Surface:
    x = np.abs(np.arange(width) + 0.5 - 0.5 * width) - (0.5 * width - radius)
    y = np.abs(np.arange(height) + 0.5 - 0.5 * height) - (0.5 * height - radius)
    outside_x, outside_y = np.maximum(x, 0.0)[:, None], np.maximum(y, 0.0)[None, :]
    distance = np.sqrt(outside_x * outside_x + outside_y * outside_y) - radius
    distance += np.minimum(np.maximum(x[:, None], y[None, :]), 0.0)
    return _painted(distance, fill, outline, border)


def _make_disc(
    side: int, x: float, y: float, radius: float, fill: Color | None, outline: Color | None, border: float
) -> pygame.Surface:
    dx, dy = (np.arange(side) + 0.5 - x)[:, None], (np.arange(side) + 0.5 - y)[None, :]
    return _painted(np.sqrt(dx * dx + dy * dy) - radius, fill, outline, border)


def _painted(
    distance: np.ndarray, fill: Color | None, outline: Color | None, border: float
) -> pygame.Surface:
    """A picture from signed distances to the outline (px, negative inside): its colours and coverage."""
    outer = np.clip(0.5 - distance, 0.0, 1.0)
    inner = np.clip(0.5 - distance - border, 0.0, 1.0) if outline is not None else outer
    edge = outline if outline is not None else fill
    assert edge is not None, "a box needs a fill or an outline"
    middle = fill if fill is not None else edge
    middle_alpha = middle.a / 255.0 if fill is not None else 0.0
    alpha_middle, alpha_edge = inner * middle_alpha, (outer - inner) * (edge.a / 255.0)
    alpha = alpha_middle + alpha_edge
    share = np.divide(alpha_middle, alpha, out=np.zeros_like(alpha), where=alpha > 0.0)
    picture = pygame.Surface(distance.shape, pygame.SRCALPHA, 32)
    pixels = pygame.surfarray.pixels3d(picture)
    for channel in range(3):
        pixels[:, :, channel] = np.rint(edge[channel] + share * (middle[channel] - edge[channel]))
    del pixels
    _set_alpha(picture, alpha)
    return picture


def _set_alpha(picture: pygame.Surface, alpha: np.ndarray) -> None:
    pixels = pygame.surfarray.pixels_alpha(picture)
    pixels[:, :] = np.rint(alpha * 255.0)
    del pixels


def _make_shadow(width: int, height: int, blur: float, opacity: float) -> pygame.Surface:
    reach = math.ceil(3.0 * blur)
    picture = pygame.Surface((width + 2 * reach, height + 2 * reach), pygame.SRCALPHA, 32)
    _set_alpha(picture, opacity * np.outer(_soft_step(width, reach, blur), _soft_step(height, reach, blur)))
    return picture


def _soft_step(length: int, reach: int, blur: float) -> np.ndarray:
    """A bar of ``length`` blurred by a normal distribution, with ``reach`` px on either side."""
    s = max(blur, 1e-6) * math.sqrt(2.0)
    at = np.arange(-reach, length + reach) + 0.5
    return np.array([0.5 * (math.erf(x / s) - math.erf((x - length) / s)) for x in at])


def _make_gradient(width: int, height: int, radius: float, left: Color, right: Color) -> pygame.Surface:
    shape = _make_box(width, height, min(radius, 0.5 * width, 0.5 * height), left, None, 0.0)
    share = (np.arange(width) / max(width - 1, 1))[:, None]
    pixels = pygame.surfarray.pixels3d(shape)
    for channel in range(3):
        pixels[:, :, channel] = np.rint(left[channel] + share * (right[channel] - left[channel]))
    del pixels
    return shape
