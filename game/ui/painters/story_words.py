"""The words of a story over its picture: captions at the foot, cards over all of it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import lru_cache

import pygame

from game.ui.look.fonts import FontBook
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box

SIZE, LEADING = 21, 1.36  # design px, of a caption's letters; times that from line to line
WIDEST = 0.74  # of the picture's width
ROW = (18, 10)  # design px about a caption's words
EDGE = 0.045  # of the picture's height from a caption to its edge
FADE_S = 0.25
CARD_FADE_S = 0.6
LIGHT_VEIL = 178  # of 255, over the picture behind a card of dark words

AFTER_A_NUMBER = re.compile(r"(?<=\d) (?=\S)")  # a line does not end there: a unit follows
UNBROKEN = "\u00a0"  # a space at which no line ends

CardLine = tuple[str, int, str, str]  # words, size in design px, weight, colour


def opacity_at(time: float, begins: float, ends: float, fade_s: float = FADE_S) -> float:
    """How far words have come, 0 to 1, that stand from one moment to another, s."""
    return min(max(min((time - begins) / fade_s, (ends - time) / fade_s), 0.0), 1.0)


def caption_rect(look: Look, rect: pygame.Rect, text: str, above: bool = False) -> pygame.Rect:
    """Where a caption lies in a picture: at its foot, or ``above``; px."""
    lines = _lines(look, rect, text)
    width = max(look.fonts.size(line, SIZE, "semibold")[0] for line in lines) + 2 * look.px(ROW[0])
    height = round(len(lines) * SIZE * LEADING * look.k) + 2 * look.px(ROW[1])
    place = pygame.Rect(0, 0, width, height)
    edge = round(EDGE * rect.h)
    if above:
        place.midtop = (rect.centerx, rect.y + edge)
    else:
        place.midbottom = (rect.centerx, rect.bottom - edge)
    return place


def draw_caption(
    surface: pygame.Surface, look: Look, rect: pygame.Rect, text: str, opacity: float, above: bool = False
) -> None:
    """A caption in a picture's rectangle, on a ground of its own."""
    if opacity <= 0.0 or not text:
        return
    place = caption_rect(look, rect, text, above)
    theme = look.theme
    card = pygame.Surface(place.size, pygame.SRCALPHA, 32)
    draw_box(
        card, card.get_rect(), look.px(12), pygame.Color(theme.panel.r, theme.panel.g, theme.panel.b, 226)
    )
    y = look.px(ROW[1]) + 0.5 * SIZE * LEADING * look.k
    for line in _lines(look, rect, text):
        look.text(card, line, (place.w // 2, round(y)), SIZE, "semibold", "text1", "center")
        y += SIZE * LEADING * look.k
    card.set_alpha(round(255 * opacity))
    surface.blit(card, place)


def _lines(look: Look, rect: pygame.Rect, text: str) -> list[str]:
    return _even_lines(look.fonts, look.k, text, round(WIDEST * rect.w))


@lru_cache(maxsize=64)
def _even_lines(fonts: FontBook, scale: float, text: str, widest: int) -> list[str]:
    """As few lines as ``widest`` px allow, each about as long as the others: no word stands alone below,
    and no unit is parted from its number.

    scale: of the fonts; with another one the same words are wider.
    """
    text = AFTER_A_NUMBER.sub(UNBROKEN, text)
    lines = fonts.wrap(text, SIZE, "semibold", widest) or [""]
    narrow, wide = widest // len(lines), widest
    while wide - narrow > 1:
        middle = (narrow + wide) // 2
        fewer = fonts.wrap(text, SIZE, "semibold", middle)
        if len(fewer) <= len(lines):
            lines, wide = fewer or lines, middle
        else:
            narrow = middle
    return lines


def draw_card(
    surface: pygame.Surface, look: Look, rect: pygame.Rect, lines: Sequence[CardLine], opacity: float,
    rise: float = 0.0,
) -> None:  # fmt: skip
    """Lines of words in the middle of a rectangle, on a picture that a veil covers: a dark one, or a light
    one where words are dark. ``rise``: design px downwards.
    """
    if opacity <= 0.0:
        return
    scrim, stage = look.theme.scrim, look.theme.stage
    dark_words = stage.r + stage.g + stage.b > 384
    ink, most = (stage, LIGHT_VEIL) if dark_words else (scrim, scrim.a)
    veil = pygame.Surface(rect.size, pygame.SRCALPHA, 32)
    veil.fill((ink.r, ink.g, ink.b, round(most * opacity)))
    surface.blit(veil, rect)
    rows = [
        (part, size, weight, color)
        for words, size, weight, color in lines
        for part in look.fonts.wrap(words, size, weight, rect.w - look.px(64))
    ]
    heights = [look.px(1.5 * size) for _, size, _, _ in rows]
    y = rect.centery - 0.5 * sum(heights) + rise * look.k
    for (words, size, weight, color), height in zip(rows, heights, strict=True):
        picture = look.fonts.render(words, size, weight, look.color(color, words=True)).copy()
        picture.set_alpha(round(255 * opacity))
        surface.blit(picture, picture.get_rect(center=(rect.centerx, round(y + 0.5 * height))))
        y += height
