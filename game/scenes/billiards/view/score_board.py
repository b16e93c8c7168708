"""The score board above the table, and the line below it with the key to the lines on the cloth."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import pygame

from game.scenes.billiards import layout
from game.scenes.billiards.view.standing import Card, Standing
from game.scenes.billiards.view.words import Line
from game.scenes.shared.tables.choices import FIRST, NONE
from game.ui.canvas.canvas import Canvas
from game.ui.look.icons import icon
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box, draw_disc
from game.ui.look.theme import FELT, FELT_COOL, FELT_LINE, FELT_WARM
from game.ui.painters.ball_picture import ball_chip

COLORS = ("amber", "accent")  # of the two players

ON_CLOTH = {"line": FELT_LINE, "cool": FELT_COOL, "warm": FELT_WARM}


class KeyRow(NamedTuple):
    """A line on the cloth and what it means; color: of ON_CLOTH."""

    words: str
    color: str
    dashed: bool


def key_rows(guide: str, shaky: bool) -> tuple[KeyRow, ...]:
    """What the lines of a guide mean. shaky: the hand is unsteady, and a fan shows how much."""
    if guide == NONE:
        return ()
    rows = [KeyRow("cue ball", "line", False)]
    if guide == FIRST:
        rows.append(KeyRow("first ball sets off", "cool", True))
    else:
        rows += [KeyRow("after the hit", "line", True), KeyRow("other balls", "cool", True)]
    if shaky:
        rows.append(KeyRow("your hand, 19 of 20 strokes", "warm", False))
    return tuple(rows)


def draw_board(canvas: Canvas, look: Look, standing: Standing) -> None:
    """Title, cards and score."""
    rect = layout.rect_of(canvas, layout.BOARD)
    if rect.w < 60 or rect.h < 16:
        return
    picture = _board_picture(standing, rect.size, look)
    canvas.surface.blit(picture, rect)


@lru_cache(maxsize=12)
def _board_picture(standing: Standing, size: tuple[int, int], look: Look) -> pygame.Surface:
    """The board as a picture, made again only when it says something else."""
    picture = pygame.Surface(size, pygame.SRCALPHA, 32)
    px, height = look.px, size[1]
    look.text(picture, standing.title, (px(4), 0.5 * height - px(10)), 15, "semibold", "text1")
    look.text(picture, standing.under, (px(4), 0.5 * height + px(10)), 12, "medium", "text3")
    if len(standing.cards) == 1:
        box = pygame.Rect(px(layout.CARD_FROM), 0, size[0] - 2 * px(layout.CARD_FROM), height)
        _draw_card(picture, box, standing.cards[0], 0, look)
        return picture
    width = px(layout.CARD)
    boxes = (
        pygame.Rect(px(layout.CARD_FROM), 0, width, height),
        pygame.Rect(size[0] - px(layout.CARD_FROM) - width, 0, width, height),
    )
    for player, (card, box) in enumerate(zip(standing.cards, boxes, strict=True)):
        _draw_card(picture, box, card, player, look)
    middle = 0.5 * size[0]
    look.text(picture, standing.score, (middle, 0.5 * height - px(8)), 24, "display", "text1", "center")
    look.text(picture, standing.caption, (middle, 0.5 * height + px(17)), 12, "medium", "text3", "center")
    return picture


def _draw_card(picture: pygame.Surface, box: pygame.Rect, card: Card, player: int, look: Look) -> None:
    """One card; the second player's is mirrored."""
    theme, px = look.theme, look.px
    fill, line = (theme.accent_soft, theme.accent) if card.lit else (theme.panel, theme.line)
    draw_box(picture, box, px(8), fill, line, max(2, px(2)) if card.lit else look.border)
    side = 1 if player == 0 else -1
    edge = box.left if player == 0 else box.right
    align = "left" if player == 0 else "right"
    badge = (edge + side * px(26), box.centery)
    draw_disc(picture, badge, px(15), look.color(COLORS[player]))
    ink = theme.ink_on_amber if player == 0 else theme.on_accent
    look.text(picture, card.name[:1], badge, 15, "bold", ink, "center")
    x = edge + side * px(50)
    width = box.w - px(62)
    chips_width = len(card.chips) * px(18)
    if width - chips_width < px(100):
        chips_width = 0
    name = look.fonts.fit(card.name, 15, "semibold", width - chips_width)
    status = look.fonts.fit(card.status, 12, "medium", width - chips_width)
    look.text(picture, name, (x, box.centery - px(10)), 15, "semibold", "text1", align)
    look.text(picture, status, (x, box.centery + px(10)), 12, "medium", "text2", align)
    if not chips_width:
        return
    far = box.right - px(16) if player == 0 else box.left + px(16)
    for place, (number, gone) in enumerate(reversed(card.chips) if player == 0 else card.chips):
        at = (far - side * place * px(18), box.centery)
        if gone:
            draw_disc(picture, at, px(7), None, theme.line2, look.border)
            tick = icon("check", px(10), theme.text3)
            picture.blit(tick, tick.get_rect(center=at))
        else:
            chip = ball_chip(number, max(8.0 * look.k, 2.0), (fill.r, fill.g, fill.b))
            picture.blit(chip, chip.get_rect(center=at))


