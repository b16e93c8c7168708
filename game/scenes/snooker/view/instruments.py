"""The instruments round the table: power, spin, elevation, figures of the aim, buttons."""

from __future__ import annotations

import math

from game.billiards.game.arrangement import Stroke
from game.billiards.table.snooker import name_of
from game.scenes.shared.tables import grip
from game.scenes.shared.tables.beside.figures import Number, draw_numbers
from game.scenes.shared.tables.boxes import rect_of
from game.scenes.shared.tables.buttons import draw_button
from game.scenes.shared.tables.course import STRIKING
from game.scenes.shared.tables.cue import MAX_SPEED
from game.scenes.shared.tables.odds import HAND, OFFSETS, Odds
from game.scenes.shared.tables.through.measured import pushed, sway_words
from game.scenes.snooker import layout
from game.scenes.snooker.course import BALL_PER_CUE, Course
from game.scenes.snooker.hand import SnookerHand
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.numerals import NOTHING
from game.ui.painters.gauges import draw_elevation, draw_power, draw_spin

UNKNOWN = "…"


def draw_instruments(
    canvas: Canvas, look: Look, course: Course, hand: SnookerHand, odds: Odds | None
) -> None:
    """All of them. odds: of the stroke that is aimed."""
    swings = course.phase == STRIKING and course.pending is not None
    swinging = course.pending if swings else None
    _draw_stroke(canvas, look, swinging or pushed(course) or course.stroke)
    rows = hand.buttons()
    _draw_figures(canvas, look, course, odds, rect_of(canvas, layout.button_box(len(rows) - 1)).y)
    for row, (name, words, on) in enumerate(rows):
        draw_button(canvas, look, layout.button_box(row), words, on, course.grip == grip.button(name))


def _draw_stroke(canvas: Canvas, look: Look, stroke: Stroke) -> None:
    """Power, spin and elevation of a stroke."""
    surface, book, theme = canvas.surface, look.fonts, look.theme
    power = stroke.cue_speed * BALL_PER_CUE
    draw_power(surface, rect_of(canvas, layout.POWER), power, MAX_SPEED, theme, book)
    x, y = canvas.camera.to_screen(*layout.SPIN)
    look.text(surface, "Spin", (x, y - look.px(44)), 13, "medium", "text2", "center")
    draw_spin(surface, (x, y), -stroke.tip_left, stroke.tip_up, theme, book)
    lines = (("top" if stroke.tip_up >= 0.0 else "draw", abs(stroke.tip_up)),
             ("left" if stroke.tip_left >= 0.0 else "right", abs(stroke.tip_left)))  # fmt: skip
    for row, (word, value) in enumerate(lines):
        at = (x, y + look.px(46 + 18 * row))
        look.text(surface, f"{word} {value:.2f} R", at, 12, "medium", "text2", "center")
    px, py = canvas.camera.to_screen(*layout.ELEVATION)
    look.text(surface, "Elevation", (x, py - look.px(56)), 13, "medium", "text2", "center")
    draw_elevation(surface, (px, py), stroke.elevation, theme, book)
    degrees = f"{math.degrees(stroke.elevation):.0f}°"
    look.text(surface, degrees, (x, py + look.px(16)), 13, "semibold", "text1", "center")


def _draw_figures(canvas: Canvas, look: Look, course: Course, odds: Odds | None, end: float) -> None:
    """Direction of the aim, how far it may be off, and how often a hand pots with it; all above y px."""
    aim = -math.degrees(math.remainder(0.5 * math.pi - course.cue.aim, 2.0 * math.pi))
    locked = course.locked and course.may_aim
    sways = sway_words(course.push) if course.may_aim else ""
    words = f"{aim + 0.0:.2f}°".replace("-", "\u2212")
    rows = [Number("Aim locked" if locked else "Aim", words, locked, sways)]
    if odds is not None:
        chance = UNKNOWN if odds.chance is None else f"{100.0 * odds.chance:.0f} %"
        rows.append(Number("Margin", _margin(odds)))
        hand = f"hand ±{math.degrees(HAND.azimuth):.2f}°"
        rows.append(Number(f"Pot {name_of(odds.ball)}", chance, under=hand))
    at = canvas.camera.to_screen(layout.NUMBERS_TOP, layout.RIGHT_MIDDLE)
    draw_numbers(canvas, look, rows, at, layout.NUMBERS_PITCH * canvas.pixels_per_unit, end)


def _margin(odds: Odds) -> str:
    """By how much the aim may be off to the side where it may be less, in words."""
    if odds.missed:
        return NOTHING
    if odds.margin is None:
        return UNKNOWN
    nearer = min(odds.margin)
    return f"{'≥' if nearer >= OFFSETS[-1] else '±'}{math.degrees(nearer):.2f}°"
