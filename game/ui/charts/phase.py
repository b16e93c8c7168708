"""A phase plot: one readout against another over the last ten seconds, what is older fainter."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from game.stage.series import StripSeries
from game.ui import raster
from game.ui.charts.strip_axis import Axis, rule_text, unit_of
from game.ui.look.look import Look
from game.ui.raster import packed

AGES = (0.15, 0.3, 0.5, 0.75, 1.0)  # opacity of equal parts of the curve, the oldest first
EDGE = 0.06  # of the range, free on either side
SMALLEST_USE = 0.35  # of an axis; below that it is made again


class Phase(NamedTuple):
    """What a chart shows: the readout ``x`` to the right, ``y`` upwards, by their names."""

    x: str
    y: str

    @property
    def series(self) -> tuple[str, ...]:
        """Names of what is drawn."""
        return self.x, self.y

    @property
    def title(self) -> str:
        """Words over the chart."""
        return f"{self.y} against {self.x}"

    @property
    def unit(self) -> str:
        """A phase plot has two, which the readouts say."""
        return ""


class PhaseAxes(NamedTuple):
    """The ends of both axes."""

    x: Axis
    y: Axis


def points_of(series: StripSeries, phase: Phase) -> NDArray[np.float64]:
    """Samples (n, 2) of both where both were measured, from the oldest to the newest."""
    if phase.x not in series.names or phase.y not in series.names:
        return np.empty((0, 2))
    both = np.stack([series.values(phase.x), series.values(phase.y)], axis=1)
    found: NDArray[np.float64] = both[np.isfinite(both).all(axis=1)]
    return found


def axis_about(values: NDArray[np.float64], before: Axis | None) -> Axis:
    """Ends about the values, with a little space; the old ones stay while they fit and are not too wide."""
    if not values.size:
        return before or Axis(0.0, 1.0)
    low, high = float(values.min()), float(values.max())
    wide = high - low
    fits = before is not None and before.low <= low and high <= before.high
    if before is not None and fits and wide >= SMALLEST_USE * (before.high - before.low):
        return before
    if wide <= 1e-12 * max(abs(low), abs(high), 1e-300):
        wide = max(abs(low), 1.0) * 0.1
        low, high = low - 0.5 * wide, high + 0.5 * wide
    return Axis(low - EDGE * wide, high + EDGE * wide)


def paint_phase(
    picture: pygame.Surface, place: pygame.Rect, look: Look, phase: Phase, series: StripSeries,
    units: tuple[str, str], before: PhaseAxes | None,
) -> PhaseAxes:  # fmt: skip
    """Draw the chart into its column of the row of charts; the axes, for the next time.

    ``units``: of x and y.
    """
    px = look.px
    points = points_of(series, phase)
    axes = PhaseAxes(
        axis_about(points[:, 0], before.x if before else None),
        axis_about(points[:, 1], before.y if before else None),
    )
    (unit_x, factor_x), (unit_y, factor_y) = unit_of(axes.x, units[0]), unit_of(axes.y, units[1])
    title = look.fonts.fit(phase.title, 12, "semibold", place.w - px(40))
    look.text(picture, title, (place.x, place.y + px(16)), 12, "semibold")
    ends_y = [rule_text(end / factor_y) for end in (axes.y.high, axes.y.low)]
    left = max(look.fonts.size(words, 11)[0] for words in ends_y) + px(6)
    box = pygame.Rect(
        place.x + left, place.y + px(32), max(place.w - left - px(24), px(24)), place.h - px(72)
    )
    _paint_frame(picture, look, box, axes)
    for words, y in zip(ends_y, (box.y + px(5), box.bottom - px(5)), strict=True):
        look.text(picture, words, (box.x - px(6), y), 11, "medium", "text3", "right")
    if unit_y:
        look.text(picture, unit_y, (box.x - px(6), box.centery), 11, "medium", "text3", "right")
    foot = box.bottom + px(11)
    low, high = (rule_text(end / factor_x) for end in axes.x)
    look.text(picture, low, (box.x, foot), 11, "medium", "text3")
    look.text(picture, high, (box.right, foot), 11, "medium", "text3", "right")
    name = look.fonts.fit(f"{phase.x} {unit_x}".rstrip(), 11, "medium", max(box.w - px(90), 0))
    look.text(picture, name, (box.centerx, foot), 11, "medium", "text3", "center")
    if len(points):
        _paint_curve(picture, look, box, _places(points, axes, box))
    return axes


def _places(points: NDArray[np.float64], axes: PhaseAxes, box: pygame.Rect) -> NDArray[np.float64]:
    """Pixels (n, 2) of the samples."""
    x = box.x + (points[:, 0] - axes.x.low) / (axes.x.high - axes.x.low) * box.w
    y = box.bottom - (points[:, 1] - axes.y.low) / (axes.y.high - axes.y.low) * box.h
    return np.ascontiguousarray(np.stack([x, y], axis=1))


def _paint_frame(picture: pygame.Surface, look: Look, box: pygame.Rect, axes: PhaseAxes) -> None:
    """The box, and a line at either zero."""
    theme = look.theme
    for y in (box.y, box.bottom):
        picture.fill(theme.inset, (box.x, y, box.w, 1))
    for x in (box.x, box.right):
        picture.fill(theme.inset, (x, box.y, 1, box.h + 1))
    if axes.x.low < 0.0 < axes.x.high:
        share = -axes.x.low / (axes.x.high - axes.x.low)
        picture.fill(theme.hover, (box.x + round(share * box.w), box.y, 1, box.h))
    if axes.y.low < 0.0 < axes.y.high:
        share = -axes.y.low / (axes.y.high - axes.y.low)
        picture.fill(theme.hover, (box.x, box.bottom - round(share * box.h), box.w, 1))


def _paint_curve(picture: pygame.Surface, look: Look, box: pygame.Rect, places: NDArray[np.float64]) -> None:
    """The curve in parts of growing strength, and the present point."""
    pixels, k = raster.pixels_of(picture), look.k
    clip = np.array((box.x - 2, box.y - 2, box.right + 3, box.bottom + 3), np.int64)
    cover, _, _ = raster.scratch_for(pixels)
    ink = packed(look.color("chalk"))
    for i, alpha in enumerate(AGES):
        begin, end = (math.floor(len(places) * j / len(AGES)) for j in (i, i + 1))
        part = np.ascontiguousarray(places[max(begin - 1, 0) : end])
        if len(part) > 1:
            raster.stroke_polyline(pixels, clip, cover, part, float(1.6 * k), False, ink, alpha)
    raster.fill_disc(pixels, clip, float(places[-1, 0]), float(places[-1, 1]), 3.5 * k, ink, 1.0)
