"""The menu screen: header with the search field, cards, levels found, hints at the foot."""

from __future__ import annotations

from typing import ClassVar, NamedTuple

import pygame

from game.app.menu import cards, flow
from game.app.menu.background import Background
from game.app.menu.foot import paint_foot
from game.app.menu.header import Header
from game.app.menu.items import Offer
from game.app.menu.sketch import sketch
from game.app.screens.host import Host
from game.app.screens.screen import Screen
from game.app.stagehand.level_index import LevelHead
from game.app.window.commands import Actions
from game.app.window.guard import Failure
from game.stage.catalogue import Entry
from game.ui.look.motion import LIFT_S, Fade

ARROWS = {pygame.K_LEFT: (-1, 0), pygame.K_RIGHT: (1, 0), pygame.K_UP: (0, -1), pygame.K_DOWN: (0, 1)}
LEVELS_SHOWN = 60  # of those found; more is no list to read
WHEEL = 60  # design px for a notch


class Item(NamedTuple):
    """Something that can be chosen: a scene's card or a level's row; its place in the content, window px."""

    rect: pygame.Rect
    entry: Entry
    card: flow.Card | None = None
    level: LevelHead | None = None


class MenuScreen(Screen):
    """All scenes; opens one."""

    called: ClassVar[str] = "The menu"

    def __init__(self, host: Host, focus: str = ""):
        super().__init__(host)
        self.offer = Offer(host.catalogue)
        self.header = Header(host)
        self.background = Background(host)
        self.thumbnails = self.background.thumbnails
        self.query = ""
        self.items: list[Item] = []
        self.focus = 0
        self._heads: tuple[flow.Head, ...] = ()
        self._scroll = 0
        self._content_height = 0
        self._lift = Fade(LIFT_S)
        self._picture: pygame.Surface | None = None
        self._wanted_focus = focus
        self.restyle()

    # -- layout -------------------------------------------------------------------------------------

    def restyle(self) -> None:
        look, (width, height) = self.host.look, self.host.size
        self._top = look.px(flow.HEADER)
        self._bottom = max(self._top + 1, height - look.px(flow.FOOTER))
        self.header.place(pygame.Rect(0, 0, width, self._top), look)
        self.header.prompt = f"Type to search {_count(len(self.offer.catalogue), 'scene')}"
        if self.offer.levels:
            self.header.prompt += f" and {_count(len(self.offer.levels), 'level')}"
        self._lay_out()

    def _lay_out(self) -> None:
        """Places of everything in the content, whose upper end is the header's foot."""
        before = self._focused_key() or (self._wanted_focus, None)
        found = self.offer.find(self.query) if self.query else None
        if found is None:
            groups = self.offer.groups()
        else:
            groups = [flow.Group("Scenes", tuple(e.name for e in found.scenes))] if found.scenes else []
        look, (width, _) = self.host.look, self.host.size
        space = self._bottom - self._top
        arranged = flow.arrange_cards(groups, "" if self.query else self.offer.wide, width, space, look.k)
        self._heads = arranged.heads
        self.items = [Item(card.rect, self.offer.catalogue[card.name], card) for card in arranged.cards]
        self._content_height = arranged.height
        levels = list(found.levels if found else self.offer.levels)
        self._add_levels(levels[:LEVELS_SHOWN], len(levels), space, width)
        keys = [self._key(item) for item in self.items]
        self.focus = keys.index(before) if before in keys and not self.query else 0
        self._scroll = 0
        self._show_focus()
        self._picture = None

    def _add_levels(self, levels: list[LevelHead], count: int, space: int, width: int) -> None:
        """Rows of levels under the cards: all that were found; without a search what there is space for."""
        look = self.host.look
        top = self._content_height + look.px(flow.HEAD)
        if not self.query:
            lines = (space - top) // look.px(flow.LIST_ROW)
            while levels and (len(levels) > 0) and lines < 1:
                levels = []
            per_line = sum(1 for r in flow.arrange_rows(8, 0, width, look.k) if r.y == 0)
            levels = levels[: max(lines, 0) * per_line]
        if not levels:
            return
        at = (look.px(flow.MARGIN), self._content_height + look.px(12))
        self._heads = (*self._heads, flow.Head("Levels and hard cases", count, at))
        rects = flow.arrange_rows(len(levels), top, width, look.k)
        for rect, head in zip(rects, levels, strict=True):
            self.items.append(Item(rect, self.offer.catalogue[head.scene], level=head))
        self._content_height = rects[-1].bottom + look.px(flow.ROW_GAP)

    def _key(self, item: Item) -> tuple[str, object]:
        return item.entry.name, item.level.path if item.level else None

    def _focused_key(self) -> tuple[str, object] | None:
        return self._key(self.items[self.focus]) if self.focus < len(self.items) else None

    def _show_focus(self) -> None:
        """Scroll as little as brings the chosen item wholly into view."""
        most = max(0, self._content_height - (self._bottom - self._top))
        if self.focus < len(self.items):
            rect, head = self.items[self.focus].rect, self.host.look.px(flow.HEAD)
            lowest = rect.bottom + self.host.look.px(flow.ROW_GAP) - (self._bottom - self._top)
            self._scroll = min(max(self._scroll, lowest), rect.top - head)
        self._set_scroll(min(max(self._scroll, 0), most))

    def _set_scroll(self, scroll: int) -> None:
        most = max(0, self._content_height - (self._bottom - self._top))
        scroll = min(max(scroll, 0), most)
        if scroll != self._scroll:
            self._picture = None
        self._scroll = scroll

    # -- events -------------------------------------------------------------------------------------

    @property
    def actions(self) -> Actions:
        """Without ``menu``: it is left by closing the window."""
        return {"back": lambda: self._search(""), "help": self.host.open_keys}

    def handle(self, event: pygame.Event) -> None:
        wish = self.header.handle(event)
        if wish == "clear":
            self._search("")
        elif wish is not None:
            self.host.perform(wish)
        elif event.type == pygame.TEXTINPUT:
            self._search(self.query + "".join(c for c in event.text if c.isprintable()))
        elif event.type == pygame.KEYDOWN:
            self._press(event)
        elif event.type == pygame.MOUSEMOTION:
            self._point(event.pos)
        elif event.type == pygame.MOUSEWHEEL:
            self._set_scroll(self._scroll - round(event.y * self.host.look.px(WHEEL)))
        elif event.type == pygame.MOUSEBUTTONUP and event.button == 1:
            index = self._at(event.pos)
            if index is not None:
                self._choose(index)
                self._open()

    def _press(self, event: pygame.Event) -> None:
        if event.key in ARROWS and self.items:
            rects = [item.rect for item in self.items]
            self._choose(flow.nearest_in_direction(rects, self.focus, *ARROWS[event.key]))
            self._show_focus()
        elif event.key in (pygame.K_RETURN, pygame.K_KP_ENTER):
            self._open()
        elif event.key == pygame.K_BACKSPACE and self.query:
            self._search("" if event.mod & pygame.KMOD_CTRL else self.query[:-1])
        elif event.key in (pygame.K_HOME, pygame.K_END) and self.items:
            self._choose(0 if event.key == pygame.K_HOME else len(self.items) - 1)
            self._show_focus()

    def _search(self, query: str) -> None:
        query = query.lstrip()[:40]
        if query != self.query:
            self.query = self.header.query = query
            self._lay_out()

    def _at(self, position: tuple[int, int]) -> int | None:
        """Index of the item under a pixel."""
        x, y = position
        if not self._top <= y < self._bottom:
            return None
        content = (x, y - self._top + self._scroll)
        return next((i for i, item in enumerate(self.items) if item.rect.collidepoint(content)), None)

    def _point(self, position: tuple[int, int]) -> None:
        index = self._at(position)
        if index is not None:
            self._choose(index)

    def _choose(self, index: int) -> None:
        if index != self.focus:
            self.focus = index
            self._lift = Fade(0.0 if self.host.look.less_motion else LIFT_S)
            self._picture = None

    def _open(self) -> None:
        if self.focus < len(self.items):
            item = self.items[self.focus]
            self.host.open_scene(item.entry.name, level=item.level.path if item.level else None)

    # -- life ---------------------------------------------------------------------------------------

    def uncovered(self) -> None:
        self.thumbnails.wake()
        self._picture = None

    def closed(self) -> None:
        self.background.close()

    def update(self, elapsed_s: float) -> None:
        self.header.update(elapsed_s)
        if self.background.update(elapsed_s):
            self._picture = None
        self._lift.update(elapsed_s, True)
        live = self.items[self.focus] if self.focus < len(self.items) else None
        name = live.entry.name if live is not None and live.card is not None else ""
        sizes = {item.entry.name: item.card.picture.size for item in self.items if item.card is not None}
        still = self.host.look.less_motion
        if self.thumbnails.update(elapsed_s, sizes, self.host.look, "" if still else name):
            self._picture = None

    # -- picture ------------------------------------------------------------------------------------

    def draw(self, surface: pygame.Surface) -> None:
        if self._picture is None or self._picture.get_size() != surface.get_size():
            self._picture = self._paint(surface.get_size())
        surface.blit(self._picture, (0, 0))
        clip = pygame.Rect(0, self._top - self.host.look.px(8), surface.get_width(), 0)
        clip.h = self._bottom - clip.y
        surface.set_clip(clip)
        if self.focus < len(self.items):
            self._draw_focused(surface, self.items[self.focus])
        surface.set_clip(None)
        self.header.draw(surface)

    def _draw_focused(self, surface: pygame.Surface, item: Item) -> None:
        down = self._top - self._scroll
        if item.card is not None:
            picture = self._thumbnail(item)
            cards.paint_focused(
                surface, self.host.look, item.card, item.entry, picture, self._lift.amount, down
            )
        else:
            self._paint_row(surface, item, item.rect.move(0, down), lit=True)
            cards.draw_ring(surface, self.host.look, item.rect.move(0, down), 8)

    def _thumbnail(self, item: Item) -> pygame.Surface:
        assert item.card is not None
        size = item.card.picture.size
        picture = self.thumbnails.picture(item.entry.name, size, self.host.look)
        if picture is None:
            picture = pygame.Surface(size, 0, 32)
            picture.fill(self.host.look.theme.stage)
            with self.host.guard.over(f"The drawing of {item.entry.title}", self._tell_undrawn):
                picture = sketch(item.entry, size, self.host.look)
        return picture

    def _tell_undrawn(self, failure: Failure) -> None:
        self.host.tell_of(failure, "cannot be shown")

    def _paint(self, size: tuple[int, int]) -> pygame.Surface:
        """Everything but the chosen item and the header."""
        look = self.host.look
        picture = pygame.Surface(size, 0, 32)
        picture.fill(look.theme.bg)
        down = self._top - self._scroll
        for head in self._heads:
            at = (head.at[0], head.at[1] + down)
            used = look.text(picture, head.text, at, 13, "semibold", "text1").w
            look.text(picture, str(head.number), (at[0] + used + look.px(8), at[1]), 12, "medium", "text3")
        for i, item in enumerate(self.items):
            place = item.rect.move(0, down)
            if i == self.focus or place.bottom < self._top or place.top > self._bottom:
                continue
            if item.card is not None:
                cards.paint_card(picture, look, item.card, item.entry, self._thumbnail(item), place.topleft)
            else:
                self._paint_row(picture, item, place, lit=False)
        if not self.items:
            middle = (size[0] / 2, (self._top + self._bottom) / 2)
            look.text(picture, f"Nothing is called “{self.query}”", middle, 13, "medium", "text2", "center")
        picture.fill(look.theme.bg, (0, 0, size[0], self._top - look.px(6)))
        foot = pygame.Rect(0, self._bottom, size[0], max(1, size[1] - self._bottom))
        paint_foot(picture, self.host, foot, bool(self.query), self.background.words())
        return picture

    def _paint_row(self, surface: pygame.Surface, item: Item, rect: pygame.Rect, lit: bool) -> None:
        assert item.level is not None
        head = item.level
        title = f"{head.title}  {head.stars}".rstrip()
        cards.paint_row(
            surface, self.host.look, rect, item.entry.task, title, head.about, bool(head.hard_case), lit
        )


def _count(n: int, what: str) -> str:
    return f"{n} {what}" if n == 1 else f"{n} {what}s"
