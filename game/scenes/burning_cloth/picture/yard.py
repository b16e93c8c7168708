"""The yard behind the cloth in the light of the sky and of what burns, place by place."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import inner_kernel, lean_kernel
from game.scenes.burning_cloth.picture import yard_picture as ya
from game.scenes.burning_cloth.picture.yard_picture import Floats, yard_picture
from game.scenes.burning_cloth.tables import HALF, TALL
from game.ui.canvas.canvas import Canvas
from game.worlds.painting.backdrops import Painted, Seen

ROWS, COLUMNS = 20, 32  # of the light that falls on the yard
SOURCES = (12, 18)  # rows, columns of blocks of what shines
REACH = 0.36  # m at which light is half as strong
WARM = (430, 235, 100)  # red, green, blue of firelight where it is strongest
MOST, OPAQUE = np.int32(255), np.uint32(0xFF000000)  # of a channel; the alpha of a pixel
DULL = np.float32(0.004)  # light that is not seen


@inner_kernel
def _light_row(row, colors, takes, near, more_red, more_green, more_blue):
    """In 32 bits throughout, which compilers make vector instructions of; no product is beyond 2 ** 27."""
    for x in range(row.size):
        ink = np.int32(colors[x] & np.uint32(0xFFFFFF))
        strong = np.int32(near[x] * np.float32(np.int32(takes[x])))
        red, green, blue = np.int32(ink >> 16), np.int32(np.int32(ink >> 8) & 255), np.int32(ink & 255)
        red = np.int32(red + np.int32(np.int32(np.int32(red * more_red) * strong) >> 16))
        green = np.int32(green + np.int32(np.int32(np.int32(green * more_green) * strong) >> 16))
        blue = np.int32(blue + np.int32(np.int32(np.int32(blue * more_blue) * strong) >> 16))
        word = np.int32(min(red, MOST) << 16) | np.int32(min(green, MOST) << 8) | min(blue, MOST)
        row[x] = np.uint32(word) | OPAQUE


@lean_kernel
def paint_yard(pixels, clip, colors, takes, light, places, gain, work):
    """Lay colors (h, w) into the clip, and firelight on it as takes (h, w) has it.

    light (ROWS, COLUMNS) float32 over the picture, linear between the middles of its cells: 1 is as bright
    again as ``gain`` (3,) 256ths of the colour. places: between which of its rows and columns those of pixels
    lie (first row (h,) int64 and share (h,) float32 of the next one, first column (w,), share (w,)). work: a
    row of light (COLUMNS,) and a row of pixels (w,), float32.
    """
    left, top, wide = clip[0], clip[1], colors.shape[1]
    first_rows, row_parts, first_columns, column_parts = places
    row_light, near = work
    red, green, blue = np.int32(gain[0]), np.int32(gain[1]), np.int32(gain[2])
    for y in range(colors.shape[0]):
        row = pixels[top + y, left : left + wide]
        upper, part, brightest = first_rows[y], row_parts[y], np.float32(0.0)
        for k in range(row_light.size):
            row_light[k] = light[upper, k] + part * (light[upper + 1, k] - light[upper, k])
            brightest = max(brightest, row_light[k])
        if brightest < DULL:
            for x in range(wide):
                row[x] = colors[y, x]
            continue
        for x in range(wide):
            k = first_columns[x]
            near[x] = row_light[k] + column_parts[x] * (row_light[k + 1] - row_light[k])
        _light_row(row, colors[y], takes[y], near, red, green, blue)


def _between(count: int, cells: int) -> tuple[NDArray[np.int64], NDArray[np.float32]]:
    """Of each of ``count`` places: the cell, of so many in their stead, whose middle is before it, and its
    share of the next one.
    """
    at = np.clip((np.arange(count) + 0.5) * cells / count - 0.5, 0.0, cells - 1.001)
    first = at.astype(np.int64)
    return first, (at - first).astype(np.float32)


class Yard:
    """Paints what is behind the cloth."""

    def __init__(self) -> None:
        self._seen = Seen()
        self._down = _between(round((ya.TOP_EDGE - ya.BOTTOM) / ya.CELL), ROWS)
        self._across = _between(round((ya.RIGHT - ya.LEFT) / ya.CELL), COLUMNS)

    def draw(self, canvas: Canvas, dark: bool, light: Floats) -> None:
        """light (ROWS, COLUMNS) float32: see `light_on_yard`."""
        picture = yard_picture(dark)
        pixels, clip = canvas.raster_target
        colors, takes = self._seen.of(
            canvas, Painted(ya.LEFT, ya.TOP_EDGE, ya.CELL), (picture.colors, picture.takes)
        )
        rows, columns = self._seen.rows, self._seen.columns
        places = (*(part[rows] for part in self._down), *(part[columns] for part in self._across))
        gain = np.array([int(part * 256.0 / picture.own) for part in WARM], dtype=np.int64)
        work = np.empty(COLUMNS, np.float32), np.empty(len(columns), np.float32)
        paint_yard(pixels, clip, colors, takes, light, places, gain, work)


def warm_up_yard() -> None:
    """Compile what paints, on a tiny picture."""
    longs, shares = np.zeros(4, np.int64), np.zeros(4, np.float32)
    paint_yard(
        np.zeros((4, 4), np.uint32), np.array((0, 0, 4, 4), np.int64), np.zeros((4, 4), np.uint32),
        np.zeros((4, 4), np.uint8), np.zeros((ROWS, COLUMNS), np.float32), (longs, shares, longs, shares),
        np.zeros(3, np.int64), (np.zeros(COLUMNS, np.float32), shares),
    )  # fmt: skip


@lru_cache(maxsize=1)
def _spread() -> Floats:
    """(ROWS COLUMNS, sources): how much of a block's light comes to a place of the yard."""
    x = ya.LEFT + (np.arange(COLUMNS) + 0.5) * (ya.RIGHT - ya.LEFT) / COLUMNS
    y = ya.TOP_EDGE - (np.arange(ROWS) + 0.5) * (ya.TOP_EDGE - ya.BOTTOM) / ROWS
    bx = -HALF + (np.arange(SOURCES[1]) + 0.5) * 2.0 * HALF / SOURCES[1]
    by = (np.arange(SOURCES[0]) + 0.5) * TALL / SOURCES[0]
    dx = (x[None, :, None, None] - bx[None, None, None, :]) / REACH
    dy = (y[:, None, None, None] - by[None, None, :, None]) / REACH
    near = 1.0 / (1.0 + dx * dx + dy * dy)
    return near.reshape(ROWS * COLUMNS, -1).astype(np.float32)


def light_on_yard(shining: Floats) -> Floats:
    """(ROWS, COLUMNS) 0 to 1 from blocks (SOURCES) of what shines, 0 to some."""
    found = _spread() @ np.ascontiguousarray(shining, dtype=np.float32).reshape(-1)
    return np.minimum(found, 1.15).reshape(ROWS, COLUMNS)
