"""A small chart in a corner of a story's picture: what is measured over what is expected.

A curve has two axes with their names and units, the measured one whole and the expected one dashed. A mark is
two bars on one axis, each with its number. Both say what they are called.
"""

from __future__ import annotations

import math

import numpy as np
import pygame

from game.arrays import Floats
from game.stage import Comparison
from game.ui.charts.plot_marks import Brush
from game.ui.charts.strip_axis import Axis, axis_for, end_text, rule_text, unit_of
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box

SHARE = (0.25, 0.3)  # of the picture's size
LEAST = (216, 132)  # design px
EDGE = 0.03  # of the picture's height, to its edges
GROUND = 232  # of 255: how much of the picture the card hides
MEASURED, EXPECTED, LIMIT = "amber", "text1", "vermilion"
LINE = 2.0  # design px
DASH = (5.0, 4.0)
SMALL = 12  # design px, of letters
STEPS = (1.0, 2.0, 2.5, 3.0, 4.0, 5.0, 10.0, 20.0)  # round ones
MANY = 24  # points that are still marked one by one


def chart_rect(look: Look, picture: pygame.Rect, corner: str) -> pygame.Rect:
    """Where a chart lies in a picture, px. corner: such as "top right"."""
    edge = round(EDGE * picture.h)
    size = [
        max(round(share * whole), look.px(least))
        for share, whole, least in zip(SHARE, picture.size, LEAST, strict=True)
    ]
    place = pygame.Rect(0, 0, min(size[0], picture.w - 2 * edge), min(size[1], picture.h - 2 * edge))
    up, side = corner.split()
    place.x = picture.x + edge if side == "left" else picture.right - edge - place.w
    place.y = picture.y + edge if up == "top" else picture.bottom - edge - place.h
    return place


def draw_comparison(
    surface: pygame.Surface, look: Look, place: pygame.Rect, shown: Comparison, opacity: float
) -> None:
    """Draw it in a rectangle (px), on a ground of its own."""
    place = place.clip(surface.get_rect())
    if opacity <= 0.0 or not (place.w and place.h):
        return
    card = surface.subsurface(place).copy()
    panel = look.theme.panel
    draw_box(card, card.get_rect(), look.px(10), pygame.Color(panel.r, panel.g, panel.b, GROUND))
    body = card.get_rect().inflate(-2 * look.px(12), -2 * look.px(8))
    if shown.over:
        _draw_curves(card, look, body, shown)
    else:
        _draw_marks(card, look, body, shown)
    card.set_alpha(round(255 * opacity))
    surface.blit(card, place)


def _axis(values: Floats) -> Axis:
    finite = values[np.isfinite(values)]
    return axis_for(float(finite.min()), float(finite.max()), None) if len(finite) else Axis(0.0, 1.0)


def close_axis(values: Floats) -> Axis:
    """Round ends about what is shown, with a round number midway; they need not hold 0."""
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    wide = max(high - low, 1e-3 * abs(high), 1e-9)
    power = 10.0 ** math.floor(math.log10(0.5 * wide))
    for step in (share * power for share in STEPS):
        bottom = step * math.floor(low / step)
        if bottom + 2.0 * step >= high:
            break
    return Axis(bottom, bottom + 2.0 * step)


def _place_axis(places: Floats) -> Axis:
    """Along the bottom: from the first place to the last, or from nothing where that is near."""
    low, high = float(places.min()), float(places.max())
    if 0.0 < low < 0.5 * high:
        low = 0.0
    return Axis(low, high) if high > low else Axis(low - 0.5, high + 0.5)


def _draw_curves(card: pygame.Surface, look: Look, body: pygame.Rect, shown: Comparison) -> None:
    """Two axes, a key above; dashes of the expected curve lie on the measured one, its points on both."""
    px = look.px
    both = np.concatenate([shown.measured, shown.expected])
    across = _place_axis(both[:, 0])
    axis = _axis(both[:, 1]) if shown.limit is None else close_axis(np.append(both[:, 1], shown.limit[1]))
    box = pygame.Rect(body.x + px(34), body.y + px(38), body.w - px(40), body.h - px(74))
    _draw_key(card, look, body, shown.names)
    _draw_axes(card, look, box, axis, across, shown)
    brush = Brush(card, box.inflate(2 * px(6), 2 * px(6)), look)
    if shown.limit is not None:
        _draw_limit(card, look, box, axis, shown.limit)
    measured = _placed(shown.measured, box, axis, across)
    if not shown.single:
        brush.chain(measured, LINE, MEASURED)
    brush.dashed_chain(_placed(shown.expected, box, axis, across), LINE, DASH, EXPECTED)
    if len(measured) <= MANY or shown.single:
        for x, y in measured:
            brush.mark("disc", x, y, MEASURED)


