"""One thing that the window shows, and the stack of them: the top one lives, those below stand still."""

from __future__ import annotations

from contextlib import ExitStack
from typing import TYPE_CHECKING, ClassVar, Literal

import pygame

if TYPE_CHECKING:
    from game.app.application import App
    from game.app.window.guard import Failure


class Screen:
    """Base of all screens. ``app`` lends theme, fonts, keys, settings and the stack."""

    called: ClassVar[str] = "The page"  # in messages
    overlay: ClassVar[bool] = False  # leaves what is below visible
    gamepad: ClassVar[Literal["keys", "pointer"]] = "keys"  # what a gamepad's stick moves

    def __init__(self, app: App):
        self.app = app

    @property
    def title(self) -> str:
        """Words for the window's title, empty for the program's own."""
        return ""

    def handle(self, event: pygame.Event) -> None:
        """One event; positions are in pixels."""

    def command(self, name: str) -> bool:
        """A key command (see ``keys.COMMANDS``); False if it means nothing here."""
        return False

    def wants_key(self, event: pygame.Event) -> bool:
        """Whether a KEYDOWN belongs to the screen whatever command it may be elsewhere."""
        return False

    def message_row(self) -> pygame.Rect:
        """Where messages are shown when this is the lowest screen that is seen: the hint row."""
        height = self.app.look.px(40)
        width, bottom = self.app.window.size
        return pygame.Rect(0, bottom - height, width, height)

    def update(self, elapsed_s: float) -> None:
        """Real time has passed. Only the top screen is told."""

    def draw(self, surface: pygame.Surface) -> None:
        """Draw the whole screen, or an overlay over what is there."""

    def restyle(self) -> None:
        """Window size, scale or theme has changed: lay everything out anew."""

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


class ScreenStack:
    """Screens from the bottom to the top. One at least, once the program runs."""

    def __init__(self) -> None:
        self._screens: list[Screen] = []

    def __len__(self) -> int:
        return len(self._screens)

    def __iter__(self):
        return iter(self._screens)

    @property
    def top(self) -> Screen:
        """The screen that gets events and time."""
        return self._screens[-1]

    def visible(self) -> list[Screen]:
        """From the lowest that shows to the top."""
        first = max((i for i, screen in enumerate(self._screens) if not screen.overlay), default=0)
        return self._screens[first:]

    def push(self, screen: Screen) -> None:
        """Put a screen on top."""
        if self._screens:
            self.top.covered()
        self._screens.append(screen)

    def pop(self) -> None:
        """Take the top screen away; the last one stays."""
        if len(self._screens) > 1:
            try:
                self._screens.pop().closed()
            finally:
                self.top.uncovered()

    def replace(self, screen: Screen) -> None:
        """Another screen in place of the top one and of all overlays."""
        first = max((i for i, one in enumerate(self._screens) if not one.overlay), default=0)
        gone, self._screens[first:] = self._screens[first:], [screen]
        _close(gone)

    def remove(self, screen: Screen) -> None:
        """Forget a screen that has failed; it is not asked anything any more. The last one stays."""
        if len(self._screens) > 1 and screen in self._screens:
            self._screens.remove(screen)

    def clear(self) -> None:
        """Close all, from the top."""
        gone, self._screens[:] = self._screens[:], []
        _close(gone)


def _close(screens: list[Screen]) -> None:
    """Close them from the top, all of them even if one raises."""
    with ExitStack() as closing:
        for screen in screens:
            closing.callback(screen.closed)
