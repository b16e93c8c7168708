"""An array of numbers as a smooth picture."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import lean_kernel
from game.ui.raster.pixels import blend, clip_bounds, is_drawable, weight_of

SHADES = 256  # of a table of colours
ALL, NONE, LAST = np.float32(SHADES), np.float32(0.0), np.float32(SHADES - 1)


class FieldRoom(NamedTuple):
    """Space to work in, for so many columns of values in pictures so many pixels wide."""

    row: NDArray[np.float32]  # (columns,) values at the height of a row of pixels
    first: NDArray[np.int32]  # (width,) the cell whose middle is left of each column of pixels
    part: NDArray[np.float32]  # (width,) of the next cell in it
    shade: NDArray[np.uint8]  # (width,) places in the table, of a row of pixels


def field_room(columns: int, width: int) -> FieldRoom:
    """For values with at most so many columns, in pictures that are at most so wide, px."""
    return FieldRoom(
        np.zeros(columns, np.float32), np.zeros(width, np.int32), np.zeros(width, np.float32),
        np.zeros(width, np.uint8),
    )  # fmt: skip


@lean_kernel
def paint_field(pixels: Any, clip: Any, values: Any, box: Any, table: Any, room: Any, alpha: float) -> None:
    """Lay values (rows, columns), 0 to 1, over a box of the picture, linearly between the middles of cells.

    box: (4,) px, left, top, right and bottom, the first row at its lower end. table: (256,) colours of 0 to
    1; space: `FieldRoom`. What is outside 0 to 1 takes the nearest colour, nan the first.
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
    row, first, part, shade = room
    width = x_high - x_low
    for x in range(width):
        u = min(max((x_low + x + 0.5 - left) * across - 0.5, 0.0), columns - 1.0)
        first[x] = min(int(u), max(columns - 2, 0))
        part[x] = u - first[x]
    more = 1 if columns > 1 else 0
    for y in range(y_low, y_high):
        v = min(max((bottom - (y + 0.5)) * down - 0.5, 0.0), rows - 1.0)
        lower = min(int(v), max(rows - 2, 0))
        upper = min(lower + 1, rows - 1)
        above = np.float32(v - lower)
        for column in range(columns):
            row[column] = values[lower, column] + above * (values[upper, column] - values[lower, column])
        for x in range(width):
            k = first[x]
            value = (row[k] + part[x] * (row[k + more] - row[k])) * ALL
            value = value if value > NONE else NONE
            shade[x] = np.uint8(np.int32(value if value < LAST else LAST))
        if weight >= 256:
            for x in range(width):
                pixels[y, x_low + x] = table[shade[x]]
        else:
            for x in range(width):
                blend(pixels, y, x_low + x, np.int64(table[shade[x]]), weight)


def shade_table(stops: Any) -> Any:
    """(256,) uint32 through stops of (place 0 to 1, colour), linearly between them."""
    places = [place for place, _ in stops]
    at = np.arange(SHADES) / (SHADES - 1.0)
    table = np.full(SHADES, 0xFF000000, np.uint32)
    for shift, channel in ((16, 0), (8, 1), (0, 2)):
        level = np.interp(at, places, [color[channel] for _, color in stops])
        table |= np.clip(np.floor(level + 0.5), 0, 255).astype(np.uint32) << np.uint32(shift)
    return table
