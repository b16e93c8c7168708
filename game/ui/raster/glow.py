"""Additive light: very many small lights, large soft ones, and the bloom about all of them.

Small lights are stamps laid at eighths of a pixel. Bloom is a picture of a quarter of the size: what shines
is added there as well, blurred by an exponential filter forwards and backwards (Alvarez and Mazorra 1994:
peaked, with long tails, as the halo about a bright light is), and added to the picture, smooth and dithered.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import inner_kernel, lean_kernel
from game.ui.raster.additions import add_between, add_four
from game.ui.raster.pixels import bounds_of, is_drawable

SUBPIXELS = 8  # a stamp is kept for each eighth of a pixel both ways
LARGEST = 7.5  # px, radius of the largest stamp
CELL = 4  # px, side of a cell of the bloom
STEPS = 32.0  # of a cell's light to one of a pixel's
CHANNELS = 4  # blue, green, red and none
BRIGHTEST = 255.0


class Stamps(NamedTuple):
    """Small lights of some radii. weights: flat uint16, each stamp by eighth down, eighth across, row,
    column, channel."""

    weights: NDArray[np.uint16]
    first: NDArray[np.int64]  # (sizes,) of each stamp in the weights
    side: NDArray[np.int64]  # (sizes,) px


@lru_cache(maxsize=16)
def stamps_of(radii: tuple[float, ...]) -> Stamps:
    """Lights of these radii (px, to LARGEST) fading as (1 - r²/R²)² to their rim. ValueError for others."""
    parts, first, sides, total = [], [], [], 0
    eighths = (np.arange(SUBPIXELS) + 0.5) / SUBPIXELS
    for radius in radii:
        if not 0.0 < radius <= LARGEST:
            raise ValueError(f"glow: radius {radius!r} px is not between 0 and {LARGEST}")
        side = 4 * math.ceil((2.0 * radius - 0.25) / 4.0)
        reach = max(radius, 0.75)
        along = np.arange(side) - 0.5 * side + 1.0 - eighths[:, None]
        squared = along[:, None, :, None] ** 2 + along[None, :, None, :] ** 2
        shape = np.maximum(1.0 - squared / reach**2, 0.0) ** 2 * min(radius / 0.75, 1.0) ** 2
        first.append(total)
        sides.append(side)
        parts.append(np.repeat(np.round(256.0 * shape).reshape(-1), CHANNELS).astype(np.uint16))
        total += len(parts[-1])
    return Stamps(np.concatenate(parts), np.array(first), np.array(sides))


@inner_kernel
def _add_cut(
    pixels: Any, bounds: Any, column: int, row: int, weights: Any, first: int, side: int, color: int
) -> None:
    """Add what lies inside the bounds of a stamp whose corner is at a column and row."""
    x_low, y_low, x_high, y_high = bounds
    for j in range(max(0, y_low - row), min(side, y_high - row)):
        for i in range(max(0, x_low - column), min(side, x_high - column)):
            weight = np.int64(weights[first + CHANNELS * (j * side + i)])
            below: Any = np.int64(pixels[row + j, column + i])
            red = min(((below >> 16) & 255) + ((((color >> 16) & 255) * weight) >> 8), 255)
            green = min(((below >> 8) & 255) + ((((color >> 8) & 255) * weight) >> 8), 255)
            blue = min((below & 255) + (((color & 255) * weight) >> 8), 255)
            pixels[row + j, column + i] = (below & 0xFF000000) | (red << 16) | (green << 8) | blue


@lean_kernel
def add_lights(
    pixels: Any,
    flat: Any,
    clip: Any,
    points: Any,
    colors: Any,
    sizes: Any,
    weights: Any,
    first: Any,
    side: Any,
) -> None:
    """Add small lights: ``points`` (n, 2) px, ``colors`` (n,) uint32 already as strong as they are to be,
    ``sizes`` (n,) uint8 numbers of stamps. ``flat`` is ``pixels.reshape(-1)``; the last three are `Stamps`.
    """  # fmt: skip
    width = pixels.shape[1]
    x_low, y_low, x_high, y_high = bounds_of(pixels, clip)
    bounds = (x_low, y_low, x_high, y_high)
    for n in range(min(points.shape[0], colors.shape[0], sizes.shape[0])):
        color: Any = np.int64(colors[n]) & 0xFFFFFF
        size = np.int64(sizes[n])
        if color == 0 or size >= side.shape[0]:
            continue
        length = side[size]
        left = points[n, 0] - 0.5 * length + 0.5
        top = points[n, 1] - 0.5 * length + 0.5
        if not (x_low - length < left < x_high and y_low - length < top < y_high):
            continue
        column, row = math.floor(left), math.floor(top)
        across = min(SUBPIXELS - 1, int((left - column) * SUBPIXELS))
        down = min(SUBPIXELS - 1, int((top - row) * SUBPIXELS))
        at = first[size] + (down * SUBPIXELS + across) * length * length * CHANNELS
        if x_low <= column and column + length <= x_high and y_low <= row and row + length <= y_high:
            place = row * width + column
            for j in range(length):
                for i in range(0, length, 4):
                    add_four(flat, place + j * width + i, weights, at + CHANNELS * (j * length + i), color)
        else:
            _add_cut(pixels, bounds, column, row, weights, at, length, color)


@lean_kernel
def gather_lights(light: Any, left: float, top: float, points: Any, colors: Any, shares: Any) -> None:
    """Add lights to the bloom's cells ``light`` (rows, 4 columns) float32, each times its share (n,)."""
    rows, columns = light.shape[0], light.shape[1] // CHANNELS
    for n in range(min(points.shape[0], colors.shape[0], shares.shape[0])):
        x = (points[n, 0] - left) / CELL + 0.5
        y = (points[n, 1] - top) / CELL + 0.5
        if not (0.0 <= x < columns and 0.0 <= y < rows):
            continue
        color, share = np.int64(colors[n]), np.float32(shares[n])
        row, at = int(y), CHANNELS * int(x)
        light[row, at] += share * np.float32(color & 255)
        light[row, at + 1] += share * np.float32((color >> 8) & 255)
        light[row, at + 2] += share * np.float32((color >> 16) & 255)


