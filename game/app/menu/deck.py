"""Cards and rows as they lie: each painted once and then copied, a few of them in a frame.

A card that comes into view for the first time shows its empty stage until its turn comes.
"""

from __future__ import annotations

from collections import OrderedDict
from time import thread_time

import pygame

from game.app.menu import cards
from game.app.menu.contents import Item
from game.app.menu.sketch import sketch
from game.app.menu.thumbnails import Thumbnails
from game.app.screens.host import Host
from game.app.window.guard import Failure
from game.ui.look.look import Look

MOST_KEPT = 160  # cards and rows
SPENT_S = 0.003  # s of the drawing thread after which a frame begins no other card

Place = tuple[str, int, int]  # scene, width, height of the picture


class Deck:
    """``begin`` once before the menu is painted; ``unfinished``: a card waits for its picture."""

    def __init__(self, host: Host, thumbnails: Thumbnails) -> None:
        self._host = host
        self._thumbnails = thumbnails
        self._faces: OrderedDict[tuple[object, ...], tuple[pygame.Surface, pygame.Surface]] = OrderedDict()
        self._drawings: dict[Place, pygame.Surface] = {}
        self._began = 0.0
        self.unfinished = False

    def clear(self) -> None:
        """Another theme or scale: paint all of them again."""
        self._faces.clear()
        self._drawings.clear()

    def begin(self) -> None:
        """A frame begins."""
        self._began, self.unfinished = thread_time(), False

    @property
    def _spent(self) -> bool:
        """Whether this frame has had its share."""
        return thread_time() - self._began > SPENT_S

    def draw(self, surface: pygame.Surface, item: Item, starred: bool, at: tuple[int, int]) -> None:
        """Draw a resting card or row with its left upper corner there."""
        look = self._host.look
        key = (item.key[1:], item.rect.size, starred)
        kept = self._faces.get(key)
        if kept is None and self._spent:
            self.unfinished = True
            cards.paint_empty(surface, look, pygame.Rect(at, item.rect.size))
            return
        picture = self._empty((1, 1)) if item.card is None else self.picture(item)
        if kept is None or kept[0] is not picture:
            kept = self._faces[key] = (picture, self._face(item, picture, starred))
        self._faces.move_to_end(key)
        while len(self._faces) > MOST_KEPT:
            self._faces.popitem(last=False)
        reach = 0 if item.card is None else cards.reach(look)
        surface.blit(kept[1], (at[0] - reach, at[1] - reach))

    def _face(self, item: Item, picture: pygame.Surface, starred: bool) -> pygame.Surface:
        look = self._host.look
        if item.card is not None:
            return cards.face(look, item.card, item.entry, picture, starred)
        row = pygame.Surface(item.rect.size, 0, 32)
        row.fill(look.theme.bg)
        paint_row(row, look, item, row.get_rect(), lit=False)
        return row

    def picture(self, item: Item) -> pygame.Surface:
        """The scene's picture in its card's size: as it was drawn, else its drawing, else its empty stage."""
        assert item.card is not None
        size = item.card.picture.size
        place = (item.entry.name, *size)
        picture = self._thumbnails.kept(item.entry.name, size, self._host.look) or self._drawings.get(place)
        if picture is not None:
            return picture
        if self._spent:
            self.unfinished = True
            return self._empty(size)
        loaded = self._thumbnails.load(item.entry.name, size, self._host.look)
        if loaded is not None:
            return loaded
        drawing = self._drawings[place] = self._drawing(item, size)
        return drawing

    def _drawing(self, item: Item, size: tuple[int, int]) -> pygame.Surface:
        with self._host.guard.over(f"The drawing of {item.entry.title}", self._tell_undrawn):
            return sketch(item.entry, size, self._host.look)
        return self._empty(size)

    def _empty(self, size: tuple[int, int]) -> pygame.Surface:
        place = ("", *size)
        if place not in self._drawings:
            self._drawings[place] = pygame.Surface(size, 0, 32)
            self._drawings[place].fill(self._host.look.theme.stage)
        return self._drawings[place]

    def _tell_undrawn(self, failure: Failure) -> None:
        self._host.tell_of(failure, "cannot be shown")


def paint_row(surface: pygame.Surface, look: Look, item: Item, rect: pygame.Rect, lit: bool) -> None:
    """A level's row at its place; nothing for a card."""
    head = item.level
    if head is not None:
        title = f"{head.title}  {head.stars}".rstrip()
        cards.paint_row(surface, look, rect, item.entry.task, title, head.about, bool(head.hard_case), lit)
