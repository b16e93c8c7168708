"""Strip charts: measured values over the last ten seconds, below the stage.

Three rules have their numbers at the left. Each series has a line with its last point, the first one over a
fading ground, exact values dashed. Name and value stand at the line's end, pushed apart. In a low window only
the last values are shown. Each chart is redrawn twenty times a second, which is one pixel of its way, and
never two in one frame. Values are those of the moment at which all numbers in the window change.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import pygame

from game.stage import Stage, Strip
from game.ui import raster
from game.ui.charts.phase import Phase, PhaseAxes, paint_phase
from game.ui.charts.strip_axis import Axis, axis_for, end_text, rule_text, spread, unit_of
from game.ui.look.icons import icon
from game.ui.look.layout import Layout
from game.ui.look.look import Look
from game.ui.look.numerals import format_number, quantity
from game.ui.raster import packed
from game.ui.raster.curves import finite_range, place_curve, thinned
from game.ui.widgets.hotspots import Hotspot, Hotspots
from game.ui.widgets.wishes import Wish

SPAN_S = 10.0
REFRESH_S = 0.05
COLORS = ("chalk", "green", "pink", "violet", "yellow", "vermilion")
EXACT = "text1"
TIMES = ("s",)  # units of what is measured by a clock
USUAL, OVER_USUAL = 0.95, 1.25  # quantile of times, and how much more the axis of a chart holds
APART = 15  # design px between value labels
LABELS, WIDEST_LABELS = 84, 124  # design px right of the curves
MOST = 3  # charts in a row
NUMBERS = 14  # design px left of the curves, at least


def ends_of(values: np.ndarray, unit: str) -> tuple[float, float, bool]:
    """As `finite_range`; of measured times without the few that a first step or an interruption made long."""
    low, high, whole = finite_range(values)
    if unit in TIMES and math.isfinite(high):
        usual = float(np.quantile(values[np.isfinite(values)], USUAL))
        high = min(high, OVER_USUAL * usual) if usual > 0.0 else high
    return low, high, whole


def color_of(strip: Strip, name: str) -> str:
    """The colour of a series, by its name in the theme."""
    if name in strip.exact:
        return EXACT
    colors = strip.colors or COLORS
    return colors[strip.series.index(name) % len(colors)]


class Strips:
    """The charts of a scene, as the layout gives them space."""

    def __init__(self, look: Look, strips: Sequence[Strip]) -> None:
        self.look = look
        self.declared: tuple[Strip, ...] = tuple(strips)
        self.strips: tuple[Strip | Phase, ...] = self.declared
        self.spots = Hotspots()
        self._phases: dict[int, PhaseAxes] = {}
        self._readout_units: dict[str, str] = {}
        self.layout: Layout | None = None
        self._axes: dict[int, Axis] = {}
        self._labels: dict[int, int] = {}  # by chart, window px of its labels; they only grow
        self._numbers: dict[int, int] = {}  # the same, of the numbers at its rules
        self._picture: pygame.Surface | None = None
        self._since_s = 0.0
        self._next = 0  # chart whose turn it is
        self._painted: dict[int, tuple[int, int]] = {}  # by chart, the changes of its curves and values
        self._last: dict[str, float] = {}  # by series, the value that is written
        self._units: dict[str, str] = {}
        self._measured = -1  # change of the series that these values are of
        self._stage: Stage | None = None

    def place(self, layout: Layout, look: Look) -> None:
        """Take a place in the window and an appearance."""
        self.layout, self.look = layout, look
        self._picture, self._labels, self._numbers = None, {}, {}
        size, spots = look.px(20), []
        for i, column in enumerate(layout.charts[: len(self.strips)] if not layout.values_only else ()):
            place = pygame.Rect(column.right - size, column.y + look.px(6), size, size)
            spots.append(Hotspot(f"{i}", place, True, "Another readout, a phase plot, or the numbers as CSV"))
        self.spots.place(spots)

    def declare(self, strips: Sequence[Strip]) -> None:
        """Other charts that one goes back to; they are shown from now on."""
        self.declared = tuple(strips)
        self.show(strips)

    def show(self, strips: Sequence[Strip | Phase]) -> None:
        """Other charts from now on; the caller places them."""
        self.strips = tuple(strips)
        self._axes, self._phases, self._stage, self._painted = {}, {}, None, {}

    @property
    def tall(self) -> bool:
        """Whether the row is to be higher than usual."""
        return any(isinstance(strip, Phase) for strip in self.strips)

    def handle(self, event: pygame.event.Event) -> Wish | None:
        """The wish for another chart in place of one, if the event is one."""
        name = self.spots.handle(event) if event.type != pygame.KEYDOWN else None
        return Wish("chart", int(name)) if name is not None else None

    def tip(self) -> tuple[str, pygame.Rect] | None:
        """Tool tip of the sign under the pointer."""
        spot = self.spots.find(self.spots.hovered) if self.spots.hovered else None
        return (spot.tip, spot.rect) if spot is not None else None

    def update(self, dt_s: float, stage: Stage, fresh: bool = True) -> None:
        """Look at the stage; written values change if they are ``fresh``, curves at once."""
        self._since_s += dt_s
        self.spots.update(dt_s, self.look)
        if stage is not self._stage:
            self._stage, self._axes, self._picture = stage, {}, None
            self._labels, self._numbers = {}, {}
            fresh = True
        if fresh:
            series = {name: _values(stage, name) for strip in self.strips for name in strip.series}
            self._last = {name: float(values[-1]) for name, values in series.items() if values.size}
            self._measured = stage.series.changes
            self._units = self._measured_units(stage)

    def _measured_units(self, stage: Stage) -> dict[str, str]:
        """By strip without a unit of its own, that of what it draws now: a scene may offer a choice."""
        if all(strip.unit for strip in self.strips):
            return {}
        units = self._readout_units = {readout.name: readout.unit for readout in stage.readouts()}
        return {strip.title: units.get(strip.series[0], "") for strip in self.strips if not strip.unit}

    def unit_shown(self, strip: Strip | Phase) -> str:
        """Unit of a strip: its own, or that of what it draws now."""
        return strip.unit or self._units.get(strip.title, "")

    def draw(self, surface: pygame.Surface) -> None:
        """Show the charts."""
        layout = self.layout
        if layout is None or layout.strips.h < 1 or self._stage is None:
            return
        count = min(len(layout.charts), len(self.strips))
        if self._picture is None:
            self._picture = self._paint_ground(layout)
            for i in range(count):
                self._paint_column(self._picture, layout, i, self._stage)
        elif count and self._since_s * count >= REFRESH_S:  # one chart at a time: no frame pays for all
            self._next = (self._next + 1) % count
            if self._painted.get(self._next) != (self._stage.series.changes, self._measured):
                self._paint_column(self._picture, layout, self._next, self._stage)
        surface.blit(self._picture, layout.strips)
        for spot in self.spots.spots:
            theme, lit = self.look.theme, self.spots.hover(spot.name)
            sign = icon("chevron", self.look.px(14), theme.text3.lerp(theme.text1, lit))
            surface.blit(sign, sign.get_rect(center=spot.rect.center))

    def _paint_ground(self, layout: Layout) -> pygame.Surface:
        """The empty row with its lines."""
        look, strips = self.look, layout.strips
        picture = pygame.Surface(strips.size, 0, 32)
        picture.fill(look.theme.panel)
        picture.fill(look.theme.line, (0, 0, strips.w, look.border))
        inset = look.px(16) if not layout.values_only else look.px(8)
        for column in layout.charts[1 : len(self.strips)]:
            x = column.x - strips.x - look.px(16)
            picture.fill(look.theme.line, (x, inset, look.border, strips.h - 2 * inset))
        return picture

    def _paint_column(self, picture: pygame.Surface, layout: Layout, i: int, stage: Stage) -> None:
        """One chart again, within its column."""
        place = layout.charts[i].move(-layout.strips.x, -layout.strips.y)
        inside = pygame.Rect(place.x, self.look.border, place.w, place.h - self.look.border)
        picture.fill(self.look.theme.panel, inside)
        picture.set_clip(inside)
        strip = self.strips[i]
        if layout.values_only:
            self._paint_values(picture, place, strip, stage)
        elif isinstance(strip, Phase):
            units = self._readout_units.get(strip.x, ""), self._readout_units.get(strip.y, "")
            before = self._phases.get(i)
            self._phases[i] = paint_phase(picture, place, self.look, strip, stage.series, units, before)
        else:
            self._paint_chart(picture, place, i, strip, stage)
        picture.set_clip(None)
        self._since_s, self._painted[i] = 0.0, (stage.series.changes, self._measured)

    def _paint_values(
        self, picture: pygame.Surface, place: pygame.Rect, strip: Strip | Phase, stage: Stage
    ) -> None:
        """Only title and last values, in one row."""
        look, y = self.look, place.h / 2
        x = place.x + look.text(picture, strip.title, (place.x, y), 12, "semibold").w + look.px(8)
        for name in strip.series:
            known = name in self._last
            number, unit = quantity(self._last[name], self.unit_shown(strip)) if known else ("–", "")
            color = color_of(strip, name) if isinstance(strip, Strip) else "text2"
            words = f"{name} "
            if x + look.fonts.size(words + number + unit, 12)[0] > place.right:
                return
            x += look.text(picture, words, (x, y), 12, "medium", color).w
            x += look.text(picture, f"{number} {unit}".rstrip(), (x, y), 12, "semibold").w + look.px(8)

    def _paint_chart(
        self, picture: pygame.Surface, place: pygame.Rect, i: int, strip: Strip, stage: Stage
    ) -> None:
        look, px = self.look, self.look.px
        own = self.unit_shown(strip)
        series = [(name, _values(stage, name)) for name in strip.series]
        ends = [ends_of(values, own) for _, values in series if values.size]
        axis = self._axes[i] = self._axis(i, ends)
        counts = not own and all(whole for _, _, whole in ends)
        unit, factor = unit_of(axis, own)
        taken = look.text(picture, strip.title, (place.x, px(16)), 12, "semibold").w
        look.text(picture, unit, (place.x + taken + px(6), px(16)), 12, "medium", "text3")
        series = [(name, values) for name, values in series if values.size]
        last = [self._last.get(name, float(values[-1])) for name, values in series]
        numbers = [
            format_number(int(value)) if counts and math.isfinite(value) else end_text(value, axis, own)
            for value in last
        ]
        labels = [_label(name, strip) for name, _ in series]
        space = self._label_space(i, labels, numbers)
        rules = [rule_text(value / factor) for value in (axis.high, 0.5 * (axis.low + axis.high), axis.low)]
        left = self._number_space(i, rules)
        box = pygame.Rect(
            place.x + left, place.y + px(32), max(place.w - left - space, px(24)), place.h - px(56)
        )
        self._paint_rules(picture, box, rules)
        curves = [(name, _curve(stage.series.times, values, box, axis)) for name, values in series]
        self._paint_curves(picture, box, strip, curves)
        heights = [_height(float(values[-1]), box, axis) for _, values in series]
        self._paint_labels(picture, box, space, strip, [name for name, _ in series], numbers, heights)

    def _label_space(self, i: int, names: Sequence[str], numbers: Sequence[str]) -> int:
        """Window px right of the curves: for the widest label, within bounds, never less than before."""
        fonts, px = self.look.fonts, self.look.px
        wanted = [
            fonts.size(name + " ", 12)[0] + fonts.size(number, 12, "semibold")[0]
            for name, number in zip(names, numbers, strict=True)
        ]
        space = min(max([px(LABELS), *(width + px(16) for width in wanted)]), px(WIDEST_LABELS))
        self._labels[i] = max(space, self._labels.get(i, 0))
        return self._labels[i]

    def _number_space(self, i: int, numbers: Sequence[str]) -> int:
        """Window px left of the curves: for the widest number at a rule, never less than before."""
        wanted = max(self.look.fonts.size(number, 11)[0] for number in numbers) + self.look.px(6)
        self._numbers[i] = max(wanted, self.look.px(NUMBERS), self._numbers.get(i, 0))
        return self._numbers[i]

    def _axis(self, i: int, ends: Sequence[tuple[float, float, bool]]) -> Axis:
        if not any(low <= high for low, high, _ in ends):
            return self._axes.get(i, Axis(0.0, 1.0))
        low, high = min(low for low, _, _ in ends), max(high for _, high, _ in ends)
        return axis_for(low, high, self._axes.get(i))

    def _paint_rules(self, picture: pygame.Surface, box: pygame.Rect, numbers: Sequence[str]) -> None:
        """Rules with their numbers, from the top, left of where the curves are."""
        look, px, theme = self.look, self.look.px, self.look.theme
        for i, color in enumerate((theme.inset, theme.inset, theme.hover)):
            y = box.y + round(0.5 * i * box.h)
            picture.fill(color, (box.x, y, box.w, 1))
            look.text(picture, numbers[i], (box.x - px(6), y), 11, "medium", "text3", "right")
        y = box.bottom + px(11)
        look.text(picture, "−10 s", (box.x, y), 11, "medium", "text3")
        look.text(picture, "now", (box.right, y), 11, "medium", "text3", "right")

    def _paint_curves(
        self,
        picture: pygame.Surface,
        box: pygame.Rect,
        strip: Strip,
        curves: Sequence[tuple[str, np.ndarray]],
    ) -> None:
        """Ground of the first measured series, then the lines, the first on top."""
        pixels, k = raster.pixels_of(picture), self.look.k
        clip = np.array((box.x, box.y - 2, box.right + 8, box.bottom + 2), np.int64)
        cover, _, _ = raster.scratch_for(pixels)
        measured = [(name, points) for name, points in curves if name not in strip.exact]
        if measured:
            name, points = measured[0]
            top = finite_range(np.ascontiguousarray(points[:, 1]))[0]
            top = top if math.isfinite(top) else float(box.y)
            ink = packed(self._color(strip, name))
            raster.fill_under(pixels, clip, points, float(box.bottom), top, ink, 0.16)
        for name, points in reversed(curves):
            ink = packed(self._color(strip, name))
            width = float(1.6 * k)
            if name in strip.exact:
                dash = float(6.0 * k)
                raster.stroke_dashes(
                    pixels, clip, cover, points, float(1.4 * k), False, dash, dash, 0.0, ink, 0.75
                )
                continue
            raster.stroke_polyline(pixels, clip, cover, points, width, False, ink, 1.0)
            wide = np.array(
                (box.x, box.y - round(4 * k), box.right + round(4 * k) + 1, box.bottom + round(4 * k)),
                np.int64,
            )
            raster.fill_disc(pixels, wide, points[-1, 0], points[-1, 1], 3.0 * k, ink, 1.0)

    def _color(self, strip: Strip, name: str) -> pygame.Color:
        return self.look.color(color_of(strip, name))

    def _paint_labels(
        self, picture: pygame.Surface, box: pygame.Rect, space: int, strip: Strip,
        names: Sequence[str], numbers: Sequence[str], heights: Sequence[float],
    ) -> None:  # fmt: skip
        """Names and last values at the right end, none over another."""
        look, px = self.look, self.look.px
        wanted = [y if math.isfinite(y) else float(box.bottom) for y in heights]
        places = spread(wanted, px(APART), box.y, box.bottom)
        for name, number, y in zip(names, numbers, places, strict=True):
            color = color_of(strip, name)
            x = box.right + px(10)
            free = space - px(10) - look.fonts.size(" " + number, 12, "semibold")[0]
            words = look.fonts.fit(_label(name, strip), 12, "medium", max(free, 0))
            if len(words) > 1 or words == name:
                x += look.text(picture, words + " ", (x, y), 12, "medium", color).w
            look.text(picture, number, (x, y), 12, "semibold")


def _label(name: str, strip: Strip) -> str:
    """The name of a series at its line, without what the chart's title says; if nothing is left, now."""
    title = strip.title.lower()
    if len(strip.series) == 1 and f"{title} ".startswith(f"{name.lower()} "):
        return "now"
    first = title.split()[0]
    whose, colon, what = name.partition(": ")
    if colon and len(strip.series) > 1 and all(one.endswith(colon + what) for one in strip.series):
        return whose
    if name.lower().startswith(first + ", "):
        return name[len(first) + 2 :]
    return name.removesuffix(" " + first)


def _values(stage: Stage, name: str) -> np.ndarray:
    """Samples of a readout, or none if the scene does not give it."""
    return stage.series.values(name) if name in stage.series.names else np.empty(0)


def _height(value: float, box: pygame.Rect, axis: Axis) -> float:
    """Pixel of a value; the middle of the rule's row for its ends."""
    share = (value - axis.low) / max(axis.high - axis.low, 1e-300)
    return box.bottom + 0.5 - share * box.h


def _curve(times: np.ndarray, values: np.ndarray, box: pygame.Rect, axis: Axis) -> np.ndarray:
    """Pixels (n, 2) of a series whose newest sample is at the right end."""
    points = np.empty((values.size, 2))
    up = box.h / max(axis.high - axis.low, 1e-300)
    place_curve(times, values, float(box.right), box.w / SPAN_S, box.bottom + 0.5, axis.low, up, points)
    return thinned(points)
