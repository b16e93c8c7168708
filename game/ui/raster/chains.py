"""Chains of straight lines and dashes, never blended twice with themselves.

A chain is first covered: the larger coverage wins where two segments overlap. Then it is laid over the
picture in one go, and the cover wiped. So a transparent line has no darker joins or crossings.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from game.compiler.decorator import inner_kernel, lean_kernel
from game.ui.raster.lines import (
    BUTT,
    FADING,
    ROUND,
    column_within,
    inside_share,
    lean_of,
    row_span,
    segment_coverage,
)
from game.ui.raster.pixels import blend, bounds_of, is_drawable, weight_of

SHORTEST_DASH = 0.5  # px; a finer pattern is drawn as a paler solid line


@inner_kernel
def _cover_segment(
    cover: Any, pixels: Any, clip: Any, x0: float, y0: float, x1: float, y1: float, half: float, ends: int
) -> None:
    """Raise ``cover`` (h, w) uint8 to a segment's coverage where that is more."""
    if not (is_drawable(x0) and is_drawable(y0) and is_drawable(x1) and is_drawable(y1)):
        return
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
            amount = int(share * 255.0 + 0.5)
            if amount > cover[row, column]:
                cover[row, column] = amount


@inner_kernel
def _lay_cover(
    cover: Any, pixels: Any, clip: Any, segment: Any, half: float, color: int, weight: int
) -> None:
    """Lay what ``cover`` holds along a segment (x0, y0, x1, y1 px) over the picture, and wipe it."""
    x0, y0, x1, y1 = segment
    if not (is_drawable(x0) and is_drawable(y0) and is_drawable(x1) and is_drawable(y1)):
        return
    reach = half + FADING
    first, last = inside_share(clip, x0, y0, x1, y1, reach + 1.0)
    if first > last:
        return
    dx, dy = x1 - x0, y1 - y0
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
            amount = np.int64(cover[row, column])
            if amount > 0:
                blend(pixels, row, column, color, (amount * weight + 127) // 255)
                cover[row, column] = 0


@lean_kernel
def stroke_polyline(
    pixels: Any, clip: Any, cover: Any, points: Any, width: float, closed: bool, color: int, alpha: float
) -> None:
    """A chain of lines through ``points`` (n, 2) px with round joins and ends, blended once.

    ``cover`` is the scratch of ``scratch_for``, all zero before and after. Points that are not finite, or
    farther than 10^9 px, break the chain.
    """
    count = points.shape[0]
    if count == 0 or not 0.0 < width < 1e9:
        return
    half = 0.5 * width
    weight = weight_of(1.0, alpha)
    links = count if closed and count > 2 else max(1, count - 1)
    for phase in range(2):
        for i in range(links):
            j = (i + 1) % count
            x0, y0, x1, y1 = points[i, 0], points[i, 1], points[j, 0], points[j, 1]
            if phase == 0:
                _cover_segment(cover, pixels, clip, x0, y0, x1, y1, half, np.int64(ROUND))
            else:
                _lay_cover(cover, pixels, clip, (x0, y0, x1, y1), half, color, weight)


@inner_kernel
def _cover_dashes(
    cover: Any,
    pixels: Any,
    clip: Any,
    segment: Any,
    half: float,
    travelled: float,
    dash: float,
    period: float,
) -> None:
    """Cover the dashes on one segment (x0, y0, x1, y1 px), which starts ``travelled`` px into the pattern."""
    x0, y0, x1, y1 = segment
    dx, dy = x1 - x0, y1 - y0
    length = math.sqrt(dx * dx + dy * dy)
    first, last = inside_share(clip, x0, y0, x1, y1, half + 2.0)
    if first > last or length == 0.0:
        return
    ux, uy = dx / length, dy / length
    begin, end = travelled + first * length, travelled + last * length
    number = math.floor(begin / period)
    for i in range(int((end - begin) / period) + 2):
        start = max(begin, (number + i) * period)
        stop = min(end, (number + i) * period + dash)
        if stop > start:
            a, b = start - travelled, stop - travelled
            _cover_segment(
                cover, pixels, clip, x0 + a * ux, y0 + a * uy, x0 + b * ux, y0 + b * uy, half, np.int64(BUTT)
            )


@lean_kernel
def stroke_dashes(
    pixels: Any,
    clip: Any,
    cover: Any,
    points: Any,
    width: float,
    closed: bool,
    dash: float,
    gap: float,
    offset: float,
    color: int,
    alpha: float,
) -> None:
    """A dashed chain: ``dash`` px drawn and ``gap`` px not, from ``offset`` px into the pattern.

    The pattern runs on round corners. Dashes have square ends. Without a gap, or with a pattern finer than
    half a pixel, the line is solid (and as much paler). Else as ``stroke_polyline``.
    """  # fmt: skip
    count = points.shape[0]
    if count < 2 or not 0.0 < width < 1e9 or not 0.0 < dash < 1e9 or not is_drawable(offset):
        return
    period = dash + max(gap, 0.0) if is_drawable(gap) else dash
    if period <= dash or period < SHORTEST_DASH:
        stroke_polyline(pixels, clip, cover, points, width, closed, color, alpha * dash / period)
        return
    half = 0.5 * width
    weight = weight_of(1.0, alpha)
    links = count if closed and count > 2 else count - 1
    for phase in range(2):
        travelled = offset
        for i in range(links):
            j = (i + 1) % count
            x0, y0, x1, y1 = points[i, 0], points[i, 1], points[j, 0], points[j, 1]
            if not (is_drawable(x0) and is_drawable(y0) and is_drawable(x1) and is_drawable(y1)):
                continue
            if phase == 0:
                _cover_dashes(cover, pixels, clip, (x0, y0, x1, y1), half, travelled, dash, period)
                travelled += math.sqrt((x1 - x0) * (x1 - x0) + (y1 - y0) * (y1 - y0))
            else:
                _lay_cover(cover, pixels, clip, (x0, y0, x1, y1), half, color, weight)
