"""Signs for buttons, and the mark of Carom, at any size: kept once for each size and colour."""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
import pygame

from game.ui.look.strokes import Paper, Part, arc, disc, frame, line, right_half, ring, solid, teeth
from game.ui.look.theme import Theme
from game.ui.look.tool_signs import TOOL_SIGNS

LARGEST = 512  # px


def _star(radius: float) -> tuple[tuple[float, float], ...]:
    """The ten corners of a five-pointed star, clockwise from its uppermost."""
    reach = (radius, 0.42 * radius)
    turns = [math.pi * i / 5.0 for i in range(10)]
    return tuple((reach[i % 2] * math.sin(t), -reach[i % 2] * math.cos(t)) for i, t in enumerate(turns))


def _points(corners: tuple[tuple[float, float], ...]) -> tuple[Part, ...]:
    """The inside of a star: a convex kite from the middle to each of its points."""
    count = len(corners)
    return tuple(
        solid((0.0, 0.0), corners[i - 1], corners[i], corners[(i + 1) % count]) for i in range(0, count, 2)
    )


_STAR = _star(7.0)
_QUESTION = (
    arc(0.0, -1.6, 2.1, 180.0, 230.0, 1.5),
    line((0.9, 0.2), (0.0, 1.5), width=1.5),
    disc(0, 4, 1.0),
)

SIGNS: dict[str, tuple[Part, ...]] = {
    "back": (line((2.8, -5.4), (-2.7, 0.0), (2.8, 5.4)),),
    "chevron": (line((-4.5, -2.2), (0.0, 2.3), (4.5, -2.2)),),
    "chevron-right": (line((-2.2, -4.5), (2.3, 0.0), (-2.2, 4.5)),),
    "play": (solid((-4.0, -5.5), (5.5, 0.0), (-4.0, 5.5)),),
    "pause": (solid((-4, -5), (-1, -5), (-1, 5), (-4, 5)), solid((1, -5), (4, -5), (4, 5), (1, 5))),
    "step": (solid((-5, -5), (2, 0), (-5, 5)), solid((3, -5), (5, -5), (5, 5), (3, 5))),
    "step-back": (solid((-2, 0), (5, -5), (5, 5)), solid((-5, -5), (-3, -5), (-3, 5), (-5, 5))),
    "reset": (arc(0.4, 0.4, 5.4, 225.0, 315.0), solid((-5.9, -5.6), (-1.4, -5.6), (-5.9, -0.9))),
    "camera": (
        frame(6.1, 4.4, 1.4, 1.8, 0.0, 1.0),
        solid((-2.8, -6.0), (2.8, -6.0), (2.8, -3.0), (-2.8, -3.0)),
        ring(0.0, 1.0, 2.3, 1.5),
    ),
    "help": (ring(0.0, 0.0, 6.9, 1.5), *_QUESTION),
    "panel": (
        frame(6.1, 5.1, 1.2, 1.8),
        solid((2, -5), (3, -5), (3, 5), (2, 5)),
    ),
    "gear": (ring(0.0, 0.0, 4.3, 1.6), teeth(8, 5.2, 7.2, 1.8), ring(0.0, 0.0, 1.5, 1.2)),
    "search": (ring(-1.2, -1.2, 4.9, 1.6), line((2.5, 2.5), (6.4, 6.4))),
    "page": (
        line((-4.6, -6.2), (1.6, -6.2), (4.6, -3.2), (4.6, 6.2), (-4.6, 6.2), (-4.6, -6.2)),
        line((-2.0, -0.6), (2.0, -0.6)),
        line((-2.0, 2.6), (2.0, 2.6)),
    ),
    "contrast": (ring(0.0, 0.0, 6.3, 1.5), right_half(6.5)),
    "undo": (
        line((-3.1, -5.6), (-5.7, -2.6), (-3.1, 0.4)),
        line((-5.3, -2.6), (2.3, -2.6)),
        arc(2.3, 1.3, 3.9, 270.0, 180.0, 1.7),
        line((2.3, 5.2), (-2.2, 5.2)),
    ),
    "replay": (frame(6.1, 4.1, 1.0, 1.8), solid((-1.6, -2.2), (2.4, 0.0), (-1.6, 2.2))),
    "warning": (
        line((0.0, -5.9), (6.5, 5.4), (-6.5, 5.4), (0.0, -5.9), width=1.6),
        line((0.0, -1.6), (0.0, 1.6), width=1.6),
        disc(0.0, 3.7, 0.9),
    ),
    "check": (line((-5.0, 0.3), (-1.5, 3.8), (5.2, -3.6)),),
    "close": (line((-4, -4), (4, 4)), line((4, -4), (-4, 4))),
    "plus": (line((-4.5, 0), (4.5, 0)), line((0, -4.5), (0, 4.5))),
    "minus": (line((-4.5, 0), (4.5, 0)),),
    "info": (ring(0.0, 0.0, 6.9, 1.5), line((0.0, -0.4), (0.0, 3.6), width=1.6), disc(0.0, -3.4, 1.0)),
    "sound": (
        solid((-6.5, -2.2), (-3.5, -2.2), (-3.5, 2.2), (-6.5, 2.2)),
        solid((-3.6, -2.2), (0.0, -5.4), (0.0, 5.4), (-3.6, 2.2)),
        arc(-0.5, 0.0, 3.4, -42.0, 84.0, 1.5),
        arc(-0.5, 0.0, 6.4, -45.0, 90.0, 1.5),
    ),
    "star": (line(*_STAR, _STAR[0], width=1.3),),
    "star-full": (*_points(_STAR), disc(0.0, 0.0, 2.7), line(*_STAR, _STAR[0], width=1.3)),
    "ruler": (
        line((-6.4, 2.6), (2.6, -6.4), (6.4, -2.6), (-2.6, 6.4), (-6.4, 2.6), width=1.6),
        *(line((x, -x - 3.8), (x + 1.6, -x - 2.2), width=1.3) for x in (-3.9, -1.9, 0.1)),
    ),
    "cup": (
        solid((-4.2, -6.4), (4.2, -6.4), (2.6, 0.4), (-2.6, 0.4)),
        arc(-4.4, -4.0, 2.2, 60.0, 240.0, 1.3),
        arc(4.4, -4.0, 2.2, -120.0, 240.0, 1.3),
        line((0.0, 0.2), (0.0, 4.4), width=1.8),
        line((-3.4, 5.6), (3.4, 5.6), width=1.8),
    ),
    "target": (ring(0.0, 0.0, 6.3, 1.5), ring(0.0, 0.0, 3.2, 1.4), disc(0.0, 0.0, 1.2)),
    "record": (ring(0.0, 0.0, 6.3, 1.5), disc(0.0, 0.0, 3.3)),
    **TOOL_SIGNS,
}


