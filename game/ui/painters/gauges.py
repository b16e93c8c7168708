"""Instruments of a stroke: the power bar, the ball that shows where the tip strikes, the dial of elevation.

All measures are design px times the book's scale.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import pygame

from game.ui.look.fonts import FontBook, format_number
from game.ui.look.measures import border_width
from game.ui.look.numerals import NOTHING
from game.ui.look.theme import CUE_CHALK, Theme
from game.ui.painters.ball_picture import plain_ball_picture
from game.ui.raster import (
    BUTT,
    ROUND,
    clip_of,
    fill_box,
    fill_disc,
    fill_polygon,
    packed,
    pixels_of,
    scratch_for,
    stroke_arc,
    stroke_box,
    stroke_ring,
    stroke_segment,
)

POWER_WIDTH = 16.0
SPIN_RADIUS = 30.0
DIAL_RADIUS = 40.0


class _Bar(NamedTuple):
    """Where the power bar stands, in coordinates of the window: edges, middle of 0 and of the top."""

    left: float
    top: float
    right: float
    bottom: float
    zero: float
    full: float
    line: float  # width of an outline


def draw_power(
    surface: pygame.Surface, rect: pygame.Rect, speed: float, top_speed: float, theme: Theme, book: FontBook
) -> None:
    """A bar from 0 to ``top_speed`` m/s inside ``rect``, with its scale, a pointer and the figure below it.

    The bar stands in the middle of ``rect``, which should be 64 design px wide; "Power" stands above.
    """
    k = book.k
    ox, oy = surface.get_abs_offset()
    left = float(ox + round(rect.centerx - 0.5 * POWER_WIDTH * k))
    top, bottom = float(oy + rect.y + round(44 * k)), float(oy + rect.bottom - round(60 * k))
    if bottom - top < 32.0 * k:
        return
    end = 8.0 * k  # the round ends lie beyond 0 and the top
    bar = _Bar(
        left, top, left + round(POWER_WIDTH * k), bottom, bottom - end, top + end, float(border_width(k))
    )
    share = min(1.0, max(0.0, speed / top_speed)) if math.isfinite(speed) and top_speed > 0.0 else 0.0
    level = float(math.floor(bar.zero + share * (bar.full - bar.zero)))
    _draw_filling(surface, bar, level, theme)
    _draw_pointer(surface, bar, level, theme, k)
    _draw_scale(surface, bar, level, top_speed, theme, book)
    x, foot = rect.centerx, bottom - oy
    book.draw(surface, "Power", (x, rect.y + 8 * k), 13, "medium", theme.text2, "center")
    figure = f"{speed:.1f}" if math.isfinite(speed) else NOTHING
    book.draw(surface, figure, (x, foot + 24 * k), 18, "semibold", theme.text1, "center")
    book.draw(surface, "m/s", (x, foot + 46 * k), 12, "medium", theme.text2, "center")


def _draw_filling(surface: pygame.Surface, bar: _Bar, level: float, theme: Theme) -> None:
    """Tray, filling up to the level, outline."""
    pixels, clip = pixels_of(surface), clip_of(surface)
    left, top, right, bottom, w = bar.left, bar.top, bar.right, bar.bottom, bar.line
    radius = 0.5 * (right - left)
    fill_box(pixels, clip, left, top, right, bottom, radius, packed(theme.inset), 1.0)
    below = clip.copy()
    below[1] = max(clip[1], int(level))
    fill_box(
        pixels, below, left + 2 * w, top, right - 2 * w, bottom - 2 * w, radius, packed(theme.chalk.mark), 1.0
    )
    stroke_box(pixels, clip, left, top, right, bottom, radius, w, packed(theme.line2), 1.0)


def _draw_pointer(surface: pygame.Surface, bar: _Bar, level: float, theme: Theme, k: float) -> None:
    """A line across the bar at the level, and a triangle at its right."""
    pixels, clip = pixels_of(surface), clip_of(surface)
    _, area, extent = scratch_for(pixels)
    ink = packed(theme.text1)
    fill_box(pixels, clip, bar.left + bar.line, level, bar.right - bar.line, level + bar.line, 0.0, ink, 1.0)
    x, y = bar.right + 6.0 * k, level + 0.5 * bar.line
    corners = np.array(((x, y), (x + 9.0 * k, y - 6.0 * k), (x + 9.0 * k, y + 6.0 * k)))
    fill_polygon(pixels, clip, area, extent, corners, ink, 1.0)


def _draw_scale(
    surface: pygame.Surface, bar: _Bar, level: float, top_speed: float, theme: Theme, book: FontBook
) -> None:
    """Ten ticks at the right, which give way to the pointer, and every second one's figure at the left."""
    pixels, clip, k = pixels_of(surface), clip_of(surface), book.k
    ox, oy = surface.get_abs_offset()
    for i in range(11):
        y = float(math.floor(bar.zero + (bar.full - bar.zero) * i / 10.0))
        x0, x1 = bar.right + 4 * k, bar.right + (11 if i % 2 == 0 else 8) * k
        if abs(y - level) > 8.0 * k:
            fill_box(pixels, clip, x0, y, x1, y + bar.line, 0.0, packed(theme.line2), 1.0)
        if i % 2 == 0 and math.isfinite(top_speed):
            place, text = (bar.left - ox - 8 * k, y - oy), format_number(round(top_speed * i / 10.0))
            book.draw(surface, text, place, 12, "medium", theme.text2, "right")