def draw_line(canvas: Canvas, look: Look, line: Line, key: tuple[KeyRow, ...]) -> None:
    """What was said last, or what to do now; key: what the lines on the cloth mean, at its right."""
    rect = layout.rect_of(canvas, layout.FOOT)
    taken = _draw_key(canvas, look, rect, key) if key else 0
    if not line.lead:
        return
    x = rect.x + look.px(4)
    if line.foul:
        mark = icon("warning", look.px(18), look.color("vermilion"))
        canvas.surface.blit(mark, mark.get_rect(midleft=(x, rect.centery)))
        x += look.px(26)
    width, color = rect.right - x - taken, "vermilion" if line.foul else "text1"
    more = line.more
    lead = look.fonts.fit(line.lead, 14, "medium", width)
    if lead != line.lead and not more:  # too long for one line: broken in two
        lead, *rest = look.fonts.wrap(line.lead, 14, "medium", width)
        more = " ".join(rest)
    if not more:
        look.text(canvas.surface, lead, (x, rect.centery), 14, "medium", color)
        return
    taken = look.fonts.size(lead, 14, "medium")[0] + look.px(10)
    if look.fonts.fit(more, 12, "medium", width - taken) == more:  # beside it
        look.text(canvas.surface, lead, (x, rect.centery), 14, "medium", color)
        look.text(canvas.surface, more, (x + taken, rect.centery + look.px(1)), 12, "medium", "text2")
        return
    if rect.h < look.fonts.line_height(12) + look.fonts.line_height(11) - look.px(8):  # no space for two
        look.text(canvas.surface, lead, (x, rect.centery), 14, "medium", color)
        more = look.fonts.fit(more, 12, "medium", width - taken)
        look.text(canvas.surface, more, (x + taken, rect.centery), 12, "medium", "text2")
        return
    lead = look.fonts.fit(line.lead if more == line.more else lead, 12, "semibold", width)
    look.text(canvas.surface, lead, (x, rect.centery - look.px(7)), 12, "semibold", color)
    more = look.fonts.fit(more, 11, "medium", width)
    look.text(canvas.surface, more, (x, rect.centery + look.px(7)), 11, "medium", "text2")


def _draw_key(canvas: Canvas, look: Look, rect: pygame.Rect, key: tuple[KeyRow, ...]) -> int:
    """What the lines on the cloth mean, at the right end of the row; the width it takes, px."""
    picture = _key_picture(key, min(rect.h, look.px(26)), look)
    canvas.surface.blit(picture, picture.get_rect(midright=rect.midright))
    return picture.get_width() + look.px(18)


@lru_cache(maxsize=8)
def _key_picture(key: tuple[KeyRow, ...], height: int, look: Look) -> pygame.Surface:
    """The words and samples of the lines, on a piece of cloth, where they look as they do on the table."""
    gap, sample, edge = look.px(16), look.px(24) + look.px(8), look.px(12)
    widths = [look.fonts.size(row.words, 12, "medium")[0] + sample for row in key]
    width = sum(widths) + gap * (len(key) - 1) + 2 * edge
    picture = pygame.Surface((width, max(height, 1)), pygame.SRCALPHA, 32)
    draw_box(picture, picture.get_rect(), look.px(8), FELT)
    x, middle = edge, height // 2
    for row, wide in zip(key, widths, strict=True):
        for k in range(3 if row.dashed else 1):
            box = pygame.Rect(
                x + k * look.px(9), middle - 1, look.px(6 if row.dashed else 24), max(2, look.px(2))
            )
            draw_box(picture, box, 0, ON_CLOTH[row.color])
        look.text(picture, row.words, (x + sample, middle), 12, "medium", FELT_LINE)
        x += wide + gap
    return picture