def icon(name: str, size: int, color: pygame.Color) -> pygame.Surface:
    """A sign in a square of ``size`` px on a transparent surface; kept, so do not draw on it.

    ValueError names an unknown sign.
    """
    if name not in SIGNS:
        raise ValueError(f"icon {name!r}: there is none; known are {', '.join(sorted(SIGNS))}")
    return _icon(name, min(LARGEST, max(1, int(size))), (color.r, color.g, color.b, color.a))


@lru_cache(maxsize=512)
def _icon(name: str, size: int, color: tuple[int, int, int, int]) -> pygame.Surface:
    paper = Paper(size)
    for part in SIGNS[name]:
        part(paper)
    return _inked(paper.coverage * (color[3] / 255.0), color)


def _inked(coverage: np.ndarray, color: tuple[int, int, int, int]) -> pygame.Surface:
    """A surface of one colour with the coverage as its alpha."""
    picture = pygame.Surface(coverage.shape, pygame.SRCALPHA, 32)
    picture.fill((*color[:3], 0))
    alpha = pygame.surfarray.pixels_alpha(picture)
    alpha[:] = np.rint(255.0 * coverage)
    del alpha
    return picture


def logo(size: int, theme: Theme) -> pygame.Surface:
    """The mark of Carom in a square of ``size`` px: a line that turns at a cushion, and two balls; kept."""
    return _logo(
        min(LARGEST, max(1, int(size))),
        theme.name,
        _bytes(theme.text1),
        _bytes(theme.chalk.mark),
        _bytes(theme.amber.mark),
    )


def _bytes(color: pygame.Color) -> tuple[int, int, int, int]:
    return color.r, color.g, color.b, color.a


Rgba = tuple[int, int, int, int]


@lru_cache(maxsize=32)
def _logo(size: int, name: str, way: Rgba, first: Rgba, second: Rgba) -> pygame.Surface:
    paper = Paper(size)
    line((-8.5, 6.7), (0.7, -2.3), (5.0, 3.0), width=1.05)(paper)
    picture = _inked(paper.coverage * (0.88 if name == "dark" else 1.0), way)
    for x, y, radius, color in ((3.7, -5.35, 3.1, first), (5.35, 5.15, 2.8, second)):
        picture.blit(_small_ball(size, x, y, radius, color), (0, 0))
    return picture


def _small_ball(size: int, x: float, y: float, radius: float, color: Rgba) -> pygame.Surface:
    """A ball of the mark with its spot of light."""
    paper = Paper(size)
    paper.add(np.hypot(paper.x - x, paper.y - y) - radius)
    picture = _inked(paper.coverage, color)
    glow = np.clip(
        1.0 - np.hypot(paper.x - x + 0.38 * radius, paper.y - y + 0.38 * radius) / (0.42 * radius), 0, 1
    )
    pixels = pygame.surfarray.pixels3d(picture)
    share = (0.8 * np.sqrt(glow))[:, :, None]
    pixels[:] = np.rint(pixels + share * (255.0 - pixels))
    del pixels
    return picture
