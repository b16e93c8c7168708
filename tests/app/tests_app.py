"""A program without a screen and without real time: posted events, a clock that the test sets."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path
from typing import Any

import pygame

from game.app.application import App
from game.app.scene.screen import SceneScreen
from game.app.settings import Settings
from game.app.window import Window
from game.stage.catalogue import Catalogue, Entry

EXAMPLE = Path(__file__).resolve().parents[1] / "stage" / "example_scene.py"
FRAME_S = 1.0 / 60.0
LONGEST_LOAD_S = 200.0


def load_example() -> None:
    """Make the example scene importable under one name, however the tests are started."""
    if "example_scene" not in sys.modules:
        spec = importlib.util.spec_from_file_location("example_scene", EXAMPLE)
        assert spec is not None and spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        sys.modules["example_scene"] = module
        spec.loader.exec_module(module)


def example_entry(name: str = "example") -> Entry:
    """A catalogue row of the example scene, or of the same under another name."""
    load_example()
    module, class_name = sys.modules["example_scene"], "BouncingBall"
    if name != "example":
        class_name = f"BouncingBall_{name}"
        setattr(
            module,
            class_name,
            type(class_name, (module.BouncingBall,), {"name": name, "__doc__": "Another."}),
        )
    return Entry(
        name, "X00", "Bouncing ball", "one ball", "Examples", module.__name__, class_name, "gravity ground"
    )


CATALOGUE = Catalogue(
    (
        example_entry(),
        Entry("broken", "X01", "Broken scene", "cannot be opened", "Examples", "no_such_module", "Nothing"),
    )
)


class SetClock:
    """Time goes on only when the test says so, or when the loop waits."""

    def __init__(self) -> None:
        self.time_s = 0.0

    def now(self) -> float:
        return self.time_s

    def wait(self, seconds: float) -> None:
        self.time_s += max(seconds, 0.0)


class Driver:
    """Drives the program by events, frame by frame."""

    def __init__(
        self,
        folder: Path,
        size: tuple[int, int] = (1280, 720),
        catalogue: Catalogue = CATALOGUE,
        **settings: Any,
    ):
        self.window = Window(size)
        self.clock = SetClock()
        self.waiting: list[pygame.Event] = []
        self.app = App(
            self.window, catalogue, Settings(**settings), folder, self.clock, self._take, background=False
        )
        pygame.event.clear()
        self.app.open_menu()

    def _take(self) -> list[pygame.Event]:
        events, self.waiting = self.waiting, []
        return events

    def frames(self, count: int = 1, seconds: float = FRAME_S) -> None:
        for _ in range(count):
            self.clock.time_s += seconds
            self.app.frame()

    def post(self, *events: pygame.Event) -> None:
        self.waiting += events
        self.frames()

    def key(self, code: int, mod: int = 0) -> None:
        """Press and release a key (by its key code on a US keyboard)."""
        scancode = pygame.key.ScancodeWrapper(tuple(range(512)))[code]
        fields = {"key": code, "scancode": scancode, "mod": mod}
        self.post(pygame.Event(pygame.KEYDOWN, unicode="", **fields), pygame.Event(pygame.KEYUP, **fields))

    def type(self, text: str) -> None:
        self.post(*(pygame.Event(pygame.TEXTINPUT, text=letter) for letter in text))

    def move(self, x: int, y: int) -> None:
        self.post(pygame.Event(pygame.MOUSEMOTION, pos=(x, y), rel=(0, 0), buttons=(0, 0, 0)))

    def button(self, down: bool, x: int, y: int, button: int = 1) -> None:
        kind = pygame.MOUSEBUTTONDOWN if down else pygame.MOUSEBUTTONUP
        self.post(pygame.Event(kind, pos=(x, y), button=button))

    def click(self, x: int, y: int, button: int = 1) -> None:
        self.move(x, y)
        self.button(True, x, y, button)
        self.button(False, x, y, button)

    def wheel(self, turns: int) -> None:
        self.post(pygame.Event(pygame.MOUSEWHEEL, x=0, y=turns, precise_y=float(turns), pos=(400, 300)))

    def resize(self, width: int, height: int) -> None:
        """What a window system may do that knows no smallest size."""
        self.window.window.minimum_size = (1, 1)
        self.window.resize((width, height))
        pygame.event.clear()
        self.post(pygame.Event(pygame.WINDOWSIZECHANGED, x=width, y=height))

    @property
    def top(self) -> Any:
        return self.app.screens.top

    @property
    def stage(self) -> Any:
        return self.top.play.stage

    def open(self, name: str = "example") -> SceneScreen:
        """Open a scene and wait until it is there, or until the menu is back."""
        self.app.open_scene(name)
        screen = self.top
        screen.loader.wait(LONGEST_LOAD_S)
        self.frames(2)
        return screen

    def close(self) -> None:
        self.app.screens.clear()
        self.window.close()
