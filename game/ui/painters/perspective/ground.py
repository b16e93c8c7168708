"""Cloth, cushions, pockets and wood as a pinhole camera sees them: one ray a pixel through two sheets.

The camera has no roll, so a row of pixels meets each sheet along a straight line, at equal distances. A ray
that passes the rails' height over the cloth and comes to the cloth's height under a rail meets its face.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from game.compiler.decorator import inner_kernel, kernel
from game.ui.painters.perspective.relief import Relief
from game.ui.raster.pixels import OPAQUE, bounds_of

FLOOR_DEPTH = 0.80  # m of the floor below the cloth
FLOOR = (54.0, 39.0, 28.0)  # of 255, under the lamp
FLOOR_LIGHT, FLOOR_FADES = 0.62, 0.55  # under the table's middle; how fast it fades, 1/m2
WALL = (20.0, 25.0, 30.0)  # of 255, at the horizon
WALL_FADES = 2.6  # how much darker for each focal length above it
SIDE = 0x140E0C  # the frame's outer side
FACE_HIGH, FACE_LOW = 0.86, 0.34  # brightness of a cushion's face at its nose and at the cloth
LINER = 90  # sum of channels below which a face is that of a pocket, which is darker
BEHIND = 2.5  # texels behind an edge from which a face has its colour
STRIDE, MOST_PARTS = 0.02, 16  # m, less than a cushion is broad
FIXED = 16  # bits of a texel's fraction
PAIR = 0xFF00FF
LANES = 0x00FF00FF00FF00FF  # four channels, each with space for a product: raised, green, red, blue


@inner_kernel
def _spread(texel: int) -> int:
    """The channels of a texel in lanes of 16 bits, from above: raised share, green, red, blue."""
    return (texel & PAIR) | (texel & 0xFF00FF00) << 24


@inner_kernel
def _packed(lanes: int) -> int:
    """A pixel of spread channels, solid."""
    return OPAQUE | (lanes & PAIR) | (lanes >> 24 & 0xFF00)


@inner_kernel
def _between(first: int, second: int, share: int) -> int:
    """Spread channels mixed; the share of the second is 0 to 256."""
    return (first * (256 - share) + second * share) >> 8 & LANES


@inner_kernel
def _mixed(texels: Any, at: int, columns: int, a: int, b: int) -> int:
    """Between four texels, spread; a, b: shares of the right and the lower ones, 0 to 256."""
    upper = _between(_spread(np.int64(texels[at])), _spread(np.int64(texels[at + 1])), a)
    at += columns
    return _between(upper, _between(_spread(np.int64(texels[at])), _spread(np.int64(texels[at + 1])), a), b)


@inner_kernel
def _texel(texels: Any, level: Any, column: float, row: float) -> int:
    """As `_mixed` at a place of a copy (begin, columns, rows), kept within it."""
    begin, columns, rows = level
    x = min(max(column - 0.5, 0.0), columns - 1.001)
    y = min(max(row - 0.5, 0.0), rows - 1.001)
    i, j = int(x), int(y)
    return _mixed(texels, begin + j * columns + i, columns, int((x - i) * 256.0), int((y - j) * 256.0))


@inner_kernel
def _low_of(texels: Any, level: Any, column: float, row: float, step: Any, stride: float) -> int:
    """Spread colour at the cloth's height, or of the face that hides it.

    column, row: at the rails' height; step: from there to the cloth's height; stride: from one look to the
    next; all texels.
    """
    length = max(math.sqrt(step[0] * step[0] + step[1] * step[1]), 1e-6)
    parts = min(int(length / stride) + 1, MOST_PARTS)
    low, high, raised, found = 0.0, 1.0, 0, 0
    for part in range(1, parts + 1):  # a rail that the ray would pass through is narrower than its way
        high = part / parts
        found = _texel(texels, level, column + high * step[0], row + high * step[1])
        raised = found >> 48
        if raised > 127 and part < parts:
            raised = 255
            break
        low = high if part < parts else low
    if raised == 0:
        return found
    for _ in range(4):  # how far down the ray meets the face
        half = 0.5 * (low + high)
        if _texel(texels, level, column + half * step[0], row + half * step[1]) >> 48 > 127:
            high = half
        else:
            low = half
    into = high + BEHIND / length
    skin = _texel(texels, level, column + into * step[0], row + into * step[1])
    bright = FACE_HIGH + (FACE_LOW - FACE_HIGH) * high
    if (skin & 255) + (skin >> 16 & 255) + (skin >> 32 & 255) < LINER:
        bright *= 0.3
    return _between(found, _between(0, skin, int(256.0 * bright)), raised + (raised >> 7))


@inner_kernel
def _floor(t: float, way_x: float, way_y: float, eye: Any) -> int:
    """Colour of the floor beside the table, where a ray meets it after t."""
    x, y = eye[0] + t * way_x, eye[1] + t * way_y
    light = FLOOR_LIGHT / (1.0 + FLOOR_FADES * (x * x + 2.0 * y * y))
    red, green, blue = max(FLOOR[0] * light, 11.0), max(FLOOR[1] * light, 13.0), max(FLOOR[2] * light, 15.0)
    return (int(red) << 16) | (int(green) << 8) | int(blue)


@inner_kernel
def _within(first: float, step: float, limit: float, low: float, high: float) -> Any:
    """Part (low, high) of a range of columns in which |first + column step| < limit."""
    if abs(step) < 1e-12:
        return (low, high) if abs(first) < limit else (1.0, 0.0)
    a, b = (-limit - first) / step, (limit - first) / step
    return max(low, min(a, b)), min(high, max(a, b))


@inner_kernel
def _bed_columns(eye: Any, bed: Any, heights: Any, slope: Any, x_low: int, x_high: int) -> Any:
    """Columns (first, past the last) whose rays stay over the bed from the rails' height to the cloth."""
    low, high = 1.0 * x_low, x_high - 1.0
    for which in range(2):
        t, u = heights[which], 0.5 - eye[8]
        x, y = eye[0] + t * (slope[0] + u * eye[4]), eye[1] + t * (slope[1] - u * eye[3])
        low, high = _within(x, t * eye[4], bed[0], low, high)
        low, high = _within(y, -t * eye[3], bed[1], low, high)
    if not low <= high:
        return x_low, x_low
    return math.ceil(low), math.floor(high) + 1


