"""The menu screen: search field, bar of categories, cards, levels, hints at the foot."""

from __future__ import annotations

from typing import ClassVar

import pygame

from game.app.menu import flow
from game.app.menu.background import Background
from game.app.menu.bar import CategoryBar
from game.app.menu.contents import Contents, Item, Key, lay_out
from game.app.menu.header import Header
from game.app.menu.items import FAVOURITES, RECENT, Offer
from game.app.menu.liked import toggle_favourite
from game.app.menu.painter import Painter, Shown
from game.app.menu.scroll import Scroll
from game.app.screens.host import Host
from game.app.screens.screen import Screen
from game.app.stagehand.opening import Opening
from game.app.window.commands import Actions
from game.stage.catalogue import STORIES
from game.ui.look.motion import LIFT_S, Fade

ARROWS = {pygame.K_LEFT: (-1, 0), pygame.K_RIGHT: (1, 0), pygame.K_UP: (0, -1), pygame.K_DOWN: (0, 1)}
PAGES = {pygame.K_PAGEUP: -1, pygame.K_PAGEDOWN: 1}
WHEEL = 100  # design px for a notch
TEXTS = 60  # got ready to be searched in a frame that has nothing else to do
SIGNS = {FAVOURITES: "star-full"}


class MenuScreen(Screen):
    """All scenes; opens one."""

    called: ClassVar[str] = "The menu"

    def __init__(self, host: Host, focus: str = "", category: str = ""):
        """``focus``: the scene whose card is chosen, in that ``category`` if it is there."""
        super().__init__(host)
        self.offer = Offer(host.catalogue)
        self.header = Header(host)
        self.bar = CategoryBar()
        self.scroll = Scroll()
        self.background = Background(host)
        self.thumbnails = self.background.thumbnails
        self.painter = Painter(host, self.thumbnails, self.bar, self.scroll)
        self.query = ""
        self.contents = Contents((), (), 0)
        self.focus = 0
        self._pressed: int | None = None
        self._pointer: tuple[int, int] | None = None  # while what is under it is to be chosen
        self._lift = Fade(LIFT_S)
        self._wanted: tuple[Key, str] = ((category, focus, None), focus)
        self.restyle()

    @property
    def items(self) -> tuple[Item, ...]:
        """All that can be chosen, from the top."""
        return self.contents.items

    @property
    def focused(self) -> Item | None:
        """The chosen card or row."""
        return self.items[self.focus] if self.focus < len(self.items) else None

    # -- layout -------------------------------------------------------------------------------------

    def restyle(self) -> None:
        look, (width, height) = self.host.look, self.host.size
        head, top = look.px(flow.HEADER), look.px(flow.HEADER + flow.BAR)
        bottom = max(top + 1, height - look.px(flow.FOOTER))
        self.view = pygame.Rect(0, top, width, bottom - top)
        self.header.place(pygame.Rect(0, 0, width, head), look)
        self.header.prompt = f"Type to search {_count(len(self.offer.catalogue), 'scene')}"
        if self.offer.levels:
            self.header.prompt += f" and {_count(len(self.offer.levels), 'level')}"
        self.painter.restyle()
        self._lay_out()

    def _lay_out(self) -> None:
        """Places of everything in the content, whose upper end is the bar's foot."""
        look, before, anchor = self.host.look, self.focused, self._anchor()
        self.contents = lay_out(self.offer, self.query, self.host.settings, self.view.size, look)
        if self.query:
            self.focus = 0
        elif before is not None and self._has_left(before):
            self.focus = max(0, min(self.focus, len(self.items) - 1))  # go on beside it
        else:
            wanted = (before.key, before.entry.name) if before is not None else self._wanted
            self.focus = self.contents.find(*wanted)
        self._pressed = self._pointer = None
        bar = pygame.Rect(0, self.view.y - look.px(flow.BAR), self.view.w, look.px(flow.BAR))
        self.bar.place(bar, self.contents.categories, look, SIGNS)
        self.scroll.bound(self.contents.height, self.view, look)
        self._stand(anchor)
        self.painter.forget()

    def _has_left(self, item: Item) -> bool:
        """Whether it stood among favourites or recent ones and does no more."""
        return item.category in (FAVOURITES, RECENT) and not self.contents.has(item.key)

    def _anchor(self) -> tuple[Item, float] | None:
        """What shall not move when things are laid out anew: an item in view, and how far below its top."""
        if not self.items:
            return None
        item = self.items[self._nearest_seen()]
        return item, item.rect.top - self.scroll.target

    def _stand(self, anchor: tuple[Item, float] | None) -> None:
        """After another layout: the anchor where it stood, or at first the chosen item in the middle."""
        focused = self.focused
        if self.query or focused is None or (anchor is None and self.focus == 0):
            self.scroll.go(0.0, at_once=True)
        elif anchor is None:
            self.scroll.go(focused.rect.centery - self.view.h / 2, at_once=True)
        elif not self._has_left(anchor[0]):
            index = self.contents.find(anchor[0].key, anchor[0].entry.name)
            self.scroll.go(self.items[index].rect.top - anchor[1], at_once=True)
            if index == self.focus:
                self._show_focus(at_once=True)

    def _show_focus(self, at_once: bool = False) -> None:
        """Scroll as little as brings the chosen item and its heading wholly into view."""
        item, px = self.focused, self.host.look.px
        if item is not None:
            self.scroll.show(item.rect.top - px(flow.HEAD), item.rect.bottom + px(flow.ROW_GAP), at_once)

    def show_category(self, category: str) -> None:
        """Go to where a category begins and choose its first card."""
        first = self.contents.first_of(category)
        if first is not None:
            self._choose(first)
            self.scroll.go(self.items[first].rect.top - self.host.look.px(flow.HEAD))

    # -- events -------------------------------------------------------------------------------------

    @property
    def actions(self) -> Actions:
        """Without ``menu``: it is left by closing the window."""
        return {
            "back": lambda: self._search(""),
            "help": self.host.cards.open_keys,
            "favourite": lambda: self._star(self.focused),
        }

    def handle(self, event: pygame.Event) -> None:
        wish = self.header.handle(event)
        category = self.bar.handle(event, self.host.look)
        if wish == "clear":
            self._search("")
        elif wish is not None:
            self.host.perform(wish)
        elif category is not None:
            self.show_category(category)
        elif event.type == pygame.TEXTINPUT:
            self._search(self.query + "".join(c for c in event.text if c.isprintable()))
        elif event.type == pygame.KEYDOWN:
            self._press_key(event)
        elif event.type == pygame.MOUSEWHEEL:
            self._wheel(event)
        else:
            self._handle_pointer(event)

    def _press_key(self, event: pygame.Event) -> None:
        self._pointer = None
        if event.key in ARROWS and self.items:
            rects = [item.rect for item in self.items]
            at = self._nearest_seen()
            there = flow.nearest_in_direction(rects, at, *ARROWS[event.key])
            self._walk_to(there if at == self.focus else at)
        elif event.key in PAGES and self.items:
            self._turn_page(PAGES[event.key])
        elif event.key == pygame.K_TAB:
            self.show_category(self.bar.beside(-1 if event.mod & pygame.KMOD_SHIFT else 1))
        elif event.key in (pygame.K_RETURN, pygame.K_KP_ENTER):
            self._open()
        elif event.key == pygame.K_BACKSPACE and self.query:
            self._search("" if event.mod & pygame.KMOD_CTRL else self.query[:-1])
        elif event.key in (pygame.K_HOME, pygame.K_END) and self.items:
            self._walk_to(0 if event.key == pygame.K_HOME else len(self.items) - 1)

    def _walk_to(self, index: int) -> None:
        self._choose(index)
        self._show_focus()

    def _turn_page(self, pages: int) -> None:
        """Choose what lies a view further; at the content's end the last, or the first."""
        here = self.items[self.focus].rect
        goal = here.top + pages * (self.view.h - self.host.look.px(flow.HEAD + flow.ROW_GAP))
        last = len(self.items) - 1
        ends = {1: self.items[last].rect.top, -1: 0}
        if (goal - ends[pages]) * pages >= 0:
            self._walk_to(last if pages > 0 else 0)
            return
        aside = [abs(item.rect.centerx - here.centerx) for item in self.items]
        way = [abs(item.rect.top - goal) * 4 + aside[i] for i, item in enumerate(self.items)]
        self._walk_to(way.index(min(way)))

    def _wheel(self, event: pygame.Event) -> None:
        turns = getattr(event, "precise_y", event.y)
        pointer = getattr(event, "pos", None) or self._pointer
        if pointer is not None and self.bar.rect.collidepoint(pointer):
            self.bar.wheel(turns, self.host.look)
            return
        self.scroll.go(self.scroll.target - turns * self.host.look.px(WHEEL))
        self._pointer = pointer

    def _handle_pointer(self, event: pygame.Event) -> None:
        """Press, drag and let go: a card is opened, its star changed, or the content dragged."""
        look = self.host.look
        if event.type == pygame.MOUSEMOTION:
            if self.scroll.drag(event.pos, look):
                self._pressed = None
            else:
                self._point(event.pos)
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            if self.view.collidepoint(event.pos):
                self.scroll.press(event.pos, look)
                self._pressed = None if self.scroll.dragging else self._at(event.pos)
        elif event.type == pygame.MOUSEBUTTONUP and event.button == 1:
            index, pressed = self._at(event.pos), self._pressed
            self._pressed = None
            if not self.scroll.release() and index is not None and index == pressed:
                self._click(index, event.pos)

    def _click(self, index: int, position: tuple[int, int]) -> None:
        item = self.items[index]
        if item.card is not None:
            star = flow.star_of(item.rect, self.host.look.k).move(0, self.down)
            if star.collidepoint(position):
                self._star(item)
                return
        self._choose(index)
        self._open()

    def _star(self, item: Item | None) -> None:
        """A star more, or less; what stands in the view stays where it is."""
        if item is None:
            return
        starred = toggle_favourite(self.host.settings, item.entry.name)
        self.host.save_settings()
        if starred:
            self.host.tell(f"{item.entry.title} is a favourite", "It stands first in the menu.")
        else:
            self.host.tell(f"{item.entry.title} is no favourite any more")
        if not self.query:
            self._lay_out()
        self.painter.forget()

    def _search(self, query: str) -> None:
        query = query.lstrip()[:40]
        if query != self.query:
            self.query = self.header.query = query
            self._lay_out()

    # -- what is where ------------------------------------------------------------------------------

    @property
    def down(self) -> int:
        """From a place in the content to one in the window, px."""
        return self.view.y - self.scroll.offset

    def _at(self, position: tuple[int, int]) -> int | None:
        """Index of the item under a pixel."""
        if not self.view.collidepoint(position):
            return None
        content = (position[0], position[1] - self.down)
        return next((i for i, item in enumerate(self.items) if item.rect.collidepoint(content)), None)

    def in_view(self) -> list[int]:
        """Indices of the items of which something is seen."""
        view = self.view.move(0, -self.down)
        return [i for i, item in enumerate(self.items) if view.colliderect(item.rect)]

    def _nearest_seen(self) -> int:
        """The chosen item if something of it is in view, else the first that is wholly; as it will come to
        rest: a key may be pressed again before that."""
        view = pygame.Rect(0, round(self.scroll.target), self.view.w, self.view.h)
        if self.focus < len(self.items) and view.colliderect(self.items[self.focus].rect):
            return self.focus
        seen = [i for i, item in enumerate(self.items) if view.colliderect(item.rect)]
        whole = [i for i in seen if view.contains(self.items[i].rect)]
        return (whole or seen or [self.focus])[0]

    def _point(self, position: tuple[int, int]) -> None:
        self._pointer = position if self.scroll.moving else None
        index = self._at(position)
        if index is not None:
            self._choose(index)

    def _choose(self, index: int) -> None:
        if index != self.focus:
            self.focus = index
            self._lift = Fade(0.0 if self.host.look.less_motion else LIFT_S)
            self.painter.forget()

    def _open(self) -> None:
        item = self.focused
        if item is not None:
            self.host.menu_category = item.category
            told = item.category == STORIES and item.level is None
            opening = Opening(story="") if told and item.entry.category != STORIES else None
            self.host.open_scene(
                item.entry.name, level=item.level.path if item.level else None, opening=opening
            )

    # -- life ---------------------------------------------------------------------------------------

    def cancel(self) -> None:
        self.scroll.release()
        self._pressed = self._pointer = None

    def uncovered(self) -> None:
        self.thumbnails.wake()
        self.painter.forget()

    def closed(self) -> None:
        self.background.close()

    def update(self, elapsed_s: float) -> None:
        look = self.host.look
        self.header.update(elapsed_s)
        changed = self.background.update(elapsed_s)
        changed |= self.bar.spots.update(elapsed_s, look)
        changed |= self.scroll.update(elapsed_s)
        if self._pointer is not None and not self.scroll.moving:
            self._point(self._pointer)
        changed |= self.bar.show(self._category(), look)
        self._lift.update(elapsed_s, True)
        changed |= self._update_pictures(elapsed_s)
        if changed or self.painter.unfinished:
            self.painter.forget()
            return
        self.offer.prepare(TEXTS)
        if self.host.welcome_due and self.painter.painted:  # over a menu whose cards have their pictures
            self.host.cards.open_welcome()

    def _update_pictures(self, elapsed_s: float) -> bool:
        """Pictures of what is seen, the chosen one's moving; none while the content moves."""
        if self.scroll.moving or self.scroll.dragging:
            return False
        focused = self.focused
        seen = [self.items[i] for i in self.in_view()]
        sizes = [(item.entry.name, item.card.picture.size) for item in seen if item.card is not None]
        moving = None
        if focused is not None and focused.card is not None and not self.host.look.less_motion:
            moving = (focused.entry.name, focused.card.picture.size)
        return self.thumbnails.update(elapsed_s, sizes, self.host.look, moving if moving in sizes else None)

    def _category(self) -> str:
        """The one that the bar marks: of the chosen item while it is seen, else of the first that is seen."""
        if not self.items:
            return ""
        index = self._nearest_seen()
        return self.items[index].category

    # -- picture ------------------------------------------------------------------------------------

    def draw(self, surface: pygame.Surface) -> None:
        words = self.background.words()
        shown = Shown(self.view, self.down, self.contents, self.in_view(), self.focus, self.query, words)
        self.painter.draw(surface, shown, self._lift.amount)
        self.header.draw(surface)


def _count(n: int, what: str) -> str:
    return f"{n} {what}" if n == 1 else f"{n} {what}s"
