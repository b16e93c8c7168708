"""Painting of the menu's cards and rows: a picture with round corners, a rule, a title, an id and a fact."""

from __future__ import annotations

from functools import lru_cache

import pygame

from game.app.menu.flow import GAP, Card, star_of
from game.stage.catalogue import Entry
from game.ui.look.icons import icon
from game.ui.look.look import Look
from game.ui.look.shapes import box, draw_box, draw_disc, draw_shadow

RADIUS = 12
LIFT = 2


def round_corners(picture: pygame.Surface, look: Look, below: int) -> pygame.Surface:
    """A copy with the card's round corners; ``below`` px of card follow under the picture."""
    size = picture.get_size()
    rounded = pygame.Surface(size, pygame.SRCALPHA, 32)
    rounded.blit(picture, (0, 0))
    mask = box((size[0], size[1] + below), look.px(RADIUS), pygame.Color(255, 255, 255))
    rounded.blit(mask, (0, 0), special_flags=pygame.BLEND_RGBA_MULT)
    return rounded


def reach(look: Look) -> int:
    """How far a card's shadow reaches beyond it, window px."""
    return look.px(GAP / 2)


def face(look: Look, card: Card, entry: Entry, picture: pygame.Surface, starred: bool) -> pygame.Surface:
    """A resting card with its shadow on the menu's ground, ``reach`` px larger on every side."""
    margin = reach(look)
    surface = pygame.Surface((card.rect.w + 2 * margin, card.rect.h + 2 * margin), 0, 32)
    surface.fill(look.theme.bg)
    paint_card(surface, look, card, entry, picture, starred, (margin, margin))
    return surface


def paint_empty(surface: pygame.Surface, look: Look, rect: pygame.Rect) -> None:
    """A card or a row without anything on it."""
    draw_box(surface, rect, look.px(RADIUS), look.theme.panel, look.theme.line, look.border)


def paint_card(
    surface: pygame.Surface,
    look: Look,
    card: Card,
    entry: Entry,
    picture: pygame.Surface,
    starred: bool,
    at: tuple[int, int],
) -> pygame.Rect:
    """Draw a whole card with its left upper corner there; where it is."""
    rect = pygame.Rect(at, card.rect.size)
    draw_shadow(surface, rect, 2.5 * look.k, 2 * look.k, 0.25)
    draw_box(surface, rect, look.px(RADIUS), look.theme.panel)
    surface.blit(round_corners(picture, look, card.rect.h - card.picture.h), rect)
    if card.wide:
        _paint_wide_words(surface, look, rect, entry)
    else:
        _paint_words(surface, look, rect, card.picture.h, entry)
    draw_box(surface, rect, look.px(RADIUS), None, look.theme.line, look.border)
    if starred:
        _paint_star(surface, look, rect, True)
    return rect


def _paint_star(surface: pygame.Surface, look: Look, rect: pygame.Rect, full: bool) -> None:
    """A card's star on a disc that keeps it legible over any picture."""
    center = star_of(rect, look.k).center
    draw_disc(surface, center, look.px(13), look.theme.panel, look.theme.line2, look.border)
    color = look.theme.accent if full else look.theme.text2
    sign = icon("star-full" if full else "star", look.px(18), color)
    surface.blit(sign, sign.get_rect(center=center))


def _paint_words(
    surface: pygame.Surface, look: Look, rect: pygame.Rect, picture_height: int, entry: Entry
) -> None:
    theme, px = look.theme, look.px
    surface.fill(theme.line, (rect.x + 1, rect.y + picture_height, rect.w - 2, look.border))
    x, space = rect.x + px(12), rect.w - 2 * px(12)
    title = look.fonts.fit(entry.title, 13, "semibold", space)
    look.text(surface, title, (x, rect.y + picture_height + px(20)), 13, "semibold", "text1")
    y = rect.y + picture_height + px(39)
    used = look.text(surface, entry.task, (x, y), 11, "semibold", "accent").w + px(7)
    look.text(
        surface, look.fonts.fit(entry.fact, 11, "medium", space - used), (x + used, y), 11, "medium", "text3"
    )


