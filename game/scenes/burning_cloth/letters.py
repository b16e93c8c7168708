"""Letters as strokes of a brush: polylines on a field 4 wide and 6 high, and how they lie on a cloth."""

from __future__ import annotations

from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Floats

Line = tuple[tuple[float, float], ...]
TALL, WIDE, GAP = 6.0, 4.0, 2.1  # of a letter, and between two, in units of its field
NARROW = {"I": 0.0, " ": 1.5, "1": 1.6}  # width of those that are not as wide
MOST = 8  # letters
_L: dict[str, tuple[Line, ...]] = {
    "A": (((0, 0), (0, 4), (2, 6), (4, 4), (4, 0)), ((0, 2.4), (4, 2.4))),
    "B": (((0, 0), (0, 6), (3, 6), (4, 5), (3, 3.2), (0, 3.2)), ((3, 3.2), (4, 2), (3, 0), (0, 0))),
    "C": (((4, 5), (3, 6), (1, 6), (0, 5), (0, 1), (1, 0), (3, 0), (4, 1)),),
    "D": (((0, 0), (0, 6), (2.6, 6), (4, 4.6), (4, 1.4), (2.6, 0), (0, 0)),),
    "E": (((4, 0), (0, 0), (0, 6), (4, 6)), ((0, 3.1), (3, 3.1))),
    "F": (((0, 0), (0, 6), (4, 6)), ((0, 3.1), (3, 3.1))),
    "G": (((4, 5), (3, 6), (1, 6), (0, 5), (0, 1), (1, 0), (3, 0), (4, 1), (4, 2.8), (2.4, 2.8)),),
    "H": (((0, 0), (0, 6)), ((4, 0), (4, 6)), ((0, 3.1), (4, 3.1))),
    "I": (((0, 0), (0, 6)),),
    "J": (((4, 6), (4, 1), (3, 0), (1, 0), (0, 1)),),
    "K": (((0, 0), (0, 6)), ((4, 6), (0, 2.6)), ((1.2, 3.6), (4, 0))),
    "L": (((0, 6), (0, 0), (4, 0)),),
    "M": (((0, 0), (0, 6), (2, 3), (4, 6), (4, 0)),),
    "N": (((0, 0), (0, 6), (4, 0), (4, 6)),),
    "O": (((1, 0), (0, 1), (0, 5), (1, 6), (3, 6), (4, 5), (4, 1), (3, 0), (1, 0)),),
    "P": (((0, 0), (0, 6), (3, 6), (4, 5), (4, 3.8), (3, 2.8), (0, 2.8)),),
    "Q": (((1, 0), (0, 1), (0, 5), (1, 6), (3, 6), (4, 5), (4, 1), (3, 0), (1, 0)), ((2.6, 1.6), (4, -0.2))),
    "R": (((0, 0), (0, 6), (3.2, 6), (4, 5.2), (4, 3.6), (3.2, 2.8), (0, 2.8)), ((2, 2.8), (4, 0))),
    "S": (((4, 5), (3, 6), (1, 6), (0, 5), (0, 4), (1, 3.1), (3, 3.1), (4, 2.2), (4, 1), (3, 0), (1, 0),
           (0, 1)),),
    "T": (((2, 0), (2, 6)), ((0, 6), (4, 6))),
    "U": (((0, 6), (0, 1), (1, 0), (3, 0), (4, 1), (4, 6)),),
    "V": (((0, 6), (2, 0), (4, 6)),),
    "W": (((0, 6), (1, 0), (2, 3.4), (3, 0), (4, 6)),),
    "X": (((0, 0), (4, 6)), ((0, 6), (4, 0))),
    "Y": (((2, 0), (2, 3), (0, 6)), ((2, 3), (4, 6))),
    "Z": (((4, 0), (0, 0), (4, 6), (0, 6)),),
    "0": (((1, 0), (0, 1), (0, 5), (1, 6), (3, 6), (4, 5), (4, 1), (3, 0), (1, 0)),),
    "1": (((1.6, 0), (1.6, 6), (0, 4.6)),),
    "2": (((4, 0), (0, 0), (4, 3.8), (4, 5), (3, 6), (1, 6), (0, 5)),),
    "3": (((0, 6), (4, 6), (2, 3.4), (4, 2.4), (4, 1), (3, 0), (1, 0), (0, 1)),),
    "4": (((3, 0), (3, 6), (0, 2), (4, 2)),),
    "5": (((0, 1), (1, 0), (3, 0), (4, 1), (4, 2.6), (3, 3.4), (0, 3.4), (0, 6), (4, 6)),),
    "6": (((0, 2.6), (1, 3.4), (3, 3.4), (4, 2.6), (4, 1), (3, 0), (1, 0), (0, 1), (0, 4), (2, 6), (4, 6)),),
    "7": (((1, 0), (4, 6), (0, 6)),),
    "8": (((1, 3.1), (0, 4), (0, 5), (1, 6), (3, 6), (4, 5), (4, 4), (3, 3.1), (1, 3.1), (0, 2.2), (0, 1),
           (1, 0), (3, 0), (4, 1), (4, 2.2), (3, 3.1)),),
    "9": (((0, 0), (2, 0), (4, 2), (4, 5), (3, 6), (1, 6), (0, 5), (0, 4), (1, 3), (3, 3), (4, 3.8)),),
    "♥": (((2, 0), (0, 3.4), (0, 4.8), (0.9, 5.8), (1.5, 5.6), (2, 4.7), (2.5, 5.6), (3.1, 5.8), (4, 4.8),
           (4, 3.4), (2, 0)),),
    " ": (),
}  # fmt: skip
KNOWN = frozenset(_L)


