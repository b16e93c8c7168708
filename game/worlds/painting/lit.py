"""Painted pictures in two lights: what a room's own light shows of them, and what a flame's adds.

A picture has rows of seven layers (rows, 7, columns), the first row the lowest: red, green and blue 0 to 255
in the room's light, the same in the flame's, and what share of the ground it covers. Both lights are already
taken times the opacity, so that a layer that covers nothing is added: a gleam, or a flame.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.arrays import Singles
from game.compiler.decorator import inner_kernel, lean_kernel
from game.ui.raster.pixels import clip_bounds, is_drawable

LAYERS = 7
ONE, FULL, SOLID = np.float32(1.0), np.float32(255.0), np.float32(0.999)
CLEAR = np.float32(0.002)  # opacity and light that are not seen


@inner_kernel
def _light_row(cells, lights, ends, lit):
    """Into lit (4, columns): a row of cells (7, columns) in both lights, from the first of ``ends`` on."""
    for c in range(3):
        one, other = lights[c], lights[c + 3]
        for i in range(ends[0], ends[1]):
            lit[c, i] = cells[c, i] * one + cells[c + 3, i] * other
    for i in range(ends[0], ends[1]):
        lit[3, i] = cells[6, i]


@inner_kernel
def _mix(low, high, part, line, more):
    """Into line (columns,): what lies between two rows; into more: how much more the next column has."""
    for i in range(line.size):
        line[i] = low[i] + part * (high[i] - low[i])
    for i in range(line.size - 1):
        more[i] = line[i + 1] - line[i]


@inner_kernel
def _is_seen(line, i):
    return line[0, i] + line[1, i] + line[2, i] + line[3, i] > CLEAR


@inner_kernel
def _between(low, high, part, ends, line):
    """Into line (8, columns): what lies between two lit rows, and how much more the next column has.

    Returns how many columns are not opaque, and from which to which anything is seen.
    """
    begin, end, thin = ends[0], ends[1], 0
    for c in range(4):
        _mix(low[c, begin:end], high[c, begin:end], part, line[c, begin:end], line[c + 4, begin:end])
    cover = line[3, begin:end]
    for i in range(cover.size):
        thin += cover[i] < SOLID
    while begin < end and not _is_seen(line, begin):
        begin += 1
    while end > begin and not _is_seen(line, end - 1):
        end -= 1
    return thin, begin - 1, end


@inner_kernel
def _cover_row(row, line, cells, parts, noise):
    """Lay an opaque line over a row of pixels."""
    for x in range(row.size):
        i, f, n = cells[x], parts[x], noise[x]
        r = np.int32(min(line[0, i] + f * line[4, i] + n, FULL))
        g = np.int32(min(line[1, i] + f * line[5, i] + n, FULL))
        b = np.int32(min(line[2, i] + f * line[6, i] + n, FULL))
        row[x] = np.uint32(0xFF000000) | np.uint32((r << 16) | (g << 8) | b)


@inner_kernel
def _blend_row(row, line, cells, parts, noise):
    """The same of a line that lets some of the ground through."""
    for x in range(row.size):
        i, f, n = cells[x], parts[x], noise[x]
        keep, under = ONE - line[3, i] - f * line[7, i], row[x]
        red = keep * np.float32(np.int32((under >> np.uint32(16)) & np.uint32(255)))
        green = keep * np.float32(np.int32((under >> np.uint32(8)) & np.uint32(255)))
        blue = keep * np.float32(np.int32(under & np.uint32(255)))
        r = np.int32(min(red + line[0, i] + f * line[4, i] + n, FULL))
        g = np.int32(min(green + line[1, i] + f * line[5, i] + n, FULL))
        b = np.int32(min(blue + line[2, i] + f * line[6, i] + n, FULL))
        row[x] = np.uint32(0xFF000000) | np.uint32((r << 16) | (g << 8) | b)


@inner_kernel
def _place(begin, across, columns, cells, parts):
    """Between which middles of cells pixels lie, the first of them at ``begin``; the nearest ones beyond."""
    for x in range(cells.size):
        u = min(max(begin + across * x, 0.0), columns - 1.001)
        cells[x] = int(u)
        parts[x] = u - cells[x]


@inner_kernel
def _grain(first, y, noise):
    """0 to 1, below a step of 8 bits: it keeps slow shades from falling into bands (Jimenez 2014)."""
    for x in range(noise.size):
        n = 0.06711056 * (first + x) + 0.00583715 * y
        n = 52.9829189 * (n - int(n))
        noise[x] = n - int(n)


@lean_kernel
def paint_lit(pixels: Any, clip: Any, layers: Any, box: Any, bend: Any, lights: Any, work: Any) -> None:
    """Lay layers (rows, 7, columns) over a box (4,) px of the picture: left, top, right, bottom.

    bend (rows,) px: how far each row is moved to the right; lights (6,) float32: red, green and blue of the
    room's light and of the flame's. work: `LitRoom`.
    """
    left, top, right, bottom = box[0], box[1], box[2], box[3]
    rows, columns = layers.shape[0], layers.shape[2]
    if not (is_drawable(left) and is_drawable(top) and is_drawable(right) and is_drawable(bottom)):
        return
    if not (right > left and bottom > top) or rows < 2 or columns < 2:
        return
    x_low, y_low, x_high, y_high = clip_bounds(pixels, clip, left, top, right, bottom)
    width = x_high - x_low
    if width <= 0:
        return
    down, across, most = rows / (bottom - top), columns / (right - left), 0.0
    for j in range(rows):
        most = max(most, abs(bend[j]))
    first = max(math.floor((x_low - most - left) * across - 1.5), 0)
    ends = first, min(math.ceil((x_high + most - left) * across + 1.5), columns)
    cells, parts, noise = work.cells[:width], work.parts[:width], work.noise[:width]
    held_even, held_odd, placed = -1, -1, math.nan
    for y in range(y_low, y_high):
        v = min(max((bottom - y - 0.5) * down - 0.5, 0.0), rows - 1.001)
        j = int(v)
        for k in (j, j + 1):
            if k != (held_odd if k % 2 else held_even):
                _light_row(layers[k], lights, ends, work.lit[k % 2])
                held_even, held_odd = (held_even, k) if k % 2 else (k, held_odd)
        thin, seen, behind = _between(
            work.lit[j % 2], work.lit[(j + 1) % 2], np.float32(v - j), ends, work.line
        )
        begin = (x_low + 0.5 - left - bend[j] - (v - j) * (bend[j + 1] - bend[j])) * across - 0.5
        if begin != placed:
            _place(begin, across, columns, cells, parts)
            placed = begin
        low = min(max(int((seen - begin) / across), 0), width) if seen > 0 else 0
        high = min(max(int((behind - begin) / across) + 2, low), width) if behind < columns - 1 else width
        _grain(x_low, y, noise)
        row = pixels[y, x_low:x_high]
        if thin == 0:
            _cover_row(row, work.line, cells, parts, noise)
        else:
            _blend_row(row[low:high], work.line, cells[low:high], parts[low:high], noise[low:high])


class LitRoom(NamedTuple):
    """Space to work in, for pictures so many columns and so many pixels wide."""

    lit: Singles  # (2, 4, columns) two rows of cells
    line: Singles  # (8, columns) between them
    cells: NDArray[np.int32]  # (width,) of each pixel: the cell, its share of the next one, its grain
    parts: Singles
    noise: Singles


def lit_room(columns: int, width: int) -> LitRoom:
    """For such a picture."""
    one = np.zeros(width, np.float32)
    return LitRoom(
        np.zeros((2, 4, columns), np.float32), np.zeros((8, columns), np.float32), np.zeros(width, np.int32),
        one, one.copy(),
    )  # fmt: skip


def warm_up_lit() -> None:
    """Compile what lays pictures, on a tiny one."""
    paint_lit(
        np.zeros((4, 4), np.uint32), np.array((0, 0, 4, 4), np.int64), np.zeros((2, LAYERS, 2), np.float32),
        np.array((0.0, 0.0, 4.0, 4.0)), np.zeros(2), np.ones(6, np.float32), lit_room(2, 4),
    )  # fmt: skip