@lru_cache(maxsize=8)
def _spin_ball(radius: float, backdrop: tuple[int, int, int]) -> pygame.Surface:
    """The cue ball as the player sees it from behind, without its spots."""
    return plain_ball_picture(radius, pygame.Color(*backdrop))


def draw_spin(
    surface: pygame.Surface,
    middle: tuple[float, float],
    side: float,
    height: float,
    theme: Theme,
    book: FontBook,
) -> None:
    """The cue ball with cross-hairs, and the tip's mark at (side, height) in shares of the radius.

    ``side`` counts to the right, ``height`` upwards; the mark stays on the ball.
    """
    k = book.k
    radius = SPIN_RADIUS * k
    picture = _spin_ball(radius, (theme.bg.r, theme.bg.g, theme.bg.b))
    x0, y0 = round(middle[0]), round(middle[1])
    surface.blit(picture, picture.get_rect(center=(x0, y0)))
    pixels, clip = pixels_of(surface), clip_of(surface)
    ox, oy = surface.get_abs_offset()
    x, y = float(x0 + ox), float(y0 + oy)
    ink = 0x6B7178
    reach = radius - 2.0 * k
    stroke_segment(pixels, clip, x - reach, y, x + reach, y, 1.0 * k, BUTT, ink, 0.45)
    stroke_segment(pixels, clip, x, y - reach, x, y + reach, 1.0 * k, BUTT, ink, 0.45)
    stroke_ring(pixels, clip, x, y, 0.5 * radius, 1.0 * k, ink, 0.5)
    length = math.sqrt(side * side + height * height)
    if not math.isfinite(length):
        return
    shrink = min(1.0, 0.98 / length) if length > 0.0 else 1.0
    tx, ty = x + side * shrink * radius, y - height * shrink * radius
    fill_disc(pixels, clip, tx, ty, 5.5 * k, 0x123A57, 1.0)
    fill_disc(pixels, clip, tx, ty, 4.3 * k, packed(CUE_CHALK), 1.0)


def draw_elevation(
    surface: pygame.Surface, pivot: tuple[float, float], angle: float, theme: Theme, book: FontBook
) -> None:
    """A quarter dial over its pivot: ticks each 15 degrees, the cue as an amber hand at ``angle`` rad."""
    k = book.k
    pixels, clip = pixels_of(surface), clip_of(surface)
    ox, oy = surface.get_abs_offset()
    x, y = round(pivot[0]) + ox + 0.5, round(pivot[1]) + oy + 0.5
    radius, line = DIAL_RADIUS * k, packed(theme.line2)
    stroke_arc(pixels, clip, x, y, radius, 1.0 * k, -0.5 * math.pi, 0.5 * math.pi, line, 1.0)
    stroke_segment(pixels, clip, x, y, x + radius + 6.0 * k, y, 1.0 * k, BUTT, line, 1.0)
    for i in range(7):
        c, s = math.cos(math.radians(15.0 * i)), -math.sin(math.radians(15.0 * i))
        a, b = radius - 3.0 * k, radius + 3.0 * k
        stroke_segment(pixels, clip, x + a * c, y + a * s, x + b * c, y + b * s, 1.0 * k, BUTT, line, 1.0)
    if math.isfinite(angle):
        c, s = math.cos(angle), -math.sin(angle)
        reach = radius + 5.0 * k
        stroke_segment(
            pixels, clip, x, y, x + reach * c, y + reach * s, 2.0 * k, ROUND, packed(theme.amber.mark), 1.0
        )
    fill_disc(pixels, clip, x, y, 3.0 * k, packed(theme.text1), 1.0)
