"""The screen of one scene: opens it, lets hand and keys in, runs its stage, draws it in its shell."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar, Literal

import pygame

from game.app.scene.keeping import kept_path
from game.app.scene.loader import Loader
from game.app.scene.shell import Shell
from game.app.screens.choices import ChoiceCard, Row
from game.app.screens.screen import Screen
from game.app.stagehand.opening import Opening
from game.ui.widgets.commands import Command

if TYPE_CHECKING:
    from game.app.application import App
    from game.app.scene.play import ScenePlay
    from game.app.window.guard import Failure
    from game.stage.catalogue import Entry


TOUR_AFTER_S = 1.5  # s in which a scene comes to something worth showing
PAUSE_ROWS = (
    ("", "Go on"),
    ("reset", "Begin anew"),
    ("levels", "Levels and hard cases"),
    ("open", "Open what was saved"),
    ("save", "Save level and recording"),
    ("help", "Help"),
    ("tour", "Tour of the window"),
    ("settings", "Settings"),
    ("next", "Next scene"),
    ("back", "Menu"),
    ("quit", "Leave Carom"),
)


class SceneScreen(Screen):
    """While the scene loads, its shell with the loading card; then the scene itself."""

    called: ClassVar[str] = "The scene"
    gamepad: ClassVar[Literal["keys", "pointer"]] = "pointer"

    def __init__(self, app: App, entry: Entry, opening: Opening):
        super().__init__(app)
        self.entry = entry
        self.opening = opening
        self.goes_on = entry.roomy and opening == Opening() and kept_path(entry.name).exists()
        if self.goes_on:
            self.opening = Opening(level=kept_path(entry.name))
        self.shell = Shell(app, entry)
        self.loader: Loader | None = self._load()
        self.play: ScenePlay | None = None
        self._waiting = ""
        self._age_s = 0.0  # since the scene was there

    def _load(self) -> Loader:
        return Loader(
            self.entry, self.opening, self.app.canvas_warming, self.app.look, self.shell.layout.free_stage
        )

    @property
    def title(self) -> str:
        return self.entry.title

    def restyle(self) -> None:
        self.shell.place()
        if self.play is not None:
            self.play.restyle()

    def message_row(self) -> pygame.Rect:
        return self.shell.layout.hint_bar

    # -- life ---------------------------------------------------------------------------------------

    def uncovered(self) -> None:
        name, self._waiting = self._waiting, ""
        if name and not self.app.command(name):
            self.command(name)

    def update(self, elapsed_s: float) -> None:
        if self.loader is not None:
            self.shell.loading.update(elapsed_s, self.loader.done, self.loader.total)
            if self.loader.finished:
                self._open(self.loader)
        if self.play is not None:
            self.play.update(elapsed_s)
            self._age_s += elapsed_s
            if self.app.tour_due and self._age_s >= TOUR_AFTER_S and not self.play.hand.held:
                self._open_tour()
        else:
            self.shell.update(elapsed_s, None, None)

    def _open(self, loader: Loader) -> None:
        """The scene is there, or it is not: then say why and go back to the menu."""
        self.loader = None
        if loader.stage is None and self.goes_on:
            self.goes_on, self.opening = False, Opening()
            self.app.tell("The kept game cannot be read.", loader.error, "warning")
            self.loader = self._load()
            return
        if loader.stage is None:
            self.app.open_menu(self.entry.name)
            self.app.tell(f"{self.entry.title} cannot be opened.", loader.error, "warning")
            return
        from game.app.scene.play import ScenePlay

        self.play = ScenePlay(self.app, self.shell, loader.stage, self.opening)
        if self.goes_on:
            self.app.tell("Your game goes on.", "N begins a new one.")

    def closed(self) -> None:
        if self.loader is not None:
            self.loader.stop()
        if self.play is not None:
            self.play.close()

    def cancel(self) -> None:
        if self.play is not None:
            self.play.cancel()

    def survive(self, failure: Failure, asked: bool) -> bool:
        return self.play is not None and self.play.survive(failure, asked)

    # -- events -------------------------------------------------------------------------------------

    def wants_key(self, event: pygame.Event) -> bool:
        if self.play is None:
            return False
        return self.play.panel_wants(event) or self.play.action_of(event) is not None

    def handle(self, event: pygame.Event) -> None:
        if self.play is None:
            _, wishes = self.shell.handle(event)
            for wish in wishes:
                if wish.name in ("back", "panel", "help"):
                    self.command(wish.name)
            return
        name = None
        if event.type == pygame.KEYDOWN and not self.play.panel_wants(event):
            name = self.play.action_of(event)
        if name is not None:
            self.play.act(name)
            return
        for wish in self.play.handle(event):
            self._fulfil(wish)

    def _fulfil(self, wish: Command) -> None:
        """What a widget asks for: the names of game/ui/widgets/commands.py."""
        play = self.play
        if play is None:
            return
        if wish.name == "back":
            self.app.open_menu(self.entry.name)
        elif wish.name == "speed":
            play.change_speed(wish.value)
        elif wish.name == "level":
            play.open_file(wish.value)
        elif wish.name in ("refused", "toast"):
            self.app.tell("Not taken." if wish.name == "refused" else str(wish.value),
                          str(wish.value) if wish.name == "refused" else "", "warning")  # fmt: skip
        elif wish.name == "defaults":
            play.gate.set_defaults()
        else:
            name = {"play": "pause", "picture": "screenshot"}.get(wish.name, wish.name)
            if not self.app.command(name):
                self.command(name)

    def command(self, name: str) -> bool:
        if name == "back":
            if self.play is None or not self.play.step_out():
                self.app.open_menu(self.entry.name)
        elif name in ("next", "previous"):
            self.app.open_scene(
                self.app.catalogue.neighbour(self.entry.name, 1 if name == "next" else -1).name
            )
        elif name == "panel":
            name = "panel_in_games" if self.entry.roomy else "panel"
            setattr(self.app.settings, name, not getattr(self.app.settings, name))
            self.restyle()
        elif self.play is not None:
            return self._command_in_play(self.play, name)
        else:
            return False
        return True

    def _command_in_play(self, play: ScenePlay, name: str) -> bool:
        if name == "levels":
            self._choose("Levels and hard cases", play.shelf.levels(), play.shelf.present)
        elif name == "open":
            self._choose("Saved levels and recordings", play.shelf.saved(), None)
        elif name == "help":
            from game.app.scene.help_card import HelpCard

            self.app.open_card(HelpCard, play.stage.scene_type)
        elif name == "tour":
            self._open_tour()
        elif name == "accuracy":
            self._open_accuracy(play)
        elif name == "pause-menu":
            self._open_pause_menu()
        else:
            return play.command(name)
        return True

    def _open_tour(self) -> None:
        """The tour, which from now on comes only when it is asked for."""
        from game.app.scene.tour import TourScreen

        self.app.tour_due = False
        self.app.settings.toured = True
        self.app.save_settings()
        self.app.open_card(TourScreen, self.shell)

    def _open_pause_menu(self) -> None:
        """All that can be done, as a list; the scene stands still under it."""
        label = self.app.keys.label
        rows = [Row(words, chip=label(name) if name else "", value=name) for name, words in PAUSE_ROWS]
        self.app.open_card(ChoiceCard, "Pause", rows, self._do_later)

    def _do_later(self, name: str) -> None:
        """Do what was chosen once the card has gone."""
        self._waiting = name

    def _choose(self, heading: str, rows: list[Row], present: Any) -> None:
        assert self.play is not None
        self.app.open_card(ChoiceCard, heading, rows, self.play.open_file, present)

    def _open_accuracy(self, play: ScenePlay) -> None:
        study = play.stage.scene_type.study
        if study is None:
            self.app.tell("No study.", "This scene has none yet.")
            return
        from game.app.scene.accuracy_card import AccuracyCard

        play.errands.wait()  # it looks into the scene
        self.app.open_card(AccuracyCard, play, study)

    # -- picture ------------------------------------------------------------------------------------

    def draw(self, surface: pygame.Surface) -> None:
        if self.play is not None:
            self.play.draw(surface)
        elif self.loader is not None:
            self.shell.draw_loading(surface, self.loader)
        else:
            surface.fill(self.app.look.theme.bg)
