"""The grid of the stage: lines at round numbers of the world's unit, and the numbers themselves."""

from __future__ import annotations

import math

from game.ui.canvas.base import CanvasBase
from game.ui.look.numerals import MINUS, format_number

CLOSEST = 72.0  # design px between lines
MOST_LINES = 400


def round_spacing(least: float) -> float:
    """The smallest of 1, 2, 5, 10, ... times a power of ten that is at least ``least``."""
    if not (math.isfinite(least) and least > 0.0):
        return 1.0
    power = 10.0 ** math.floor(math.log10(least))
    for factor in (1.0, 2.0, 5.0, 10.0):
        if factor * power >= least * (1.0 - 1e-9):
            return factor * power
    return 10.0 * power


def draw_grid(canvas: CanvasBase, spacing: float | None, labels: str) -> None:
    """Draw lines 1 px wide on whole pixels; at the right the heights, at the foot the widths."""
    camera, rect, surface = canvas.camera, canvas.rect, canvas.surface
    if spacing is None or not (math.isfinite(spacing) and spacing > 0.0):
        spacing = round_spacing(CLOSEST * canvas.k / camera.scale)
    seen, color = camera.visible(), canvas.color("grid")
    a, b, c, d, e, f = camera.affine()
    swapped = abs(a) < abs(c)  # a quarter turn: x runs up the picture
    marks: list[tuple[float, bool, str]] = []  # px, whether the line is upright, world value
    for axis, low, high in (("x", seen.left, seen.right), ("y", seen.bottom, seen.top)):
        if not (high - low) / spacing < MOST_LINES or abs(low) + abs(high) > 1e15 * spacing:
            continue  # too many to see, or too far for steps of this size
        first, last = math.ceil(low / spacing), math.floor(high / spacing)
        for i in range(first, last + 1):
            value = i * spacing
            upright = (axis == "x") != swapped
            across, along = (a, c) if axis == "x" else (b, d)
            place = int(across * value + e if upright else along * value + f)
            line = (place, rect.y, 1, rect.h) if upright else (rect.x, place, rect.w, 1)
            surface.fill(color, line)
            if axis in labels and canvas.words:
                marks.append((place, upright, _number(value, spacing)))
    for spot, upright, number in marks:
        _draw_number(canvas, spot, upright, f"{number} {canvas.unit}".rstrip())


def _number(value: float, spacing: float) -> str:
    """A round coordinate with as many decimals as its grid needs."""
    if not 1e-4 <= spacing < 1e7:
        return format_number(value)
    decimals = max(0, -math.floor(math.log10(spacing) + 1e-9))
    return f"{value:.{decimals}f}".replace("-", MINUS) if abs(value) > 0.5 * spacing else "0"


def _draw_number(canvas: CanvasBase, place: float, upright: bool, text: str) -> None:
    """A number with its unit: above its line at the right end, or at the foot of an upright line."""
    rect, k, insets = canvas.rect, canvas.k, canvas.insets
    if upright:
        at = (place + 5 * k, rect.bottom - insets[3] - 10 * k)
        space = rect.x + insets[0] + 24 * k < place < rect.right - insets[2] - 64 * k
        align = "left"
    else:
        at, align = (rect.right - insets[2] - 12 * k, place - 9 * k), "right"
        space = rect.y + insets[1] + 24 * k < place < rect.bottom - insets[3] - 8 * k
    if space:
        fonts, theme = canvas.fonts, canvas.theme
        fonts.draw(canvas.surface, text, at, 11, "medium", theme.text3, align, theme.stage)
