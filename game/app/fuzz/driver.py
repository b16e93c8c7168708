"""The program driven by code: posted events and a clock that is set, so that no screen and no time is needed.

What drives it: fuzzing, films, and tests. Nothing here is done by a person.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pygame

from game.app.application import App
from game.app.loop import Loop
from game.app.scene.screen import SceneScreen
from game.app.stagehand.opening import Opening
from game.app.window.children import end_children
from game.app.window.settings import Settings
from game.app.window.window import Window
from game.stage.catalogue import Catalogue

FRAME_S = 1.0 / 60.0
LONGEST_LOAD_S = 300.0
SCANCODES: Any = pygame.key.ScancodeWrapper(tuple(range(512)))  # type: ignore[arg-type]  # by key code


class SetClock:
    """Time goes on only when the driver says so, or when the loop waits."""

    def __init__(self) -> None:
        self.time_s = 0.0

    def now(self) -> float:
        return self.time_s

    def wait(self, seconds: float) -> None:
        self.time_s += max(seconds, 0.0)


class Driver:
    """Drives the program by events, frame by frame.

    ``folder``: of the settings. ``size``: of the window, px. ``settings``: fields of the settings.
    ``forgiving``: False lets pass what a screen or a scene raises, as the driver is to see it.
    """

    def __init__(
        self,
        folder: Path,
        size: tuple[int, int],
        catalogue: Catalogue,
        forgiving: bool = False,
        **settings: Any,
    ):
        self.window = Window(size)
        self.clock = SetClock()
        self.waiting: list[pygame.Event] = []
        self.app = App(self.window, catalogue, Settings(**settings), folder, False, forgiving)
        self.loop = Loop(self.app, self.clock, self._take)
        self._take()
        self.app.open_menu()

    def _take(self) -> list[pygame.Event]:
        """What was posted here; what the window system or pygame_gui posted beside it is dropped.

        By ``get``, for ``pygame.event.clear`` (2.5.8) never lets go of what a posted event refers to.
        """
        pygame.event.get()
        events, self.waiting = self.waiting, []
        return events

    def frames(self, count: int = 1, seconds: float = FRAME_S, shown: bool = True) -> None:
        """So many frames, each that long, drawn or not."""
        for _ in range(count):
            self.clock.time_s += seconds
            self.loop.frame(shown)

    def post(self, *events: pygame.Event) -> None:
        """One frame with these events."""
        self.waiting += events
        self.frames()

    def key(self, code: int, mod: int = 0) -> None:
        """Press and release a key (by its key code on a US keyboard)."""
        scancode = SCANCODES[code]
        fields: dict[str, Any] = {"key": code, "scancode": scancode, "mod": mod}
        self.post(pygame.Event(pygame.KEYDOWN, unicode="", **fields), pygame.Event(pygame.KEYUP, **fields))

    def type(self, text: str) -> None:
        """Type letters."""
        self.post(*(pygame.Event(pygame.TEXTINPUT, text=letter) for letter in text))

    def move(self, x: int, y: int) -> None:
        """Move the pointer, px."""
        self.post(pygame.Event(pygame.MOUSEMOTION, pos=(x, y), rel=(0, 0), buttons=(0, 0, 0)))

    def button(self, down: bool, x: int, y: int, button: int = 1) -> None:
        """Press or let go a mouse button."""
        kind = pygame.MOUSEBUTTONDOWN if down else pygame.MOUSEBUTTONUP
        self.post(pygame.Event(kind, pos=(x, y), button=button))

    def click(self, x: int, y: int, button: int = 1) -> None:
        """Move there, press and let go."""
        self.move(x, y)
        self.button(True, x, y, button)
        self.button(False, x, y, button)

    def wheel(self, turns: int) -> None:
        """Turn the wheel."""
        self.post(pygame.Event(pygame.MOUSEWHEEL, x=0, y=turns, precise_y=float(turns), pos=(400, 300)))

    def resize(self, width: int, height: int) -> None:
        """What a window system may do that knows no smallest size."""
        self.window.window.minimum_size = (1, 1)
        self.window.resize((width, height))
        self.post(pygame.Event(pygame.WINDOWSIZECHANGED, x=width, y=height))

    @property
    def top(self) -> Any:
        """The screen on top."""
        return self.app.screens.top

    @property
    def stage(self) -> Any:
        """The stage of the scene on top."""
        return self.top.play.stage

    def open(self, name: str) -> SceneScreen:
        """Open a scene, a game without its start card, and wait until it is there, or the menu is back."""
        self.app.open_scene(name, opening=Opening())
        screen = self.top
        screen.loader.wait(LONGEST_LOAD_S)
        self.frames(2)
        return screen

    def close(self) -> None:
        """Close all screens; a film that was begun is not finished."""
        self.app.screens.clear()
        end_children()