@lean_kernel
def gather_glows(
    light: Any, left: float, top: float, points: Any, radii: Any, colors: Any, shares: Any
) -> None:
    """Add large soft lights of ``radii`` (n,) px to the cells, fading as (1 - r²/R²)² to their rim."""
    rows, columns = light.shape[0], light.shape[1] // CHANNELS
    for n in range(min(points.shape[0], radii.shape[0], colors.shape[0], shares.shape[0])):
        if not (is_drawable(points[n, 0]) and is_drawable(points[n, 1]) and 0.0 < radii[n] < 1e5):
            continue
        x, y = (points[n, 0] - left) / CELL, (points[n, 1] - top) / CELL
        reach = max(radii[n] / CELL, 0.8)
        color, share = np.int64(colors[n]), np.float32(shares[n])
        blue = share * np.float32(color & 255)
        green = share * np.float32((color >> 8) & 255)
        red = share * np.float32((color >> 16) & 255)
        inverse = np.float32(1.0 / (reach * reach))
        for j in range(max(0, math.ceil(y - reach)), min(rows, math.floor(y + reach) + 1)):
            half = math.sqrt(max(reach * reach - (j - y) * (j - y), 0.0))
            begin, end = max(0, math.ceil(x - half)), min(columns, math.floor(x + half) + 1)
            across = np.float32(begin - x)
            most = np.float32(1.0) - np.float32((j - y) * (j - y)) * inverse
            for at in range(CHANNELS * begin, CHANNELS * end, CHANNELS):
                rest = max(most - across * across * inverse, np.float32(0.0))
                weight = rest * rest
                light[j, at] += weight * blue
                light[j, at + 1] += weight * green
                light[j, at + 2] += weight * red
                light[j, at + 3] += weight * np.float32(0.0)
                across += np.float32(1.0)


