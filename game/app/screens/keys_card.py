"""The card of all keys, with the names that the present keyboard layout prints on them; they change here."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pygame

from game.app.keys import COMMANDS, chord_of
from game.app.screens.card import HEAD, CardScreen
from game.ui import keycap
from game.ui.hotspots import Hotspot
from game.ui.shapes import draw_box

if TYPE_CHECKING:
    from game.app.application import App

GESTURES = (
    (("Wheel",), "zoom"),
    (("Middle drag",), "move the view"),
    (("Double click",), "a slider's default"),
)
ROW, FOOT = 32, 48  # design px
DEFAULTS = "defaults"
MODIFIERS = frozenset(
    (
        pygame.K_LCTRL, pygame.K_RCTRL, pygame.K_LSHIFT, pygame.K_RSHIFT, pygame.K_LALT, pygame.K_RALT,
        pygame.K_LMETA, pygame.K_RMETA, pygame.K_CAPSLOCK, pygame.K_NUMLOCK, pygame.K_MODE,
    )
)  # fmt: skip


class KeysCard(CardScreen):
    """Every command and its key, in two columns; a row that is pressed waits for its new key."""

    def __init__(self, app: App):
        super().__init__(app)
        self.waiting = ""  # the command whose key is awaited
        self._half = (len(COMMANDS) + len(GESTURES) + 1) // 2
        self.veil.size = (self.width, HEAD + ROW * self._half + 64)
        self.restyle()

    @property
    def heading(self) -> str:
        return "Keys"

    def state(self) -> object:
        return self.waiting, tuple(self.app.settings.keys.items())

    # -- places -------------------------------------------------------------------------------------

    def _row(self, i: int) -> pygame.Rect:
        """The i-th row, on the card's own surface."""
        px = self.app.look.px
        column = (self.veil.card.w - px(64)) // 2
        x, y = px(24) + (i // self._half) * column, px(HEAD - 4) + (i % self._half) * px(ROW)
        return pygame.Rect(x, y, column - px(8), px(ROW))

    def _inside(self, rect: pygame.Rect) -> bool:
        return rect.bottom <= self.veil.card.h - self.app.look.px(FOOT)

    def places(self) -> list[Hotspot]:
        px, card = self.app.look.px, self.veil.card
        rows = ((command.name, self._row(i)) for i, command in enumerate(COMMANDS))
        spots = [Hotspot(name, row.move(card.topleft)) for name, row in rows if self._inside(row)]
        if self.app.settings.keys:
            button = pygame.Rect(card.right - px(32 + 128), card.bottom - px(48), px(128), px(32))
            spots.append(Hotspot(DEFAULTS, button))
        return spots

    # -- changing -----------------------------------------------------------------------------------

    def pressed(self, name: str) -> None:
        if name == DEFAULTS:
            self.waiting = ""
            self.app.change_keys({})
        else:
            self.waiting = "" if name == self.waiting else name

    def wants_key(self, event: pygame.Event) -> bool:
        return bool(self.waiting)

    def handle(self, event: pygame.Event) -> None:
        if event.type == pygame.KEYDOWN and self.waiting:
            self._take_key(event)
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
            self.app.change_keys(self.app.keys.changed_by(name, chord_of(event)))
        except ValueError as error:
            self.app.tell("The key stays.", f"{error}.", "warning")

    # -- picture ------------------------------------------------------------------------------------

    def paint(self, picture: pygame.Surface) -> None:
        look, px = self.app.look, self.app.look.px
        rows = [((self.app.keys.label(c.name),), c.label, c.name) for c in COMMANDS]
        rows += [(keys, words, "") for keys, words in GESTURES]
        for i, (keys, words, name) in enumerate(rows):
            row = self._row(i)
            if not self._inside(row):
                continue
            self._paint_ground(picture, row.inflate(0, -px(4)), name)
            x, y = row.x + px(8), row.centery
            if name and name == self.waiting:
                look.text(picture, "press a key", (x, y), 12, "semibold", "amber")
            else:
                keycap.draw_keys(picture, look, x, y, keys)
            words = look.fonts.fit(words, 13, "medium", row.w - px(8 + 104))
            look.text(picture, words, (x + px(104), y), 13, "medium", "text2")
        y = picture.get_height() - px(32)
        look.text(picture, "Click a row to give it another key", (px(32), y), 12, "medium", "text3")
        self.draw_button(picture, DEFAULTS, "All as before")

    def _paint_ground(self, picture: pygame.Surface, row: pygame.Rect, name: str) -> None:
        """What shows that a row can be pressed, has the focus, or waits."""
        px, theme = self.app.look.px, self.app.look.theme
        if not name:
            return
        lit = 1.0 if name == self.waiting else self.spots.hover(name)
        if lit:
            draw_box(picture, row, px(6), theme.panel.lerp(theme.hover, lit))
        if self.spots.focused == name:
            draw_box(picture, row, px(6), None, theme.accent, max(2, px(2)))
