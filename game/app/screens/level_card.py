"""The card of a scene's levels: in groups, each level with its picture and the stars that were won in it."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path
from typing import ClassVar, NamedTuple

import pygame

from game.app.screens.card import HEAD, CardScreen
from game.app.screens.host import Host
from game.app.stagehand.level_index import LevelHead, level_heads
from game.files import read_text
from game.folders import user_folder
from game.stage.catalogue import Entry
from game.ui.canvas.pen import CARD, Pen
from game.ui.look.look import Look
from game.ui.look.shapes import draw_box
from game.ui.widgets.hotspots import Hotspot

GROUPS = (
    ("lesson-", "The first ten minutes"), ("ghost-", "Against the ghost"), ("set-", "Drills in sets"),
    ("drill-", "Drills"),
    ("trick-", "Trick shots"), ("hard-", "Hard cases"),
)  # fmt: skip  # by names of files
OWN, OTHERS = "Your own", "Games"
TILE, WORDS, GAP, TITLE, MARGIN, FOOT = 152, 44, 12, 32, 32, 56  # design px
SHAPE = 0.54  # height of a picture to its width
LARGEST_BYTES = 200_000  # of a level that is drawn
MOST_KEPT = 400  # pictures


class Tile(NamedTuple):
    """A level and its place in the list, px from the list's upper left corner."""

    head: LevelHead
    rect: pygame.Rect