class Lettering(NamedTuple):
    """share (rows, columns) of saltpetre; of (rows, columns): which letter a patch is of, -1: none; feet
    (n, 2): where each letter begins, m from the cloth's upper left corner.
    """

    share: Floats
    of: NDArray[np.int64]
    feet: Floats


def unknown_in(words: str) -> str:
    """The first sign that cannot be written, or ""."""
    return next((sign for sign in words.upper() if sign not in KNOWN), "")


def _away(x: NDArray[Any], y: NDArray[Any], line: Line) -> Floats:
    """Distances of points to a polyline."""
    best = np.full(np.broadcast_shapes(x.shape, y.shape), np.inf)
    for (ax, ay), (bx, by) in pairwise(line):
        dx, dy = bx - ax, by - ay
        along = np.clip(((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy), 0.0, 1.0)
        ex, ey = x - ax - along * dx, y - ay - along * dy
        best = np.minimum(best, ex * ex + ey * ey)
    return np.asarray(np.sqrt(best))


def lettering(
    words: str, shape: tuple[int, int], size: float, stroke: float, fills: float = 0.8, tall: float = 0.6
) -> Lettering:  # fmt: skip
    """Words in the middle of a cloth of patches ``shape`` of ``size`` m, with a brush ``stroke`` m wide.

    They are ``tall`` times as high as the cloth, or as wide as ``fills`` of it if that is less.
    """
    rows, columns = shape
    share, of = np.zeros(shape), np.full(shape, -1, dtype=np.int64)
    signs = words.upper()[:MOST]
    wides = [NARROW.get(sign, WIDE) for sign in signs]
    total = sum(wides) + GAP * max(len(signs) - 1, 0)
    if not signs.strip():
        return Lettering(share, of, np.zeros((0, 2)))
    unit = min(tall * rows * size / TALL, (fills * columns * size - stroke) / max(total, 1.0))
    x = (np.arange(columns) + 0.5)[None, :] * size
    y = (rows - np.arange(rows) - 0.5)[:, None] * size  # upwards from the lower edge
    left, low = 0.5 * (columns * size - total * unit), 0.5 * (rows * size - TALL * unit)
    feet: list[tuple[float, float]] = []
    for sign, wide in zip(signs, wides, strict=True):
        for line in _L[sign]:
            part = np.clip(
                0.5 + (0.5 * stroke - unit * _away((x - left) / unit, (y - low) / unit, line)) / size, 0, 1
            )
            of[(part > 0.5) & (part >= share)] = len(feet)
            share = np.maximum(share, part)
        if _L[sign]:
            foot = min((point for line in _L[sign] for point in line), key=lambda point: (point[1], point[0]))
            feet.append((left + unit * foot[0], rows * size - low - unit * foot[1]))
        left += (wide + GAP) * unit
    return Lettering(share, of, np.array(feet).reshape(-1, 2))
