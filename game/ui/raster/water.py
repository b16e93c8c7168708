"""Still water: rows of a picture that mirror those above a shore, shaken by small waves."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.compiler.decorator import lean_kernel
from game.ui.raster.pixels import bounds_of

WAVE_PLACES = 1024  # in the table of waves, whose last meets its first; a power of two
WAVE_SIZE = 256


@lru_cache(maxsize=1)
def wave_table() -> NDArray[np.int32]:
    """(WAVE_PLACES,) heights of small waves, in 1/WAVE_SIZE of the highest."""
    turn = 2.0 * np.pi * np.arange(WAVE_PLACES) / WAVE_PLACES
    made = np.sin(5 * turn) + 0.7 * np.sin(13 * turn + 1.0) + 0.5 * np.sin(29 * turn + 2.0)
    made += 0.35 * np.sin(61 * turn + 0.5)
    return np.asarray(np.round(WAVE_SIZE * made / np.abs(made).max()), np.int32)


@lean_kernel
def mirror_rows(
    pixels: Any, clip: Any, shore: float, squeeze: float, waves: Any, time: float, near: int, share: float
) -> None:
    """Fill the clip below the row ``shore`` (px) with what stands above it, upside down.

    squeeze: rows above for one below. waves: `wave_table`; time: s. near: colour 0xRRGGBB of the water at the
    bottom, which takes over there; share: of the light that is mirrored at the shore.
    """
    x_low, y_low, x_high, y_high = bounds_of(pixels, clip)
    if not (-1e6 < shore < 1e6 and 0.0 < squeeze < 1e3 and -1e9 < time < 1e9):
        return
    first = max(y_low, int(max(math.ceil(shore), 0.0)))
    depth = max(y_high - shore, 1.0)
    for row in range(first, y_high):
        down = (row - shore) / depth
        height = 1.0 + 10.0 * down  # px, of the waves: near ones look high and long
        stride = int(256.0 * 4.0 / (1.0 + 6.0 * down))
        begin = int((time * (40.0 + 60.0 * down) + 160.0 * row) * 256.0) & 0x3FFFF
        weight = int(256.0 * share * (1.0 - 0.45 * down))
        own = 256 - weight
        own_red_blue, own_green = (near & 0xFF00FF) * own, (near & 0xFF00) * own
        middle = int(256.0 * (shore - (row - shore) * squeeze - 1.0))
        lift, sway = int(height * squeeze), int(0.6 * height * 256.0)
        still = (
            np.int64(waves[(begin // 85 + row * 31) & (WAVE_PLACES - 1)]) * int(0.75 * height * 256.0) >> 16
        )
        for column in range(x_low, x_high):
            wave = np.int64(waves[((begin + column * stride) >> 8) & (WAVE_PLACES - 1)])
            source = min(max((middle + wave * lift) >> 8, y_low), first - 1)
            beside = min(max(column + still + (wave * sway >> 16), x_low), x_high - 1)
            above = np.int64(pixels[source, beside]) if first > y_low else np.int64(near)
            red_blue = ((above & 0xFF00FF) * weight + own_red_blue) >> 8
            green = ((above & 0xFF00) * weight + own_green) >> 8
            pixels[row, column] = 0xFF000000 | (red_blue & 0xFF00FF) | (green & 0xFF00)
