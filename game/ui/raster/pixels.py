"""One pixel of a picture, and a piece of a row: how a colour is laid over them.

A pixel is 0xAARRGGBB in a uint32. A weight of 256 replaces it, 0 leaves it. All four channels are mixed, the
colour counting as opaque: on a surface without alpha the top byte is ignored; on one with alpha that starts
at zero the result is premultiplied.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from game.compiler.decorator import inner_kernel, lean_kernel
from game.ui.raster.vectors import mix_four

FARTHEST = 1.0e9  # px; beyond this a coordinate has lost its subpixels and nothing is drawn
OPAQUE = 0xFF000000
FULL = 256  # the weight that replaces a pixel


@inner_kernel
def is_drawable(value: float) -> bool:
    """Whether a coordinate or length is finite and near enough to draw with."""
    return -FARTHEST <= value <= FARTHEST


@lean_kernel
def blend(pixels: Any, row: int, column: int, color: int, weight: int) -> None:
    """Lay a colour over one pixel with ``weight`` 0 to 256."""
    below = np.int64(pixels[row, column])
    keep = FULL - weight
    red_blue = ((color & 0xFF00FF) * weight + (below & 0xFF00FF) * keep + 0x800080) >> 8
    over = ((color >> 8) & 0xFF00FF) | 0xFF0000
    alpha_green = over * weight + ((below >> 8) & 0xFF00FF) * keep + 0x800080
    pixels[row, column] = (red_blue & 0xFF00FF) | (alpha_green & 0xFF00FF00)


@lean_kernel
def fill_row(pixels: Any, row: int, start: int, stop: int, color: int, weight: int) -> None:
    """Lay a colour over the pixels ``start`` to ``stop`` - 1 of a row with one weight."""
    if weight >= FULL:
        solid, goal = np.uint32((color & 0xFFFFFF) | OPAQUE), pixels[row, start : max(start, stop)]
        for k in range(goal.size):  # counted in a loop of its own, so that pixels come in vectors
            goal[k] = solid
    elif weight > 0:
        column, begin = start, row * pixels.shape[1]
        while column + 4 <= stop:
            mix_four(pixels, begin + column, color | OPAQUE, weight)
            column += 4
        while column < stop:
            blend(pixels, row, column, color, weight)
            column += 1


@inner_kernel
def weight_of(coverage: float, alpha: float) -> int:
    """Blending weight 0 to 256 of a covered share of a pixel; nan counts as nothing."""
    share = coverage * alpha
    if not share > 0.0:
        return 0
    return int(min(share, 1.0) * 256.0 + 0.5)


@inner_kernel
def lay(pixels: Any, row: int, column: int, color: int, share: float) -> None:
    """Lay a colour over a share 0 to 1 of one pixel; more counts as 1, less and nan as 0."""
    weight = weight_of(share, 1.0)
    if weight > 0:
        blend(pixels, row, column, color, weight)


@inner_kernel
def strip_coverage(distance: float, half: float) -> float:
    """Share of a one-pixel window ``distance`` from the middle of a strip that the strip covers.

    Exact along the axis across the strip: thin lines fade, they do not break up.
    """
    return max(0.0, min(half, distance + 0.5) - max(-half, distance - 0.5))


@inner_kernel
def bounds_of(pixels: Any, clip: Any) -> Any:
    """The clip cut to the picture, as four integers."""
    return max(0, clip[0]), max(0, clip[1]), min(pixels.shape[1], clip[2]), min(pixels.shape[0], clip[3])


@inner_kernel
def clip_bounds(pixels: Any, clip: Any, left: float, top: float, right: float, bottom: float) -> Any:
    """Pixels that a box touches inside the clip: first column and row, past-the-last column and row."""
    x_low = max(0, clip[0], math.floor(max(left, -1.0)))
    y_low = max(0, clip[1], math.floor(max(top, -1.0)))
    x_high = min(pixels.shape[1], clip[2], math.ceil(min(right, 1.0 * pixels.shape[1])))
    y_high = min(pixels.shape[0], clip[3], math.ceil(min(bottom, 1.0 * pixels.shape[0])))
    return x_low, y_low, x_high, y_high
