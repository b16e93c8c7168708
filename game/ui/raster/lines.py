"""Single straight lines of any width, with round or square ends, and the geometry of their rows."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from game.compiler.decorator import inner_kernel, lean_kernel
from game.ui.raster.pixels import blend, bounds_of, is_drawable, strip_coverage, weight_of

ROUND = 1  # line ends: a half disc, or (0) cut square
BUTT = 0
FADING = 0.501  # px beyond a strip's edge where a pixel's middle may lie that it still touches


@inner_kernel
def inside_share(clip: Any, x0: float, y0: float, x1: float, y1: float, margin: float) -> Any:
    """Part (first, last) of a segment, as shares 0 to 1, within the clip widened by ``margin``; else (1, 0).

    Liang and Barsky (1984).
    """
    first, last = 0.0, 1.0
    dx, dy = x1 - x0, y1 - y0
    for side in range(4):
        if side == 0:
            direction, space = -dx, x0 - (clip[0] - margin)
        elif side == 1:
            direction, space = dx, (clip[2] + margin) - x0
        elif side == 2:
            direction, space = -dy, y0 - (clip[1] - margin)
        else:
            direction, space = dy, (clip[3] + margin) - y0
        if direction == 0.0:
            if space < 0.0:
                return 1.0, 0.0
        elif direction < 0.0:
            first = max(first, space / direction)
        else:
            last = min(last, space / direction)
    return first, last


@inner_kernel
def lean_of(x0: float, y0: float, x1: float, y1: float, reach: float) -> Any:
    """Columns that a segment moves in one row, and half the breadth of its band of ``reach`` along a row."""
    dx, dy = x1 - x0, y1 - y0
    if abs(dy) <= 1e-9 * abs(dx) or dx * dx + dy * dy == 0.0:
        return 0.0, abs(dx) + reach
    return dx / dy, reach * math.sqrt(dx * dx + dy * dy) / abs(dy)


@inner_kernel
def row_span(
    middle: float, x0: float, y0: float, x1: float, y1: float, reach: float, lean: float, slack: float
) -> Any:
    """Columns (first, last) that a segment widened by ``reach`` may touch in the row with this middle."""
    if lean == 0.0:
        return min(x0, x1) - reach, max(x0, x1) + reach
    low, high = min(y0, y1), max(y0, y1)
    xa = x0 + (min(high, max(low, middle - reach)) - y0) * lean
    xb = x0 + (min(high, max(low, middle + reach)) - y0) * lean
    across = x0 + (middle - y0) * lean
    return max(min(xa, xb) - reach, across - slack), min(max(xa, xb) + reach, across + slack)


@inner_kernel
def segment_coverage(
    px: float, py: float, x0: float, y0: float, ux: float, uy: float, length: float, half: float, ends: int
) -> float:
    """Share of the pixel with middle (px, py) under a segment from (x0, y0) along the unit (ux, uy)."""
    along = (px - x0) * ux + (py - y0) * uy
    across = (py - y0) * ux - (px - x0) * uy
    if ends == ROUND:
        beyond = max(0.0, max(-along, along - length))
        if beyond > 0.0:
            return strip_coverage(math.sqrt(across * across + beyond * beyond), half)
        return strip_coverage(across, half)
    inside = min(length, along + 0.5) - max(0.0, along - 0.5)
    if inside <= 0.0:
        return 0.0
    return strip_coverage(across, half) * inside


@inner_kernel
def column_within(x: float, low: int, high: int) -> int:
    """A finite abscissa as a column between ``low`` and ``high``."""
    return int(min(max(x, 1.0 * low), 1.0 * high))


@lean_kernel
def stroke_segment(
    pixels: Any,
    clip: Any,
    x0: float,
    y0: float,
    x1: float,
    y1: float,
    width: float,
    ends: int,
    color: int,
    alpha: float,
) -> None:
    """One straight line with round (1) or square (0) ends; a point with round ends is a disc."""  # fmt: skip
    if not (is_drawable(x0) and is_drawable(y0) and is_drawable(x1) and is_drawable(y1)):
        return
    if not 0.0 < width < 1e9:
        return
    half = 0.5 * width
    reach = half + FADING
    first, last = inside_share(clip, x0, y0, x1, y1, reach + 1.0)
    if first > last:
        return
    dx, dy = x1 - x0, y1 - y0
    length = math.sqrt(dx * dx + dy * dy)
    ux, uy = (dx / length, dy / length) if length > 0.0 else (1.0, 0.0)
    ax, ay, bx, by = x0 + first * dx, y0 + first * dy, x0 + last * dx, y0 + last * dy
    x_low, y_low, x_high, y_high = bounds_of(pixels, clip)
    top, bottom = (
        column_within(min(ay, by) - reach, y_low, y_high),
        column_within(max(ay, by) + reach + 1.0, y_low, y_high),
    )
    lean, slack = lean_of(ax, ay, bx, by, reach)
    for row in range(top, bottom):
        left, right = row_span(row + 0.5, ax, ay, bx, by, reach, lean, slack)
        for column in range(
            column_within(left + 0.5, x_low, x_high), column_within(right + 0.5, x_low, x_high)
        ):
            share = segment_coverage(column + 0.5, row + 0.5, x0, y0, ux, uy, length, half, ends)
            weight = weight_of(share, alpha)
            if weight > 0:
                blend(pixels, row, column, color, weight)


@lean_kernel
def stroke_segments(
    pixels: Any, clip: Any, segments: Any, width: float, ends: int, colors: Any, alpha: float
) -> None:
    """Many single lines: ``segments`` (n, 4) px as x0, y0, x1, y1, ``colors`` (n,) uint32."""
    for i in range(min(segments.shape[0], colors.shape[0])):
        stroke_segment(
            pixels, clip, segments[i, 0], segments[i, 1], segments[i, 2], segments[i, 3], width, ends,
            np.int64(colors[i]), alpha,
        )  # fmt: skip