@lean_kernel
def blur_light(light: Any, keep: float) -> None:
    """Blur in place, each cell takes 1 - keep of itself and keep of the one before, both ways."""
    rows, length = light.shape[0], light.shape[1]
    held, taken = np.float32(keep), np.float32(1.0 - keep)
    for j in range(rows):
        line = light[j]
        for k in range(CHANNELS, length):
            line[k] = taken * line[k] + held * line[k - CHANNELS]
        for k in range(length - CHANNELS - 1, -1, -1):
            line[k] = taken * line[k] + held * line[k + CHANNELS]
    for j in range(1, rows):
        line, before = light[j], light[j - 1]
        for k in range(length):
            line[k] = taken * line[k] + held * before[k]
    for j in range(rows - 2, -1, -1):
        line, before = light[j], light[j + 1]
        for k in range(length):
            line[k] = taken * line[k] + held * before[k]


@lean_kernel
def add_bloom(pixels: Any, flat: Any, clip: Any, light: Any, strength: float, line: Any, grain: Any) -> None:
    """Add the light of the cells to the picture's clip, and leave the cells dark.

    ``line``: (4 columns,) uint16 of working memory; ``grain`` (64,) uint16: four rows of dithering.
    """
    x_low, y_low, x_high, y_high = bounds_of(pixels, clip)
    width, length, rows = pixels.shape[1], light.shape[1], light.shape[0]
    scale = np.float32(strength * STEPS)
    most = np.float32(BRIGHTEST * STEPS)
    whole = min((x_high - x_low) // CELL, length // CHANNELS - 1)
    for row in range(y_low, y_high):
        upper = min((row - y_low) // CELL, rows - 2)
        below = np.float32(min((row - y_low + 0.5) / CELL - upper, 1.0)) * scale
        above = scale - below
        first_line, second_line = light[upper], light[upper + 1]
        for k in range(length):
            line[k] = np.uint16(np.int32(min(above * first_line[k] + below * second_line[k], most)))
        first = 16 * (row & 3)
        for cell in range(whole):
            at = CHANNELS * cell
            here = line[at] | line[at + 1] | line[at + 2] | line[at + 4] | line[at + 5] | line[at + 6]
            if here > 0:
                add_between(flat, row * width + x_low + CELL * cell, line, cell, grain, first)
        for column in range(x_low + CELL * whole, x_high):
            _add_edge(pixels, row, column, line, whole)
    light[:] = np.float32(0.0)


@inner_kernel
def _add_edge(pixels: Any, row: int, column: int, line: Any, cell: int) -> None:
    """Add a cell's light to one pixel beside the last whole cell."""
    below: Any = np.int64(pixels[row, column])
    blue = min((below & 255) + (np.int64(line[CHANNELS * cell]) >> 5), 255)
    green = min(((below >> 8) & 255) + (np.int64(line[CHANNELS * cell + 1]) >> 5), 255)
    red = min(((below >> 16) & 255) + (np.int64(line[CHANNELS * cell + 2]) >> 5), 255)
    pixels[row, column] = (below & 0xFF000000) | (red << 16) | (green << 8) | blue


def dither_grain() -> NDArray[np.uint16]:
    """Four rows of four pixels' rounding (0 to 255) by Bayer's ordered pattern (1973), for all channels."""
    order = np.array(((0, 8, 2, 10), (12, 4, 14, 6), (3, 11, 1, 9), (15, 7, 13, 5)))
    return np.repeat((16 * order + 8).reshape(-1), CHANNELS).astype(np.uint16)


class Bloom:
    """The light about what shines: cells for a picture of any size, used again each frame."""

    def __init__(self) -> None:
        self.light = np.zeros((2, 2 * CHANNELS), np.float32)
        self._line = np.zeros(2 * CHANNELS, np.uint16)
        self._grain = dither_grain()

    def fit(self, width: int, height: int) -> None:
        """Have cells for so many px; dark if they were for another size."""
        shape = (height // CELL + 2, (width // CELL + 2) * CHANNELS)
        if self.light.shape != shape:
            self.light = np.zeros(shape, np.float32)
            self._line = np.zeros(shape[1], np.uint16)

    def shine(self, pixels: np.ndarray, clip: np.ndarray, strength: float, keep: float) -> None:
        """Blur what was gathered and add it to the picture; the cells are dark again."""
        blur_light(self.light, keep)
        add_bloom(pixels, pixels.reshape(-1), clip, self.light, strength, self._line, self._grain)
