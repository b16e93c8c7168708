"""The main loop: events, time, picture, as often as the screen shows one."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import pygame

from game.app.application import App
from game.app.window.commands import BY_NAME
from game.app.window.frames import Clock, SystemClock

HIDDEN_HZ = 10.0  # a window out of sight asks for events only now and then
LONGEST_FRAME_S = 1.0  # what is longer is a machine that slept; the scene's clock drops more than that itself


class Loop:
    """Brings events and time to the program. ``run`` until quit, or ``frame`` by frame in tests."""

    def __init__(
        self,
        app: App,
        clock: Clock | None = None,
        events: Callable[[], Iterable[pygame.Event]] = pygame.event.get,
    ):
        self.app = app
        self.clock: Clock = clock or SystemClock()
        self._events = events
        self._hidden = False
        self._held: set[int] = set()  # scancodes
        self._last = self.clock.now()

    def run(self) -> None:
        """Frames until quit."""
        app = self.app
        try:
            while app.running and len(app.screens):
                began = self.clock.now()
                self.frame()
                hz = HIDDEN_HZ if self._hidden else app.window.refresh_hz
                self.clock.wait(1.0 / hz - (self.clock.now() - began))
        finally:
            app.close()

    def frame(self, shown: bool = True) -> None:
        """Take the events, pass the time, draw and show the picture (if anybody is to see it)."""
        app, began = self.app, self.clock.now()
        elapsed_s = min(max(began - self._last, 0.0), LONGEST_FRAME_S)
        self._last = began
        for event in self._events():
            with app.watch(app.screens.top, asked=True):
                self._take(event)
        for event in app.gamepads.update(elapsed_s, app.screens.top.gamepad, app.size):
            with app.watch(app.screens.top, asked=True):
                self._give(event)
        if not app.running:
            return
        self._tell_of_pictures()
        with app.watch(app.screens.top):
            app.screens.top.update(elapsed_s)
        app.toasts.update(elapsed_s)
        if shown and not self._hidden:
            app.draw(elapsed_s)
        app.meter.add(self.clock.now() - began)

    def _tell_of_pictures(self) -> None:
        """Say where pictures are that have been written meanwhile."""
        for path, problem, what in self.app.pictures.take():
            if problem:
                self.app.tell(f"No {what.lower()}.", problem, "warning")
            else:
                self.app.tell(f"{what} saved", str(path))

    # -- events -------------------------------------------------------------------------------------

    def _take(self, event: pygame.Event) -> None:
        """An event of the system: of the window, of a gamepad, or one for the top screen."""
        app = self.app
        if event.type in (pygame.QUIT, pygame.WINDOWCLOSE):
            app.running = False
        elif event.type == pygame.WINDOWSIZECHANGED:
            self._resized()
        elif event.type == pygame.WINDOWFOCUSLOST:
            app.screens.top.cancel()
        elif event.type in (pygame.WINDOWMINIMIZED, pygame.WINDOWHIDDEN):
            self._hidden = True
            app.screens.top.cancel()
        elif event.type in (pygame.WINDOWRESTORED, pygame.WINDOWSHOWN, pygame.WINDOWMAXIMIZED):
            self._hidden = False
        else:
            translated = app.gamepads.translate(event, app.screens.top.gamepad)
            for one in [event] if translated is None else translated:
                self._give(app.window.to_pixels(one))

    def _resized(self) -> None:
        app = self.app
        app.screens.top.cancel()
        if not app.full_screen:
            width, height = app.window.points
            app.settings.width, app.settings.height = max(width, 1), max(height, 1)
        app.restyle()

    def _give(self, event: pygame.Event) -> None:
        """An event for the top screen; a key may be a command instead, of the screen or of the program."""
        top = self.app.screens.top
        if event.type == pygame.KEYUP:
            self._held.discard(event.scancode)
        if event.type != pygame.KEYDOWN:
            top.handle(event)
            return
        repeated = event.scancode in self._held
        self._held.add(event.scancode)
        if top.wants_key(event):
            top.handle(event)
            return
        name = self.app.keys.command(event)
        if name is not None and repeated and not BY_NAME[name].repeats:
            return
        if name is None or not self.app.perform(name):
            top.handle(event)
