"""The program with its window: what all screens share, and the only place that knows each of them."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path
from typing import TYPE_CHECKING

from game.app.cards import AppCards
from game.app.compile.canvas_warming import CanvasWarming
from game.app.menu.liked import note_opened
from game.app.menu.screen import MenuScreen
from game.app.scene.screen import SceneScreen
from game.app.screens.composition import Composition
from game.app.screens.host import Cards
from game.app.screens.screen import Screen
from game.app.screens.stack import ScreenStack
from game.app.screens.start_card import Below, StartCard
from game.app.stagehand.challenge import best_of, today, words_of, write_challenge
from game.app.stagehand.opening import Opening
from game.app.stagehand.start_choices import own_choices
from game.app.window import clipboard
from game.app.window.commands import Actions, perform
from game.app.window.frames import FrameMeter
from game.app.window.gamepad import Gamepads
from game.app.window.guard import Failure, Guard
from game.app.window.keys import Keys
from game.app.window.looks import Looks
from game.app.window.pictures import PictureSaver
from game.app.window.settings import Settings, save_settings
from game.app.window.transition import OVERLAY_S, SCENE_S
from game.app.window.window import Window
from game.files import FileProblem
from game.stage import RecordingError
from game.stage.catalogue import Catalogue
from game.stage.records.run_text import recording_in
from game.ui.look.layout import auto_scale
from game.ui.look.look import Look
from game.ui.sound import SoundPlayer
from game.ui.widgets.toasts import Toasts

if TYPE_CHECKING:
    pass


class App:
    """The `Host` of all screens. `Loop` brings it events and time."""

    def __init__(
        self,
        window: Window,
        catalogue: Catalogue,
        settings: Settings,
        folder: Path,
        background: bool = True,
        forgiving: bool = True,
    ):
        """``folder``: of the settings. ``background``: whether threads may compile and build things.

        ``forgiving``: whether the program goes on without a screen that raises, or a scene; see `Guard`.
        """
        self.window = window
        self.catalogue = catalogue
        self.settings = settings
        self.folder = folder
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
        self.tour_due = self.story_tour_due = False
        self.welcome_due = False
        self.menu_category = ""
        self.cards: Cards = AppCards(self)
        self._composition = Composition(self.screens, self.watch)
        self._looks = Looks()
        self.look = self._style()
        self.toasts = Toasts(self.look)

    # -- what screens share -------------------------------------------------------------------------

    @property
    def size(self) -> tuple[int, int]:
        """The window's size, px."""
        return self.window.size

    @property
    def full_screen(self) -> bool:
        """Whether the window covers the whole screen."""
        return self.window.full_screen

    def _style(self) -> Look:
        """Theme, fonts and scale for the present window and settings."""
        scale = auto_scale(*self.window.size, self.settings.ui_scale)
        return self._looks.get(self.settings.theme, scale, self.settings.less_motion)

    def restyle(self) -> None:
        """Lay all screens out again for another size, scale or theme."""
        look, old = self._style(), self.look
        if (look.theme, look.k, look.less_motion) != (old.theme, old.k, old.less_motion):
            self.look = look
            self.toasts.place(look)
        self._composition.forget()
        for screen in list(self.screens):
            with self.watch(screen):
                screen.restyle()

    def save_settings(self) -> None:
        """Keep the settings; what cannot be written holds until the program ends, and a message says so."""
        try:
            save_settings(self.settings, self.folder)
        except FileProblem as problem:
            self.tell("Settings not kept.", str(problem), "warning")

    def change_keys(self, changed: dict[str, str]) -> None:
        """Other keys from now on, kept in the settings. ValueError, and nothing changed, if they clash."""
        self.keys = Keys(changed)
        self.settings.keys = changed
        self.save_settings()
        self.restyle()

    def tell(self, cause: str, consequence: str = "", kind: str = "info") -> None:
        """A message that fades: kind is "info", "warning" or "marker"."""
        self.toasts.add(cause, consequence, kind)

    def tell_of(self, failure: Failure, consequence: str) -> None:
        """Something has failed: what was done about it, and where one can read why."""
        self.tell(f"{failure.what} {consequence}.", failure.message, "warning")

    # -- commands -----------------------------------------------------------------------------------

    @property
    def actions(self) -> Actions:
        """What the commands of `game.app.window.commands` do that mean the same on every screen."""
        return {
            "full-screen": self.toggle_full_screen,
            "theme": self.toggle_theme,
            "screenshot": self.screenshot,
            "settings": self.cards.open_settings,
            "papers": self.cards.open_papers,
            "career": self.cards.open_career,
            "challenge": self.open_challenge,
            "paste": self.paste,
            "quit": self.quit,
        }

    def perform(self, name: str) -> bool:
        """Do a command, of the program or of the screen on top; False if it means nothing now."""
        return perform(name, {**self.screens.top.actions, **self.actions})

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

    def screenshot(self) -> None:
        """Save what the window shows into the pictures folder and say where."""
        self.draw(0.0)
        try:
            self.pictures.save(self.window.surface, self.screens.visible()[0].title or "menu")
        except OSError as error:
            self.tell("No picture.", str(error.strerror or error), "warning")

    def draw(self, elapsed_s: float) -> None:
        """Draw what the window shows now, and show it."""
        self._composition.draw(self.window.surface, self.look, self.toasts, self.gamepads.pointer, elapsed_s)
        self.window.flip()

    # -- screens ------------------------------------------------------------------------------------

    def open_menu(self, focus: str = "") -> None:
        """The menu in place of everything, with that scene's card chosen."""
        self._replace(MenuScreen(self, focus, self.menu_category))

    def open_scene(self, name: str, level: Path | None = None, opening: Opening | None = None) -> None:
        """A scene in place of the menu or of another scene; the menu shows it among the recent ones.

        A game of which nothing is asked begins with its start card; an empty ``opening`` begins it at once.
        """
        note_opened(self.settings, name)
        entry = self.catalogue[name]
        screen = SceneScreen(self, entry, opening or Opening(level=level))
        self._replace(screen)
        if entry.start and level is None and opening is None:
            below = Below(lambda elapsed_s: self._load_below(screen, elapsed_s), lambda: screen.goes_on)
            self.open_card(StartCard.called, lambda: StartCard(self, entry, below))

    def _load_below(self, screen: SceneScreen, elapsed_s: float) -> None:
        """Let a scene go on loading under a card, and show it when it is there."""
        if screen.load(elapsed_s):
            self._composition.forget()

    def paste(self) -> None:
        """What lies in the clipboard: a stroke is played by the scene on top, a run is watched."""
        top = self.screens.top
        if isinstance(top, SceneScreen) and top.play is not None:
            top.play.passing.take()
        else:
            self.open_clipboard()

    def open_clipboard(self) -> None:
        """Watch the run whose text lies in the clipboard; a message says why not, if it cannot be."""
        try:
            opening = Opening(recording=recording_in(clipboard.get()))
            assert opening.recording is not None
            self.open_scene(self.catalogue[opening.recording.scene].name, opening=opening)
        except RecordingError as error:
            self.tell("Not opened.", str(error), "warning")
        except KeyError as error:
            self.tell("Not opened.", str(error.args[0]), "warning")

    def open_next_round(self) -> None:
        """The next match of the tournament at its table; the card of the career once that has ended."""
        from game.app.stagehand.career_file import load_career
        from game.app.stagehand.career_opening import begin_match
        from game.billiards.career.matches import cup_match
        from game.billiards.game.register import REGISTER

        career, complaint = load_career()
        match = cup_match(career.player) if career.player is not None else None
        if match is None:
            self.cards.open_career()
            return
        family = REGISTER[match.game].family
        own = own_choices(self.catalogue, family, self.settings.start, career.player)
        begun = begin_match(career, match, own)
        for words in filter(None, (complaint, begun.complaint)):
            self.tell("Career.", words, "warning")
        self.open_scene(begun.scene, opening=begun.opening)

    def open_challenge(self) -> None:
        """The challenge of this day at its table; one line where the catalogue has no such table."""
        if not any(entry.name == "billiards" for entry in self.catalogue):
            self.tell("Challenge.", "There is no billiard table here.", "warning")
            return
        try:
            path = write_challenge(today())
        except ValueError as error:
            self.tell("Challenge.", str(error), "warning")
            return
        best = best_of(today())
        self.open_scene("billiards", level=path)
        if best is not None:
            self.tell("Challenge of the day.", f"Your best: {words_of(best.distance)} from the middle.")

    def open_card(self, name: str, make: Callable[[], Screen]) -> None:
        """A screen over the present one; a message names one that cannot be made."""
        with self.guard.over(name, lambda failure: self.tell_of(failure, "cannot be opened")):
            screen = make()
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

    def _replace(self, screen: Screen) -> None:
        """A screen in place of the present one."""
        if len(self.screens):
            self._begin_change(SCENE_S)
        with self.guard.over("What was closed", self.tell_closed):
            self.screens.replace(screen)
        self._changed()

    def _begin_change(self, length_s: float) -> None:
        self._composition.begin_change(self.window.surface, 0.0 if self.settings.less_motion else length_s)

    def _changed(self) -> None:
        self._composition.forget()
        self.meter.clear()
        self.window.set_title(self.screens.top.title)

    # -- what fails ---------------------------------------------------------------------------------

    def watch(self, screen: Screen, asked: bool = False) -> AbstractContextManager[None]:
        """Within this a screen is at work: if it raises it goes on without what failed, or is closed.

        ``asked``: an event has it do this; else time that passes, or the picture.
        """
        return self.guard.over(screen.called, lambda failure: self._lose(screen, failure, asked))

    def _lose(self, screen: Screen, failure: Failure, asked: bool) -> None:
        """A screen has raised: let it go on if it can, else close it and say so."""
        self.window.surface.set_clip(None)  # it may have been at drawing
        self._composition.forget()
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

    def close(self) -> None:
        """Close all screens, and finish what is being written."""
        with self.guard.over("The end", self.tell_closed):
            self.screens.clear()
        self.sounds.close()
        self.pictures.wait()
