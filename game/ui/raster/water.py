"""Still water: rows of a picture that mirror those above a shore, shaken by small waves."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.physics.kernels.lean import lean_kernel
from game.ui.raster.pixels import bounds_of

WAVE_PLACES = 1024  # in the table of waves, whose last meets its first


@lru_cache(maxsize=1)
def wave_table() -> NDArray[np.float64]:
    """(WAVE_PLACES,) heights of small waves, -1 to 1."""
    turn = 2.0 * np.pi * np.arange(WAVE_PLACES) / WAVE_PLACES
    made = np.sin(5 * turn) + 0.7 * np.sin(13 * turn + 1.0) + 0.5 * np.sin(29 * turn + 2.0)
    made += 0.35 * np.sin(61 * turn + 0.5)
    return np.asarray(made / np.abs(made).max())


@lean_kernel
def mirror_rows(
    pixels: Any, clip: Any, shore: float, squeeze: float, waves: Any, time: float, near: int, share: float
) -> None:
    """Fill the clip below the row ``shore`` (px) with what stands above it, upside down.

    squeeze: rows above for one below. waves: `wave_table`; time: s. near: colour 0xRRGGBB of the water at the
    bottom, which takes over there; share: of the light that is mirrored at the shore.
    """
    x_low, y_low, x_high, y_high = bounds_of(pixels, clip)
    if not -1e6 < shore < 1e6:
        return
    first = max(y_low, int(max(math.ceil(shore), 0.0)))
    places = waves.shape[0]
    depth = max(y_high - shore, 1.0)
    for row in range(first, y_high):
        down = (row - shore) / depth
        drift = int(time * (40.0 + 60.0 * down) + 7919.0 * row * 0.013)
        along = 16.0 / (1.0 + 6.0 * down)  # far waves look short
        size = 1.0 + 10.0 * down
        weight = int(256.0 * share * (1.0 - 0.45 * down))
        own = 256 - weight
        middle = shore - (row - shore) * squeeze - 1.0
        sway = waves[(drift * 3 + row * 31) % places] * 2.5 * size * 0.3
        for column in range(x_low, x_high):
            wave = waves[int(column * along * 0.25 + drift + row * 57) % places]
            source = min(max(int(middle + wave * size * squeeze), y_low), first - 1)
            beside = min(max(column + int(sway + 0.6 * size * wave), x_low), x_high - 1)
            above = np.int64(pixels[source, beside]) if first > y_low else np.int64(near)
            red_blue = ((above & 0xFF00FF) * weight + (near & 0xFF00FF) * own) >> 8
            green = ((above & 0xFF00) * weight + (near & 0xFF00) * own) >> 8
            pixels[row, column] = 0xFF000000 | (red_blue & 0xFF00FF) | (green & 0xFF00)
