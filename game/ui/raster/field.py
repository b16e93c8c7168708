"""An array of numbers as a smooth picture."""

from __future__ import annotations

from typing import Any

import numpy as np

from game.physics.kernels.lean import lean_kernel
from game.ui.raster.pixels import blend, clip_bounds, is_drawable, weight_of

SHADES = 256  # of a table of colours


@lean_kernel
def paint_field(pixels: Any, clip: Any, values: Any, box: Any, table: Any, row: Any, alpha: float) -> None:
    """Lay values (rows, columns), 0 to 1, over a box of the picture, linearly between the middles of cells.

    box: (4,) px, left, top, right and bottom, the first row at its lower end. table: (256,) colours of 0 to
    1; row: (columns,) float32 to work in. What is outside 0 to 1 takes the nearest colour, nan the first.
    """
    left, top, right, bottom = box[0], box[1], box[2], box[3]
    if not (is_drawable(left) and is_drawable(top) and is_drawable(right) and is_drawable(bottom)):
        return
    rows, columns = values.shape
    if not (right > left and bottom > top) or rows < 1 or columns < 1:
        return
    x_low, y_low, x_high, y_high = clip_bounds(pixels, clip, left, top, right, bottom)
    down, across = rows / (bottom - top), columns / (right - left)
    weight = weight_of(1.0, alpha)
    if weight <= 0:
        return
    for y in range(y_low, y_high):
        v = min(max((bottom - (y + 0.5)) * down - 0.5, 0.0), rows - 1.0)
        lower = min(int(v), max(rows - 2, 0))
        upper = min(lower + 1, rows - 1)
        part = np.float32(v - lower)
        for column in range(columns):
            row[column] = values[lower, column] + part * (values[upper, column] - values[lower, column])
        for x in range(x_low, x_high):
            u = min(max((x + 0.5 - left) * across - 0.5, 0.0), columns - 1.0)
            first = min(int(u), max(columns - 2, 0))
            second = min(first + 1, columns - 1)
            value = row[first] + np.float32(u - first) * (row[second] - row[first])
            shade = 0
            if value > 0.0:
                shade = min(int(value * SHADES), SHADES - 1) if value < 1.0 else SHADES - 1
            if weight >= 256:
                pixels[y, x] = table[shade]
            else:
                blend(pixels, y, x, np.int64(table[shade]), weight)


def shade_table(stops: Any) -> Any:
    """(256,) uint32 through stops of (place 0 to 1, colour), linearly between them."""
    places = [place for place, _ in stops]
    at = np.arange(SHADES) / (SHADES - 1.0)
    table = np.full(SHADES, 0xFF000000, np.uint32)
    for shift, channel in ((16, 0), (8, 1), (0, 2)):
        level = np.interp(at, places, [color[channel] for _, color in stops])
        table |= np.clip(np.floor(level + 0.5), 0, 255).astype(np.uint32) << np.uint32(shift)
    return table
