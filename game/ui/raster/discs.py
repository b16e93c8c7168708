"""Discs, rings and arcs; very many small discs; streaks behind moving particles."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any

import numpy as np

from game.compiler.decorator import inner_kernel, lean_kernel
from game.ui.raster.pixels import (
    FULL,
    OPAQUE,
    blend,
    bounds_of,
    clip_bounds,
    fill_row,
    is_drawable,
    strip_coverage,
    weight_of,
)
from game.ui.raster.vectors import blend_four, cover_four

SUBPIXELS = 8  # a stamp is kept for each eighth of a pixel both ways
NARROW = 16  # px; in rows up to this the inside is not worth being looked for
LARGEST_STAMP = 3.5  # px; larger discs are drawn one by one
STREAK_DOTS = 5
STREAK_FADE = (1.0, 0.5, 0.3, 0.18, 0.1)  # weight of a streak's dots from the particle backwards


@inner_kernel
def _fill_edge(
    pixels: Any, row: int, start: int, stop: int, x: float, dy: float, radius: float, color: int, alpha: float
) -> None:
    """Part of a row of a disc, ``dy`` px below its middle, each pixel by how much of it is covered."""
    outer, inner_squared = radius + 0.5, (radius - 0.5) * (radius - 0.5)
    begin, above = start, row * pixels.shape[1]
    while begin < stop and above + begin + 4 <= pixels.size:
        place, limits = (np.int64(begin), np.int64(min(stop - begin, 4))), (inner_squared, outer)
        cover_four(pixels, above + begin, place, (x, dy * dy), limits, color | OPAQUE, alpha)
        begin += 4
    for column in range(begin, stop):  # the last pixels of the picture
        dx = column + 0.5 - x
        squared = dx * dx + dy * dy
        if squared <= inner_squared:
            blend(pixels, row, column, color, weight_of(1.0, alpha))
        elif squared < outer * outer:
            blend(pixels, row, column, color, weight_of(outer - math.sqrt(squared), alpha))


@lean_kernel
def fill_disc(pixels: Any, clip: Any, x: float, y: float, radius: float, color: int, alpha: float) -> None:
    """A filled disc; below half a pixel of radius it keeps its area and fades."""
    if not (is_drawable(x) and is_drawable(y) and 0.0 < radius < 1e9):
        return
    if radius < 0.5:
        alpha *= 4.0 * radius * radius
        radius = 0.5
    outer = radius + 0.5
    x_low, y_low, x_high, y_high = clip_bounds(pixels, clip, x - outer, y - outer, x + outer, y + outer)
    full = weight_of(1.0, alpha)
    inner_squared = (radius - 0.5) * (radius - 0.5)
    outer_squared = outer * outer
    for row in range(y_low, y_high):
        dy = row + 0.5 - y
        rest = outer_squared - dy * dy
        if rest <= 0.0:
            continue
        half = math.sqrt(rest)
        first = max(x_low, int(max(x - half - 0.5, -1.0)))
        last = min(x_high, int(min(x + half + 1.5, 1.0 * x_high)))
        if last - first <= NARROW:
            _fill_edge(pixels, row, first, last, x, dy, radius, color, alpha)
            continue
        # columns that lie wholly inside are laid at once; what the root rounds to is tried at both ends
        inside = math.sqrt(max(inner_squared - dy * dy, 0.0))
        begin = max(first, math.ceil(x - inside - 0.5))
        end = min(last, math.floor(x + inside - 0.5) + 1)
        while begin < end and (begin + 0.5 - x) ** 2 + dy * dy > inner_squared:
            begin += 1
        while end > begin and (end - 0.5 - x) ** 2 + dy * dy > inner_squared:
            end -= 1
        if end <= begin:
            begin = end = last
        _fill_edge(pixels, row, first, begin, x, dy, radius, color, alpha)
        fill_row(pixels, row, begin, end, color, full)
        _fill_edge(pixels, row, end, last, x, dy, radius, color, alpha)


@inner_kernel
def _arc_coverage(
    forward: float, aside: float, radius: float, end_x: float, end_y: float, half: float
) -> float:
    """Share of a pixel that an arc covers which runs from straight forward to (end_x, end_y) on both sides.

    ``aside`` >= 0; ``end_x`` below -1 closes the ring. Beyond the ends both round ends count: where they
    lie on opposite sides of the pixel what they cover adds up, on the same side it is the same.
    """
    distance = math.sqrt(forward * forward + aside * aside)
    if forward >= distance * end_x:
        return strip_coverage(distance - radius, half)
    dx, near_y, far_y = forward - radius * end_x, aside - radius * end_y, aside + radius * end_y
    near, far = math.sqrt(dx * dx + near_y * near_y), math.sqrt(dx * dx + far_y * far_y)
    larger, smaller = strip_coverage(near, half), strip_coverage(far, half)
    if smaller <= 0.0 or larger >= 1.0 or near <= 0.0:
        return larger
    opposite = 0.5 - 0.5 * (dx * dx + near_y * far_y) / (near * far)
    return min(larger + opposite * smaller, 1.0)


@lean_kernel
def stroke_arc(
    pixels: Any,
    clip: Any,
    x: float,
    y: float,
    radius: float,
    width: float,
    start: float,
    sweep: float,
    color: int,
    alpha: float,
) -> None:
    """Part of a circle from angle ``start`` (rad, from +x towards +y) over ``sweep`` rad, with round ends.

    The line lies half inside and half outside of ``radius``. A sweep of 2 pi or more closes the ring.
    """  # fmt: skip
    if not (is_drawable(x) and is_drawable(y) and 0.0 < radius < 1e9 and 0.0 < width < 1e9):
        return
    if not (is_drawable(start) and is_drawable(sweep)):
        return
    if sweep < 0.0:
        start, sweep = start + sweep, -sweep
    half = 0.5 * width
    outer = radius + half + 0.5
    gap = max(0.0, radius - half - 0.5)
    half_sweep = 0.5 * sweep
    across, along = math.cos(start + half_sweep), math.sin(start + half_sweep)
    end_x, end_y = (math.cos(half_sweep), math.sin(half_sweep)) if half_sweep < math.pi else (-2.0, 0.0)
    x_low, y_low, x_high, y_high = clip_bounds(pixels, clip, x - outer, y - outer, x + outer, y + outer)
    for row in range(y_low, y_high):
        dy = row + 0.5 - y
        rest = outer * outer - dy * dy
        if rest <= 0.0:
            continue
        reach = math.sqrt(rest)
        hole = math.sqrt(max(0.0, gap * gap - dy * dy))
        column = max(x_low, int(max(x - reach - 0.5, -1.0)))
        last = min(x_high, int(min(x + reach + 1.5, 1.0 * x_high)))
        while column < last:
            dx = column + 0.5 - x
            if -hole < dx < hole - 1.0:  # nothing inside the ring
                column = max(column + 1, int(min(x + hole - 0.5, 1.0 * last)))
                continue
            # in a frame whose axes run along and across the middle of the arc, it is symmetric
            forward, aside = dx * across + dy * along, abs(dy * across - dx * along)
            weight = weight_of(_arc_coverage(forward, aside, radius, end_x, end_y, half), alpha)
            if weight > 0:
                blend(pixels, row, column, color, weight)
            column += 1


@lean_kernel
def stroke_ring(
    pixels: Any, clip: Any, x: float, y: float, radius: float, width: float, color: int, alpha: float
) -> None:
    """A circle's line, half inside and half outside of ``radius``."""
    stroke_arc(pixels, clip, x, y, radius, width, 0.0, 7.0, color, alpha)


