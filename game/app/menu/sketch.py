"""Quiet drawings for the cards of scenes whose kernels are not compiled yet."""

from __future__ import annotations

from functools import lru_cache

import pygame

from game.stage.catalogue import Entry
from game.ui.canvas.pen import Pen
from game.ui.look.look import Look

MOST_KEPT = 128  # drawings: those of eighty cards, and some in two sizes


@lru_cache(maxsize=MOST_KEPT)
def sketch(entry: Entry, size: tuple[int, int], look: Look) -> pygame.Surface:
    """The drawing of a scene in that size, window px; of one without a drawing a thrown ball."""
    pen = Pen((max(1, size[0]), max(1, size[1])), look)
    (entry.card_painter() or _draw_thrown_ball)(pen)
    return pen.finished()


def _draw_thrown_ball(pen: Pen) -> None:
    """A thrown ball in a grid: for a scene that has no drawing of its own."""
    pen.fill("stage")
    for x in range(-80, 241, 20):
        pen.line(((x, -40.0), (x, 144.0)), "grid", 0.6)
    for y in range(-38, 144, 20):
        pen.line(((-80.0, y), (240.0, y)), "grid", 0.6)
    path = [(20.0 + 6.0 * t, 84.0 - 9.6 * t + 0.42 * t * t) for t in range(21)]
    pen.line(path, "ghost", 1.0)
    for t in (3, 7, 11):
        pen.disc(*path[t], 6.0, "line2", ring=0.9)
    pen.disc(*path[15], 6.5, "body")
    pen.disc(*path[15], 6.5, "chalk", ring=1.5)
