"""A word or two on a dark plate, on the cloth."""

from __future__ import annotations

import pygame

from game.ui.look.fonts import FontBook
from game.ui.look.theme import FELT_LINE
from game.ui.raster import clip_of, fill_box, pixels_of


def draw_cloth_label(
    surface: pygame.Surface, book: FontBook, text: str, at: tuple[float, float]
) -> pygame.Rect:
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