@lean_kernel
def fill_discs(pixels: Any, clip: Any, points: Any, radii: Any, colors: Any, alpha: float) -> None:
    """Discs of any radius: ``points`` (n, 2) px, ``radii`` (n,) px, ``colors`` (n,) uint32."""
    for i in range(min(points.shape[0], radii.shape[0], colors.shape[0])):
        fill_disc(pixels, clip, points[i, 0], points[i, 1], radii[i], np.int64(colors[i]), alpha)


@inner_kernel
def _lay_whole_stamp(
    flat: Any, width: int, left: float, top: float, weights: Any, rows: int, side: int, level: int, color: int
) -> None:
    """Lay a stamp of 4 x 4 or ``rows`` x 8 pixels, inside the clip, with its corner at (left, top)."""
    column, row = int(left), int(top)
    sub_x, sub_y = int((left - column) * SUBPIXELS), int((top - row) * SUBPIXELS)
    first = ((level * SUBPIXELS + sub_y) * SUBPIXELS + sub_x) * rows * side * 4
    place = row * width + column
    if side == 4:
        for j in range(4):
            blend_four(flat, place + j * width, weights, first + 16 * j, color)
    else:
        for j in range(rows):
            blend_four(flat, place + j * width, weights, first + 32 * j, color)
            blend_four(flat, place + j * width + 4, weights, first + 32 * j + 16, color)


