"""What the menu shows and where: cards under their headings, levels in rows, by category."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import pygame

from game.app.menu import flow
from game.app.menu.items import FAVOURITES, LEVELS, RECENT, Found, Offer
from game.app.stagehand.level_index import LevelHead
from game.app.window.settings import Settings
from game.stage.catalogue import Entry
from game.ui.look.look import Look

LEVELS_SHOWN = 60  # of those found; more is no list to read
SCENES = "Scenes"  # the category of those found

Key = tuple[str, str, object]


class Item(NamedTuple):
    """Something that can be chosen: a scene's card or a level's row; its place in the content, window px."""

    rect: pygame.Rect
    entry: Entry
    category: str
    card: flow.Card | None = None
    level: LevelHead | None = None

    @property
    def key(self) -> Key:
        """What makes it the same in another layout."""
        return self.category, self.entry.name, self.level.path if self.level else None


class Contents(NamedTuple):
    """Everything in the content, its height in window px, and its categories in their order."""

    items: tuple[Item, ...]
    heads: tuple[flow.Head, ...]
    height: int

    @property
    def categories(self) -> tuple[str, ...]:
        """Each once, from the top."""
        return tuple(dict.fromkeys(item.category for item in self.items))

    def first_of(self, category: str) -> int | None:
        """Index of the first item of a category."""
        return next((i for i, item in enumerate(self.items) if item.category == category), None)

    def has(self, key: Key) -> bool:
        """Whether that item is among them."""
        return any(item.key == key for item in self.items)

    def find(self, key: Key | None, name: str) -> int:
        """Index of that item; else of the scene's card in its own category; else 0."""
        keys = [item.key for item in self.items]
        if key in keys:
            return keys.index(key)
        cards = [i for i, item in enumerate(self.items) if item.entry.name == name and item.card is not None]
        own = [i for i in cards if self.items[i].category not in (FAVOURITES, RECENT)]
        return (own or cards or [0])[0]


def lay_out(offer: Offer, query: str, settings: Settings, size: tuple[int, int], look: Look) -> Contents:
    """Everything that is offered, or what a query finds, in a view of that size, window px."""
    found = offer.find(query) if query else None
    groups = offer.groups(settings.favourites, settings.recent) if found is None else _groups_of(found)
    arranged = flow.arrange_cards(groups, "" if query else offer.wide, *size, look.k)
    cards = tuple(
        Item(c.rect, offer.entry_in(c.category, c.name), c.category, card=c) for c in arranged.cards
    )
    contents = Contents(cards, arranged.heads, arranged.height)
    levels = offer.levels if found is None else found.levels[:LEVELS_SHOWN]
    number = len(levels) if found is None else len(found.levels)
    return _with_levels(contents, offer, levels, number, size[0], look) if levels else contents


def _groups_of(found: Found) -> list[flow.Group]:
    names = tuple(entry.name for entry in found.scenes)
    return [flow.Group(SCENES, names, SCENES)] if names else []


def _with_levels(
    contents: Contents, offer: Offer, levels: Sequence[LevelHead], number: int, width: int, look: Look
) -> Contents:
    """Rows of levels under the cards; ``number``: how many there are."""
    top = contents.height
    head = flow.Head("Levels and hard cases", number, (look.px(flow.MARGIN), top + look.px(12)), LEVELS)
    rects = flow.arrange_rows(len(levels), top + look.px(flow.HEAD), width, look.k)
    rows = tuple(
        Item(rect, offer.catalogue[level.scene], LEVELS, level=level)
        for rect, level in zip(rects, levels, strict=True)
    )
    height = rects[-1].bottom + look.px(flow.ROW_GAP)
    return Contents(contents.items + rows, (*contents.heads, head), height)
