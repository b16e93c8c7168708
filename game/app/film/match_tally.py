"""The tally of a match on film: what each player has potted, at both ends of the row below the table."""

from __future__ import annotations

import pygame

from game.billiards.players.match import PLAYERS
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box, draw_disc
from game.ui.painters.ball_picture import ball_chip


def draw_tally(
    surface: pygame.Surface, look: Look, row: pygame.Rect, colors: tuple[str, str],
    potted: tuple[tuple[int, ...], tuple[int, ...]],
) -> None:  # fmt: skip
    """The balls of each player, at both ends of a row (px), each by the colour of the cue."""
    px, theme = look.px, look.theme
    for player, balls in enumerate(potted):
        width = px(60) + look.fonts.size(PLAYERS[player], 13, "semibold")[0] + px(24) * len(balls)
        card = pygame.Surface((width, px(36)), pygame.SRCALPHA, 32)
        draw_box(card, card.get_rect(), px(10), theme.panel, theme.line, look.border)
        draw_disc(card, (px(18), px(18)), px(6), look.color(colors[player]))
        x = px(32) + look.text(card, PLAYERS[player], (px(32), px(18)), 13, "semibold", "text1").w + px(20)
        for number in balls:
            chip = ball_chip(number, 8.5 * look.k, (theme.panel.r, theme.panel.g, theme.panel.b))
            card.blit(chip, chip.get_rect(center=(x, px(18))))
            x += px(24)
        at = row.x + px(24) if player == 0 else row.right - px(24) - width
        surface.blit(card, (at, row.centery - px(18)))