class LevelCard(CardScreen):
    """A click, or Enter, opens a level: ``chosen`` is called with its file. ``present``: the one in play."""

    called: ClassVar[str] = "The list of levels"
    width = 1056.0
    height = 680.0

    def __init__(
        self, host: Host, entry: Entry, chosen: Callable[[Path], object], present: Path | None = None
    ):
        self.entry = entry
        self._chosen = chosen
        self.present = present
        self.groups = grouped(level_heads(entry.name))
        self._painter = entry.level_painter()
        self._drawn: dict[Path, pygame.Surface] = {}
        self.titles: list[tuple[str, int]] = []
        self.tiles: list[Tile] = []
        self._length = self._scroll = 0
        heads = [head for _, some in self.groups for head in some]
        self.focus = next((i for i, head in enumerate(heads) if head.path == present), 0)
        super().__init__(host)
        self.restyle()

    @property
    def heading(self) -> str:
        return f"{self.entry.title}: levels"

    # -- places -------------------------------------------------------------------------------------

    @property
    def view(self) -> pygame.Rect:
        """Where the list is seen, window px."""
        px, card = self.host.look.px, self.veil.card
        return pygame.Rect(
            card.x + px(MARGIN), card.y + px(HEAD), max(card.w - 2 * px(MARGIN), 1),
            max(card.h - px(HEAD) - px(FOOT), 1),
        )  # fmt: skip

    def restyle(self) -> None:
        self.veil.place(pygame.Rect((0, 0), self.host.size), self.host.look)
        self._drawn.clear()
        self._arrange()
        self._show_focus()
        self.refresh()

    def _arrange(self) -> None:
        """Lay the groups out one below the other."""
        px, wide = self.host.look.px, self.view.w
        count = max(1, (wide + px(GAP)) // px(TILE + GAP))
        tile = (wide - (count - 1) * px(GAP)) // count
        high = round(tile * SHAPE) + px(WORDS)
        self.titles, self.tiles, y = [], [], 0
        for title, heads in self.groups:
            self.titles.append((title, y))
            y += px(TITLE)
            for i, head in enumerate(heads):
                row, column = divmod(i, count)
                place = pygame.Rect(column * (tile + px(GAP)), y + row * (high + px(GAP)), tile, high)
                self.tiles.append(Tile(head, place))
            y += -(-len(heads) // count) * (high + px(GAP))
        self._length = y

    def places(self) -> list[Hotspot]:
        view = self.view
        self._scroll = max(0, min(self._scroll, self._length - view.h))
        spots = []
        for i, tile in enumerate(self.tiles):
            seen = tile.rect.move(view.x, view.y - self._scroll).clip(view)
            if seen.h > 0 and seen.w > 0:
                spots.append(Hotspot(f"level-{i}", seen))
        return spots

    def _show_focus(self) -> None:
        """Scroll to the level that is chosen."""
        if self.tiles:
            rect, title = self.tiles[self.focus].rect, self.host.look.px(TITLE)
            self._scroll = max(min(self._scroll, rect.y - title), rect.bottom - self.view.h)

    # -- input --------------------------------------------------------------------------------------

    def handle(self, event: pygame.Event) -> None:
        if self.leaving or not self.tiles:
            super().handle(event)
            return
        if event.type == pygame.KEYDOWN and event.key in (pygame.K_RETURN, pygame.K_KP_ENTER):
            self.pressed(f"level-{self.focus}")
        elif event.type == pygame.KEYDOWN and event.key in STEPS:
            self._go_to(self._beside(*STEPS[event.key]))
        elif event.type == pygame.KEYDOWN and event.key in (pygame.K_HOME, pygame.K_END):
            self._go_to(0 if event.key == pygame.K_HOME else len(self.tiles) - 1)
        elif event.type == pygame.MOUSEWHEEL:
            self._scroll -= event.y * self.tiles[0].rect.h // 2
            self.refresh()
        else:
            super().handle(event)
            if event.type == pygame.MOUSEMOTION and (self.spots.hovered or "").startswith("level-"):
                self.focus = int(str(self.spots.hovered)[6:])

    def _go_to(self, focus: int) -> None:
        """Choose a level, and show it."""
        self.focus = focus
        self._show_focus()
        self.refresh()

    def _beside(self, right: int, down: int) -> int:
        """The level beside the chosen one, or the nearest in the next row; itself where there is none."""
        if right:
            return min(max(self.focus + right, 0), len(self.tiles) - 1)
        here = self.tiles[self.focus].rect
        rows = sorted({tile.rect.y for tile in self.tiles if (tile.rect.y - here.y) * down > 0})
        if not rows:
            return self.focus
        row = rows[0] if down > 0 else rows[-1]
        there = [i for i, tile in enumerate(self.tiles) if tile.rect.y == row]
        return min(there, key=lambda i: abs(self.tiles[i].rect.x - here.x))

    def pressed(self, name: str) -> None:
        if name.startswith("level-") and not self.leaving:
            path = self.tiles[int(name[6:])].head.path
            self.close()
            self._chosen(path)

    def update(self, elapsed_s: float) -> None:
        self._draw_one_more()
        super().update(elapsed_s)

    def _draw_one_more(self) -> None:
        """One picture a frame, so that the card is there at once."""
        if self._painter is None:
            return
        for tile in self.tiles:
            if tile.head.path not in self._drawn:
                size = (tile.rect.w, tile.rect.h - self.host.look.px(WORDS))
                self._drawn[tile.head.path] = level_picture(self.entry, tile.head.path, size, self.host.look)
                return

    def shown(self, path: Path) -> pygame.Surface | None:
        """The picture of a level; None as long as it has not been drawn."""
        return self._drawn.get(path)

    # -- picture ------------------------------------------------------------------------------------

    def state(self) -> object:
        return self.focus, self._scroll, len(self._drawn)

    def paint(self, picture: pygame.Surface) -> None:
        look, px, view = self.host.look, self.host.look.px, self.inner(self.view)
        picture.set_clip(view)
        for title, y in self.titles:
            at = (view.x, view.y + y - self._scroll + px(14))
            look.text(picture, title, at, 13, "semibold", "text2")
        for i, tile in enumerate(self.tiles):
            rect = tile.rect.move(view.x, view.y - self._scroll)
            if rect.colliderect(view):
                self._paint_tile(picture, rect, tile.head, i == self.focus)
        picture.set_clip(None)
        if self._length > view.h:
            track = pygame.Rect(picture.get_width() - px(18), view.y, px(4), view.h)
            thumb = pygame.Rect(track.x, 0, px(4), max(px(24), view.h * view.h // self._length))
            thumb.y = view.y + (view.h - thumb.h) * self._scroll // max(1, self._length - view.h)
            draw_box(picture, track, px(2), look.theme.inset)
            draw_box(picture, thumb, px(2), look.theme.line2)
        if self.tiles:
            about = look.fonts.fit(self.tiles[self.focus].head.about, 13, "medium", view.w)
            look.text(picture, about, (view.x, picture.get_height() - px(FOOT) // 2), 13, "medium", "text2")

    def _paint_tile(self, picture: pygame.Surface, rect: pygame.Rect, head: LevelHead, lit: bool) -> None:
        look, px, theme = self.host.look, self.host.look.px, self.host.look.theme
        draw_box(picture, rect, px(8), theme.accent_soft if lit else theme.inset)
        shown = self.shown(head.path)
        if shown is not None:
            picture.blit(shown, rect)
        x, space = rect.x + px(10), rect.w - px(20)
        y = rect.bottom - px(WORDS)
        here = head.path == self.present
        title = look.fonts.fit(head.title.partition(": ")[2] or head.title, 12, "semibold", space)
        look.text(picture, title[:1].upper() + title[1:], (x, y + px(14)), 12, "semibold", "text1")
        if head.stars or here:
            words, color = (head.stars, "amber") if head.stars else ("in play", "accent")
            look.text(picture, words, (x, y + px(32)), 12, "semibold", color)
        draw_box(picture, rect, px(8), None, theme.accent if lit else theme.line, max(1, px(2 if lit else 1)))


STEPS = {
    pygame.K_RIGHT: (1, 0), pygame.K_LEFT: (-1, 0), pygame.K_DOWN: (0, 1), pygame.K_UP: (0, -1),
}  # fmt: skip


def grouped(heads: list[LevelHead]) -> list[tuple[str, list[LevelHead]]]:
    """Levels under the titles of their groups; groups without a level are left out."""
    found: dict[str, list[LevelHead]] = {title: [] for title in (OTHERS, *(t for _, t in GROUPS), OWN)}
    for head in heads:
        group = next((title for prefix, title in GROUPS if head.path.stem.startswith(prefix)), OTHERS)
        found[OWN if user_folder() in head.path.parents else group].append(head)
    return [(title, some) for title, some in found.items() if some]


def level_picture(entry: Entry, path: Path, size: tuple[int, int], look: Look) -> pygame.Surface:
    """The picture of a level as it is in its file now, window px; the scene's own if it cannot be read."""
    try:
        found = path.stat()
        return _picture(entry, path, found.st_mtime_ns, found.st_size, size, look)
    except OSError:
        return _sketch(entry, size, look)


@lru_cache(maxsize=MOST_KEPT)
def _picture(
    entry: Entry, path: Path, modified_ns: int, length: int, size: tuple[int, int], look: Look
) -> pygame.Surface:
    painter = entry.level_painter()
    pen = Pen((max(1, size[0]), max(1, size[1])), look, (CARD[0], CARD[0] * SHAPE))
    try:
        if painter is None or length > LARGEST_BYTES:
            return _sketch(entry, size, look)
        painter(pen, tomllib.loads(read_text(path, LARGEST_BYTES)))
    except (ValueError, TypeError, AttributeError, KeyError, IndexError, RecursionError):
        return _sketch(entry, size, look)  # opening it says what is wrong with it
    return pen.finished()


def _sketch(entry: Entry, size: tuple[int, int], look: Look) -> pygame.Surface:
    """The drawing of the scene's card."""
    pen = Pen((max(1, size[0]), max(1, size[1])), look)
    painter = entry.card_painter()
    if painter is None:
        pen.fill("stage")
    else:
        painter(pen)
    return pen.finished()
