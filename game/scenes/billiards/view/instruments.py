"""The instruments round the table: power, spin, elevation, numbers, buttons, options, tray and scrubber."""

from __future__ import annotations

import math

import pygame

from game.billiards.game.arrangement import Stroke
from game.billiards.game.frame import Frame
from game.billiards.game.rules import CUE_BALL
from game.billiards.game.table_lengths import table_lengths
from game.scenes.billiards import layout
from game.scenes.billiards.buttons import Buttons
from game.scenes.billiards.modes import Replay
from game.scenes.billiards.play import REPLAY, SET_UP, STRIKING, Play
from game.scenes.billiards.stroke.motion import power_of
from game.scenes.billiards.view.words import aim_words
from game.scenes.shared.tables import grip
from game.scenes.shared.tables.beside.figures import Number, draw_numbers
from game.scenes.shared.tables.buttons import draw_button
from game.scenes.shared.tables.cue import MAX_SPEED
from game.scenes.shared.tables.odds import OFFSETS, Odds
from game.scenes.shared.tables.through.measured import pushed, sway_words
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.numerals import NOTHING
from game.ui.look.shapes import draw_box, draw_disc, draw_line, draw_polygon
from game.ui.painters.ball_picture import ball_chip
from game.ui.painters.gauges import draw_elevation, draw_power, draw_spin

UNKNOWN = "…"
PLACING = "Drag balls to the table and back. Done: E. Save: Ctrl+S."
MAKING = "Click a ball and its pocket, drag a zone. Wheel: how many."
TRAY_WIDTH = 610.0  # design px that the balls of the tray take
MOST_LINES = 3  # of words before options


class Instruments:
    """All of them, as far as the phase of the game has them."""

    def __init__(self, play: Play, replay: Replay, buttons: Buttons) -> None:
        self.play = play
        self.replay = replay
        self.buttons = buttons

    def draw(self, canvas: Canvas, look: Look, odds: Odds | None) -> None:
        """Draw them round the table. odds: of the stroke that is aimed."""
        play = self.play
        swinging = play.phase == STRIKING and play.pending is not None
        stroke = play.pending if swinging and play.pending else pushed(play) or play.aiming.stroke
        _draw_stroke(canvas, look, stroke, play.model.frame)
        locked = play.aiming.locked and play.may_aim
        title, sways = "Aim locked" if locked else "Aim", sway_words(play.push) if play.may_aim else ""
        aim = Number(title, aim_words(play.aiming.cue.aim), locked, under=sways)
        rows = self.buttons.rows()
        at = canvas.camera.to_screen(layout.NUMBERS_TOP, layout.RIGHT_MIDDLE)
        end = layout.rect_of(canvas, layout.button_box(len(rows) - 1)).y
        pitch = layout.NUMBERS_PITCH * canvas.pixels_per_unit
        draw_numbers(canvas, look, (aim, *odds_numbers(odds)), at, pitch, end)
        for row, (name, words, on) in enumerate(rows):
            draw_button(canvas, look, layout.button_box(row), words, on, play.grip == grip.button(name))
        if play.asked:
            _draw_options(canvas, look, play.model.frame, play.grip)
        if play.phase == SET_UP:
            words = MAKING if self.buttons.maker.active else PLACING
            _draw_tray(canvas, look, play.model.frame.layout.numbers, words)
        elif play.phase == REPLAY:
            _draw_scrubber(canvas, look, self.replay)


def lengths_words(power: float, frame: Frame) -> str:
    """How far a ball of that speed (m/s) goes up and down the table, in its lengths. One short line:
    below it lie the window's hints.
    """
    lengths = table_lengths(round(power, 2), frame.physics, frame.table.width, frame.table.length)
    return f"{lengths:.1f} lengths" if math.isfinite(lengths) else ""


def _draw_stroke(canvas: Canvas, look: Look, stroke: Stroke, frame: Frame) -> None:
    """Power, spin and elevation of a stroke."""
    surface, book, theme = canvas.surface, look.fonts, look.theme
    power = power_of(stroke.cue_speed)
    bar = layout.rect_of(canvas, layout.POWER)
    draw_power(surface, bar, power, MAX_SPEED, theme, book)
    below = (bar.centerx, bar.bottom + look.px(7))
    look.text(surface, lengths_words(power, frame), below, 12, "medium", "text2", "center")
    x, y = canvas.camera.to_screen(*layout.SPIN)
    look.text(surface, "Spin, mm", (x, y - look.px(44)), 13, "medium", "text2", "center")
    draw_spin(surface, (x, y), -stroke.tip_left, stroke.tip_up, theme, book)
    radius = float(frame.layout.balls.radii[CUE_BALL])
    _draw_offsets(look, surface, (x, y + look.px(46)), stroke.tip_left, stroke.tip_up, radius)
    px, py = canvas.camera.to_screen(*layout.ELEVATION)
    look.text(surface, "Elevation", (x, py - look.px(56)), 13, "medium", "text2", "center")
    draw_elevation(surface, (px, py), stroke.elevation, theme, book)
    degrees = f"{math.degrees(stroke.elevation):.0f}°"
    look.text(surface, degrees, (x, py + look.px(16)), 13, "semibold", "text1", "center")


