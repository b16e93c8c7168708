"""The referee's call on a plate over the upper rail, for a few seconds: no ball lies there."""

from __future__ import annotations

import pygame

from game.scenes.shared.tables.boxes import Box, rect_of
from game.scenes.shared.tables.referee.calls import END, FOUL, Spoken
from game.ui.canvas.canvas import Canvas
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box

SHOWN_S, FADES_S = 2.6, 0.4
HEIGHT, SIDE = 32.0, 18.0  # design px of the plate; beside the words
LETTERS = 16


def draw_call(canvas: Canvas, look: Look, bed: Box, spoken: Spoken, age_s: float) -> None:
    """The call, so many s after it was made; nothing when it is over. bed: the table with its frame."""
    if not spoken.words or not 0.0 <= age_s < SHOWN_S:
        return
    rect, theme = rect_of(canvas, bed), look.theme
    width = look.fonts.size(spoken.words, LETTERS, "semibold")[0] + look.px(2.0 * SIDE)
    plate = pygame.Surface((min(width, rect.w), look.px(HEIGHT)), pygame.SRCALPHA, 32)
    area = plate.get_rect()
    edge = {FOUL: look.color("vermilion"), END: theme.accent}.get(spoken.about, theme.line2)
    draw_box(plate, area, area.h // 2, theme.panel, edge, max(2, look.border))
    ink = "vermilion" if spoken.about == FOUL else "text1"
    fitted = look.fonts.fit(spoken.words, LETTERS, "semibold", area.w - look.px(SIDE))
    look.text(plate, fitted, area.center, LETTERS, "semibold", ink, "center")
    share = 1.0 if look.less_motion else min((SHOWN_S - age_s) / FADES_S, 1.0)
    plate.set_alpha(round(255 * share))
    canvas.surface.blit(plate, plate.get_rect(midtop=(rect.centerx, rect.top + look.px(3))))
