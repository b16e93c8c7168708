"""Smoke and flames as one veil over a picture: what covers by its thickness, and light that is added or
laid.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from game.physics.kernels.lean import lean_kernel
from game.ui.raster.pixels import blend, clip_bounds, is_drawable

SHADES = 256  # of a table of colours
SMOKE, LIGHT = range(2)  # of the last axis of a veil


@lean_kernel
def paint_veil(
    pixels: Any, clip: Any, veil: Any, box: Any, smoke: int, table: Any, row: Any, adds: bool
) -> None:
    """Lay a veil (rows, columns, 2) float32 over a box of the picture, linearly between the middles of cells.

    Its SMOKE, 0 to 1, covers with the colour ``smoke``; then its LIGHT, 0 to 1, is added in the colour of
    table (256,), or, unless it ``adds``, laid over as thickly as it is strong. box: (4,) px, left, top,
    right and bottom, the first row at its lower end. row: (columns, 2) float32 to work in.
    """
    left, top, right, bottom = box[0], box[1], box[2], box[3]
    if not (is_drawable(left) and is_drawable(top) and is_drawable(right) and is_drawable(bottom)):
        return
    rows, columns = veil.shape[0], veil.shape[1]
    if not (right > left and bottom > top) or rows < 1 or columns < 1:
        return
    x_low, y_low, x_high, y_high = clip_bounds(pixels, clip, left, top, right, bottom)
    down, across = rows / (bottom - top), columns / (right - left)
    least = np.float32(0.5 / SHADES)
    for y in range(y_low, y_high):
        v = min(max((bottom - (y + 0.5)) * down - 0.5, 0.0), rows - 1.0)
        lower = min(int(v), max(rows - 2, 0))
        upper = min(lower + 1, rows - 1)
        part = np.float32(v - lower)
        for column in range(columns):
            for k in range(2):
                below = veil[lower, column, k]
                row[column, k] = below + part * (veil[upper, column, k] - below)
        for x in range(x_low, x_high):
            u = min(max((x + 0.5 - left) * across - 0.5, 0.0), columns - 1.0)
            first = min(int(u), max(columns - 2, 0))
            second = min(first + 1, columns - 1)
            share = np.float32(u - first)
            thick = row[first, SMOKE] + share * (row[second, SMOKE] - row[first, SMOKE])
            light = row[first, LIGHT] + share * (row[second, LIGHT] - row[first, LIGHT])
            if thick > least:
                blend(pixels, y, x, smoke, min(int(thick * 256.0 + 0.5), 256))
            if light > least:
                shade = min(int(light * SHADES), SHADES - 1)
                ink = np.int64(table[shade])
                if not adds:
                    blend(pixels, y, x, ink, min(int(light * 384.0 + 0.5), 256))
                    continue
                under = np.int64(pixels[y, x])
                red = min(int((under >> 16) & 255) + int((ink >> 16) & 255), 255)
                green = min(int((under >> 8) & 255) + int((ink >> 8) & 255), 255)
                blue = min(int(under & 255) + int(ink & 255), 255)
                pixels[y, x] = np.uint32(
                    (under & 0xFF000000) | (int(red) << 16) | (int(green) << 8) | int(blue)
                )