@inner_kernel
def _lay_cut_stamp(
    pixels: Any,
    x_low: int,
    y_low: int,
    x_high: int,
    y_high: int,
    left: float,
    top: float,
    weights: Any,
    rows: int,
    side: int,
    level: int,
    color: int,
) -> None:
    """Lay what is inside the given columns and rows of a stamp."""  # fmt: skip
    if not (x_low - side < left < x_high and y_low - rows < top < y_high):
        return
    column, row = math.floor(left), math.floor(top)
    sub_x = min(SUBPIXELS - 1, int((left - column) * SUBPIXELS))  # just below 0 the difference rounds to 1
    sub_y = min(SUBPIXELS - 1, int((top - row) * SUBPIXELS))
    first = ((level * SUBPIXELS + sub_y) * SUBPIXELS + sub_x) * rows * side * 4
    for j in range(max(0, y_low - row), min(rows, y_high - row)):
        for i in range(max(0, x_low - column), min(side, x_high - column)):
            blend(pixels, row + j, column + i, color, np.int64(weights[first + 4 * (j * side + i)]))


@lean_kernel
def fill_stamps(
    pixels: Any, flat: Any, clip: Any, points: Any, colors: Any, weights: Any, rows: int, side: int
) -> None:
    """Very many equal small discs: ``points`` (n, 2) px, ``colors`` (n,) uint32, ``weights`` of one stamp.

    ``flat`` is ``pixels.reshape(-1)``. Places are rounded to an eighth of a pixel.
    """
    width = pixels.shape[1]
    x_low, y_low, x_high, y_high = bounds_of(pixels, clip)
    corner, rise = 0.5 * side - 0.5, 0.5 * rows - 0.5
    for i in range(min(points.shape[0], colors.shape[0])):
        color = np.int64(colors[i]) | OPAQUE
        left, top = points[i, 0] - corner, points[i, 1] - rise
        if x_low <= left < x_high - side and y_low <= top < y_high - rows:
            _lay_whole_stamp(flat, width, left, top, weights, rows, side, np.int64(0), color)
        else:
            _lay_cut_stamp(
                pixels, x_low, y_low, x_high, y_high, left, top, weights, rows, side, np.int64(0), color
            )


@lean_kernel
def fill_streaks(
    pixels: Any,
    flat: Any,
    clip: Any,
    points: Any,
    trails: Any,
    seconds: float,
    colors: Any,
    weights: Any,
    rows: int,
    side: int,
) -> None:
    """Particles with five fading dots behind them: ``trails`` (n, 2) px/s, the last dot ``seconds`` back.

    ``weights`` hold one stamp a dot, from the particle backwards; the rest as in ``fill_stamps``.
    """  # fmt: skip
    width = pixels.shape[1]
    x_low, y_low, x_high, y_high = bounds_of(pixels, clip)
    corner, rise = 0.5 * side - 0.5, 0.5 * rows - 0.5
    step = seconds / (STREAK_DOTS - 1)
    for i in range(min(points.shape[0], trails.shape[0], colors.shape[0])):
        color = np.int64(colors[i]) | OPAQUE
        for dot in range(STREAK_DOTS - 1, -1, -1):
            left = points[i, 0] - corner - dot * step * trails[i, 0]
            top = points[i, 1] - rise - dot * step * trails[i, 1]
            if x_low <= left < x_high - side and y_low <= top < y_high - rows:
                _lay_whole_stamp(flat, width, left, top, weights, rows, side, dot, color)
            else:
                _lay_cut_stamp(
                    pixels, x_low, y_low, x_high, y_high, left, top, weights, rows, side, dot, color
                )