@kernel
def _paint_bed(pixels: Any, row: int, begin: int, end: int, texels: Any, level: Any, way: Any) -> None:
    """A stretch of bare cloth. way: column and row of the first pixel's texel, and from pixel to pixel."""
    unit = 1.0 * (1 << FIXED)
    i, j = int((way[0] - 0.5) * unit), int((way[1] - 0.5) * unit)
    di, dj = int(way[2] * unit), int(way[3] * unit)
    first, columns = level[0], level[1]
    for column in range(begin, end):
        at = first + (j >> FIXED) * columns + (i >> FIXED)
        lanes = _mixed(texels, at, columns, i >> (FIXED - 8) & 255, j >> (FIXED - 8) & 255)
        pixels[row, column] = _packed(lanes)
        i += di
        j += dj


@kernel
def paint_ground(pixels: Any, clip: Any, eye: Any, relief: Any) -> None:
    """The table without its balls, and the room about it, over all of the clip.

    eye (10,) as `Eye.numbers`; relief as `Relief`. A camera below the rails sees the wall alone.
    """
    texels, levels, bed, scale, height = relief
    x_low, y_low, x_high, y_high = bounds_of(pixels, clip)
    focal, middle_x, middle_y = eye[7], eye[8], eye[9]
    half_columns, half_rows = 0.5 * levels[0, 1], 0.5 * levels[0, 2]
    for row in range(y_low, y_high):
        up = middle_y - row - 0.5
        down = eye[6] * focal - eye[5] * up  # how fast a ray falls
        if not (down > 1e-6 * focal and eye[2] > height):
            fade = 1.0 / (1.0 + WALL_FADES * max(0.0, -down / focal))
            wall = (int(WALL[0] * fade) << 16) | (int(WALL[1] * fade) << 8) | int(WALL[2] * fade)
            for column in range(x_low, x_high):
                pixels[row, column] = OPAQUE | wall
            continue
        ahead = eye[5] * focal + eye[6] * up
        slope = (eye[3] * ahead, eye[4] * ahead)
        to_rail, to_cloth, to_floor = (eye[2] - height) / down, eye[2] / down, (eye[2] + FLOOR_DEPTH) / down
        wanted = to_cloth * scale * math.sqrt(max(1.0, to_cloth * focal / eye[2]))
        pick = 0
        while pick < levels.shape[0] - 1 and levels[pick, 3] * 1.6 <= wanted:
            pick += 1
        level = (levels[pick, 0], levels[pick, 1], levels[pick, 2])
        shrink = scale / levels[pick, 3]
        centre_x, centre_y = half_columns / levels[pick, 3], half_rows / levels[pick, 3]
        begin, end = _bed_columns(eye, bed, (to_rail, to_cloth), slope, x_low, x_high)
        if begin < end:
            u = begin + 0.5 - middle_x
            x = eye[0] + to_cloth * (slope[0] + u * eye[4])
            y = eye[1] + to_cloth * (slope[1] - u * eye[3])
            way = (
                centre_x + x * shrink, centre_y - y * shrink, to_cloth * eye[4] * shrink,
                to_cloth * eye[3] * shrink,
            )  # fmt: skip
            _paint_bed(pixels, row, begin, end, texels, level, way)
        for column in range(x_low, x_high):
            if begin <= column < end:
                continue
            u = column + 0.5 - middle_x
            way_x, way_y = slope[0] + u * eye[4], slope[1] - u * eye[3]
            x, y = eye[0] + to_rail * way_x, eye[1] + to_rail * way_y
            low_x, low_y = eye[0] + to_cloth * way_x, eye[1] + to_cloth * way_y
            if abs(x) > bed[2] or abs(y) > bed[3]:
                side = abs(low_x) <= bed[2] and abs(low_y) <= bed[3]
                pixels[row, column] = OPAQUE | (SIDE if side else _floor(to_floor, way_x, way_y, eye))
                continue
            i, j = centre_x + x * shrink, centre_y - y * shrink
            lanes = _texel(texels, level, i, j)
            raised = lanes >> 48
            if raised < 255:
                step = ((low_x - x) * shrink, (y - low_y) * shrink)
                deep = _low_of(texels, level, i, j, step, STRIDE * shrink)
                lanes = _between(deep, lanes, raised + (raised >> 7))
            pixels[row, column] = _packed(lanes)


def _warm_up() -> None:
    """Compile the kernel on a picture of 8 x 8 pixels."""
    pixels, clip = np.zeros((8, 8), np.uint32), np.array((0, 0, 8, 8), np.int64)
    eye = np.array((0.0, 0.0, 1.0, 1.0, 0.0, math.sqrt(0.5), math.sqrt(0.5), 8.0, 4.0, 4.0))
    levels = np.array(((0, 16, 16, 1),), np.int64)
    relief = Relief(np.zeros(256, np.uint32), levels, np.ones(4), 4.0, 0.04)
    paint_ground(pixels, clip, eye, relief)


WARM_UPS = [("paint_ground", _warm_up)]
