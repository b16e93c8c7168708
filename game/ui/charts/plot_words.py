"""The words in the plot of a study: slopes, the amber figures on the axes, "you are here".

Each stands where the fewest marks, lines and words lie under it, tried in a fixed order of places.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import pairwise

import pygame

from game.ui.charts.plot_data import PlotPoint, PlotSeries, Present
from game.ui.charts.plot_frame import PlotFrame
from game.ui.charts.plot_marks import Brush
from game.ui.look.numerals import format_si
from game.ui.look.shapes import draw_box

# Where a slope may stand from a point, in its own widths and heights; where the leader ends, design px.
# where a word may stand from its point, in halves of its own size and a little more
CLOSE = ((0, 1), (0, -1), (1, 0), (-1, 0), (1, 1), (-1, 1), (1, -1), (-1, -1))
BESIDE = ((0.6, -1.1), (-0.6, 1.3), (0.9, -0.2), (-0.9, 0.3))
NEAR = ((-36, 92, "right"), (36, -70, "left"), (-36, -70, "right"), (36, 92, "left"), (-36, 140, "right"))
FURTHER = tuple(
    (aside * way, down, side)
    for aside in (36, 90, 160, 240)
    for down in (48, -44, 92, -70, 140, -118, 188, -166, 236, -214)
    for way, side in ((1, "left"), (-1, "right"))
)
WORD_UNDER, MARK_UNDER, LINE_UNDER = 20, 2, 1  # what these cost under words


class PlotWords:
    """Places the words of one plot and remembers what is taken."""

    def __init__(self, plot: PlotFrame, surface: pygame.Surface, brush: Brush) -> None:
        self.plot, self.look, self.surface, self.brush = plot, plot.look, surface, brush
        self._busy = [plot.place(i, p) for i, one in enumerate(plot.series) for p in one.points]
        self._ways = [way for i, one in enumerate(plot.series) for way in self._lines(i, one)]
        self._taken: list[pygame.Rect] = []

    def _lines(self, i: int, one: PlotSeries) -> list[tuple[tuple[float, float], tuple[float, float]]]:
        """The lines between the runs of a method, ends in px."""
        places = [self.plot.place(i, point) for point in one.points if not point.diverged]
        return list(pairwise([(x, y) for x, y in places if math.isfinite(x) and math.isfinite(y)]))

    def draw(self) -> None:
        """Draw all words, the present setting first."""
        present = self.plot.present
        if present is not None:
            x, y = self.plot.place(present.series, present.point)
            if math.isfinite(x) and math.isfinite(y):
                self._draw_chips(present, x, y)
                self._draw_here(present, x, y)
        for i, one in enumerate(self.plot.series):
            for point in one.points:
                if point.mark:
                    self._draw_mark(i, one, point)
        for i, one in enumerate(self.plot.series):
            if math.isfinite(one.order):
                self._draw_slope(i, one)

    def _draw_slope(self, i: int, one: PlotSeries) -> None:
        look = self.look
        words = f"slope {one.order:.2f}"
        width, height = look.fonts.size(words, 12, "semibold")
        line = [self.plot.place(i, point) for point in one.points if not point.diverged]
        wanted = []
        for x, y in line[len(line) // 2 :]:
            for dx, dy in BESIDE:
                box = pygame.Rect(0, 0, width, height)
                box.center = (_whole(x + dx * width), _whole(y + dy * height))
                wanted.append(box)
        found = self._freest(wanted)
        if found is not None:
            color = look.color(one.color, words=True)
            look.fonts.draw(
                self.surface, words, found.center, 12, "semibold", color, "center", look.theme.stage
            )

    def _draw_mark(self, i: int, one: PlotSeries, point: PlotPoint) -> None:
        """The word beside a point."""
        x, y = self.plot.place(i, point)
        if not (math.isfinite(x) and math.isfinite(y)):
            return
        look = self.look
        width, height = look.fonts.size(point.mark, 12, "semibold")
        wanted = []
        for dx, dy in CLOSE:
            box = pygame.Rect(0, 0, width, height)
            box.center = (
                _whole(x + dx * (0.5 * width + 10 * look.k)),
                _whole(y + dy * (0.5 * height + 9 * look.k)),
            )
            wanted.append(box)
        found = self._freest(wanted)
        if found is not None:
            color = look.color(one.color, words=True)
            look.fonts.draw(
                self.surface, point.mark, found.center, 12, "semibold", color, "center", look.theme.stage
            )

    def _freest(self, wanted: Sequence[pygame.Rect]) -> pygame.Rect | None:
        """Of the places inside the plot the first with the least under it; it is taken."""
        area = self.plot.area.inflate(-self.look.px(8), -self.look.px(8))
        best = math.inf
        found: pygame.Rect | None = None
        for box in wanted:
            if not area.contains(box):
                continue
            near = box.inflate(self.look.px(10), self.look.px(8))
            marks = sum(near.collidepoint(x, y) for x, y in self._busy if math.isfinite(x + y))
            lines = sum(bool(near.clipline(start, end)) for start, end in self._ways)
            words = len(near.collidelistall(self._taken))
            cost = WORD_UNDER * words + MARK_UNDER * marks + LINE_UNDER * lines
            if cost < best:
                best, found = cost, box
        if found is not None:
            self._taken.append(found)
        return found

    def _draw_chips(self, present: Present, x: float, y: float) -> None:
        """The present figures in amber on both axes."""
        self._draw_chip(format_si(present.point.x, self.plot.axes.x_unit, 2), round(x), None)
        if not present.point.diverged:
            self._draw_chip(self.plot.error_text(present.point.y), None, round(y))

    def _draw_chip(self, words: str, x: int | None, y: int | None) -> None:
        look, px, rect = self.look, self.look.px, self.plot.rect
        chip = pygame.Rect(0, 0, look.fonts.size(words, 12, "semibold")[0] + 2 * px(6), px(20))
        if x is None:
            chip.midright = (rect.x - px(8), y or 0)
        else:
            chip.midtop = (x, rect.bottom + px(8))
        draw_box(self.surface, chip, px(4), look.color("amber"))
        look.text(self.surface, words, chip.center, 12, "semibold", look.theme.ink_on_amber, "center")

    def _draw_here(self, present: Present, x: float, y: float) -> None:
        """A leader from the ring to what the present setting is."""
        look, px, fonts = self.look, self.look.px, self.look.fonts
        width = max(fonts.size(present.head, 12, "semibold")[0], fonts.size(present.words, 12)[0])
        wanted = []
        for dx, dy, side in NEAR + FURTHER:
            place = pygame.Rect(0, 0, width, px(36))
            corner = (_whole(x + dx * look.k), _whole(y + dy * look.k))
            if side == "right":
                place.midright = corner
            else:
                place.midleft = corner
            wanted.append(place)
        box = self._freest(wanted)
        if box is None:
            return
        right = box.centerx < x
        end_x = box.right + px(8) if right else box.x - px(8)
        end_y = box.centery + (px(-10) if box.centery > y else px(10))
        way_x, way_y = end_x - x, end_y - y
        reach = 10.5 * look.k / max(math.sqrt(way_x * way_x + way_y * way_y), 1.0)
        self.brush.chain(((x + way_x * reach, y + way_y * reach), (end_x, end_y)), 1.4, "amber")
        edge, align = (box.right, "right") if right else (box.x, "left")
        amber, halo = look.color("amber", words=True), look.theme.stage
        rows = ((present.head, -9, "semibold", amber), (present.words, 9, "medium", look.theme.text1))
        for words, down, weight, color in rows:
            fonts.draw(self.surface, words, (edge, box.centery + px(down)), 12, weight, color, align, halo)


def _whole(x: float) -> int:
    """A pixel as a whole number, also for what is not finite."""
    return round(x) if math.isfinite(x) else -10_000
