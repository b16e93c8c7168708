"""A page of the ui as a screen over the scene: help, accuracy."""

from __future__ import annotations

from typing import ClassVar, Protocol

import pygame

from game.app.screens.host import Host
from game.app.screens.screen import Screen
from game.app.window.commands import Actions
from game.ui.look.look import Look
from game.ui.widgets.wishes import Wish


class Page(Protocol):
    """What the ui's overlays have in common."""

    def place(self, window: pygame.Rect, look: Look) -> None: ...

    def handle(self, event: pygame.Event) -> Wish | None: ...

    def update(self, dt_s: float) -> bool: ...

    def draw(self, surface: pygame.Surface) -> None: ...

    def leave(self) -> None: ...


class PageScreen(Screen):
    """Shows a page until it is closed; subclasses do what else it asks for."""

    overlay: ClassVar[bool] = True

    def __init__(self, host: Host, page: Page):
        super().__init__(host)
        self.page = page
        self.leaving = False
        self.restyle()

    def restyle(self) -> None:
        self.page.place(pygame.Rect((0, 0), self.host.size), self.host.look)

    def fulfil(self, wish: Wish) -> None:
        """A command of the page that is not ``close``."""

    def close(self) -> None:
        """Fade out; then the screen below goes on."""
        self.leaving = True
        self.page.leave()

    @property
    def actions(self) -> Actions:
        return {"back": self.close}

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
            self.host.pop()

    def draw(self, surface: pygame.Surface) -> None:
        self.page.draw(surface)
