"""One thing that the window shows: the base of all screens."""

from __future__ import annotations

from typing import ClassVar, Literal

import pygame

from game.app.screens.host import Host
from game.app.window.commands import Actions
from game.app.window.guard import Failure


class Screen:
    """Knows its host and no other screen."""

    called: ClassVar[str] = "The page"  # in messages
    overlay: ClassVar[bool] = False  # leaves what is below visible
    gamepad: ClassVar[Literal["keys", "pointer"]] = "keys"  # what a gamepad's stick moves

    def __init__(self, host: Host):
        self.host = host

    @property
    def title(self) -> str:
        """Words for the window's title, empty for the program's own."""
        return ""

    def handle(self, event: pygame.Event) -> None:
        """One event; positions are in pixels."""

    @property
    def actions(self) -> Actions:
        """What the commands of `game.app.window.commands` do here; those that mean nothing are left out."""
        return {}

    def wants_key(self, event: pygame.Event) -> bool:
        """Whether a KEYDOWN belongs to the screen whatever command it may be elsewhere."""
        return False

    def message_row(self) -> pygame.Rect:
        """Where messages are shown when this is the lowest screen that is seen: the hint row."""
        height = self.host.look.px(40)
        width, bottom = self.host.size
        return pygame.Rect(0, bottom - height, width, height)

    def update(self, elapsed_s: float) -> None:
        """Real time has passed. Only the top screen is told."""

    def draw(self, surface: pygame.Surface) -> None:
        """Draw the whole screen, or an overlay over what is there."""

    def restyle(self) -> None:
        """Window size, scale or theme has changed: lay everything out again."""

    def cancel(self) -> None:
        """Take back what a pointer has begun: focus is lost, or another screen comes on top."""

    def covered(self) -> None:
        """Another screen comes on top."""
        self.cancel()

    def uncovered(self) -> None:
        """On top again."""

    def closed(self) -> None:
        """Taken from the stack: stop threads, let go of what is held."""

    def survive(self, failure: Failure, asked: bool) -> bool:
        """Go on without what has failed; False if that cannot be done, and the screen is to be closed.

        ``asked``: it failed at an event, not because time passed or the screen was drawn.
        """
        return False
