"""Very many axis-aligned boxes at once, of kinds with a fill and an outline each; and cells shaded by load.

A box too small for an outline is filled with its outline's colour, by the share of each pixel that it covers.
Where there are very many, by whole pixels. Between two states a box is drawn between its two places, unless
it has leapt.
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from game.compiler.decorator import kernel
from game.ui.canvas.canvas import Canvas
from game.ui.raster import pixels_of

HIDDEN = 255  # kind of a box that is not drawn
SMALLEST_OUTLINED = 5.0  # px
LEAST_SIDE = 1.0  # px; a thinner box is drawn so wide
VERY_MANY = 20_000  # boxes; small ones are then drawn by whole pixels
MOST_LAYERS = 64  # of fills, as if they lay evenly; lower ones are left out, for through so many none is seen


@kernel(inline="always", _nrt=False)
def _mix(below, color, weight):
    """A colour 0xRRGGBB over a pixel with ``weight`` 0 to 256."""
    keep = 256 - weight
    red_blue = ((color & 0xFF00FF) * weight + (below & 0xFF00FF) * keep + 0x800080) >> 8
    over = ((color >> 8) & 0xFF00FF) | 0xFF0000
    alpha_green = over * weight + ((below >> 8) & 0xFF00FF) * keep + 0x800080
    return (red_blue & 0xFF00FF) | (alpha_green & 0xFF00FF00)


@kernel(inline="always", _nrt=False)
def _mix_run(row, begin, end, color, weight):
    """The same over the pixels of a row from ``begin`` to before ``end``."""
    for column in range(begin, end):
        row[column] = _mix(int(row[column]), color, weight)


@kernel(inline="always", _nrt=False)
def _place_box(affine, lower, upper, old_lower, old_upper, share, leap):
    """Left, top, right and bottom (px) of a box between its places, or where it is now if it has leapt."""
    x0, y0, x1, y1 = float(lower[0]), float(lower[1]), float(upper[0]), float(upper[1])
    a0, b0, a1, b1 = float(old_lower[0]), float(old_lower[1]), float(old_upper[0]), float(old_upper[1])
    near = abs(x0 - a0) <= leap and abs(y0 - b0) <= leap  # an infinite corner is not near itself
    if near and abs(x1 - a1) <= leap and abs(y1 - b1) <= leap:
        x0, y0 = a0 + share * (x0 - a0), b0 + share * (y0 - b0)
        x1, y1 = a1 + share * (x1 - a1), b1 + share * (y1 - b1)
    x0, y0 = min(max(x0, -1e6), 1e6), min(max(y0, -1e6), 1e6)
    x1, y1 = min(max(x1, -1e6), 1e6), min(max(y1, -1e6), 1e6)
    u0 = affine[0] * x0 + affine[1] * y0 + affine[4]
    v0 = affine[2] * x0 + affine[3] * y0 + affine[5]
    u1 = affine[0] * x1 + affine[1] * y1 + affine[4]
    v1 = affine[2] * x1 + affine[3] * y1 + affine[5]
    return min(u0, u1), min(v0, v1), max(u0, u1), max(v0, v1)


@kernel(inline="always", _nrt=False)
def _paint_outlined(pixels, bounds, box, ink, edge):
    """A box with an outline ``edge`` px wide; ``ink``: colour and weight of fill and outline."""
    left, top, right, bottom = box
    left_end, top_end, right_end, bottom_end = bounds
    fill, fill_weight, line, line_weight = ink
    c0, c1 = int(left + 10.5) - 10, int(right + 10.5) - 10
    r0, r1 = int(top + 10.5) - 10, int(bottom + 10.5) - 10
    first, last = max(c0, left_end), min(c1, right_end)
    begin, end = min(max(c0 + edge, first), last), max(min(c1 - edge, last), first)  # of the fill
    for row in range(max(r0, top_end), min(r1, bottom_end)):
        if row < r0 + edge or row >= r1 - edge or begin >= end:
            _mix_run(pixels[row], first, last, line, line_weight)
            continue
        _mix_run(pixels[row], first, begin, line, line_weight)
        if fill_weight > 0:
            _mix_run(pixels[row], begin, end, fill, fill_weight)
        _mix_run(pixels[row], end, last, line, line_weight)


@kernel(inline="always", _nrt=False)
def _paint_whole(pixels, bounds, box, line, weight):
    """A small box by whole pixels."""
    left, top, right, bottom = box
    left_end, top_end, right_end, bottom_end = bounds
    c0, r0 = int(0.5 * (left + right) + 10.0) - 10, int(0.5 * (top + bottom) + 10.0) - 10
    half_width, half_height = int(0.5 * (right - left)), int(0.5 * (bottom - top))
    begin, end = max(c0 - half_width, left_end), min(c0 + half_width + 1, right_end)
    for row in range(max(r0 - half_height, top_end), min(r0 + half_height + 1, bottom_end)):
        _mix_run(pixels[row], begin, end, line, weight)


@kernel(inline="always", _nrt=False)
def _paint_covered(pixels, bounds, box, line, line_weight):
    """A small box by the share of each pixel that it covers."""
    left, top, right, bottom = box
    left_end, top_end, right_end, bottom_end = bounds
    if right - left < LEAST_SIDE:
        left, right = 0.5 * (left + right - LEAST_SIDE), 0.5 * (left + right + LEAST_SIDE)
    if bottom - top < LEAST_SIDE:
        top, bottom = 0.5 * (top + bottom - LEAST_SIDE), 0.5 * (top + bottom + LEAST_SIDE)
    for row in range(max(int(top + 10.0) - 10, top_end), min(int(bottom + 1.0), bottom_end)):
        down = min(row + 1.0, bottom) - max(row * 1.0, top)
        for column in range(max(int(left + 10.0) - 10, left_end), min(int(right + 1.0), right_end)):
            across = min(column + 1.0, right) - max(column * 1.0, left)
            weight = int(line_weight * min(max(down * across, 0.0), 1.0) + 0.5)
            pixels[row, column] = _mix(int(pixels[row, column]), line, weight)


class Corners(NamedTuple):
    """Lower and upper corners of boxes, (n, 2) each, in world units."""

    lowers: Any
    uppers: Any


class Between(NamedTuple):
    """When boxes are drawn: at a share of the time between both states.

    A box that has moved further than ``leap`` is drawn where it is now.
    """

    share: float
    leap: float


class BoxStyles(NamedTuple):
    """``inks``, ``weights``: (kinds, 2), colour 0xRRGGBB and 0 to 256 of fill and outline.

    ``edge``: px, width of outlines.
    """

    inks: Any
    weights: Any
    edge: int


@kernel(_nrt=False)
def paint_boxes(pixels, clip, affine, now, before, between, kinds, styles):
    """Boxes in world units, through ``affine`` (6,) a b c d e f: x' = a x + b y + e, y' = c x + d y + f, px.

    ``now``, ``before``: `Corners` of both states; ``between``: `Between`; ``kinds``: (n,); ``styles``:
    `BoxStyles`.
    """
    share, leap = between
    inks, weights, edge = styles
    bounds = max(0, clip[0]), max(0, clip[1]), min(pixels.shape[1], clip[2]), min(pixels.shape[0], clip[3])
    left_end, top_end, right_end, bottom_end = bounds
    for box in range(len(kinds)):
        kind = kinds[box]
        if kind == HIDDEN:
            continue
        left, top, right, bottom = _place_box(
            affine, now.lowers[box], now.uppers[box], before.lowers[box], before.uppers[box], share, leap
        )
        if not (
            right >= left_end - 1.0 and left <= right_end and bottom >= top_end - 1.0 and top <= bottom_end
        ):
            continue
        left, top = max(left, left_end - 9.0), max(top, top_end - 9.0)
        right, bottom = min(right, right_end + 9.0), min(bottom, bottom_end + 9.0)
        part = left, top, right, bottom
        line, line_weight = int(inks[kind, 1]), int(weights[kind, 1])
        if right - left >= SMALLEST_OUTLINED and bottom - top >= SMALLEST_OUTLINED:
            ink = int(inks[kind, 0]), int(weights[kind, 0]), line, line_weight
            _paint_outlined(pixels, bounds, part, ink, edge)
        elif len(kinds) > VERY_MANY:
            _paint_whole(pixels, bounds, part, line, line_weight)
        else:
            _paint_covered(pixels, bounds, part, line, line_weight)


def warm_up() -> None:
    """Compile the kernel, by painting one box on a tiny picture."""
    pixels, clip = np.zeros((4, 4), dtype=np.uint32), np.array((0, 0, 4, 4), dtype=np.int64)
    box = Corners(np.zeros((1, 2)), np.ones((1, 2)))
    colors, kinds = np.zeros((1, 2), dtype=np.int64), np.zeros(1, dtype=np.uint8)
    styles = BoxStyles(colors, colors, 1)
    paint_boxes(pixels, clip, np.zeros(6), box, box, Between(1.0, 1.0), kinds, styles)


class BoxPainter:
    """Paints boxes by kind on a canvas. ``styles``: for each kind, (fill, its share, outline, its share)."""

    def __init__(self, styles: tuple[tuple[str, float, str, float], ...]):
        self._kinds = len(styles)
        self._styles = styles + tuple((fill, 0.0, line, share) for fill, _, line, share in styles)

    def paint(
        self,
        canvas: Canvas,
        lowers: Any,
        uppers: Any,
        kinds: Any,
        before: tuple[Any, Any] | None = None,
        share: float = 1.0,
        leap: float = 1.0,
    ) -> None:
        """Boxes from ``lowers`` to ``uppers``, (n, 2) world units; ``kinds`` (n,) uint8, HIDDEN for none.

        ``before``: the same of the state before, if they are to be drawn at ``share`` of the
        displacement from there.
        """
        inks = np.array([(canvas.ink(fill), canvas.ink(line)) for fill, _, line, _ in self._styles])
        weights = np.array([(round(256 * a), round(256 * b)) for _, a, _, b in self._styles])
        pixels, clip = canvas.raster_target
        affine = _affine_of(canvas)
        buried = _first_seen(affine, clip, lowers, uppers)
        if buried:
            kinds = kinds.copy()
            kinds[:buried][kinds[:buried] != HIDDEN] += self._kinds
        now = Corners(lowers, uppers)
        old = Corners(*before) if before is not None else now
        between = Between(float(share) if before is not None else 1.0, float(leap))
        styles = BoxStyles(inks.astype(np.int64), weights.astype(np.int64), max(round(canvas.k), 1))
        paint_boxes(pixels, clip, affine, now, old, between, kinds, styles)


def _first_seen(affine: Any, clip: Any, lowers: Any, uppers: Any) -> int:
    """The first box whose fill is to be seen: those before it lie under as many as may be painted."""
    wide, high = float(clip[2] - clip[0]), float(clip[3] - clip[1])
    with np.errstate(invalid="ignore", over="ignore"):
        sizes = (uppers - lowers) @ np.abs(affine[:4].reshape(2, 2).T)
    areas = np.fmin(sizes[:, 0], wide) * np.fmin(sizes[:, 1], high)
    above = np.cumsum(areas[::-1])
    seen = int(np.searchsorted(above, MOST_LAYERS * wide * high, side="right"))
    return len(areas) - seen


def _affine_of(canvas: Canvas) -> NDArray[np.float64]:
    """The map from world to pixels, from where it takes three points."""
    e, f = canvas.place((0.0, 0.0))
    a, c = canvas.place((1.0, 0.0))
    b, d = canvas.place((0.0, 1.0))
    return np.array([a - e, b - e, c - f, d - f, e, f])


def shades(canvas: Canvas, values: Any, color: str, ground: str = "stage") -> NDArray[np.uint32]:
    """Colours 0xRRGGBB from ``ground`` (value 0) to ``color`` (value 1), of the shape of ``values``."""
    share = np.clip(np.asarray(values, dtype=np.float64), 0.0, 1.0)
    ramp = _ramp(int(canvas.ink(ground)), int(canvas.ink(color)))
    return ramp[np.rint(share * (len(ramp) - 1)).astype(np.intp)]


@lru_cache(maxsize=32)
def _ramp(low: int, high: int) -> NDArray[np.uint32]:
    """Colours from one to the other, in as many steps as a channel has values."""
    share = np.linspace(0.0, 1.0, 256)[:, None]
    first, last = (np.array([ink >> shift & 255 for shift in (16, 8, 0)]) for ink in (low, high))
    mixed = np.rint(first + share * (last - first)).astype(np.uint32)
    return mixed[:, 0] << 16 | mixed[:, 1] << 8 | mixed[:, 2]


def paint_raster(
    canvas: Canvas, colors: NDArray[np.uint32], lower: tuple[float, float], upper: tuple[float, float]
) -> None:
    """A picture of (rows, columns) colours 0xRRGGBB, first row lowest, stretched over a part of the world."""
    (left, bottom), (right, top) = canvas.place(lower), canvas.place(upper)
    if not (1.0 <= right - left <= 8192.0 and 1.0 <= bottom - top <= 8192.0) or colors.size == 0:
        return
    picture = pygame.Surface((colors.shape[1], colors.shape[0]), 0, 32)  # without alpha: laid down as it is
    pixels_of(picture)[:] = colors[::-1]
    width, height = max(round(right) - round(left), 1), max(round(bottom) - round(top), 1)
    canvas.blit(pygame.transform.scale(picture, (width, height)), (lower[0], upper[1]), anchor="topleft")
