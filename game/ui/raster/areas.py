"""Filled polygons and arrows with exact coverage; the ground under a curve.

Each edge adds the area it cuts off, row by row, to ``area``. Summing a row from the left gives every pixel's
covered share, as in FreeType's smooth rasteriser (Levoy 1990; Raph Levien's font-rs, 2016).
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from game.compiler.decorator import inner_kernel, lean_kernel
from game.ui.raster.pixels import blend, fill_row, is_drawable, weight_of
from game.ui.raster.vectors import is_blank

LEVEL = 1e-12  # px; an edge less high has no area beside it
HEAD_LENGTH = 3.2  # widths of the shaft from an arrow's point to the shaft
HEAD_HALF = 1.6  # widths: half of the head's greatest breadth


@inner_kernel
def _widen(extent: Any, row: int, first: int, last: int) -> None:
    """Remember that a row is touched from column ``first`` to ``last``."""
    if first < extent[row, 0]:
        extent[row, 0] = first
    if last > extent[row, 1]:
        extent[row, 1] = last


@inner_kernel
def _cut_row(area: Any, extent: Any, row: int, x0: float, x1: float, height: float) -> None:
    """Add an edge piece within one row, x0 <= x1 in columns, of signed ``height``."""
    first = math.floor(x0)
    last = math.ceil(x1)
    if last <= first + 1:
        right = height * (0.5 * (x0 + x1) - first)
        area[row, first] += height - right
        area[row, first + 1] += right
        _widen(extent, row, first, first + 1)
        return
    slope = height / (x1 - x0)
    begin = 1.0 - (x0 - first)
    covered = 0.5 * slope * begin * begin
    area[row, first] += covered
    for column in range(first + 1, last - 1):
        share = slope * (column + 0.5 - x0)
        area[row, column] += share - covered
        covered = share
    end = x1 - last + 1.0
    share = height - 0.5 * slope * end * end
    area[row, last - 1] += share - covered
    area[row, last] += height - share
    _widen(extent, row, first, last)


@inner_kernel
def _add_edge(area: Any, extent: Any, start: Any, end: Any, box: Any) -> None:
    """Add one edge of a polygon, from (x, y) to (x, y) px; what is left of the box counts at its border."""
    (x0, y0), (x1, y1) = start, end
    x_low, y_low, x_high, y_high = box
    sign = 1.0
    if y0 > y1:
        x0, y0, x1, y1 = x1, y1, x0, y0
        sign = -1.0
    if y1 <= y_low or y0 >= y_high or not y1 - y0 > LEVEL:
        return
    # shares of the edge, not a slope: that is huge for an edge almost level
    whole, breadth = 1.0 / (y1 - y0), x1 - x0
    start = max(y0, 1.0 * y_low)
    xb, bottom = x0 + (start - y0) * whole * breadth, start
    for row in range(int(start), min(y_high, math.ceil(min(y1, 1.0 * y_high)))):
        xa, top = xb, bottom
        bottom = min(y1, row + 1.0)
        xb = x0 + (bottom - y0) * whole * breadth
        a, b = min(xa, xb), max(xa, xb)
        height = sign * (bottom - top)
        if a >= x_low and b <= x_high:
            _cut_row(area, extent, row, a, b, height)
            continue
        if a < x_low:
            share = 1.0 if b <= x_low or b <= a else (x_low - a) / (b - a)
            area[row, x_low] += height * share
            _widen(extent, row, x_low, x_low)
            if share >= 1.0:
                continue
        if a >= x_high:
            continue  # right of the clip an edge changes nothing inside
        p, q = max(a, 1.0 * x_low), min(b, 1.0 * x_high)
        part = height * (q - p) / (b - a) if b > a else height
        _cut_row(area, extent, row, p, max(p, q), part)


@inner_kernel
def _next_change(area: Any, row: int, column: int, last: int) -> int:
    """The next column, from this one to ``last``, whose sum is not zero; else the one after ``last``."""
    begin = row * area.shape[1]
    while column + 8 <= last and is_blank(area, begin + column):
        column += 8
    while column <= last and area[row, column] == 0.0:
        column += 1
    return column


@inner_kernel
def _sweep(
    pixels: Any, area: Any, extent: Any, x_high: int, y_low: int, y_high: int, color: int, alpha: float
) -> None:
    """Sum each touched row from the left, lay the colour by coverage, wipe the sums."""
    for row in range(y_low, y_high):
        first, last = extent[row, 0], extent[row, 1]
        if last < first:
            continue
        sum_so_far = 0.0
        column = first
        while column <= last:
            sum_so_far += area[row, column]
            area[row, column] = 0.0
            weight = weight_of(min(1.0, abs(sum_so_far)), alpha)
            start = column
            column += 1
            column = _next_change(area, row, column, last)  # between edges the share stays
            if column > start + 1:
                fill_row(pixels, row, start, min(column, x_high), color, weight)
            elif weight > 0 and start < x_high:
                blend(pixels, row, start, color, weight)
        extent[row, 0] = 1 << 30
        extent[row, 1] = -1
        if last + 1 < x_high and abs(sum_so_far) > 1e-9:  # the closing edge lies right of the clip
            fill_row(pixels, row, last + 1, x_high, color, weight_of(min(1.0, abs(sum_so_far)), alpha))


@lean_kernel
def fill_polygon(
    pixels: Any, clip: Any, area: Any, extent: Any, points: Any, color: int, alpha: float
) -> None:
    """A filled polygon of any shape through ``points`` (n, 2) px, closed by itself.

    Where it overlaps itself it is filled once if both parts turn the same way round. ``area`` and ``extent``
    are the scratch of ``scratch_for``. Nothing is drawn if any point is not finite or beyond 10^9 px.
    """
    count = points.shape[0]
    if count < 3 or not alpha > 0.0:
        return
    top, bottom = points[0, 1], points[0, 1]
    for i in range(count):
        if not (is_drawable(points[i, 0]) and is_drawable(points[i, 1])):
            return
        top, bottom = min(top, points[i, 1]), max(bottom, points[i, 1])
    x_low, y_low = max(0, clip[0]), max(0, clip[1])
    x_high, y_high = min(pixels.shape[1], clip[2]), min(pixels.shape[0], clip[3])
    if x_low >= x_high or y_low >= y_high or bottom <= y_low or top >= y_high:
        return
    for i in range(count):
        j = i + 1 if i + 1 < count else 0
        start, end = (points[i, 0], points[i, 1]), (points[j, 0], points[j, 1])
        _add_edge(area, extent, start, end, (x_low, y_low, x_high, y_high))
    first = int(max(top, 1.0 * y_low))
    last = min(y_high, math.ceil(min(bottom, 1.0 * y_high)))
    _sweep(pixels, area, extent, x_high, first, last, color, alpha)


@inner_kernel
def _arrow_corner(corner: int, size: float, length: float) -> Any:
    """Along and across of a corner of an arrow: neck, wing, point, wing, neck, and twice the tail."""
    neck = length - HEAD_LENGTH * size
    if corner == 0:
        return neck, 0.5 * size
    if corner == 1:
        return neck, HEAD_HALF * size
    if corner == 2:
        return length, 0.0
    if corner == 3:
        return neck, -HEAD_HALF * size
    if corner == 4:
        return neck, -0.5 * size
    if corner == 5:
        return 0.0, -0.5 * size
    return 0.0, 0.5 * size


@lean_kernel
def fill_arrow(
    pixels: Any,
    clip: Any,
    area: Any,
    extent: Any,
    x0: float,
    y0: float,
    x1: float,
    y1: float,
    width: float,
    color: int,
    alpha: float,
) -> None:
    """An arrow to (x1, y1): shaft ``width`` px wide, solid head 3.2 widths long and as broad.

    Shorter than its head, the whole arrow shrinks.
    """  # fmt: skip
    if not (
        is_drawable(x0) and is_drawable(y0) and is_drawable(x1) and is_drawable(y1) and 0.0 < width < 1e9
    ):
        return
    dx, dy = x1 - x0, y1 - y0
    length = math.sqrt(dx * dx + dy * dy)
    x_low, y_low = max(0, clip[0]), max(0, clip[1])
    x_high, y_high = min(pixels.shape[1], clip[2]), min(pixels.shape[0], clip[3])
    if length == 0.0 or x_low >= x_high or y_low >= y_high:
        return
    ux, uy = dx / length, dy / length
    size = min(width, length / (HEAD_LENGTH + 0.4))
    along, across = _arrow_corner(np.int64(6), size, length)  # a bare number would be compiled in, twice
    px, py = x0 + along * ux - across * uy, y0 + along * uy + across * ux
    for corner in range(7):
        along, across = _arrow_corner(corner, size, length)
        qx, qy = x0 + along * ux - across * uy, y0 + along * uy + across * ux
        _add_edge(area, extent, (px, py), (qx, qy), (x_low, y_low, x_high, y_high))
        px, py = qx, qy
    top, bottom = min(y0, y1) - HEAD_HALF * size, max(y0, y1) + HEAD_HALF * size
    first = int(min(max(top - 1.0, 1.0 * y_low), 1.0 * y_high))
    last = int(min(max(bottom + 2.0, 1.0 * y_low), 1.0 * y_high))
    _sweep(pixels, area, extent, x_high, first, last, color, alpha)


@lean_kernel
def fill_under(
    pixels: Any, clip: Any, points: Any, base: float, top: float, color: int, alpha: float
) -> None:
    """The ground between a curve and the level ``base``: ``alpha`` at the level ``top``, fading to 0 at base.

    ``points`` (n, 2) px with x ascending; pieces that are not finite are left out.
    """
    if not (is_drawable(base) and is_drawable(top)) or base <= top:
        return
    x_low, y_low = max(0, clip[0]), max(0, clip[1])
    x_high, y_high = min(pixels.shape[1], clip[2]), min(pixels.shape[0], clip[3])
    for i in range(points.shape[0] - 1):
        x0, y0, x1, y1 = points[i, 0], points[i, 1], points[i + 1, 0], points[i + 1, 1]
        if not (is_drawable(x0) and is_drawable(y0) and is_drawable(x1) and is_drawable(y1)) or x1 <= x0:
            continue
        first = int(min(max(math.ceil(x0 - 0.5), 1.0 * x_low), 1.0 * x_high))
        last = int(min(max(math.ceil(x1 - 0.5), 1.0 * x_low), 1.0 * x_high))
        for column in range(first, last):
            y = y0 + (column + 0.5 - x0) / (x1 - x0) * (y1 - y0)
            start = int(min(max(y, 1.0 * y_low), 1.0 * y_high))
            stop = int(min(max(base, 1.0 * y_low), 1.0 * y_high))
            for row in range(start, stop):
                covered = min(1.0, row + 1.0 - y)
                strength = min(1.0, (base - row - 0.5) / (base - top))
                blend(pixels, row, column, color, weight_of(covered * strength, alpha))