def _draw_offsets(
    look: Look, surface: pygame.Surface, at: tuple[float, float], left: float, up: float, radius: float
) -> None:
    """Where the tip strikes, mm from the middle of the ball. left, up: in ball radii; radius m."""
    lines = (("top" if up >= 0.0 else "draw", abs(up)), ("left" if left >= 0.0 else "right", abs(left)))
    for row, (word, value) in enumerate(lines):
        text = f"{word} {1000.0 * value * radius:.1f}"
        look.text(surface, text, (at[0], at[1] + look.px(18 * row)), 12, "medium", "text2", "center")


def odds_numbers(odds: Odds | None) -> tuple[Number, ...]:
    """How far the aim may be off, and how often a hand pots with it."""
    if odds is None:
        return ()
    if odds.missed or odds.margin is None:
        margin = Number("Margin", NOTHING if odds.missed else UNKNOWN)
    else:
        margin = margin_number(*odds.margin)
    chance = UNKNOWN if odds.chance is None else f"{100.0 * odds.chance:.0f} %"
    if odds.foul:
        chance = "foul"
    hand = f"hand ±{math.degrees(odds.noise.azimuth):.2f}°"
    return margin, Number(f"Pot {odds.ball}", chance, under=hand)


def margin_number(more: float, less: float) -> Number:
    """How far (rad) the aim's figure may be more and less: one figure where both look the same."""
    nearer, farther = (f"{math.degrees(side):.2f}°" for side in sorted((more, less)))
    sign = "≥" if min(more, less) >= OFFSETS[-1] else "±"
    if nearer == farther:
        return Number("Margin", sign + nearer)
    above, below = (
        ("≥" if side >= OFFSETS[-1] else sign) + f"{math.degrees(side):.2f}"
        for sign, side in (("+", more), ("\N{MINUS SIGN}", less))
    )
    return Number("Margin", f"{above} {below}°", small=True)


def _draw_options(canvas: Canvas, look: Look, frame: Frame, held: grip.Grip) -> None:
    """The player that chooses and why, and what may be chosen, in the row below the table."""
    game, rect = frame.game, layout.rect_of(canvas, layout.FOOT)
    said = " ".join(frame.words) or f"{game.shooter} chooses."
    lines = look.fonts.wrap(said, 12, "medium", look.px(layout.ASKED - 12.0))[:MOST_LINES]
    for row, line in enumerate(lines):
        y = rect.centery + (row - 0.5 * (len(lines) - 1)) * look.px(14)
        look.text(canvas.surface, line, (rect.x + look.px(4), y), 12, "medium", "text1")
    for row, option in enumerate(game.options):
        box = layout.option_box(row, len(game.options))
        draw_button(canvas, look, box, f"{row + 1}  {option.words}", False, held == grip.option(row))


def _draw_tray(canvas: Canvas, look: Look, on_table: tuple[int, ...], words: str) -> None:
    """The balls that are not on the table, below it; beside them what can be done."""
    rect = layout.rect_of(canvas, layout.FOOT)
    theme = look.theme
    draw_box(canvas.surface, rect, look.px(10), theme.inset, theme.line, look.border)
    for number in range(16):
        x, y = canvas.camera.to_screen(*layout.tray_place(number))
        if number in on_table:
            draw_disc(canvas.surface, (x, y), look.px(10), None, theme.line2, look.border)
        else:
            chip = ball_chip(number, max(10.5 * look.k, 2.0), (theme.inset.r, theme.inset.g, theme.inset.b))
            canvas.surface.blit(chip, chip.get_rect(center=(round(x), round(y))))
    words = look.fonts.fit(words, 12, "medium", max(rect.w - look.px(TRAY_WIDTH + 14.0), 1))
    look.text(canvas.surface, words, (rect.right - look.px(14), rect.centery), 12, "medium", "text2", "right")


def _draw_scrubber(canvas: Canvas, look: Look, replay: Replay) -> None:
    """Run or stand, speed, and the bar of the replay with the contacts as ticks."""
    surface, theme, px = canvas.surface, look.theme, look.px
    rect = layout.rect_of(canvas, layout.PLAY)
    draw_box(surface, rect, px(8), theme.inset, theme.line2, look.border)
    x, y = rect.center
    if replay.runs:
        for side in (-4, 4):
            bar = pygame.Rect(0, 0, px(4), px(14))
            bar.center = (x + px(side), y)
            draw_box(surface, bar, 1, theme.text1)
    else:
        draw_polygon(surface, [(x - px(5), y - px(8)), (x + px(8), y), (x - px(5), y + px(8))], theme.text1)
    speed = replay.speed
    words = f"{speed:g}×" if speed >= 1.0 else f"1/{round(1.0 / speed)}×"
    draw_button(canvas, look, layout.SPEED, words)
    bar = layout.rect_of(canvas, layout.SCRUBBER)
    length = replay.play.shown_s
    share = replay.time / length
    track = pygame.Rect(bar.x, bar.centery - px(2), bar.w, max(px(4), 2))
    draw_box(surface, track, px(2), theme.hover)
    draw_box(
        surface, pygame.Rect(track.x, track.y, max(round(track.w * share), 1), track.h), px(2), theme.accent
    )
    played = replay.play.model.played
    for time in (
        played.trajectory.times[played.trajectory.rows[:, 1] <= 1].tolist() if played is not None else ()
    ):
        at = bar.x + bar.w * time / length
        draw_line(surface, theme.line2, (at, bar.centery + px(5)), (at, bar.centery + px(9)), look.border)
    draw_disc(surface, (bar.x + bar.w * share, bar.centery), px(8), theme.knob)
    words = f"{replay.time:.2f} s"
    look.text(surface, words, (bar.right + px(14), bar.centery), 13, "semibold", "text1")
