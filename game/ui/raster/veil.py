"""Smoke and flames as one veil over a picture: what covers by its thickness, and light that is added or
laid.

A row of cells is spread over the columns of the picture once. A row of pixels lies between two of those, and
is laid in a few plain loops over all its pixels. The compiler makes each loop of vector instructions.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import inner_kernel, lean_kernel
from game.ui.raster.pixels import clip_bounds, is_drawable

SHADES = 256  # of a table of colours
SMOKE, LIGHT = range(2)  # of the last axis of a veil
LEAST = np.float32(0.5 / SHADES)  # what is fainter is nothing
NONE, ONE, HALF, FULL = np.float32(0.0), np.float32(1.0), np.float32(0.5), np.float32(255.0)
THICKER = np.float32(1.5)  # how much more light covers where it is laid over than it shines
LAST = np.float32(SHADES - 1)


class VeilRoom(NamedTuple):
    """Space to work in, for pictures so many pixels wide."""

    wide: NDArray[np.float32]  # (4, width) smoke and light of two rows of cells
    share: NDArray[np.float32]  # (width,) of the second cell in each column
    smoke: NDArray[np.float32]  # (width,) of a row of pixels
    light: NDArray[np.float32]
    first: NDArray[np.int32]  # (width,) the first cell
    shade: NDArray[np.uint8]  # (width,) place in the table
    ink: NDArray[np.uint32]  # (width,)
    reach: NDArray[np.int64]  # (2, 4) of either row of cells: first column with anything in it and the one
    # behind the last, then the same of light


def veil_room(width: int) -> VeilRoom:
    """For pictures that are at most so wide."""
    return VeilRoom(
        np.zeros((4, width), np.float32), np.zeros(width, np.float32), np.zeros(width, np.float32),
        np.zeros(width, np.float32), np.zeros(width, np.int32), np.zeros(width, np.uint8),
        np.zeros(width, np.uint32), np.zeros((2, 4), np.int64),
    )  # fmt: skip


@inner_kernel
def _reach(cells, least_kind, room, ends, width):
    """Into ends (2,): the columns in which a row of cells shows anything, or (from LIGHT on) any light."""
    columns, begin, end = cells.shape[0], cells.shape[0], -1
    for column in range(columns):
        if cells[column, LIGHT] > LEAST or (least_kind == SMOKE and cells[column, SMOKE] > LEAST):
            begin, end = min(begin, column), column
    before, behind = 0, 0
    for x in range(width):
        before += room.first[x] < begin - 1
        behind += room.first[x] <= end
    ends[0], ends[1] = before, behind


@inner_kernel
def _spread(cells, room, slot, width):
    """Spread a row of cells over the columns of the picture, and say how far it reaches."""
    columns, smoke, light = cells.shape[0], room.wide[2 * slot], room.wide[2 * slot + 1]
    _reach(cells, SMOKE, room, room.reach[slot, :2], width)
    _reach(cells, LIGHT, room, room.reach[slot, 2:], width)
    for x in range(width):
        smoke[x], light[x] = NONE, NONE
    for x in range(room.reach[slot, 0], room.reach[slot, 1]):
        k, share = room.first[x], room.share[x]
        m = k + 1 if k + 1 < columns else k
        smoke[x] = cells[k, SMOKE] + share * (cells[m, SMOKE] - cells[k, SMOKE])
        light[x] = cells[k, LIGHT] + share * (cells[m, LIGHT] - cells[k, LIGHT])


@inner_kernel
def _blur(low, high, part, out):
    """Between two rows of cells, 0 to 1; nothing for what is fainter than a shade, or no number."""
    for x in range(out.size):
        value = low[x] + part * (high[x] - low[x])
        value = value if value > LEAST else NONE
        out[x] = value if value < ONE else ONE


@inner_kernel
def _choose_inks(light, shade, ink, table):
    """The colours of light in a table."""
    for x in range(light.size):
        value = light[x] * np.float32(SHADES)
        shade[x] = np.uint8(np.int32(value if value < LAST else LAST))
    for x in range(light.size):
        ink[x] = table[shade[x]]


@inner_kernel(forceinline=True)
def _channel(word, shift):
    return np.float32(np.int32((word >> np.uint32(shift)) & np.uint32(255)))


@inner_kernel
def _lay_smoke(pixels, smoke, color):
    """Cover a row of pixels with a colour, as thickly as said."""
    red, green, blue = _channel(color, 16), _channel(color, 8), _channel(color, 0)
    for x in range(pixels.size):
        under, thick = pixels[x], smoke[x]
        r = np.int32(_channel(under, 16) * (ONE - thick) + red * thick + HALF)
        g = np.int32(_channel(under, 8) * (ONE - thick) + green * thick + HALF)
        b = np.int32(_channel(under, 0) * (ONE - thick) + blue * thick + HALF)
        a = np.int32(_channel(under, 24) * (ONE - thick) + FULL * thick + HALF)
        pixels[x] = np.uint32((a << 24) | (r << 16) | (g << 8) | b)


@inner_kernel
def _lay_both(pixels, smoke, light, ink, color, adds):
    """The same, then light: added, or laid over by one and a half times its strength."""
    red, green, blue = _channel(color, 16), _channel(color, 8), _channel(color, 0)
    for x in range(pixels.size):
        under, thick, shine = pixels[x], smoke[x], ink[x]
        strong = light[x] * THICKER
        strong = strong if strong < ONE else ONE
        gain = ONE if adds else strong
        keep = ONE if adds else ONE - strong
        r = (_channel(under, 16) * (ONE - thick) + red * thick) * keep + _channel(shine, 16) * gain + HALF
        g = (_channel(under, 8) * (ONE - thick) + green * thick) * keep + _channel(shine, 8) * gain + HALF
        b = (_channel(under, 0) * (ONE - thick) + blue * thick) * keep + _channel(shine, 0) * gain + HALF
        a = (_channel(under, 24) * (ONE - thick) + FULL * thick) * keep + FULL * (ONE - keep) + HALF
        word = np.int32(r if r < FULL else FULL) << 16 | np.int32(g if g < FULL else FULL) << 8
        pixels[x] = np.uint32(np.int32(a) << 24 | word | np.int32(b if b < FULL else FULL))


@inner_kernel
def _lay_row(pixels, room, slots, part, color, table, adds):
    """A row of pixels between two spread rows of cells: smoke alone but for where there is light."""
    one, other = slots
    begin = min(room.reach[one, 0], room.reach[other, 0])
    end = max(room.reach[one, 1], room.reach[other, 1])
    first = max(min(room.reach[one, 2], room.reach[other, 2]), begin)
    last = max(room.reach[one, 3], room.reach[other, 3])
    if last <= first:
        first, last = end, end
    low, high = room.wide[2 * one], room.wide[2 * other]
    _blur(low[begin:end], high[begin:end], part, room.smoke[begin:end])
    _lay_smoke(pixels[begin:first], room.smoke[begin:first], np.uint32(color))
    _lay_smoke(pixels[last:end], room.smoke[last:end], np.uint32(color))
    if last > first:
        low, high, light = room.wide[2 * one + 1], room.wide[2 * other + 1], room.light[first:last]
        _blur(low[first:last], high[first:last], part, light)
        ink = room.ink[first:last]
        _choose_inks(light, room.shade[first:last], ink, table)
        _lay_both(pixels[first:last], room.smoke[first:last], light, ink, np.uint32(color), adds)


@lean_kernel
def paint_veil(
    pixels: Any, clip: Any, veil: Any, box: Any, smoke: int, table: Any, room: Any, adds: bool
) -> None:
    """Lay a veil (rows, columns, 2) float32 over a box of the picture, linearly between the middles of cells.

    Its SMOKE, 0 to 1, covers with the colour ``smoke``. Then its LIGHT, 0 to 1, is added in the colour of
    table (256,), or, unless it ``adds``, laid over as thickly as it is strong. box: (4,) px, left, top, right
    and bottom, the first row at its lower end. space: `VeilRoom`, as wide as the picture.
    """
    left, top, right, bottom = box[0], box[1], box[2], box[3]
    if not (is_drawable(left) and is_drawable(top) and is_drawable(right) and is_drawable(bottom)):
        return
    rows, columns = veil.shape[0], veil.shape[1]
    if not (right > left and bottom > top) or rows < 1 or columns < 1:
        return
    x_low, y_low, x_high, y_high = clip_bounds(pixels, clip, left, top, right, bottom)
    width, down, across = x_high - x_low, rows / (bottom - top), columns / (right - left)
    if width <= 0:
        return
    for x in range(width):
        u = min(max((x_low + x + 0.5 - left) * across - 0.5, 0.0), columns - 1.0)
        room.first[x] = min(int(u), max(columns - 2, 0))
        room.share[x] = u - room.first[x]
    held_even, held_odd = -1, -1  # which rows of cells are spread
    for y in range(y_low, y_high):
        v = min(max((bottom - (y + 0.5)) * down - 0.5, 0.0), rows - 1.0)
        lower = min(int(v), max(rows - 2, 0))
        upper = min(lower + 1, rows - 1)
        for line in (lower, upper):
            if line != (held_odd if line % 2 else held_even):
                _spread(veil[line], room, line % 2, width)
                held_even, held_odd = (held_even, line) if line % 2 else (line, held_odd)
        _lay_row(
            pixels[y, x_low:x_high], room, (lower % 2, upper % 2), np.float32(v - lower), smoke, table, adds
        )
