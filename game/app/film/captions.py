"""Words in the film of a match: title, who plays what, the tally, the end.

What is said while balls roll stands in a row of its own below the table, so that no pocket is covered.
"""

from __future__ import annotations

import pygame

from game.app.film.script import Act
from game.billiards.players.match import PLAYERS, Match
from game.physics.animation import Keyframes
from game.scenes.billiards.layout import pocket_words
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box, draw_disc, draw_line
from game.ui.painters.ball_picture import ball_chip

COLORS = ("chalk", "vermilion")  # of the two players
HEADING = "A billiard match"
FADE_S = 0.6
ROW = 64  # design px of the row of words


def draw_title(
    surface: pygame.Surface, look: Look, title: str, match: Match, time: float, ends: float
) -> None:
    """Name and title over the racked table; they come and go by key-frames: opacity and height px."""
    track = Keyframes(
        [0.0, FADE_S, ends - FADE_S, ends], [(0.0, 24.0), (1.0, 0.0), (1.0, 0.0), (0.0, -12.0)], "monotone"
    )
    opacity, rise = track.sample(time).tolist()
    lines = [(HEADING, 44, "display-bold", "text1")]
    if title:
        lines.append((title, 24, "display", "accent"))
    lines.append((f"{PLAYERS[0]} against {PLAYERS[1]}: each ball by way of another", 17, "medium", "text2"))
    _draw_card(surface, look, lines, opacity, rise)


def draw_end(surface: pygame.Surface, look: Look, title: str, match: Match, since: float) -> None:
    """How it ended."""
    points = [sum(1 for one in match.rounds if one.player == player) for player in range(2)]
    winner = PLAYERS[points.index(max(points))]
    lines = [
        (f"{winner} wins, {max(points)} : {min(points)}", 40, "display-bold", "text1"),
        (f"{len(match.rounds)} rounds, every ball but the last by way of another", 17, "medium", "text2"),
    ]
    if title:
        lines.append((title, 20, "display", "accent"))
    opacity = min(max((since - 0.4) / FADE_S, 0.0), 1.0)
    _draw_card(surface, look, lines, opacity, 16.0 * (1.0 - opacity))


def _draw_card(
    surface: pygame.Surface, look: Look, lines: list[tuple[str, int, str, str]], opacity: float, rise: float
) -> None:
    """Lines of words in the middle, on a darkened picture."""
    if opacity <= 0.0:
        return
    veil = pygame.Surface(surface.get_size(), pygame.SRCALPHA, 32)
    scrim = look.theme.scrim
    veil.fill((scrim.r, scrim.g, scrim.b, round(scrim.a * opacity)))
    surface.blit(veil, (0, 0))
    heights = [look.px(1.5 * size) for _, size, _, _ in lines]
    y = 0.5 * surface.get_height() - 0.5 * sum(heights) + rise * look.k
    x = 0.5 * surface.get_width()
    for (words, size, weight, color), height in zip(lines, heights, strict=True):
        text = look.fonts.fit(words, size, weight, surface.get_width() - look.px(64))
        picture = look.fonts.render(text, size, weight, look.color(color, words=True)).copy()
        picture.set_alpha(round(255 * opacity))
        surface.blit(picture, picture.get_rect(center=(round(x), round(y + 0.5 * height))))
        y += height


def row_of_words(size: tuple[int, int], look: Look) -> pygame.Rect:
    """The row at the foot of a picture (px) in which the tally and the caption stand."""
    height = min(look.px(ROW), size[1] // 3)
    return pygame.Rect(0, size[1] - height, size[0], height)


def draw_row(surface: pygame.Surface, look: Look, row: pygame.Rect) -> None:
    """The empty row of words."""
    surface.fill(look.theme.bg, row)
    surface.fill(look.theme.line, (row.x, row.y, row.w, look.border))


def draw_caption(surface: pygame.Surface, look: Look, row: pygame.Rect, act: Act, time: float) -> None:
    """Who plays, and by way of which balls which one is to fall, in the middle of the row."""
    px, theme = look.px, look.theme
    one = act.round
    came = min(max((time - act.begins) / 0.3, 0.0), 1.0)
    left = min(max((act.ends - time) / 0.3, 0.0), 1.0)
    opacity = min(came, left)
    chips = one.fallen.chain if one.fallen.chain else (0, one.fallen.ball)
    words = f"{PLAYERS[one.player]} · round {one.number}"
    under = pocket_words(one.fallen.pocket)
    width = px(96) + max(look.fonts.size(words, 15, "semibold")[0], look.fonts.size(under, 12, "medium")[0])
    width += len(chips) * px(38)
    card = pygame.Surface((width, px(56)), pygame.SRCALPHA, 32)
    draw_box(card, card.get_rect(), px(12), theme.panel, theme.line, look.border)
    draw_disc(card, (px(28), px(28)), px(9), look.color(COLORS[one.player]))
    text_width = look.text(card, words, (px(48), px(20)), 15, "semibold", "text1").w
    text_width = max(text_width, look.text(card, under, (px(48), px(39)), 12, "medium", "text2").w)
    x = px(48) + text_width + px(34)
    down = time >= act.potted
    for place, number in enumerate(chips):
        if place:
            draw_line(card, theme.line2, (x - px(24), px(28)), (x - px(14), px(28)), max(2.0, 1.5 * look.k))
        chip = ball_chip(int(number), 11.0 * look.k, (theme.panel.r, theme.panel.g, theme.panel.b))
        card.blit(chip, chip.get_rect(center=(x, px(28))))
        if down and place == len(chips) - 1:
            draw_disc(card, (x, px(28)), px(14), None, look.color("green"), max(2, px(2)))
        x += px(38)
    card.set_alpha(round(255 * opacity))
    surface.blit(card, card.get_rect(center=row.center).clamp(row))


def draw_tally(
    surface: pygame.Surface, look: Look, row: pygame.Rect, potted: tuple[tuple[int, ...], tuple[int, ...]]
) -> None:
    """The balls of each player, at the ends of the row."""
    px, theme = look.px, look.theme
    for player, balls in enumerate(potted):
        width = px(60) + look.fonts.size(PLAYERS[player], 13, "semibold")[0] + px(24) * len(balls)
        card = pygame.Surface((width, px(36)), pygame.SRCALPHA, 32)
        draw_box(card, card.get_rect(), px(10), theme.panel, theme.line, look.border)
        draw_disc(card, (px(18), px(18)), px(6), look.color(COLORS[player]))
        x = px(32) + look.text(card, PLAYERS[player], (px(32), px(18)), 13, "semibold", "text1").w + px(20)
        for number in balls:
            chip = ball_chip(number, 8.5 * look.k, (theme.panel.r, theme.panel.g, theme.panel.b))
            card.blit(chip, chip.get_rect(center=(x, px(18))))
            x += px(24)
        at = row.x + px(16) if player == 0 else row.right - px(16) - width
        surface.blit(card, (at, row.centery - card.get_height() // 2))
