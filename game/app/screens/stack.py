"""The screens that are open: the top one lives, those below stand still."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack

from game.app.screens.screen import Screen


class ScreenStack:
    """Screens from the bottom to the top. One at least, once the program runs."""

    def __init__(self) -> None:
        self._screens: list[Screen] = []

    def __len__(self) -> int:
        return len(self._screens)

    def __iter__(self) -> Iterator[Screen]:
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
