"""Polygons of boards, posts and dominoes, as arrays to be painted at once."""

from __future__ import annotations

import colorsys
from functools import lru_cache

import numpy as np

from game.arrays import Floats, Longs
from game.scenes.domino.level import FloorEntry

BOARD, FRONT = 0.34, 0.09  # m: of a board, of its lit upper edge
POST, EVERY = 0.26, 6.9  # m: breadth of a post, between two
# of a domino, in shares of its half thickness and half height: where the painted band lies, and the grain
BAND = (-1.0, 0.18, 1.0, 0.56)
LIT = (-1.0, -1.0, -0.62, 1.0)
SHADED = (0.66, -1.0, 1.0, 1.0)
GRAIN = ((-0.3, -0.9, -0.16, 0.1), (0.18, -0.96, 0.3, -0.12))


def posts_of(floor: FloorEntry, points: Floats, others: list[Floats], ground: float) -> Floats:
    """Corners (4 n, 2) m of the posts below a floor, each down to the next floor or the ground."""
    if floor.look != "board":
        return np.zeros((0, 2))
    bare = _bare(floor)
    low, high = float(points[0, 0]), float(points[-1, 0])
    found = []
    for x in np.arange(low + 0.7, high - 0.3, EVERY):
        if any(left < x < right for left, right in bare):
            continue
        top = _height(points, float(x))
        below = [_height(one, float(x)) for one in others if one[0, 0] < x < one[-1, 0]]
        foot = max([ground, *(y for y in below if y < top - 0.6)])
        a, b = x - 0.5 * POST, x + 0.5 * POST
        found.append([(a, foot), (b, foot), (b, top - 0.1), (a, top - 0.1)])
    return np.array(found).reshape(-1, 2)


def pools_of(floor: FloorEntry) -> list[tuple[float, float, float, float]]:
    """Left, bottom, right and top (m) of the gaps of a floor."""
    (x, y), found, edge = floor.start, [], 0.0
    for piece in floor.pieces:
        if piece.look == "gap" and piece.rise < 0.0:
            edge = y
        elif piece.look == "gap" and piece.run:
            found.append((x, y, x + piece.run, y + 0.72 * (edge - y)))
        x, y = x + piece.run + piece.radius, y + piece.rise
    return found


def _bare(floor: FloorEntry) -> list[tuple[float, float]]:
    """Where a floor has no posts: below bridges, gaps and where it rises upright."""
    x, found = floor.start[0], []
    for piece in floor.pieces:
        after = x + piece.run + (piece.radius if piece.radius else 0.0)
        if piece.look or piece.radius:
            found.append((x - 0.1, after + 0.1))
        x = after
    return found


def spans_of(floor: FloorEntry) -> list[tuple[float, float, float]]:
    """Left end, right end and height (m) of the bridges of a floor."""
    (x, y), found = floor.start, []
    for piece in floor.pieces:
        if piece.look == "bridge":
            found.append((x, x + piece.run, y))
        x, y = x + piece.run + piece.radius, y + piece.rise
    return found


def _height(points: Floats, x: float) -> float:
    k = np.flatnonzero((points[:-1, 0] <= x) & (points[1:, 0] >= x) & (points[1:, 0] > points[:-1, 0]))
    if not len(k):
        return float(points[:, 1].min())
    (x0, y0), (x1, y1) = points[k[0]], points[k[0] + 1]
    return float(y0 + (y1 - y0) * (x - x0) / (x1 - x0))


@lru_cache(maxsize=8)
def rainbow(count: int, dark: bool) -> Longs:
    """Colours (n,) 0xRRGGBB along the path, from red over green to violet."""
    hues = np.linspace(0.0, 0.8, max(count, 1))
    found = []
    for hue in hues.tolist():
        r, g, b = colorsys.hsv_to_rgb(hue, 0.62 if dark else 0.68, 0.86 if dark else 0.8)
        found.append(int(255 * r) << 16 | int(255 * g) << 8 | int(255 * b))
    return np.array(found, dtype=np.int64)
