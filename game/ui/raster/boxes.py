"""Boxes upright on the screen: filled, outlined, with round corners, and the soft shadow under one."""

from __future__ import annotations

import math
from typing import Any

from game.compiler.decorator import inner_kernel, lean_kernel
from game.ui.raster.pixels import blend, clip_bounds, fill_row, is_drawable, weight_of


@inner_kernel
def _box_coverage(column: int, row: int, x0: float, y0: float, x1: float, y1: float, radius: float) -> float:
    """Share of a pixel inside a box with round corners: exact on straight sides, by distance in corners."""
    px, py = column + 0.5, row + 0.5
    corner_x = x0 + radius - px if px < x0 + radius else px - (x1 - radius)
    corner_y = y0 + radius - py if py < y0 + radius else py - (y1 - radius)
    if corner_x > 0.0 and corner_y > 0.0 and radius > 0.0:
        distance = math.sqrt(corner_x * corner_x + corner_y * corner_y)
        return min(1.0, max(0.0, radius + 0.5 - distance))
    across = min(column + 1.0, x1) - max(1.0 * column, x0)
    down = min(row + 1.0, y1) - max(1.0 * row, y0)
    return max(0.0, across) * max(0.0, down)


@inner_kernel
def _corner(radius: float, x0: float, y0: float, x1: float, y1: float) -> float:
    """Radius that a box's corners get: at most half the shorter side; below half a pixel they are sharp."""
    r = min(max(radius, 0.0), 0.5 * (x1 - x0), 0.5 * (y1 - y0)) if is_drawable(radius) else 0.0
    return r if r >= 0.5 else 0.0


@inner_kernel
def _is_box(x0: float, y0: float, x1: float, y1: float) -> bool:
    """Whether the corners are finite and in order."""
    return is_drawable(x0) and is_drawable(y0) and is_drawable(x1) and is_drawable(y1) and x0 < x1 and y0 < y1


@lean_kernel
def fill_box(
    pixels: Any,
    clip: Any,
    x0: float,
    y0: float,
    x1: float,
    y1: float,
    radius: float,
    color: int,
    alpha: float,
) -> None:
    """A filled box from (x0, y0) to (x1, y1) px; ``radius`` is cut to half the shorter side."""
    if not _is_box(x0, y0, x1, y1):
        return
    r = _corner(radius, x0, y0, x1, y1)
    x_low, y_low, x_high, y_high = clip_bounds(pixels, clip, x0, y0, x1, y1)
    full = weight_of(1.0, alpha)
    for row in range(y_low, y_high):
        inside = row >= y0 + r and row + 1.0 <= y1 - r
        left, right = (x0, x1) if inside else (x0 + r, x1 - r)
        whole = row >= y0 and row + 1.0 <= y1
        start = min(x_high, max(x_low, math.ceil(max(left, -1.0))))
        stop = max(start, min(x_high, math.floor(min(right, 1.0 * x_high)))) if whole else start
        for column in range(x_low, start):
            blend(pixels, row, column, color, weight_of(_box_coverage(column, row, x0, y0, x1, y1, r), alpha))
        fill_row(pixels, row, start, stop, color, full)
        for column in range(stop, x_high):
            blend(pixels, row, column, color, weight_of(_box_coverage(column, row, x0, y0, x1, y1, r), alpha))


@lean_kernel
def stroke_box(
    pixels: Any,
    clip: Any,
    x0: float,
    y0: float,
    x1: float,
    y1: float,
    radius: float,
    width: float,
    color: int,
    alpha: float,
) -> None:
    """The outline of a box, ``width`` px wide and wholly inside it."""  # fmt: skip
    if not _is_box(x0, y0, x1, y1) or not 0.0 < width < 1e9:
        return
    r = _corner(radius, x0, y0, x1, y1)
    inner = max(0.0, r - width)
    a, b, c, d = x0 + width, y0 + width, x1 - width, y1 - width
    hollow = c > a and d > b
    margin = max(r, width) + 1.0
    x_low, y_low, x_high, y_high = clip_bounds(pixels, clip, x0, y0, x1, y1)
    skip_from = int(min(max(x0 + margin, 1.0 * x_low), 1.0 * x_high))
    skip_to = int(min(max(x1 - margin, 1.0 * skip_from), 1.0 * x_high))
    for row in range(y_low, y_high):
        middle = hollow and row > y0 + width + 1.0 and row + 2.0 < y1 - width
        column = x_low
        while column < x_high:
            if middle and column == skip_from and skip_to > skip_from:
                column = skip_to
                if column >= x_high:
                    break
            share = _box_coverage(column, row, x0, y0, x1, y1, r)
            if hollow:
                share -= _box_coverage(column, row, a, b, c, d, inner)
            weight = weight_of(share, alpha)
            if weight > 0:
                blend(pixels, row, column, color, weight)
            column += 1


@lean_kernel
def fill_shadow(
    pixels: Any,
    clip: Any,
    x0: float,
    y0: float,
    x1: float,
    y1: float,
    radius: float,
    blur: float,
    color: int,
    alpha: float,
) -> None:
    """The blurred shade of a box: half strength on its edge, gone ``blur`` px outside."""  # fmt: skip
    if not _is_box(x0, y0, x1, y1):
        return
    if not 0.5 < blur < 1e9:
        fill_box(pixels, clip, x0, y0, x1, y1, radius, color, alpha)
        return
    r = min(max(radius, blur, 0.0), 0.5 * (x1 - x0), 0.5 * (y1 - y0)) if is_drawable(radius) else 0.0
    mx, my, half_x, half_y = 0.5 * (x0 + x1), 0.5 * (y0 + y1), 0.5 * (x1 - x0) - r, 0.5 * (y1 - y0) - r
    x_low, y_low, x_high, y_high = clip_bounds(pixels, clip, x0 - blur, y0 - blur, x1 + blur, y1 + blur)
    for row in range(y_low, y_high):
        qy = abs(row + 0.5 - my) - half_y
        for column in range(x_low, x_high):
            qx = abs(column + 0.5 - mx) - half_x
            ox, oy = max(qx, 0.0), max(qy, 0.0)
            distance = math.sqrt(ox * ox + oy * oy) + min(max(qx, qy), 0.0) - r
            t = min(1.0, max(0.0, 0.5 - 0.5 * distance / blur))
            weight = weight_of(t * t * (3.0 - 2.0 * t), alpha)
            if weight > 0:
                blend(pixels, row, column, color, weight)
