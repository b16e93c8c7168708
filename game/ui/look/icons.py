"""Signs for buttons, and the mark of Carom, at any size: drawn from strokes by their exact distance.

They are needed while kernels still compile, so numpy draws them, once for each size and colour. A sign is a
list of parts on a square of 20 design px with the origin in its middle, x right, y down.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache
from itertools import pairwise

import numpy as np
import pygame

from game.ui.look.theme import Theme

Coverage = np.ndarray  # (n, n) 0 to 1, [x, y]
Part = Callable[["Paper"], None]
GRID = 20.0  # design px along a sign's side
LARGEST = 512  # px


class Paper:
    """A square picture of coverage that strokes are added to; lengths are design px."""

    def __init__(self, size: int) -> None:
        self.scale = size / GRID
        axis = (np.arange(size) + 0.5) / self.scale - 0.5 * GRID
        self.x, self.y = np.meshgrid(axis, axis, indexing="ij")
        self.coverage = np.zeros((size, size))

    def add(self, distance: np.ndarray, width: float = 0.0) -> None:
        """Add what lies within half a ``width`` of the zero of a distance; with no width, its inside."""
        half = 0.5 * width * self.scale
        d = distance * self.scale
        if width == 0.0:
            share = np.clip(0.5 - d, 0.0, 1.0)
        else:
            share = np.clip(np.minimum(half, np.abs(d) + 0.5) - np.maximum(-half, np.abs(d) - 0.5), 0.0, 1.0)
        self.coverage = np.maximum(self.coverage, share)

    def segment(self, x0: float, y0: float, x1: float, y1: float) -> np.ndarray:
        """Distance from a straight line between two points."""
        dx, dy = x1 - x0, y1 - y0
        t = np.clip(((self.x - x0) * dx + (self.y - y0) * dy) / (dx * dx + dy * dy), 0.0, 1.0)
        return np.hypot(self.x - x0 - t * dx, self.y - y0 - t * dy)

    def arc(self, x: float, y: float, radius: float, start: float, sweep: float) -> np.ndarray:
        """Distance from part of a circle; angles in degrees, clockwise on the screen."""
        dx, dy = self.x - x, self.y - y
        middle = math.radians(start + 0.5 * sweep)
        within = dx * math.cos(middle) + dy * math.sin(middle) >= np.hypot(dx, dy) * math.cos(
            math.radians(0.5 * sweep)
        )
        ends = [
            np.hypot(dx - radius * math.cos(math.radians(a)), dy - radius * math.sin(math.radians(a)))
            for a in (start, start + sweep)
        ]
        return np.where(within, np.abs(np.hypot(dx, dy) - radius), np.minimum(*ends))

    def polygon(self, points: tuple[tuple[float, float], ...]) -> np.ndarray:
        """Distance, negative inside, from a convex polygon given clockwise on the screen."""
        result = np.full(self.x.shape, -np.inf)
        for (x0, y0), (x1, y1) in zip(points, (*points[1:], points[0]), strict=True):
            length = math.hypot(x1 - x0, y1 - y0)
            side = ((self.x - x0) * (y1 - y0) - (self.y - y0) * (x1 - x0)) / length
            result = np.maximum(result, side)
        return result

    def box(self, half_x: float, half_y: float, radius: float, x: float = 0.0, y: float = 0.0) -> np.ndarray:
        """Distance, negative inside, from a box with round corners."""
        qx, qy = np.abs(self.x - x) - half_x + radius, np.abs(self.y - y) - half_y + radius
        outside = np.hypot(np.maximum(qx, 0.0), np.maximum(qy, 0.0))
        return outside + np.minimum(np.maximum(qx, qy), 0.0) - radius


def _line(*points: tuple[float, float], width: float = 1.7) -> Part:
    def draw(paper: Paper) -> None:
        for (x0, y0), (x1, y1) in pairwise(points):
            paper.add(paper.segment(x0, y0, x1, y1), width)

    return draw


def _arc(x: float, y: float, radius: float, start: float, sweep: float, width: float = 1.6) -> Part:
    return lambda paper: paper.add(paper.arc(x, y, radius, start, sweep), width)


def _ring(x: float, y: float, radius: float, width: float = 1.6) -> Part:
    return lambda paper: paper.add(np.hypot(paper.x - x, paper.y - y) - radius, width)


def _disc(x: float, y: float, radius: float) -> Part:
    return lambda paper: paper.add(np.hypot(paper.x - x, paper.y - y) - radius)


def _solid(*points: tuple[float, float]) -> Part:
    return lambda paper: paper.add(paper.polygon(points))


def _frame(half_x: float, half_y: float, radius: float, width: float, x: float = 0.0, y: float = 0.0) -> Part:
    return lambda paper: paper.add(paper.box(half_x, half_y, radius, x, y), width)


def _right_half(radius: float) -> Part:
    return lambda paper: paper.add(np.maximum(np.hypot(paper.x, paper.y) - radius, -paper.x))


def _teeth(count: int, inner: float, outer: float, width: float) -> Part:
    def draw(paper: Paper) -> None:
        for i in range(count):
            c, s = math.cos(2.0 * math.pi * i / count), math.sin(2.0 * math.pi * i / count)
            paper.add(paper.segment(inner * c, inner * s, outer * c, outer * s), width)

    return draw


def _star(radius: float) -> tuple[tuple[float, float], ...]:
    """The ten corners of a five-pointed star, clockwise from its uppermost."""
    reach = (radius, 0.42 * radius)
    turns = [math.pi * i / 5.0 for i in range(10)]
    return tuple((reach[i % 2] * math.sin(t), -reach[i % 2] * math.cos(t)) for i, t in enumerate(turns))


def _points(corners: tuple[tuple[float, float], ...]) -> tuple[Part, ...]:
    """The inside of a star: a convex kite from the middle to each of its points."""
    count = len(corners)
    return tuple(
        _solid((0.0, 0.0), corners[i - 1], corners[i], corners[(i + 1) % count]) for i in range(0, count, 2)
    )


_STAR = _star(7.0)
_QUESTION = (
    _arc(0.0, -1.6, 2.1, 180.0, 230.0, 1.5),
    _line((0.9, 0.2), (0.0, 1.5), width=1.5),
    _disc(0, 4, 1.0),
)

SIGNS: dict[str, tuple[Part, ...]] = {
    "back": (_line((2.8, -5.4), (-2.7, 0.0), (2.8, 5.4)),),
    "chevron": (_line((-4.5, -2.2), (0.0, 2.3), (4.5, -2.2)),),
    "chevron-right": (_line((-2.2, -4.5), (2.3, 0.0), (-2.2, 4.5)),),
    "play": (_solid((-4.0, -5.5), (5.5, 0.0), (-4.0, 5.5)),),
    "pause": (_solid((-4, -5), (-1, -5), (-1, 5), (-4, 5)), _solid((1, -5), (4, -5), (4, 5), (1, 5))),
    "step": (_solid((-5, -5), (2, 0), (-5, 5)), _solid((3, -5), (5, -5), (5, 5), (3, 5))),
    "step-back": (_solid((-2, 0), (5, -5), (5, 5)), _solid((-5, -5), (-3, -5), (-3, 5), (-5, 5))),
    "reset": (_arc(0.4, 0.4, 5.4, 225.0, 315.0), _solid((-5.9, -5.6), (-1.4, -5.6), (-5.9, -0.9))),
    "camera": (
        _frame(6.1, 4.4, 1.4, 1.8, 0.0, 1.0),
        _solid((-2.8, -6.0), (2.8, -6.0), (2.8, -3.0), (-2.8, -3.0)),
        _ring(0.0, 1.0, 2.3, 1.5),
    ),
    "help": (_ring(0.0, 0.0, 6.9, 1.5), *_QUESTION),
    "panel": (
        _frame(6.1, 5.1, 1.2, 1.8),
        _solid((2, -5), (3, -5), (3, 5), (2, 5)),
    ),
    "gear": (_ring(0.0, 0.0, 4.3, 1.6), _teeth(8, 5.2, 7.2, 1.8), _ring(0.0, 0.0, 1.5, 1.2)),
    "search": (_ring(-1.2, -1.2, 4.9, 1.6), _line((2.5, 2.5), (6.4, 6.4))),
    "page": (
        _line((-4.6, -6.2), (1.6, -6.2), (4.6, -3.2), (4.6, 6.2), (-4.6, 6.2), (-4.6, -6.2)),
        _line((-2.0, -0.6), (2.0, -0.6)),
        _line((-2.0, 2.6), (2.0, 2.6)),
    ),
    "contrast": (_ring(0.0, 0.0, 6.3, 1.5), _right_half(6.5)),
    "undo": (
        _line((-3.1, -5.6), (-5.7, -2.6), (-3.1, 0.4)),
        _line((-5.3, -2.6), (2.3, -2.6)),
        _arc(2.3, 1.3, 3.9, 270.0, 180.0, 1.7),
        _line((2.3, 5.2), (-2.2, 5.2)),
    ),
    "replay": (_frame(6.1, 4.1, 1.0, 1.8), _solid((-1.6, -2.2), (2.4, 0.0), (-1.6, 2.2))),
    "warning": (
        _line((0.0, -5.9), (6.5, 5.4), (-6.5, 5.4), (0.0, -5.9), width=1.6),
        _line((0.0, -1.6), (0.0, 1.6), width=1.6),
        _disc(0.0, 3.7, 0.9),
    ),
    "check": (_line((-5.0, 0.3), (-1.5, 3.8), (5.2, -3.6)),),
    "close": (_line((-4, -4), (4, 4)), _line((4, -4), (-4, 4))),
    "plus": (_line((-4.5, 0), (4.5, 0)), _line((0, -4.5), (0, 4.5))),
    "minus": (_line((-4.5, 0), (4.5, 0)),),
    "info": (_ring(0.0, 0.0, 6.9, 1.5), _line((0.0, -0.4), (0.0, 3.6), width=1.6), _disc(0.0, -3.4, 1.0)),
    "sound": (
        _solid((-6.5, -2.2), (-3.5, -2.2), (-3.5, 2.2), (-6.5, 2.2)),
        _solid((-3.6, -2.2), (0.0, -5.4), (0.0, 5.4), (-3.6, 2.2)),
        _arc(-0.5, 0.0, 3.4, -42.0, 84.0, 1.5),
        _arc(-0.5, 0.0, 6.4, -45.0, 90.0, 1.5),
    ),
    "star": (_line(*_STAR, _STAR[0], width=1.3),),
    "star-full": (*_points(_STAR), _disc(0.0, 0.0, 2.7), _line(*_STAR, _STAR[0], width=1.3)),
    "ruler": (
        _line((-6.4, 2.6), (2.6, -6.4), (6.4, -2.6), (-2.6, 6.4), (-6.4, 2.6), width=1.6),
        *(_line((x, -x - 3.8), (x + 1.6, -x - 2.2), width=1.3) for x in (-3.9, -1.9, 0.1)),
    ),
    "record": (_ring(0.0, 0.0, 6.3, 1.5), _disc(0.0, 0.0, 3.3)),
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
def _logo(size: int, name: str, line: Rgba, first: Rgba, second: Rgba) -> pygame.Surface:
    paper = Paper(size)
    _line((-8.5, 6.7), (0.7, -2.3), (5.0, 3.0), width=1.05)(paper)
    picture = _inked(paper.coverage * (0.88 if name == "dark" else 1.0), line)
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
