"""What a player of the ladder says after a stroke: a bubble below its name, for a few seconds."""

from __future__ import annotations

from typing import Any

import pygame

from game.billiards.game.register import REGISTER
from game.billiards.players.remarks import Happened, cause_of, remark_of
from game.scenes.shared.tables.boxes import Box, rect_of
from game.scenes.shared.tables.choices import PERSON
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box

AFTER_S, SHOWN_S, FADES_S = 0.6, 5.0, 0.4  # s after the stroke: it begins, it is over; it fades
RIGHT, TIP = 60.0, 160.0  # design px from the table's right end: the bubble, and where it points up
HEIGHT, SIDE, TAIL, CORNER = (
    28.0,
    14.0,
    8.0,
    24.0,
)  # design px, of the bubble
WIDEST = 300.0  # design px: the referee's plate has the middle
LETTERS = 13


def said(course: Any, tried: bool = True) -> str:
    """The words of the ladder's player against whom a person plays, after a stroke; empty for none.

    course: of any cue game. tried: a computer player that has just played wanted to score.
    """
    entry = REGISTER.get(str(course.model.content.game))
    happened = happened_at(course, tried)
    if happened is None or entry is None or course.plays_itself or course.grade_of(0) != PERSON:
        return ""
    return remark_of(course.grade_of(1), cause_of(happened, entry.family), int(course.model.frame.strokes))


def happened_at(course: Any, tried: bool = True) -> Happened | None:
    """The last stroke between two players; None before the first."""
    frame, played = course.model.frame, course.model.played
    last = frame.last
    if last is None or played is None or len(frame.game.players) != 2:
        return None
    before, verdict = last.frame.game, played.verdict
    by, call = int(before.turn), getattr(last, "call", None)
    safe = not tried or before.opening or (call is not None and (call.safety or call.push_out))
    runs = [
        int(game.run if hasattr(game, "run") else then.tallies[by].run)
        for game, then in ((verdict.game, played.frame), (before, last.frame))
    ]
    winner = verdict.game.winner if verdict.game.over else None
    return Happened(by, bool(verdict.scored), bool(verdict.fouls), runs[0], runs[1], safe, winner)


def draw_remark(canvas: Canvas, look: Look, bed: Box, words: str, age_s: float) -> pygame.Rect:
    """The bubble, so many s after the stroke, and where it lies; empty when there is none. bed: the table."""
    if not words or not AFTER_S <= age_s < SHOWN_S:
        return pygame.Rect(0, 0, 0, 0)
    table, px = rect_of(canvas, bed), look.px
    fitted = look.fonts.fit(words, LETTERS, "medium", px(WIDEST - 2.0 * SIDE))
    width = look.fonts.size(fitted, LETTERS, "medium")[0] + px(2.0 * SIDE)
    bubble = pygame.Surface((width, px(HEIGHT + TAIL)), pygame.SRCALPHA, 32)
    body = pygame.Rect(0, px(TAIL), width, px(HEIGHT))
    left = table.right - max(px(RIGHT) + width, px(TIP + CORNER))
    middle = table.right - px(TIP) - left
    tip = [(middle - px(TAIL), body.y + 1), (middle + px(TAIL), body.y + 1), (middle, 0)]
    pygame.draw.polygon(bubble, look.theme.text1, tip)
    draw_box(bubble, body, px(12), look.theme.text1)
    look.text(bubble, fitted, body.center, LETTERS, "medium", "panel", "center")
    shown = 1.0 if look.less_motion else min((age_s - AFTER_S) / FADES_S, (SHOWN_S - age_s) / FADES_S, 1.0)
    bubble.set_alpha(round(255 * shown))
    return canvas.surface.blit(bubble, (left, table.top - px(2)))
