"""Pixels of a body of water and of the bed below it, seen from the side."""

from __future__ import annotations

import math

import numpy as np

from game.arrays import Floats
from game.compiler.decorator import lean_kernel
from game.ui.raster.pixels import blend, bounds_of

SHADES = 64  # colours from the surface downwards
SEEN, FOAM = 0.86, 0.9  # share of the water's own colour over what is behind it; of foam at its whitest
SKIN = 2.6  # px of light at the surface


@lean_kernel
def paint_water(pixels, clip, surface, floor, foam, shades, sand, reach):
    """Paint columns of water and of bed. surface, floor: (w,) px down; foam: (w,) 0 to 1.

    shades: (SHADES,) colours of water from its surface to ``reach`` px below; sand: (SHADES,) of the bed.
    """
    x_low, y_low, x_high, y_high = bounds_of(pixels, clip)
    for column in range(x_low, x_high):
        k = column - clip[0]
        top, bottom, white = surface[k], floor[k], foam[k]
        first = min(max(math.floor(top), y_low), y_high)
        last = min(max(math.floor(bottom), y_low), y_high)
        for row in range(first, min(last + 1, y_high)):
            inside = min(row + 1.0 - top, 1.0) * min(max(bottom - row, 0.0), 1.0)
            if inside <= 0.0:
                continue
            down = row + 0.5 - top
            shade = int(shades[min(int(max(down, 0.0) * SHADES / reach), SHADES - 1)])
            blend(pixels, row, column, shade, int(256.0 * inside * SEEN))
            light = max(1.0 - down / SKIN, 0.0) * 0.7
            light = max(light, white * FOAM * max(1.0 - down / (6.0 + 26.0 * white), 0.0))
            if light > 0.0:
                blend(pixels, row, column, 0xF4FBFF, int(256.0 * inside * light))
        for row in range(last, y_high):
            inside = min(row + 1.0 - bottom, 1.0)
            if inside > 0.0:
                shade = int(sand[min(int(max(row - bottom, 0.0) * SHADES / reach), SHADES - 1)])
                blend(pixels, row, column, shade, int(256.0 * inside))


def columns_of(values: Floats, x: Floats, width: int, left: float, right: float) -> Floats:
    """Values of cells (n,) at places x as (width,) columns of a picture from left to right."""
    return np.asarray(np.interp(left + (np.arange(width) + 0.5) * ((right - left) / width), x, values))
