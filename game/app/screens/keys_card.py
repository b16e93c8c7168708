"""The card of all keys, with the names that the present keyboard layout prints on them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pygame

from game.app.keys import COMMANDS
from game.app.screens.card import HEAD, CardScreen
from game.app.settings import settings_path
from game.ui import keycap

if TYPE_CHECKING:
    from game.app.application import App

GESTURES = (
    (("Wheel",), "zoom"),
    (("Middle drag",), "move the view"),
    (("Double click",), "a slider's default"),
)
ROW = 32  # design px


class KeysCard(CardScreen):
    """Every command and its key, in two columns."""

    height = 560.0

    def __init__(self, app: App):
        super().__init__(app)
        rows = len(COMMANDS) + len(GESTURES)
        self.veil.size = (self.width, HEAD + ROW * ((rows + 1) // 2) + 56)
        self.restyle()

    @property
    def heading(self) -> str:
        return "Keys"

    def paint(self, picture: pygame.Surface) -> None:
        look, px = self.app.look, self.app.look.px
        rows = [((self.app.keys.label(c.name),), c.label) for c in COMMANDS]
        rows += GESTURES
        half = (len(rows) + 1) // 2
        column = (picture.get_width() - px(64)) // 2
        for i, (keys, words) in enumerate(rows):
            x = px(32) + (i // half) * column
            y = px(HEAD + 12) + (i % half) * px(ROW)
            if y > picture.get_height() - px(48):
                continue
            keycap.draw_keys(picture, look, x, y, keys)
            room = column - px(112)
            look.text(
                picture, look.fonts.fit(words, 13, "medium", room), (x + px(104), y), 13, "medium", "text2"
            )
        where = f"Keys may be changed in {settings_path(self.app.folder)}"
        where = look.fonts.fit(where, 12, "medium", picture.get_width() - px(64))
        look.text(picture, where, (px(32), picture.get_height() - px(24)), 12, "medium", "text3")
