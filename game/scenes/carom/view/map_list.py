"""The list of the map's groups, surest first, and the picture of the tip with what may be off."""

from __future__ import annotations

import math

import numpy as np
import pygame

from game.billiards.game.games.artistic import Artistic
from game.billiards.map.tolerance import AS_MEANT, OTHERWISE, TIP_REACH
from game.billiards.map.words import rails_words, route_words, tip_words
from game.scenes.carom import layout
from game.scenes.carom.advisor import Advisor, Drawn, Studied
from game.scenes.carom.course import Course
from game.scenes.carom.view.figure_list import draw_figures
from game.scenes.shared.tables.boxes import Box, rect_of
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box, draw_disc


def draw_list(canvas: Canvas, look: Look, course: Course, advisor: Advisor, drawn: Drawn | None) -> None:
    """Heading, and a row for each group: its chance, the order of touches, how it is struck."""
    rect, game = rect_of(canvas, layout.LIST), course.model.frame.game
    if isinstance(game, Artistic) and not course.parameters.map:
        draw_figures(canvas, look, game)
        return
    draw_box(canvas.surface, rect, look.px(8), look.theme.panel, look.theme.line, look.border)
    head = (rect.x + look.px(12), rect.y + look.px(14))
    look.text(canvas.surface, "Every stroke that scores", head, 14, "semibold", "text1")
    groups = drawn.map.groups if drawn is not None else ()
    under = _under(course, drawn, advisor)
    look.text(canvas.surface, under, (head[0], head[1] + look.px(17)), 11, "medium", "text3")
    if drawn is None:
        return
    for row, group in enumerate(groups[: layout.ROWS]):
        words = route_words(group.code, drawn.position.cue)
        alike = [other for other in groups if route_words(other.code, drawn.position.cue) == words]
        line = rails_words(group.code) if len(alike) > 1 else tip_words(group.stroke, brief=True)
        lit = course.chosen == group.stroke
        share = group.chance if drawn.map.fine else float("nan")
        _draw_row(canvas, look, layout.row_box(row), (words, line), share, lit)


def _under(course: Course, drawn: Drawn | None, advisor: Advisor) -> str:
    """How many strokes were tried, and how many score."""
    if not course.parameters.map:
        return "V shows the map."
    if not advisor.active or drawn is None:
        return "The map is drawn when you may play."
    scoring = int(np.count_nonzero(drawn.map.codes))
    tried = f"{len(drawn.map.strokes):,}".replace(",", " ")
    if not scoring:
        return f"None of {tried} strokes scores."
    return f"{scoring} of {tried} strokes, {len(drawn.map.groups)} ways"


def _draw_row(canvas: Canvas, look: Look, box: Box, words: tuple[str, str], chance: float, lit: bool) -> None:
    """One group. chance nan: it is still being counted."""
    rect = rect_of(canvas, box).inflate(-look.px(12), 0)
    theme, px = look.theme, look.px
    fill, line = (theme.accent_soft, theme.accent) if lit else (theme.inset, None)
    draw_box(canvas.surface, rect, px(6), fill, line, max(1, px(1.5)))
    left = rect.x + px(62)
    counted = not math.isnan(chance)
    if counted:
        bar = pygame.Rect(rect.x + px(10), rect.bottom - px(9), px(42), max(2, px(4)))
        draw_box(canvas.surface, bar, px(2), theme.hover)
        full = pygame.Rect(bar.x, bar.y, max(1, round(bar.w * chance)), bar.h)
        draw_box(canvas.surface, full, px(2), look.color("green"))
    said = f"{round(100.0 * chance)} %" if counted else "…"
    look.text(canvas.surface, said, (rect.x + px(31), rect.y + px(14)), 14, "semibold", "text1", "center")
    room = rect.right - left - px(8)
    lines = look.fonts.wrap(words[0], 12, "semibold", room)
    upper, lower = (rect.centery - px(8), rect.centery + px(8)) if room > 0 else (rect.centery, rect.centery)
    look.text(canvas.surface, lines[0], (left, upper), 12, "semibold", "text1")
    if len(lines) > 1:
        rest = look.fonts.fit(" ".join(lines[1:]), 12, "semibold", room)
        look.text(canvas.surface, rest, (left, lower), 12, "semibold", "text1")
    else:
        under = look.fonts.fit(words[1], 11, "medium", room)
        look.text(canvas.surface, under, (left, lower), 11, "medium", "text2")


