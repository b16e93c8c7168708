"""Boxes round a table, in the world's metres, so that the hand finds them at every size; its letters."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import pygame

from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.theme import Theme

READABLE, ROOM_FOR_READABLE = 11, 0.65  # px of the smallest letters, at scales that have the space for them
CROWDED = 8  # px of them at smaller scales


class Box(NamedTuple):
    """A rectangle of the world as it is seen: top and bottom in x, left and right in y, m."""

    top: float
    left: float
    bottom: float
    right: float

    def holds(self, x: float, y: float) -> bool:
        """True if a point lies in it."""
        return self.top <= x <= self.bottom and self.left <= y <= self.right

    @property
    def middle(self) -> tuple[float, float]:
        """Its middle (x, y), m."""
        return 0.5 * (self.top + self.bottom), 0.5 * (self.left + self.right)


def rect_of(canvas: Canvas, box: Box) -> pygame.Rect:
    """A box in px of the canvas' surface."""
    left, top = canvas.camera.to_screen(box.top, box.left)
    right, bottom = canvas.camera.to_screen(box.bottom, box.right)
    return pygame.Rect(round(left), round(top), round(right) - round(left), round(bottom) - round(top))


@lru_cache(maxsize=16)
def _look(theme: Theme, k: float, less_motion: bool) -> Look:
    return Look(theme, k, less_motion=less_motion, least=READABLE if k >= ROOM_FOR_READABLE else CROWDED)


def look_of(canvas: Canvas, pixels: float) -> Look:
    """Letters and lines in the measure of a table's picture. pixels: design px to a metre."""
    k = min(max(round(canvas.pixels_per_unit / pixels, 2), 0.5), 6.0)
    return _look(canvas.theme, k, canvas.look.less_motion)
