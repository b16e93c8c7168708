"""Pixels of a pond from above: its bed through moving water, light that waves gather, sky on their slopes."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from game.arrays import Floats, Inks, Ints
from game.compiler.decorator import inner_kernel, kernel, lean_kernel
from game.ui.raster.pixels import bounds_of
from game.worlds.painting.inks import channels, opaque

TILE = 512  # px of the bed's picture, which goes on at its edges
BED_SCALE = 34.0  # px of it to a metre
PEBBLES = 600
FIXED = 256  # of a slope, in whole numbers
BEND, GATHER, SHINE = (
    0.5,
    0.5,
    4.0,
)  # how far slopes shift the bed, curves gather light, slopes mirror the sky


@kernel
def find_slopes(heights, cell, slopes):
    """slopes (3, ny, nx): along x, along y, and the curve of heights (1/m), as whole numbers of 1/FIXED."""
    ny, nx = heights.shape
    for j in range(ny):
        low, high = max(j - 1, 0), min(j + 1, ny - 1)
        for i in range(nx):
            left, right = max(i - 1, 0), min(i + 1, nx - 1)
            dx = (heights[j, right] - heights[j, left]) / (2.0 * cell)
            dy = (heights[high, i] - heights[low, i]) / (2.0 * cell)
            around = heights[j, left] + heights[j, right] + heights[low, i] + heights[high, i]
            curve = (around - 4.0 * heights[j, i]) / (cell * cell)
            slopes[0, j, i] = int(min(max(dx, -4.0), 4.0) * FIXED * 64)
            slopes[1, j, i] = int(min(max(dy, -4.0), 4.0) * FIXED * 64)
            slopes[2, j, i] = int(min(max(curve, -60.0), 60.0) * FIXED * 8)


@inner_kernel
def between(slopes, layer, j, i, weights):
    """One of the slopes between four cells, by their weights in 1/FIXED²."""
    a, b, c, d = weights
    return (
        a * np.int64(slopes[layer, j, i])
        + b * np.int64(slopes[layer, j, i + 1])
        + c * np.int64(slopes[layer, j + 1, i])
        + d * np.int64(slopes[layer, j + 1, i + 1])
    ) >> 16


@lean_kernel
def paint_pond(pixels, clip, slopes, bed, zero, scale, cell, tones):
    """Fill what the pond covers. zero: px of its lower left corner; scale: px/m; tones: (4,) of `tones_of`.

    Two by two pixels have one light: water is smooth.
    """
    x_low, y_low, x_high, y_high = bounds_of(pixels, clip)
    ny, nx = slopes.shape[1], slopes.shape[2]
    per_cell = 1.0 / (scale * cell)
    through, dark, deep, light = tones
    for row in range(y_low, y_high, 2):
        v = (zero[1] - row - 1.0) * per_cell - 0.5
        if v < -0.5 or v > ny - 0.5:
            continue
        v = min(max(v, 0.0), ny - 1.001)
        j = int(v)
        up = int((v - j) * FIXED)
        y_bed = int((zero[1] - row) / scale * BED_SCALE * FIXED)
        for column in range(x_low, x_high, 2):
            u = (column + 1.0 - zero[0]) * per_cell - 0.5
            if u < -0.5 or u > nx - 0.5:
                continue
            u = min(max(u, 0.0), nx - 1.001)
            i = int(u)
            right = int((u - i) * FIXED)
            a, b = (FIXED - right) * (FIXED - up), right * (FIXED - up)
            c, d = (FIXED - right) * up, right * up
            weights = (a, b, c, d)
            sx = between(slopes, 0, j, i, weights)
            sy = between(slopes, 1, j, i, weights)
            curve = between(slopes, 2, j, i, weights)
            x_at = int((column - zero[0]) / scale * BED_SCALE * FIXED) + int(BEND * sx)
            stone = np.int64(bed[((y_bed + int(BEND * sy)) >> 8) & (TILE - 1), (x_at >> 8) & (TILE - 1)])
            # crests gather the light of the sun on the bed, troughs spread it
            lit = min(max(FIXED - (int(GATHER * curve) >> 3), 150), 350)
            sky = min(max((int(SHINE * (sy - sx)) >> 8) + 10, 0), 150)
            glint = min(max((sy - sx) - light, 0) >> 4, 60)
            red = ((stone >> 16 & 255) * lit * through >> 16) + ((deep >> 16 & 255) * dark >> 8)
            green = ((stone >> 8 & 255) * lit * through >> 16) + ((deep >> 8 & 255) * dark >> 8)
            blue = ((stone & 255) * lit * through >> 16) + ((deep & 255) * dark >> 8)
            red = min(max(red + (sky * 150 >> 8) + glint, 0), 255)
            green = min(max(green + (sky * 190 >> 8) + glint, 0), 255)
            blue = min(max(blue + (sky * 220 >> 8) + glint, 0), 255)
            ink = np.uint32(0xFF000000 | red << 16 | green << 8 | blue)
            last_row, last_column = min(row + 2, y_high), min(column + 2, x_high)
            for y in range(row, last_row):
                for x in range(column, last_column):
                    pixels[y, x] = ink


def tones_of(night: bool) -> Ints:
    """Share of the bed and of the deep (of 256), colour of the deep, slope that glints."""
    if night:
        return np.array((116, 190, 0x0C465E, 9000), np.int32)
    return np.array((150, 150, 0x1A7C9C, 9000), np.int32)


@lru_cache(maxsize=1)
def bed_picture() -> Inks:
    """(TILE, TILE) sand and pebbles that go on at the edges, each pixel the mean of four."""
    rng = np.random.default_rng(7)
    spectrum = np.fft.rfft2(rng.standard_normal((TILE, TILE)))
    y, x = np.fft.fftfreq(TILE)[:, None], np.fft.rfftfreq(TILE)[None, :]
    size = np.sqrt(x * x + y * y)
    sand = np.fft.irfft2(spectrum * np.exp(-((size * 3.0) ** 2)) / (0.01 + size), s=(TILE, TILE))
    sand /= np.abs(sand).max()
    colors: Floats = channels(0xC4AD82) * (1.0 + 0.22 * sand[..., None])
    colors = np.repeat(np.repeat(colors, 2, axis=0), 2, axis=1)
    for _ in range(PEBBLES):
        _lay_pebble(colors, rng)
    fine = colors.reshape(TILE, 2, TILE, 2, 3).mean(axis=(1, 3))
    return np.ascontiguousarray(opaque(fine))


def _lay_pebble(colors: Floats, rng: np.random.Generator) -> None:
    """One rounded pebble somewhere in a picture (n, n, 3), lit from the upper left."""
    side = len(colors)
    wide = rng.uniform(2.5, 9.0)
    tall = wide * rng.uniform(0.6, 0.95)
    turn, middle = rng.uniform(0.0, np.pi), rng.integers(0, side, 2)
    reach = np.arange(-10, 11)
    dy, dx = np.meshgrid(reach, reach, indexing="ij")
    a = (dx * np.cos(turn) + dy * np.sin(turn)) / wide
    b = (dy * np.cos(turn) - dx * np.sin(turn)) / tall
    high = 1.0 - a * a - b * b
    gray = channels(int(rng.choice((0x8F8A80, 0x6F7473, 0xA59A86, 0x7C6A58, 0xB8AA90))))
    shade = 0.66 + 0.42 * np.sqrt(np.maximum(high, 0.0)) - 0.04 * (dx + dy) / wide
    rows, columns = (middle[0] + dy) % side, (middle[1] + dx) % side
    inside = high > 0.0
    colors[rows[inside], columns[inside]] = (gray * shade[..., None])[inside]
