"""The menu's picture: cards and headings between the header and the foot, the chosen one over them."""

from __future__ import annotations

from typing import NamedTuple

import pygame

from game.app.menu import cards
from game.app.menu.bar import CategoryBar
from game.app.menu.contents import Contents, Item
from game.app.menu.deck import Deck, paint_row
from game.app.menu.foot import paint_foot
from game.app.menu.items import LEVELS
from game.app.menu.scroll import Scroll
from game.app.menu.thumbnails import Thumbnails
from game.app.screens.host import Host


class Shown(NamedTuple):
    """What a picture of the menu depends on."""

    view: pygame.Rect  # of the window, between bar and foot
    down: int  # from a place in the content to one in the window, px
    contents: Contents
    seen: list[int]  # of the items those in view
    focus: int  # the chosen one of the items
    query: str
    words: str  # at the foot's right


class Painter:
    """Keeps what rests: the whole picture until ``forget``, the foot until its words change."""

    def __init__(self, host: Host, thumbnails: Thumbnails, bar: CategoryBar, scroll: Scroll) -> None:
        self._host, self._bar, self._scroll = host, bar, scroll
        self._deck = Deck(host, thumbnails)
        self._picture: pygame.Surface | None = None
        self._valid = False
        self.painted = 0  # times
        self._foot: tuple[object, pygame.Surface] | None = None

    @property
    def unfinished(self) -> bool:
        """A card waits for its picture."""
        return self._deck.unfinished

    def restyle(self) -> None:
        """Another theme, scale or size."""
        self._deck.clear()
        self._foot = None
        self._valid = False

    def forget(self) -> None:
        """Something has changed: paint anew."""
        self._valid = False

    def draw(self, surface: pygame.Surface, menu: Shown, lift: float) -> None:
        """Draw the menu, whose chosen item is lifted so far, 0 to 1."""
        if self._picture is None or self._picture.get_size() != surface.get_size():
            self._picture, self._valid = pygame.Surface(surface.get_size(), 0, 32), False
        if not self._valid:
            self._valid = True
            self.painted += 1
            self._paint(self._picture, menu)
        surface.blit(self._picture, (0, 0))
        surface.set_clip(menu.view)
        if menu.focus in menu.seen:
            self._draw_focused(surface, menu.contents.items[menu.focus], menu.down, lift)
        self._scroll.draw(surface, self._host.look)
        surface.set_clip(None)

    def _draw_focused(self, surface: pygame.Surface, item: Item, down: int, lift: float) -> None:
        look = self._host.look
        if item.card is not None:
            picture = self._deck.picture(item)
            starred = self._starred(item)
            cards.paint_focused(surface, look, item.card, item.entry, picture, starred, lift, down)
        else:
            paint_row(surface, look, item, item.rect.move(0, down), lit=True)
            cards.draw_ring(surface, look, item.rect.move(0, down), 8)

    def _starred(self, item: Item) -> bool:
        return item.entry.name in self._host.settings.favourites

    def _paint(self, picture: pygame.Surface, menu: Shown) -> None:
        """Everything but the chosen item and the header."""
        look, view, size = self._host.look, menu.view, picture.get_size()
        picture.fill(look.theme.bg)
        self._deck.begin()
        picture.set_clip(view)
        self._paint_heads(picture, menu)
        for i in menu.seen:
            item = menu.contents.items[i]
            if i != menu.focus:
                place = item.rect.move(0, menu.down)
                self._deck.draw(picture, item, self._starred(item), place.topleft)
        if not menu.contents.items:
            words = f"Nothing is called “{menu.query}”"
            look.text(picture, words, view.center, 13, "medium", "text2", "center")
        picture.set_clip(None)
        self._bar.draw(picture, look)
        if self._scroll.offset > 0:
            picture.fill(look.theme.line, (0, view.y - look.border, size[0], look.border))
        picture.blit(self._painted_foot(menu, size), (0, view.bottom))

    def _paint_heads(self, picture: pygame.Surface, menu: Shown) -> None:
        look, px = self._host.look, self._host.look.px
        for head in menu.contents.heads:
            x, y = head.at[0], head.at[1] + menu.down
            if not menu.view.top - px(20) < y < menu.view.bottom + px(20):
                continue
            if head.category not in ("", head.text, LEVELS):
                x += look.text(picture, head.category, (x, y), 13, "medium", "text3").w + px(6)
                x += look.text(picture, "·", (x, y), 13, "medium", "text3").w + px(6)
            x += look.text(picture, head.text, (x, y), 13, "semibold", "text1").w + px(8)
            look.text(picture, str(head.number), (x, y), 12, "medium", "text3")

    def _painted_foot(self, menu: Shown, size: tuple[int, int]) -> pygame.Surface:
        words, searching = menu.words, bool(menu.query)
        state = (words, searching, size, self._host.look.theme.name, self._host.look.k)
        if self._foot is None or self._foot[0] != state:
            foot = pygame.Surface((size[0], max(1, size[1] - menu.view.bottom)), 0, 32)
            paint_foot(foot, self._host, foot.get_rect(), searching, words)
            self._foot = (state, foot)
        return self._foot[1]
