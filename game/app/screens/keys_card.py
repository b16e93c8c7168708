"""The card of all keys, with the names that the present keyboard layout prints on them; they change here."""

from __future__ import annotations

from typing import ClassVar

import pygame

from game.app.screens.card import HEAD, CardScreen
from game.app.screens.host import Host
from game.app.window.commands import COMMANDS
from game.app.window.keys import chord_of
from game.ui.look.shapes import draw_box
from game.ui.widgets import keycap
from game.ui.widgets.hotspots import Hotspot

GESTURES = (
    (("Wheel",), "zoom"),
    (("Middle drag",), "move the view"),
    (("Double click",), "a slider's default"),
)
ROW, LEAST_ROW, FOOT = 32, 24, 48  # design px
WORDS, NARROW_WORDS = 104, 88  # design px from a row's left end to its words
NARROW, ONE_COLUMN = 660, 560  # design px: cards narrower than that
DEFAULTS = "defaults"
ROWS = len(COMMANDS) + len(GESTURES)
PAGES = {pygame.K_PAGEDOWN: 1, pygame.K_PAGEUP: -1}
MODIFIERS = frozenset(
    (
        pygame.K_LCTRL, pygame.K_RCTRL, pygame.K_LSHIFT, pygame.K_RSHIFT, pygame.K_LALT, pygame.K_RALT,
        pygame.K_LMETA, pygame.K_RMETA, pygame.K_CAPSLOCK, pygame.K_NUMLOCK, pygame.K_MODE,
    )
)  # fmt: skip


class KeysCard(CardScreen):
    """Every command and its key, in two columns; a row that is pressed waits for its new key."""

    called: ClassVar[str] = "The card of keys"

    def __init__(self, host: Host):
        super().__init__(host)
        self.waiting = ""  # the command whose key is awaited
        self._first = 0  # of the rows that are seen, if not all are
        self.veil.size = (self.width, HEAD + ROW * (ROWS + 1) // 2 + 64)
        self.restyle()

    @property
    def heading(self) -> str:
        return "Keys"

    def state(self) -> object:
        return self.waiting, self._first, tuple(self.host.settings.keys.items())

    # -- places -------------------------------------------------------------------------------------

    @property
    def _columns(self) -> int:
        return 1 if self.veil.card.w < self.host.look.px(ONE_COLUMN) else 2

    @property
    def _half(self) -> int:
        """Rows of a column."""
        return (ROWS + self._columns - 1) // self._columns

    @property
    def _height(self) -> int:
        """Height of a row, window px: less in a low window."""
        px = self.host.look.px
        fits = (self.veil.card.h - px(HEAD - 4 + FOOT)) // self._half
        return min(px(ROW), max(px(LEAST_ROW), fits))

    @property
    def _fits(self) -> int:
        """Rows of a column that there is space for."""
        px = self.host.look.px
        return max(1, (self.veil.card.h - px(HEAD - 4 + FOOT)) // self._height)

    def _row(self, i: int) -> pygame.Rect:
        """The i-th row, on the card's own surface."""
        px = self.host.look.px
        column = (self.veil.card.w - px(64)) // self._columns
        down = (i % self._half - self._first) * self._height
        return pygame.Rect(
            px(24) + (i // self._half) * column, px(HEAD - 4) + down, column - px(8), self._height
        )

    def _inside(self, i: int) -> bool:
        return self._first <= i % self._half < self._first + self._fits

    def _scroll(self, rows: int) -> None:
        """Show rows further down, if not all can be seen."""
        first = min(max(self._first + rows, 0), max(0, self._half - self._fits))
        if first != self._first:
            self._first = first
            self.refresh()

    def places(self) -> list[Hotspot]:
        px, card = self.host.look.px, self.veil.card
        self._first = min(self._first, max(0, self._half - self._fits))
        spots = [
            Hotspot(command.name, self._row(i).move(card.topleft))
            for i, command in enumerate(COMMANDS)
            if self._inside(i)
        ]
        if self.host.settings.keys:
            button = pygame.Rect(card.right - px(32 + 128), card.bottom - px(48), px(128), px(32))
            spots.append(Hotspot(DEFAULTS, button))
        return spots

    # -- changing -----------------------------------------------------------------------------------

    def pressed(self, name: str) -> None:
        if name == DEFAULTS:
            self.waiting = ""
            self.host.change_keys({})
        else:
            self.waiting = "" if name == self.waiting else name

    def wants_key(self, event: pygame.Event) -> bool:
        return bool(self.waiting)

    def handle(self, event: pygame.Event) -> None:
        if event.type == pygame.KEYDOWN and self.waiting:
            self._take_key(event)
        elif event.type == pygame.MOUSEWHEEL:
            self._scroll(-2 * event.y)
        elif event.type == pygame.KEYDOWN and event.key in PAGES:
            self._scroll(PAGES[event.key] * self._fits)
        else:
            super().handle(event)

    def cancel(self) -> None:
        self.waiting = ""
        super().cancel()

    def _take_key(self, event: pygame.Event) -> None:
        """The awaited key, unless it is Esc, which takes the question back, or only changes others."""
        if event.key in MODIFIERS:
            return
        name, self.waiting = self.waiting, ""
        if event.key == pygame.K_ESCAPE:
            return
        try:
            self.host.change_keys(self.host.keys.changed_by(name, chord_of(event)))
        except ValueError as error:
            self.host.tell("The key stays.", f"{error}.", "warning")

    # -- picture ------------------------------------------------------------------------------------

    def paint(self, picture: pygame.Surface) -> None:
        look, px = self.host.look, self.host.look.px
        beside = px(NARROW_WORDS if self.veil.card.w < px(NARROW) else WORDS)
        rows = [((self.host.keys.label(c.name),), c.label, c.name) for c in COMMANDS]
        rows += [(keys, words, "") for keys, words in GESTURES]
        for i, (keys, words, name) in enumerate(rows):
            if not self._inside(i):
                continue
            row = self._row(i)
            self._paint_ground(picture, row.inflate(0, -px(4)), name)
            x, y = row.x + px(8), row.centery
            if name and name == self.waiting:
                look.text(picture, "press a key", (x, y), 12, "semibold", "amber")
            else:
                keycap.draw_keys(picture, look, x, y, keys)
            words = look.fonts.fit(words, 13, "medium", row.w - px(8) - beside)
            look.text(picture, words, (x + beside, y), 13, "medium", "text2")
        y = picture.get_height() - px(32)
        words = "Click a row to give it another key"
        if self._fits < self._half:
            words += "; the wheel shows more"
        look.text(picture, words, (px(32), y), 12, "medium", "text3")
        self.draw_button(picture, DEFAULTS, "All as before")

    def _paint_ground(self, picture: pygame.Surface, row: pygame.Rect, name: str) -> None:
        """What shows that a row can be pressed, has the focus, or waits."""
        px, theme = self.host.look.px, self.host.look.theme
        if not name:
            return
        lit = 1.0 if name == self.waiting else self.spots.hover(name)
        if lit:
            draw_box(picture, row, px(6), theme.panel.lerp(theme.hover, lit))
        if self.spots.focused == name:
            draw_box(picture, row, px(6), None, theme.accent, max(2, px(2)))
