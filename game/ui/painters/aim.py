"""What a stroke would do, drawn on the cloth: aim line, ghost ball, target ring, predicted ways, a label."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pygame

from game.ui.look.fonts import FontBook
from game.ui.look.theme import FELT_COOL, FELT_LINE
from game.ui.raster import (
    BUTT,
    clip_of,
    fill_box,
    fill_disc,
    packed,
    pixels_of,
    scratch_for,
    stroke_dashes,
    stroke_ring,
    stroke_segment,
)

Array = np.ndarray
Point = tuple[float, float]
DASH, GAP = 8.0, 6.0  # design px
RING_GAP = 4.0  # design px between a target and its ring


class Aim(NamedTuple):
    """A prediction in window px. What is None or empty is not drawn."""

    cue_ball: Point
    ghost: Point  # the cue ball's place when it touches the target, or where it stops
    radius: float  # of the cue ball
    target: Point | None = None
    target_radius: float = 0.0
    target_way: Array | None = None  # (n, 2), from the target on
    cue_way: Array | None = None  # (n, 2), from the ghost on
    bounces: Array | None = None  # (m, 2), where the cue ball meets cushions
    last: Point | None = None  # where the cue ball comes to rest
    label: str = ""
    certain: bool = True  # False draws everything paler: the prediction ends in doubt


def draw_aim(surface: pygame.Surface, aim: Aim, book: FontBook) -> None:
    """Draw a prediction; ``book`` gives the interface scale and the label's letters."""
    pixels, clip = pixels_of(surface), clip_of(surface)
    k, white, strength = book.k, packed(FELT_LINE), 1.0 if aim.certain else 0.55
    _draw_ways(pixels, clip, aim, k, strength)
    x, y = aim.ghost
    _draw_line(pixels, clip, aim, k, strength)
    fill_disc(pixels, clip, x, y, aim.radius, white, 0.22 * strength)
    stroke_ring(pixels, clip, x, y, aim.radius, 1.5 * k, white, strength)
    if aim.target is not None:
        ring = aim.target_radius + RING_GAP * k
        stroke_ring(pixels, clip, *aim.target, ring, 1.5 * k, packed(FELT_COOL), strength)
    if aim.last is not None:
        fill_disc(pixels, clip, *aim.last, aim.radius, white, 0.16 * strength)
        stroke_ring(pixels, clip, *aim.last, aim.radius, 1.0 * k, white, 0.70 * strength)
    if aim.label:
        draw_cloth_label(surface, book, aim.label, (x - 34.0 * k, y - 40.0 * k))


def _draw_line(pixels: Array, clip: Array, aim: Aim, k: float, strength: float) -> None:
    """The solid line from the cue ball's edge to the middle of the ghost."""
    dx, dy = aim.ghost[0] - aim.cue_ball[0], aim.ghost[1] - aim.cue_ball[1]
    length = float(np.sqrt(dx * dx + dy * dy))
    if not aim.radius < length < 1e9:
        return
    share = aim.radius / length
    start = (aim.cue_ball[0] + share * dx, aim.cue_ball[1] + share * dy)
    stroke_segment(pixels, clip, *start, *aim.ghost, 1.5 * k, BUTT, packed(FELT_LINE), strength)


def _draw_ways(pixels: Array, clip: Array, aim: Aim, k: float, strength: float) -> None:
    """Dashed ways of the target and of the cue ball, and the cushion points."""
    cover = scratch_for(pixels).cover
    ways = ((aim.target_way, 2.0, FELT_COOL), (aim.cue_way, 1.5, FELT_LINE))
    for way, width, color in ways:
        if way is not None and len(way) > 1:
            points = np.ascontiguousarray(way, np.float64)
            stroke_dashes(
                pixels,
                clip,
                cover,
                points,
                width * k,
                False,
                DASH * k,
                GAP * k,
                0.0,
                packed(color),
                0.9 * strength,
            )
    if aim.bounces is not None:
        for x, y in aim.bounces:
            fill_disc(pixels, clip, float(x), float(y), 3.0 * k, 0x1E6E66, 1.0)
            stroke_ring(pixels, clip, float(x), float(y), 3.0 * k, 1.25 * k, packed(FELT_LINE), strength)


def draw_cloth_label(surface: pygame.Surface, book: FontBook, text: str, at: Point) -> pygame.Rect:
    """A word or two on a dark plate, with its middle at ``at`` but kept inside the surface's clip."""
    k = book.k
    width, height = book.size(text, 13, "medium")[0] + round(24 * k), round(22 * k)
    rect = pygame.Rect(0, 0, width, height)
    if not all(-1e6 < value < 1e6 for value in at):
        return rect
    rect.center = (round(at[0]), round(at[1]))
    rect.clamp_ip(surface.get_clip())
    pixels, clip = pixels_of(surface), clip_of(surface)
    left, top = surface.get_abs_offset()
    x, y = float(rect.x + left), float(rect.y + top)
    fill_box(pixels, clip, x, y, x + width, y + height, 6.0 * k, 0x06120F, 0.52)
    book.draw(surface, text, rect.center, 13, "medium", FELT_LINE, "center")
    return rect