@lean_kernel
def color_by_speed(velocities: Any, slow: int, fast: int, top_speed: float, colors: Any) -> None:
    """Write into ``colors`` (n,) uint32 the mixture of two colours by |velocity| / top_speed."""
    for i in range(min(velocities.shape[0], colors.shape[0])):
        vx, vy = velocities[i, 0], velocities[i, 1]
        share = math.sqrt(vx * vx + vy * vy) / top_speed if top_speed > 0.0 else 1.0
        weight = weight_of(min(share, 1.0), 1.0)
        keep = FULL - weight
        red_blue = (((fast & 0xFF00FF) * weight + (slow & 0xFF00FF) * keep + 0x800080) >> 8) & 0xFF00FF
        green = (((fast & 0xFF00) * weight + (slow & 0xFF00) * keep + 0x8000) >> 8) & 0xFF00
        colors[i] = red_blue | green


@lru_cache(maxsize=32)
def disc_stamps(radius: float, alphas: tuple[float, ...]) -> tuple[np.ndarray, int, int]:
    """Weights of a small disc at each subpixel place, for each alpha; the stamp's rows and columns.

    Flat uint16 in the order alpha, eighth down, eighth across, row, column, channel.
    """
    if not 0.0 < radius <= LARGEST_STAMP:
        raise ValueError(f"stamps: radius {radius!r} px is not between 0 and {LARGEST_STAMP}")
    rows, side = (4, 4) if radius <= 1.5 else (6, 8) if radius <= 2.0 else (8, 8)
    area = 4.0 * radius * radius if radius < 0.5 else 1.0
    reach = max(radius, 0.5) + 0.5
    eighths = (np.arange(SUBPIXELS) + 0.5) / SUBPIXELS
    across = np.arange(side) - 0.5 * side + 1.0 - eighths[:, None]  # (subpixel, pixel)
    down = np.arange(rows) - 0.5 * rows + 1.0 - eighths[:, None]
    distance = np.sqrt(down[:, None, :, None] ** 2 + across[None, :, None, :] ** 2)
    coverage = np.clip(reach - distance, 0.0, 1.0) * area
    weights = np.round(np.multiply.outer(np.clip(alphas, 0.0, 1.0), coverage) * FULL)
    return np.ascontiguousarray(np.repeat(weights.reshape(-1), 4).astype(np.uint16)), rows, side


def fill_particles(
    pixels: np.ndarray, clip: np.ndarray, points: np.ndarray, colors: np.ndarray, radius: float, alpha: float
) -> None:
    """Very many discs of one radius up to 3.5 px: ``points`` (n, 2) px, ``colors`` (n,) uint32."""
    weights, rows, side = disc_stamps(round(radius, 2), (alpha,))
    fill_stamps(pixels, pixels.reshape(-1), clip, points, colors, weights, rows, side)


def fill_particle_streaks(
    pixels: np.ndarray,
    clip: np.ndarray,
    points: np.ndarray,
    trails: np.ndarray,
    colors: np.ndarray,
    radius: float,
    seconds: float,
    alpha: float,
) -> None:
    """``fill_particles`` with five fading dots along minus ``trails`` (n, 2) px/s over ``seconds``."""
    weights, rows, side = disc_stamps(round(radius, 2), tuple(alpha * fade for fade in STREAK_FADE))
    fill_streaks(pixels, pixels.reshape(-1), clip, points, trails, seconds, colors, weights, rows, side)