def draw_tip(canvas: Canvas, look: Look, course: Course, studied: Studied | None) -> None:
    """The ball as the player sees it, where tips score, where the tip is set; what may be off."""
    rect = rect_of(canvas, layout.TIP)
    draw_box(canvas.surface, rect, look.px(8), look.theme.panel, look.theme.line, look.border)
    look.text(canvas.surface, "Tip", (rect.x + look.px(12), rect.y + look.px(14)), 13, "semibold", "text1")
    pixels = canvas.pixels_per_unit
    radius = layout.TIP_RADIUS * pixels
    middle = canvas.place(layout.TIP_MIDDLE)
    draw_disc(canvas.surface, middle, radius, look.color("knob"))
    if studied is not None:
        _draw_cells(canvas, look, studied, middle, radius)
    draw_disc(canvas.surface, middle, TIP_REACH * radius, None, look.color("line2"), look.border)
    chosen = course.parameters
    place = (middle[0] - chosen.tip_left * radius, middle[1] - chosen.tip_up * radius)
    draw_disc(
        canvas.surface, place, max(4.0 * look.k, 3.0), look.color("amber"), look.color("stage"), look.border
    )
    x, y = rect.x + look.px(186), rect.y + look.px(26)
    for row, (label, value) in enumerate(_figures(course, studied)):
        at = y + row * look.px(37)
        look.text(canvas.surface, label, (x, at), 11, "medium", "text3")
        look.text(canvas.surface, value, (x, at + look.px(16)), 13, "semibold", "text1")


def _draw_cells(
    canvas: Canvas, look: Look, studied: Studied, middle: tuple[float, float], radius: float
) -> None:
    """Green where the stroke scores as meant, blue where otherwise."""
    cells = len(studied.tips)
    size = 2.0 * TIP_REACH * radius / (cells - 1)
    colors = {AS_MEANT: look.color("green"), OTHERWISE: look.color("chalk")}
    left, top = middle[0] - TIP_REACH * radius - 0.5 * size, middle[1] - TIP_REACH * radius - 0.5 * size
    for row in range(cells):
        for column in range(cells):
            color = colors.get(int(studied.tips[row, column]))
            if color is not None:
                x, y = round(left + column * size), round(top + row * size)
                box = pygame.Rect(
                    x, y, round(left + (column + 1) * size) - x, round(top + (row + 1) * size) - y
                )
                canvas.surface.fill(color, box)


def _figures(course: Course, studied: Studied | None) -> list[tuple[str, str]]:
    """What is set, or what may be off: less and more."""
    stroke = course.stroke
    if studied is None:
        return [
            ("Cue speed", f"{stroke.cue_speed:.2f} m/s"),
            ("Aim", f"{math.degrees(stroke.azimuth):.2f}°"),
            ("Tip to the left", f"{stroke.tip_left:+.2f} R".replace("-", "\N{MINUS SIGN}")),
            ("Tip up", f"{stroke.tip_up:+.2f} R".replace("-", "\N{MINUS SIGN}")),
        ]
    aim = [math.degrees(value) for value in studied.tolerance.aim]
    speed, left, up = studied.tolerance.speed, studied.tolerance.left, studied.tolerance.up
    return [
        ("Aim off by", f"−{aim[0]:.2f}°  +{aim[1]:.2f}°"),
        ("Speed", f"−{speed[0]:.2f}  +{speed[1]:.2f} m/s"),
        ("Tip to the left", f"−{left[0]:.2f}  +{left[1]:.2f} R"),
        ("Tip up", f"−{up[0]:.2f}  +{up[1]:.2f} R"),
    ]
