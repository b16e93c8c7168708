"""Where the points of a study's plot lie: both axes by decades, a band above for runs that diverged."""

from __future__ import annotations

import math
from collections.abc import Sequence

import pygame

from game.ui.charts.plot_data import PlotAxes, PlotPoint, PlotSeries, Present, Range, decades
from game.ui.look.look import Look
from game.ui.look.numerals import format_number, format_si

ERROR_OVER_COST = PlotAxes()
BAND, HIT = 32.0, 9.0  # design px: band of diverged runs; reach of a pointer


class PlotFrame:
    """Series in a rectangle: the pixel of a point, and the point under a pixel."""

    def __init__(self, look: Look, axes: PlotAxes = ERROR_OVER_COST) -> None:
        self.look = look
        self.axes = axes
        self.rect = pygame.Rect(0, 0, 1, 1)
        self.series: tuple[PlotSeries, ...] = ()
        self.present: Present | None = None
        self.floor = 0.0
        self.target = math.nan  # the round error of the table
        self.x = self.y = Range(-2, 0)

    def show(
        self, series: Sequence[PlotSeries], present: Present | None, target: float, floor: float = 0.0
    ) -> None:
        """Take new data; the axes follow, but for errors up to ``floor``, which lie at the foot."""
        self.series, self.present, self.target, self.floor = tuple(series), present, target, floor
        points = [point for one in self.series for point in one.runs]
        if present is not None:
            points.append(present.point)
        self.x = decades([point.x for point in points])
        self.y = decades([p.y for p in points if not p.diverged and p.y > floor])

    # -- places -------------------------------------------------------------------------------------

    @property
    def area(self) -> pygame.Rect:
        """The plot below the band."""
        band = round(BAND * self.look.k)
        return pygame.Rect(self.rect.x, self.rect.y + band, self.rect.w, max(1, self.rect.h - band))

    def column(self, x: float) -> float:
        """Pixel of what runs from left to right; nan if it has none."""
        if not (math.isfinite(x) and x > 0.0):
            return math.nan
        return self.rect.x + self.rect.w * (math.log10(x) - self.x.low) / (self.x.high - self.x.low)

    def row(self, error: float) -> float:
        """Pixel of an error; one below the axis, as 0, lies at its foot; nan if it has none."""
        area = self.area
        if math.isnan(error) or error < 0.0 or math.isinf(error):
            return math.nan
        foot = area.bottom - 7.0 * self.look.k  # where a mark on the lower end is seen whole
        if error == 0.0 or math.log10(error) < self.y.low:
            return foot
        return area.bottom - area.h * (math.log10(error) - self.y.low) / (self.y.high - self.y.low)

    def place(self, i: int, point: PlotPoint) -> tuple[float, float]:
        """Pixel of a point of series ``i``; a diverged one lies in the band."""
        if point.diverged:
            rows = max(len(self.series), 1)
            return self.column(point.x), self.rect.y + (0.15 + 0.7 * (i + 0.5) / rows) * BAND * self.look.k
        return self.column(point.x), self.row(point.y)

    def hit(self, position: tuple[int, int]) -> tuple[int, int] | None:
        """Series and point nearest to a pixel and within reach."""
        best, found = HIT * self.look.k, None
        for i, one in enumerate(self.series):
            for j, point in enumerate(one.runs):
                x, y = self.place(i, point)
                distance = math.sqrt((x - position[0]) ** 2 + (y - position[1]) ** 2)
                if distance < best:
                    best, found = distance, (i, j)
        return found

    def error_text(self, error: float, digits: int = 2) -> str:
        """An error with its unit, or as a power of ten if it has none; what is only rounding is said so."""
        if self.floor > 0.0 and error <= self.floor:
            return "rounding"
        if self.axes.y_unit:
            return format_si(error, self.axes.y_unit, digits)
        return format_number(error, digits)
