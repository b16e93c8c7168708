"""The main loop: events, time, picture, as often as the screen shows one; and what all screens share."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from contextlib import AbstractContextManager
from pathlib import Path
from typing import Any

import pygame

from game.app.compile.canvas_warming import CanvasWarming
from game.app.composition import Composition
from game.app.menu.screen import MenuScreen
from game.app.scene.screen import SceneScreen
from game.app.screens.keys_card import KeysCard
from game.app.screens.screen import Screen, ScreenStack
from game.app.screens.settings_card import SettingsCard
from game.app.stagehand.opening import Opening
from game.app.window.frames import Clock, FrameMeter, SystemClock
from game.app.window.gamepad import Gamepads
from game.app.window.guard import Failure, Guard
from game.app.window.keys import Keys
from game.app.window.looks import Looks
from game.app.window.pictures import PictureSaver
from game.app.window.settings import Settings, save_settings
from game.app.window.transition import OVERLAY_S, SCENE_S
from game.app.window.window import Window
from game.files import FileProblem
from game.stage.catalogue import Catalogue
from game.ui.look.layout import auto_scale
from game.ui.look.look import Look
from game.ui.sound import SoundPlayer
from game.ui.widgets.toasts import Toasts

REPEATED = ("step", "step-back", "slower", "faster")  # commands that a held key gives again and again
HIDDEN_HZ = 10.0  # a window that nobody sees asks for events only now and then
LONGEST_FRAME_S = 1.0  # what is longer is a machine that slept; the scene's clock drops more than that itself


class App:
    """The program with its window. ``run`` until quit, or ``frame`` by frame in tests."""

    def __init__(
        self,
        window: Window,
        catalogue: Catalogue,
        settings: Settings,
        folder: Path,
        clock: Clock | None = None,
        events: Callable[[], Iterable[pygame.Event]] = pygame.event.get,
        background: bool = True,
        forgiving: bool = True,
    ):
        """``background``: whether the menu compiles and builds things behind the window's back.

        ``forgiving``: whether the program goes on without a screen that raises, or a scene; see `Guard`.
        """
        self.window = window
        self.catalogue = catalogue
        self.settings = settings
        self.folder = folder
        self.clock: Clock = clock or SystemClock()
        self.guard = Guard(forgiving)
        self.keys = Keys(settings.keys)
        self.meter = FrameMeter()
        self.screens = ScreenStack()
        self.gamepads = Gamepads()
        self.canvas_warming = CanvasWarming()
        self.sounds = SoundPlayer(settings.volume)
        self.pictures = PictureSaver()
        self.running = True
        self.background = background
        self.tour_due = False  # the first scene opened begins with the tour
        self._events = events
        self._hidden = False
        self._held: set[int] = set()
        self.composition = Composition()
        self._last = self.clock.now()
        self._looks = Looks()
        self.look = self._style()
        self.toasts = Toasts(self.look)

    # -- what screens share -------------------------------------------------------------------------

    def _style(self) -> Look:
        """Theme, fonts and scale for the present window and settings."""
        scale = auto_scale(*self.window.size, self.settings.ui_scale)
        return self._looks.get(self.settings.theme, scale, self.settings.less_motion)

    def restyle(self) -> None:
        """Lay all screens out anew for another size, scale or theme."""
        look, old = self._style(), self.look
        if (look.theme, look.k, look.less_motion) != (old.theme, old.k, old.less_motion):
            self.look = look
            self.toasts.place(look)
        self.composition.forget()
        for screen in list(self.screens):
            with self.watch(screen):
                screen.restyle()

    def save_settings(self) -> None:
        """Keep the settings; what cannot be written holds until the program ends, and that is told."""
        try:
            save_settings(self.settings, self.folder)
        except FileProblem as problem:
            self.tell("Settings not kept.", str(problem), "warning")

    def tell(self, cause: str, consequence: str = "", kind: str = "info") -> None:
        """A message that fades: kind is "info", "warning" or "marker"."""
        self.toasts.add(cause, consequence, kind)

    # -- screens ------------------------------------------------------------------------------------

    def open_menu(self, focus: str = "") -> None:
        """The menu in place of everything, with that scene's card chosen."""
        self.replace(MenuScreen(self, focus))

    def open_scene(self, name: str, level: Path | None = None, opening: Opening | None = None) -> None:
        """A scene in place of the menu or of another scene."""
        self.replace(SceneScreen(self, self.catalogue[name], opening or Opening(level=level)))

    def open_keys(self) -> None:
        """The card of all keys."""
        self.open_card(KeysCard)

    def open_settings(self) -> None:
        """The card of the settings; not over itself."""
        if not isinstance(self.screens.top, SettingsCard):
            self.open_card(SettingsCard)

    def open_card(self, kind: Callable[..., Screen], *details: Any) -> None:
        """A screen of that kind over the present one; one that cannot be made is told of."""
        name = getattr(kind, "called", "The page")
        with self.guard.over(name, lambda failure: self.tell_of(failure, "cannot be opened")):
            self.push(kind(self, *details))

    def push(self, screen: Screen) -> None:
        """A screen over the present one."""
        self._begin_change(OVERLAY_S if screen.overlay else SCENE_S)
        self.screens.push(screen)
        self._changed()

    def pop(self) -> None:
        """Back to the screen below; from the last one out of the program."""
        if len(self.screens) <= 1:
            self.running = False
            return
        screen = self.screens.top
        self._begin_change(OVERLAY_S if screen.overlay else SCENE_S)
        with self.guard.over(screen.called, self.tell_closed):
            self.screens.pop()
        self._changed()

    def replace(self, screen: Screen) -> None:
        """A screen in place of the present one."""
        if len(self.screens):
            self._begin_change(SCENE_S)
        with self.guard.over("What was closed", self.tell_closed):
            self.screens.replace(screen)
        self._changed()

    # -- what fails ---------------------------------------------------------------------------------

    def watch(self, screen: Screen, asked: bool = False) -> AbstractContextManager[None]:
        """Within this a screen is at work: if it raises it goes on without what failed, or is closed.

        ``asked``: an event has it do this; else time that passes, or the picture.
        """
        return self.guard.over(screen.called, lambda failure: self._lose(screen, failure, asked))

    def _lose(self, screen: Screen, failure: Failure, asked: bool) -> None:
        """A screen has raised: let it go on if it can, else close it and say so."""
        self.window.surface.set_clip(None)  # it may have been at drawing
        self.composition.forget()
        if screen in self.screens and screen.survive(failure, asked):
            return
        if isinstance(screen, MenuScreen):  # there is nothing to go back to
            self.tell_of(failure, "failed")
            return
        self.tell_closed(failure)
        with self.guard.over(screen.called, self.tell_closed):
            if screen.overlay and screen in self.screens:
                self.screens.remove(screen)
                screen.closed()
                self.screens.top.uncovered()
            elif screen in self.screens:
                self.open_menu()
        self._changed()

    def tell_closed(self, failure: Failure) -> None:
        """A screen has been closed as it failed."""
        self.tell_of(failure, "was closed")

    def tell_of(self, failure: Failure, consequence: str) -> None:
        """Something has failed: what was done about it, and where one can read why."""
        self.tell(f"{failure.what} {consequence}.", failure.told, "warning")

    def _begin_change(self, length_s: float) -> None:
        self.composition.begin_change(self.window.surface, 0.0 if self.settings.less_motion else length_s)

    def _changed(self) -> None:
        self.composition.forget()
        self.meter.clear()
        self.window.set_title(self.screens.top.title)

    # -- a frame ------------------------------------------------------------------------------------

    def run(self) -> None:
        """Frames until quit."""
        try:
            while self.running and len(self.screens):
                began = self.clock.now()
                self.frame()
                hz = HIDDEN_HZ if self._hidden else self.window.refresh_hz
                self.clock.wait(1.0 / hz - (self.clock.now() - began))
        finally:
            with self.guard.over("The end", self.tell_closed):
                self.screens.clear()
            self.sounds.close()
            self.pictures.wait()

    def frame(self, shown: bool = True) -> None:
        """Take the events, pass the time, draw and show the picture (if anybody is to see it)."""
        began = self.clock.now()
        elapsed_s = min(max(began - self._last, 0.0), LONGEST_FRAME_S)
        self._last = began
        for event in self._events():
            with self.watch(self.screens.top, asked=True):
                self._take(event)
        for event in self.gamepads.update(elapsed_s, self.screens.top.gamepad, self.window.size):
            with self.watch(self.screens.top, asked=True):
                self._give(event)
        if not self.running:
            return
        self._tell_of_pictures()
        with self.watch(self.screens.top):
            self.screens.top.update(elapsed_s)
        self.toasts.update(elapsed_s)
        if shown and not self._hidden:
            self._draw(elapsed_s)
        self.meter.add(self.clock.now() - began)

    def _draw(self, elapsed_s: float) -> None:
        self.composition.draw(self, elapsed_s)
        self.window.flip()

    # -- events -------------------------------------------------------------------------------------

    def _take(self, event: pygame.Event) -> None:
        """An event of the system: of the window, of a gamepad, or one for the top screen."""
        if event.type in (pygame.QUIT, pygame.WINDOWCLOSE):
            self.running = False
        elif event.type == pygame.WINDOWSIZECHANGED:
            self._resized()
        elif event.type == pygame.WINDOWFOCUSLOST:
            self.screens.top.cancel()
        elif event.type in (pygame.WINDOWMINIMIZED, pygame.WINDOWHIDDEN):
            self._hidden = True
            self.screens.top.cancel()
        elif event.type in (pygame.WINDOWRESTORED, pygame.WINDOWSHOWN, pygame.WINDOWMAXIMIZED):
            self._hidden = False
        else:
            translated = self.gamepads.translate(event, self.screens.top.gamepad)
            for one in [event] if translated is None else translated:
                self._give(self.window.to_pixels(one))

    def _resized(self) -> None:
        self.screens.top.cancel()
        if not self.window.full_screen:
            width, height = self.window.points
            self.settings.width, self.settings.height = max(width, 1), max(height, 1)
        self.restyle()

    def _give(self, event: pygame.Event) -> None:
        """An event for the top screen; a key may be a command instead, of the screen or of the program."""
        top = self.screens.top
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
        name = self.keys.command(event)
        if name is not None and repeated and name not in REPEATED:
            return
        if name is None or not (self.command(name) or top.command(name)):
            top.handle(event)

    def command(self, name: str) -> bool:
        """A command of the whole program; True if it was one."""
        action = _OWN.get(name)
        if action is not None:
            action(self)
        return action is not None

    def quit(self) -> None:
        """Leave after this frame."""
        self.running = False

    def toggle_full_screen(self) -> None:
        """Window or whole screen."""
        self.screens.top.cancel()
        self.settings.full_screen = self.window.toggle_full_screen()
        self.save_settings()

    def toggle_theme(self) -> None:
        """Dark or light."""
        self.settings.theme = "light" if self.settings.theme == "dark" else "dark"
        self.save_settings()
        self.restyle()

    def change_keys(self, changed: dict[str, str]) -> None:
        """Other keys from now on, kept in the settings. ValueError, and nothing changed, if they clash."""
        self.keys = Keys(changed)
        self.settings.keys = changed
        self.save_settings()
        self.restyle()

    def screenshot(self) -> None:
        """Save what the window shows into the pictures folder and say where."""
        self._draw(0.0)
        try:
            self.pictures.save(self.window.surface, self.screens.visible()[0].title or "menu")
        except OSError as error:
            self.tell("No picture.", str(error.strerror or error), "warning")

    def _tell_of_pictures(self) -> None:
        """Say where pictures are that have been written meanwhile."""
        for path, problem in self.pictures.take():
            if problem:
                self.tell("No picture.", problem, "warning")
            else:
                self.tell("Picture saved", str(path))


_OWN: dict[str, Callable[[App], None]] = {
    "full-screen": App.toggle_full_screen,
    "theme": App.toggle_theme,
    "screenshot": App.screenshot,
    "settings": App.open_settings,
    "quit": App.quit,
}
