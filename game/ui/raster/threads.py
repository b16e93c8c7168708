"""Very many thin lines between points, as threads of a cloth: several times quicker than strokes with ends.

Each line is one pixel wide, its coverage shared between two pixels across it (Wu 1991, "An efficient
antialiasing technique"); ends are not rounded, as another thread begins there.
"""

from __future__ import annotations

import numpy as np

from game.compiler.decorator import inner_kernel, lean_kernel
from game.ui.raster.pixels import blend, is_drawable

LONGEST = 4_000.0  # px; a longer thread is not drawn


@inner_kernel
def draw_thread(pixels, clip, x0, y0, x1, y1, color, alpha):
    """One thread between two places (px)."""
    steep = abs(y1 - y0) > abs(x1 - x0)
    if steep:
        x0, y0, x1, y1 = y0, x0, y1, x1
    if x0 > x1:
        x0, y0, x1, y1 = x1, y1, x0, y0
    first_x, first_y, last_x, last_y = clip[0], clip[1], clip[2], clip[3]
    if steep:
        first_x, first_y, last_x, last_y = clip[1], clip[0], clip[3], clip[2]
    slope = (y1 - y0) / (x1 - x0) if x1 > x0 else 0.0
    begin = max(int(x0), first_x)
    end = min(int(x1), last_x - 1)
    for x in range(begin, end + 1):
        y = y0 + slope * (x + 0.5 - x0) - 0.5
        if not first_y <= y < last_y - 1:
            continue
        whole = int(y)
        part = int((y - whole) * alpha * 256.0)
        rest = int(alpha * 256.0) - part
        if steep:
            blend(pixels, x, whole, color, rest)
            blend(pixels, x, whole + 1, color, part)
        else:
            blend(pixels, whole, x, color, rest)
            blend(pixels, whole + 1, x, color, part)


@lean_kernel
def draw_threads(pixels, clip, points, pairs, torn, colors, alpha):
    """Threads between ``points`` (n, 2) px by ``pairs`` (m, 2) of them, those torn (m,) left out.

    colors (m,) uint32; alpha 0 to 1. What is not finite or absurdly long is not drawn.
    """
    for e in range(pairs.shape[0]):
        if torn[e]:
            continue
        a = pairs[e, 0]
        b = pairs[e, 1]
        x0, y0, x1, y1 = points[a, 0], points[a, 1], points[b, 0], points[b, 1]
        if not (is_drawable(x0) and is_drawable(y0) and is_drawable(x1) and is_drawable(y1)):
            continue
        if abs(x1 - x0) + abs(y1 - y0) < LONGEST:
            draw_thread(pixels, clip, x0, y0, x1, y1, np.int64(colors[e]), alpha)
