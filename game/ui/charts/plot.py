"""The plot of a study: error against CPU time, or what else its axes say, both by decades.

Each method has its line and marks.

Runs that diverged are crosses in a band above; runs still to come are hollow, on a dashed line. The present
setting wears an amber ring, with dashed lines to its figures on both axes. The error rises with y: down
and to the left is better.
"""

from __future__ import annotations

import math
from itertools import pairwise

import pygame

from game.ui.charts.plot_data import PlotSeries, Present
from game.ui.charts.plot_frame import PlotFrame
from game.ui.charts.plot_marks import Brush
from game.ui.charts.plot_words import PlotWords
from game.ui.look.numerals import format_si
from game.ui.look.shapes import draw_box

LINE = 2.0


class WorkPrecisionPlot(PlotFrame):
    """Draws series into a rectangle of a surface."""

    # -- picture ------------------------------------------------------------------------------------

    def draw(
        self, surface: pygame.Surface, rect: pygame.Rect, hovered: tuple[int, int] | None = None
    ) -> None:
        """Draw the plot into a rectangle of a 32-bit surface; axis figures lie outside it."""
        self.rect = pygame.Rect(rect)
        if rect.w < 40 or rect.h < 60:
            return
        draw_box(surface, self.rect, self.look.px(8), self.look.theme.stage)
        brush = Brush(surface, self.rect, self.look)
        self._draw_grid(surface)
        self._draw_target(brush)
        if self.present is not None:
            self._draw_present_lines(brush, self.present)
        for i, one in reversed(list(enumerate(self.series))):
            brush.dots([self.place(i, p) for p in one.cloud if not p.diverged], one.color)
        for i, one in reversed(list(enumerate(self.series))):
            self._draw_series(brush, i, one)
        if self.present is not None:
            x, y = self.place(self.present.series, self.present.point)
            brush.ring(x, y, 9.5, "amber", 2.0)
        if hovered is not None:
            i, j = hovered
            x, y = self.place(i, self.series[i].runs[j])
            brush.ring(x, y, 8.0, "accent", 1.6)
        PlotWords(self, surface, brush).draw()

    def _draw_grid(self, surface: pygame.Surface) -> None:
        """A line for each decade, the figures, small ticks within the decades of time."""
        look, px, theme, area = self.look, self.look.px, self.look.theme, self.area
        surface.fill(theme.line2, (area.x, area.y, area.w, look.border))
        step = 1 if (self.x.high - self.x.low) * px(56) <= area.w else 2
        for n in range(self.x.low, self.x.high + 1):
            x = round(self.column(10.0**n))
            if self.x.low < n < self.x.high:
                surface.fill(theme.grid2, (x, area.y, 1, area.h))
            if (n - self.x.low) % step == 0 and not self._under_chip(x):
                look.text(
                    surface,
                    format_si(10.0**n, self.axes.x_unit, 1),
                    (x, self.rect.bottom + px(18)),
                    12,
                    "medium",
                    "text2",
                    "center",
                )
            for digit in range(2, 10):
                tick = self.column(digit * 10.0**n)
                if n < self.x.high and area.x < tick < area.right:
                    surface.fill(theme.line2, (round(tick), area.bottom - px(4), 1, px(4)))
        every = 1 if area.h >= (self.y.high - self.y.low) * px(20) * 2 else 3
        for n in range(self.y.low, self.y.high + 1):
            y = round(self.row(10.0**n))
            if self.y.low < n < self.y.high:
                surface.fill(theme.grid2, (area.x, y, area.w, 1))
            if n % every == 0 and n < self.y.high:
                self._draw_error_figure(surface, 10.0**n, y)
        if any(point.diverged for one in self.series for point in one.runs):
            place = (self.rect.x - px(12), self.rect.y + px(16))
            look.text(surface, "failed", place, 12, "medium", "vermilion", "right")
        look.text(
            surface, self.axes.y, (self.rect.x - px(12), self.rect.y - px(12)), 12, "medium", "text2", "right"
        )
        look.text(
            surface, self.axes.x, (area.centerx, self.rect.bottom + px(40)), 12, "medium", "text2", "center"
        )

    def _draw_error_figure(self, surface: pygame.Surface, error: float, y: int) -> None:
        """A figure at the left, unless the amber chip stands there."""
        if self.present is not None:
            chip = self.row(self.present.point.y)
            if abs(chip - y) < 16 * self.look.k and not self.present.point.diverged:
                return
        place = (self.rect.x - self.look.px(12), y)
        self.look.text(surface, self.error_text(error, 1), place, 12, "medium", "text2", "right")

    def _under_chip(self, x: int) -> bool:
        """Whether a figure of the time axis would lie under the amber chip."""
        if self.present is None:
            return False
        return abs(self.column(self.present.point.x) - x) < 44 * self.look.k

    def _draw_target(self, brush: Brush) -> None:
        y = self.row(self.target)
        if math.isfinite(y) and self.area.y < y < self.area.bottom:
            brush.dashes((self.rect.x, y), (self.rect.right, y), 1.0, (4.0, 4.0), "text3", 0.8)

    def _draw_present_lines(self, brush: Brush, present: Present) -> None:
        x, y = self.place(present.series, present.point)
        if math.isfinite(x) and math.isfinite(y):
            brush.dashes((self.rect.x, y), (x, y), 1.4, (4.0, 3.0), "amber", 1.0)
            brush.dashes((x, y), (x, self.rect.bottom), 1.4, (4.0, 3.0), "amber", 1.0)

    def _draw_series(self, brush: Brush, i: int, one: PlotSeries) -> None:
        """Lines through the measured runs, dashes on to those still to come, then the marks."""
        good = [point for point in one.points if not point.diverged]
        measured = [self.place(i, point) for point in good if not point.pending]
        coming = [self.place(i, point) for point in good if point.pending]
        brush.chain(measured, LINE, one.color)
        if coming:
            path = measured[-1:] + coming
            for a, b in pairwise(path):
                brush.dashes(a, b, 1.4, (5.0, 4.0), one.color, 0.5)
        for x, y in coming:
            brush.mark(one.marker, x, y, one.color, hollow=True)
        for x, y in measured:
            brush.mark(one.marker, x, y, one.color)
        last = -math.inf
        for x, y in sorted(self.place(i, point) for point in one.runs if point.diverged):
            if x - last >= 6 * self.look.k:  # of many crosses, as many as can be told apart
                brush.mark("cross", x, y, one.color)
                last = x
