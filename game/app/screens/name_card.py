"""The card that asks for a name: of what is saved, or of who plays."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

import pygame

from game.app.screens.card import HEAD, CardScreen
from game.app.screens.host import Host
from game.app.screens.question import Question
from game.ui.widgets.hotspots import Hotspot
from game.ui.widgets.line_field import LineField

ABOUT, FIELD, BUTTONS, FOOT = 24, 44, 36, 32  # design px: heights of the words, the field, the buttons, below
TAKE, LEAVE, BUTTON = "take", "leave", 128


class NameCard(CardScreen):
    """Enter or the button: ``taken`` is called with the name, "" if none is typed. Esc: nothing."""

    called: ClassVar[str] = "The card for a name"
    width: ClassVar[float] = 520.0
    height: ClassVar[float] = HEAD + ABOUT + FIELD + 24 + BUTTONS + FOOT

    def __init__(self, host: Host, question: Question, taken: Callable[[str], object]):
        super().__init__(host)
        self.question = question
        self._taken = taken
        self.field = LineField(question.text, question.prompt, question.longest)
        self.restyle()

    @property
    def heading(self) -> str:
        return self.question.heading

    def state(self) -> object:
        return self.field.state(self.host.look)

    def places(self) -> list[Hotspot]:
        px, card = self.host.look.px, self.veil.card
        right, y = card.right - px(32), card.bottom - px(FOOT + BUTTONS) + px(8)
        take = pygame.Rect(right - px(BUTTON), y, px(BUTTON), px(BUTTONS))
        return [Hotspot(TAKE, take), Hotspot(LEAVE, take.move(-px(BUTTON + 12), 0))]

    def wants_key(self, event: pygame.Event) -> bool:
        return not self.leaving and self.field.wants(event)

    def handle(self, event: pygame.Event) -> None:
        if self.leaving:
            return
        if self.field.handle(event):
            self.pressed(LEAVE if self.spots.focused == LEAVE else TAKE)
        elif event.type != pygame.TEXTINPUT and not (
            event.type == pygame.KEYDOWN and self.field.wants(event)
        ):
            super().handle(event)

    def pressed(self, name: str) -> None:
        self.close()
        if name == TAKE:
            self._taken(self.field.text.strip())

    def update(self, elapsed_s: float) -> None:
        self.field.update(elapsed_s)
        super().update(elapsed_s)

    def paint(self, picture: pygame.Surface) -> None:
        look, px = self.host.look, self.host.look.px
        space = picture.get_width() - px(64)
        about = look.fonts.fit(self.question.about, 13, "medium", space)
        look.text(picture, about, (px(32), px(HEAD - 4)), 13, "medium", "text2")
        self.field.draw(picture, pygame.Rect(px(32), px(HEAD + ABOUT - 4), max(space, 1), px(FIELD)), look)
        self.draw_button(picture, LEAVE, "Cancel")
        self.draw_button(picture, TAKE, self.question.button, primary=True)
