"""Two persons at one table: a card between their turns says to whom the cue is handed, and hides nothing."""

from __future__ import annotations

from typing import Any

import pygame

from game.scenes.shared.tables.choices import PERSON
from game.stage import Choice
from game.stage.declarations import StartLine
from game.ui.canvas.canvas import Canvas
from game.ui.look.shapes import draw_box

PLAY_ON, CARD = OPTIONS = ("play-on", "card")
LABELS = ("Play on", "Hand-over card")
AIMING = "aiming"  # phase, as of `course` and of pool's `play`
WIDTH, HEAD, ROW, FOOT = 420, 66, 26, 46  # design px
COUNTS = (("won", "Won"), ("points", "Points"), ("scores", "Points"), ("high", "Highest break"),
          ("high_runs", "Longest run"))  # fmt: skip


def hand_over() -> Choice:
    """Whether a card stands between the turns of two persons."""
    return Choice(
        PLAY_ON, OPTIONS, labels=LABELS, group="Game", label="Two persons",
        help="whether a card says to whom the cue is handed",
    )  # fmt: skip


HAND_OVER_LINE = StartLine(
    "hand_over", "Two persons", "between their turns", tuple(zip(OPTIONS, LABELS, strict=True)), PLAY_ON,
    only=("second_player", PERSON),
)  # fmt: skip


def waits(course: Any) -> bool:
    """True while the cue is to be handed over: the person at turn does not sit at the table yet."""
    game = course.model.frame.game
    return (
        course.parameters.hand_over == CARD and course.phase == AIMING and not course.plays_itself
        and len(game.players) == 2 and not game.over and game.turn != course.seated
        and course.grade_of(0) == course.grade_of(1) == PERSON
    )  # fmt: skip


def counts_of(game: Any) -> list[tuple[str, str, str]]:
    """What stands on the card: a head, and the figure of both players."""
    rows = []
    for name, head in COUNTS:
        figures = getattr(game, name, None)
        if isinstance(figures, tuple) and len(figures) == 2:
            rows.append((head, str(figures[0]), str(figures[1])))
    return rows


def draw_hand_over(canvas: Canvas, course: Any) -> None:
    """The card in the middle of the picture, while it waits."""
    if not waits(course):
        return
    look, px, surface = canvas.look, canvas.look.px, canvas.surface
    frame = course.model.frame
    rows, names = counts_of(frame.game), frame.game.players
    rect = pygame.Rect(0, 0, px(WIDTH), px(HEAD + ROW * (len(rows) + 2) + FOOT))
    rect.center = canvas.rect.center
    draw_box(surface, rect, px(12), look.theme.panel, look.theme.line, look.border)
    left, right, space = rect.x + px(24), rect.right - px(24), rect.w - px(48)
    title = look.fonts.fit(f"Over to {names[frame.game.turn]}", 20, "display", space)
    look.text(surface, title, (left, rect.y + px(32)), 20, "display", "text1")
    said = look.fonts.fit(next(iter(frame.words), "The turn has changed."), 13, "medium", space)
    look.text(surface, said, (left, rect.y + px(HEAD)), 13, "medium", "text2")
    columns = right - px(120), right
    for row, words in enumerate([("", *names), *rows]):
        y = rect.y + px(HEAD + ROW * (row + 1.2))
        look.text(surface, words[0], (left, y), 13, "medium", "text2")
        for column, text in zip(columns, words[1:], strict=True):
            fitted = look.fonts.fit(text, 13, "semibold", px(110))
            look.text(surface, fitted, (column, y), 13, "semibold", "text1", "right")
    foot = look.fonts.fit("Click, or Enter: the cue is yours.", 13, "medium", space)
    look.text(surface, foot, (left, rect.bottom - px(24)), 13, "medium", "text1")
