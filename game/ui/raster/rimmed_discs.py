"""Very many discs with a rim, each in one pass: spans within are filled, and only the rim is blended."""

from __future__ import annotations

import math

import numpy as np

from game.compiler.decorator import kernel
from game.ui.raster.pixels import blend, clip_bounds, fill_row, is_drawable, weight_of

FULL = 256


@kernel
def draw_rimmed_discs(pixels, clip, points, radii, width, fill, rims):
    """Discs at ``points`` (n, 2) px of ``radii`` (n,) px, filled, with rims (n,) uint32 of a width (px)."""
    for i in range(radii.shape[0]):
        x, y, radius = points[i, 0], points[i, 1], radii[i]
        if not (is_drawable(x) and is_drawable(y) and 0.0 < radius < 1e9):
            continue
        draw_rimmed_disc(pixels, clip, x, y, radius, max(radius - width, 0.0), fill, np.int64(rims[i]))


@kernel
def draw_rimmed_disc(pixels, clip, x, y, radius, within, fill, rim):
    """One disc; ``within`` (px): radius of what is filled."""
    outer = radius + 0.5
    x_low, y_low, x_high, y_high = clip_bounds(pixels, clip, x - outer, y - outer, x + outer, y + outer)
    solid = max(within - 0.5, 0.0)
    for row in range(y_low, y_high):
        dy = row + 0.5 - y
        rest = outer * outer - dy * dy
        if rest <= 0.0:
            continue
        half = math.sqrt(rest)
        first = max(x_low, int(max(x - half - 0.5, -1.0)))
        last = min(x_high, int(min(x + half + 1.5, 1.0 * x_high)))
        inside = solid * solid - dy * dy
        left = right = last
        if inside > 0.0:
            reach = math.sqrt(inside)
            left = min(max(first, math.ceil(x - reach - 0.5)), last)
            right = min(max(left, math.floor(x + reach - 0.5) + 1), last)
            fill_row(pixels, row, left, right, fill, FULL)
        for column in range(first, left):
            draw_rim(pixels, row, column, column + 0.5 - x, dy, outer, within, fill, rim)
        for column in range(right, last):
            draw_rim(pixels, row, column, column + 0.5 - x, dy, outer, within, fill, rim)


@kernel
def draw_rim(pixels, row, column, dx, dy, outer, within, fill, rim):
    """One pixel at or near the rim: the rim by its coverage, and over it what is filled."""
    distance = math.sqrt(dx * dx + dy * dy)
    weight = weight_of(outer - distance, 1.0)
    if weight > 0:
        blend(pixels, row, column, rim, weight)
        over = weight_of(within + 0.5 - distance, 1.0)
        if over > 0:
            blend(pixels, row, column, fill, over)