def _draw_limit(
    card: pygame.Surface, look: Look, box: pygame.Rect, axis: Axis, limit: tuple[str, float]
) -> None:
    """A rule from side to side, its name at the left end above it."""
    y = box.bottom - box.h * (limit[1] - axis.low) / (axis.high - axis.low)
    Brush(card, card.get_rect(), look).chain(((float(box.x), y), (float(box.right), y)), LINE, LIMIT)
    at = (box.x + look.px(4), round(y) - look.px(8))
    look.text(card, limit[0], at, SMALL, "semibold", LIMIT, "left")


def _draw_key(card: pygame.Surface, look: Look, body: pygame.Rect, names: tuple[str, str]) -> None:
    """Both names, each behind a piece of its line; the second goes below where there is no space beside."""
    px, brush = look.px, Brush(card, card.get_rect(), look)
    x, y = body.x, body.y + px(8)
    for name, color in zip(names, (MEASURED, EXPECTED), strict=True):
        words = look.fonts.fit(name, SMALL, "semibold", body.w // 2 - px(26))
        ends = (float(x), float(y)), (float(x + px(18)), float(y))
        if color == MEASURED:
            brush.chain(ends, LINE, color)
        else:
            brush.dashed_chain(ends, LINE, DASH, color)
        look.text(card, words, (x + px(24), y), SMALL, "semibold")
        x += body.w // 2


def _draw_axes(
    card: pygame.Surface, look: Look, box: pygame.Rect, axis: Axis, across: Axis, shown: Comparison
) -> None:
    """Three rules with their numbers, the ends of the axis below, units of both."""
    px, (unit, factor) = look.px, unit_of(axis, shown.unit)
    for share in (0.0, 0.5, 1.0):
        y = box.bottom - round(share * box.h)
        card.fill(look.theme.line2, (box.x, y, box.w, look.border))
        value = (axis.low + share * (axis.high - axis.low)) / factor
        look.text(card, rule_text(value), (box.x - px(6), y), SMALL, "medium", "text2", "right")
    look.text(card, unit, (box.x, box.y - px(11)), SMALL, "medium", "text2")
    foot, words = box.bottom + px(11), f"{shown.over}, {shown.over_unit}".removesuffix(", ")
    for place, at, align in ((across.low, box.x, "left"), (across.high, box.right, "right")):
        look.text(card, rule_text(float(f"{place:.3g}")), (at, foot), SMALL, "medium", "text2", align)
    look.text(card, words, (box.centerx, foot + px(15)), SMALL, "medium", "text2", "center")


def _draw_marks(card: pygame.Surface, look: Look, body: pygame.Rect, shown: Comparison) -> None:
    """Two bars from nothing, each below its name and its number; the axis with its unit at the foot."""
    px = look.px
    values = (float(shown.measured[-1, 1]), float(shown.expected[-1, 1]))
    axis = _axis(np.array(values))
    unit, factor = unit_of(axis, shown.unit)
    row, high = (body.h - px(20)) // 2, px(10)
    reach = axis.high - axis.low
    for i, (name, value, color) in enumerate(zip(shown.names, values, (MEASURED, EXPECTED), strict=True)):
        y = body.y + i * row
        number = f"{end_text(value, axis, shown.unit)} {unit}".strip()
        room = body.w - look.fonts.size(number, SMALL, "semibold")[0] - px(10)
        look.text(card, look.fonts.fit(name, SMALL, "semibold", room), (body.x, y + px(9)), SMALL, "semibold")
        look.text(card, number, (body.right, y + px(9)), SMALL, "semibold", color, "right")
        ends = sorted(body.x + round(body.w * (at - axis.low) / reach) for at in (0.0, value))
        card.fill(look.color(color), (ends[0], y + px(20), max(ends[1] - ends[0], look.border), high))
    foot = body.bottom - px(8)
    card.fill(look.theme.line2, (body.x, foot - px(11), body.w, look.border))
    for value, at, align in ((axis.low, body.x, "left"), (axis.high, body.right, "right")):
        look.text(card, rule_text(value / factor), (at, foot), SMALL, "medium", "text2", align)
    look.text(card, unit, (body.centerx, foot), SMALL, "medium", "text2", "center")


def _placed(rows: Floats, box: pygame.Rect, axis: Axis, across: Axis) -> list[tuple[float, float]]:
    """px of the points that have a place."""
    found = []
    for place, value in rows.tolist():
        if math.isfinite(place) and math.isfinite(value):
            x = box.x + box.w * (place - across.low) / (across.high - across.low)
            found.append((x, box.bottom - box.h * (value - axis.low) / (axis.high - axis.low)))
    return found
