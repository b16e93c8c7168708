"""The table beside a work-precision plot: each method with its order and cost, and a sentence below."""

from __future__ import annotations

import math

import pygame

from game.ui.charts.accuracy_data import AccuracyData, TableRow
from game.ui.charts.plot_data import PlotSeries
from game.ui.look.look import Look
from game.ui.look.numerals import NOTHING, format_si
from game.ui.look.shapes import draw_box
from game.ui.widgets.legend import draw_mark

ROW, HEADER, COST = 36, 36, 74  # design px: heights of a row and the header, breadth of the costs


def paint_table(flat: pygame.Surface, look: Look, area: pygame.Rect, data: AccuracyData, target: str) -> None:
    """Methods with mark, order and cost, the present one on an amber ground; then the sentence.

    ``area`` begins at the middle of the header's line; ``target`` is the error that the costs are for.
    """
    px, right, y = look.px, area.right, area.y
    header = data.cost_words or (f"for {target}" if target else "")
    look.text(flat, "Method", (area.x, y), 12, "medium", "text2")
    taken = look.text(flat, header, (right, y), 12, "medium", "text2", "right").w if header else 0
    edge = right - max(px(COST), taken + px(12))
    look.text(flat, data.slope_words, (edge, y), 12, "medium", "text2", "right")
    flat.fill(look.theme.line, (area.x, y + px(14), area.w, look.border))
    y += px(HEADER)
    present = data.present.series if data.present is not None else -1
    for i, (row, series) in enumerate(zip(data.rows, data.series, strict=False)):
        if y + px(ROW // 2) > area.bottom:
            return
        place = pygame.Rect(area.x, 0, area.w, px(ROW))
        place.centery = y
        _paint_row(flat, look, place, row, series, i == present)
        y += px(ROW)
    flat.fill(look.theme.line, (area.x, y - px(8), area.w, look.border))
    y += px(20)
    _paint_words(flat, look, pygame.Rect(area.x, y, area.w, max(area.bottom - y, 0)), data)


def _paint_row(
    flat: pygame.Surface, look: Look, place: pygame.Rect, row: TableRow, series: PlotSeries, present: bool
) -> None:
    px, left, right, y = look.px, place.x, place.right, place.centery
    if present:
        ground = place.inflate(2 * px(12), 0)
        draw_box(flat, ground, px(8), look.theme.panel.lerp(look.color("amber"), 0.15))
    draw_mark(flat, look, f"{series.marker}:{series.color}", (left + px(6), y), 0.92)
    order = f"{row.order:.2f}" if math.isfinite(row.order) else NOTHING
    expected = f"of {row.expected:g}" if math.isfinite(row.expected) else ""
    x = right - px(COST)
    if expected:
        x -= look.text(flat, expected, (x, y), 13, "medium", "text3", "right").w + px(4)
    width = look.text(flat, order, (x, y), 13, "medium", "text1", "right").w
    space = x - width - px(8) - (left + px(22))
    _paint_name(flat, look, row.name, (left + px(22), y), space)
    cost = format_si(row.cost_s, "s") if math.isfinite(row.cost_s) else NOTHING
    look.text(flat, cost, (right, y), 13, "semibold", "text1", "right")


def _paint_name(flat: pygame.Surface, look: Look, name: str, place: tuple[int, int], space: int) -> None:
    """A method's name; one that is too long for its line stands in two smaller ones."""
    x, y = place
    if look.fonts.size(name, 13, "medium")[0] <= space:
        look.text(flat, name, place, 13)
        return
    first, *rest = look.fonts.wrap(name, 12, "medium", max(space, 1))
    lines = [first, " ".join(rest)] if rest else [first]
    for at, words in enumerate(lines):
        line = y + look.px(14) * at - look.px(7) * (len(lines) - 1)
        look.text(flat, look.fonts.fit(words, 12, "medium", space), (x, line), 12)


def _paint_words(flat: pygame.Surface, look: Look, area: pygame.Rect, data: AccuracyData) -> None:
    """The sentence that says what it means, and the notes, as far as there is space."""
    px, y = look.px, area.y
    notes = [(note, 12, "text3", 18) for note in data.notes]
    for text, size, color, line in ((data.sentence, 13, "text1", 20), *notes):
        for words in look.fonts.wrap(text, size, "medium", area.w) if text else ():
            if y + px(10) > area.bottom:
                return
            look.text(flat, words, (area.x, y), size, "medium", color)
            y += px(line)
        if size == 13 and text:
            y += px(12)