def _paint_wide_words(surface: pygame.Surface, look: Look, rect: pygame.Rect, entry: Entry) -> None:
    """Title and fact in the picture itself, on its darkened foot, and a button that says: play."""
    px = look.px
    foot = _shade((rect.w, min(px(96), rect.h)))
    surface.blit(round_corners_below(foot, look), (rect.x, rect.bottom - foot.get_height()))
    light = pygame.Color("#ECE8DE")
    look.text(surface, entry.title, (rect.x + px(16), rect.bottom - px(44)), 20, "display", light)
    space = rect.w - px(16 + 64)
    look.text(
        surface,
        look.fonts.fit(entry.fact, 12, "medium", space),
        (rect.x + px(16), rect.bottom - px(21)),
        12,
        "medium",
        light,
    )
    center = (rect.right - px(32), rect.bottom - px(32))
    blue = pygame.Color("#5FBAF9")
    draw_disc(surface, center, px(18), blue)
    sign = icon("play", px(18), pygame.Color("#0B1216"))
    surface.blit(sign, sign.get_rect(center=(center[0] + px(1), center[1])))


def round_corners_below(picture: pygame.Surface, look: Look) -> pygame.Surface:
    """A copy with round lower corners."""
    width, height = picture.get_size()
    rounded = picture.copy()
    mask = box((width, height + look.px(RADIUS)), look.px(RADIUS), pygame.Color(255, 255, 255))
    rounded.blit(mask, (0, -look.px(RADIUS)), special_flags=pygame.BLEND_RGBA_MULT)
    return rounded


@lru_cache(maxsize=8)
def _shade(size: tuple[int, int]) -> pygame.Surface:
    """A veil that darkens towards its foot."""
    shade = pygame.Surface(size, pygame.SRCALPHA, 32)
    for y in range(size[1]):
        t = y / max(size[1] - 1, 1)
        shade.fill((5, 20, 18, round(200 * t * t * (3.0 - 2.0 * t))), (0, y, size[0], 1))
    return shade


def paint_focused(
    surface: pygame.Surface,
    look: Look,
    card: Card,
    entry: Entry,
    picture: pygame.Surface,
    starred: bool,
    lift: float,
    top: int,
) -> None:
    """The card under the pointer or the keyboard focus: lifted, with a ring and a star to be pressed.

    ``top``: from a place in the content to one in the window, px.
    """
    rect = card.rect.move(0, top - round(LIFT * look.k * lift))
    draw_shadow(surface, rect, 7 * look.k, 8 * look.k, 0.45 * lift)
    paint_card(surface, look, card, entry, picture, starred, rect.topleft)
    if not starred:
        _paint_star(surface, look, rect, False)
    draw_ring(surface, look, rect, RADIUS)


def draw_ring(surface: pygame.Surface, look: Look, rect: pygame.Rect, radius: int) -> None:
    """The focus ring: 2 px wide at 3 px distance (design px)."""
    width = max(2, look.px(2))
    reach = look.px(1) + width
    ring = rect.inflate(2 * reach, 2 * reach)
    draw_box(surface, ring, look.px(radius) + reach, None, look.theme.accent, width)


def paint_row(
    surface: pygame.Surface,
    look: Look,
    rect: pygame.Rect,
    scene_id: str,
    title: str,
    about: str,
    hard: bool,
    lit: bool,
) -> None:
    """A level in a list: id of its scene, title, and what it is about."""
    px, theme = look.px, look.theme
    draw_box(surface, rect, look.px(8), theme.hover if lit else theme.panel, theme.line, look.border)
    words = look.fonts.size(scene_id, 11, "semibold")[0]
    chip = pygame.Rect(rect.x + px(8), 0, words + 2 * px(6), px(20))
    chip.centery = rect.centery
    draw_box(surface, chip, px(5), theme.accent_soft)
    look.text(surface, scene_id, chip.center, 11, "semibold", "accent", "center")
    x, right = chip.right + px(10), rect.right - px(10)
    if hard:
        draw_disc(surface, (x + px(3), rect.centery), px(3), look.color("amber"))
        x += px(12)
    title = look.fonts.fit(title, 13, "medium", right - x)
    x += look.text(surface, title, (x, rect.centery), 13, "medium", "text1").w + px(10)
    about = look.fonts.fit(about, 11, "medium", max(0, right - x))
    if len(about) > 3:
        look.text(surface, about, (x, rect.centery), 11, "medium", "text3")
