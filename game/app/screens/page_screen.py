"""A page of the ui as a screen over the scene: help, accuracy."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar, Protocol

import pygame

from game.app.screens.screen import Screen
from game.ui.look.look import Look
from game.ui.widgets.commands import Command

if TYPE_CHECKING:
    from game.app.application import App


class Page(Protocol):
    """What the ui's overlays have in common."""

    def place(self, window: pygame.Rect, look: Look) -> None: ...

    def handle(self, event: pygame.Event) -> Command | None: ...

    def update(self, dt_s: float) -> bool: ...

    def draw(self, surface: pygame.Surface) -> None: ...

    def leave(self) -> None: ...


class PageScreen(Screen):
    """Shows a page until it is closed; subclasses do what else it asks for."""

    overlay: ClassVar[bool] = True

    def __init__(self, app: App, page: Page):
        super().__init__(app)
        self.page = page
        self.leaving = False
        self.restyle()

    def restyle(self) -> None:
        self.page.place(pygame.Rect((0, 0), self.app.window.size), self.app.look)

    def fulfil(self, wish: Command) -> None:
        """A command of the page that is not ``close``."""

    def close(self) -> None:
        """Fade out; then the screen below goes on."""
        self.leaving = True
        self.page.leave()

    def command(self, name: str) -> bool:
        if name == "back":
            self.close()
        return name == "back"

    def handle(self, event: pygame.Event) -> None:
        if self.leaving:
            return
        wish = self.page.handle(event)
        if wish is None:
            return
        if wish.name == "close":
            self.close()
        else:
            self.fulfil(wish)

    def update(self, elapsed_s: float) -> None:
        if not self.page.update(elapsed_s):
            self.app.pop()

    def draw(self, surface: pygame.Surface) -> None:
        self.page.draw(surface)
