"""The screen of one scene: opens it, lets hand and keys in, runs its stage, draws it in its shell."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, ClassVar, Literal

import pygame

from game.app.scene.keeping import kept_path
from game.app.scene.loader import Loader
from game.app.scene.shell import Shell
from game.app.screens.host import Host
from game.app.screens.screen import Screen
from game.app.stagehand.opening import Opening
from game.app.window.commands import COMMANDS, Actions, perform
from game.app.window.guard import Failure
from game.stage.catalogue import STORIES, Entry
from game.ui.widgets.list_row import ListRow
from game.ui.widgets.wishes import Wish

if TYPE_CHECKING:
    from game.app.scene.play import ScenePlay


TOUR_AFTER_S = 1.5  # s in which a scene comes to something worth showing
WITHOUT_A_SCENE = frozenset(("menu", "panel"))  # of the bar's buttons, those that work while it loads

ANOTHER_GAME = "another game"  # row of the card of a pause: to the card before the game


class SceneScreen(Screen):
    """While the scene loads, its shell with the loading card; then the scene itself."""

    called: ClassVar[str] = "The scene"
    gamepad: ClassVar[Literal["keys", "pointer"]] = "pointer"

    def __init__(self, host: Host, entry: Entry, opening: Opening):
        super().__init__(host)
        self.entry = entry
        self.opening = opening
        if entry.category == STORIES and opening == Opening():
            self.opening = opening = Opening(story="")
        self.goes_on = opening == Opening() and kept_path(entry.name).exists()
        if self.goes_on:
            self.opening = Opening(level=kept_path(entry.name))
        self.shell = Shell(host, entry)
        self.loader: Loader | None = self._load()
        self.play: ScenePlay | None = None
        self._waiting = ""  # command that was chosen on a card, to be done once the card has gone
        self._age_s = 0.0  # since the scene was there

    def _load(self) -> Loader:
        return Loader(
            self.entry, self.opening, self.host.canvas_warming, self.host.look, self.shell.layout.free_stage
        )

    @property
    def title(self) -> str:
        return self.entry.title

    def restyle(self) -> None:
        self.shell.place()
        if self.play is not None:
            self.play.restyle()

    def message_row(self) -> pygame.Rect:
        """The row of hints; above a story's time bar where that lies over it."""
        row = self.shell.layout.hint_bar
        story = self.play.story if self.play is not None else None
        if story is not None and row.colliderect(story.bar.rect):
            row = row.move(0, story.bar.rect.y - row.bottom)
        return row

    # -- commands -----------------------------------------------------------------------------------

    @property
    def actions(self) -> Actions:
        """Of the screen; once the scene is there, also what opens a card over it and what is done to it."""
        always: Actions = {
            "menu": lambda: self.host.open_menu(self.entry.name),
            "back": self._go_back,
            "next": lambda: self._open_neighbour(1),
            "previous": lambda: self._open_neighbour(-1),
            "panel": self._toggle_panel,
        }
        play = self.play
        if play is None:
            return always
        return {
            **always,
            **play.actions,
            "levels": lambda: self._choose_level(play),
            "open": lambda: self._choose("Saved levels and recordings", play.shelf.saved(), None),
            "help": lambda: self.host.cards.open_help(play.stage.scene_type, play.level_words),
            "tour": self._open_tour,
            "accuracy": self._open_study,
            "pause-menu": self._open_pause_menu,
        }

    def _wishes(self) -> Mapping[str, Callable[[Any], object]]:
        """What widgets ask for with a value: by the names of game/ui/widgets/wishes.py."""
        assert self.play is not None
        return {
            "speed": self.play.change_speed,
            "chart": self.play.charts.ask,
            "answer": self.play.lesson.check,
            "lesson-fold": lambda _: self.restyle(),
            "level": self.play.open_file,
            "refused": lambda why: self.host.tell("Not taken.", str(why), "warning"),
            "toast": lambda words: self.host.tell(str(words), "", "warning"),
        }

    def _go_back(self) -> None:
        """Out of what is under way in the scene, or else out of the scene."""
        if self.play is None or not self.play.step_out():
            self.host.open_menu(self.entry.name)

    def _open_neighbour(self, places: int) -> None:
        self.host.open_scene(self.host.catalogue.neighbour(self.entry.name, places).name)

    def _toggle_panel(self) -> None:
        settings = self.host.settings
        if self.entry.roomy:
            settings.panel_in_games = not settings.panel_in_games
        else:
            settings.panel = not settings.panel
        self.restyle()

    def _open_tour(self) -> None:
        """The tour, which from now on comes only when it is asked for; a story has one of its own."""
        story = self.play.story if self.play is not None else None
        if story is None:
            self.host.tour_due, self.host.settings.toured = False, True
        else:
            self.host.story_tour_due, self.host.settings.story_toured = False, True
        self.host.save_settings()
        self.host.cards.open_tour(lambda: self.shell.layout, story.tour_places if story is not None else None)

    @property
    def _tour_due(self) -> bool:
        story = self.play is not None and self.play.story is not None
        return self.host.story_tour_due if story else self.host.tour_due

    def _open_pause_menu(self) -> None:
        """All that can be done, as a list; the scene stands still under it."""
        label = self.host.keys.label
        rows = [ListRow("Go on", value="")]
        if self.entry.start:
            rows.append(ListRow("Choose another game", value=ANOTHER_GAME))
        rows += [ListRow(c.heading, chip=label(c.name), value=c.name) for c in COMMANDS if c.choice]
        self.host.cards.open_choices("Pause", rows, self._do_later)

    def _do_later(self, name: str) -> None:
        self._waiting = name

    def _choose(self, heading: str, rows: list[ListRow], present: Any) -> None:
        assert self.play is not None
        self.host.cards.open_choices(heading, rows, self.play.open_file, present)

    def _choose_level(self, play: ScenePlay) -> None:
        """The list of levels, with pictures where the scene draws them."""
        if self.entry.level_card:
            self.host.cards.open_levels(self.entry, play.open_file, play.shelf.present)
        else:
            self._choose("Levels and hard cases", play.shelf.levels(), play.shelf.present)

    def _open_study(self) -> None:
        assert self.play is not None
        study = self.play.stage.scene_type.study
        if study is None:
            self.host.tell("No study.", "This scene has none yet.")
            return
        self.play.record.errands.wait()  # it looks into the scene
        self.host.cards.open_study(study, self.play.stage, self.play.post)

    # -- life ---------------------------------------------------------------------------------------

    def covered(self) -> None:
        super().covered()
        self.shell.tip.update(0.0, None)  # else it would stand under the card

    def uncovered(self) -> None:
        name, self._waiting = self._waiting, ""
        if name == ANOTHER_GAME:
            self.host.open_scene(self.entry.name)
        elif name:
            self.host.perform(name)

    def load(self, elapsed_s: float) -> bool:
        """Go on loading for so long, as under a card; whether the scene has just come, or could not."""
        if self.loader is None:
            return False
        self.shell.loading.update(elapsed_s, self.loader.done, self.loader.total)
        if not self.loader.finished:
            return False
        self._open(self.loader)
        return True

    def update(self, elapsed_s: float) -> None:
        if self.load(elapsed_s) and self.goes_on and self.play is not None:
            if self.play.stage.scene_type.builds:
                self.host.tell("As you left it.", "The list of levels begins anew.")
            else:
                self.host.tell("Your game goes on.", "N begins a new one.")
        if self.play is not None:
            self.play.update(elapsed_s)
            self._age_s += elapsed_s
            # a game begins with its own card, and the tour can wait for another scene
            if (
                not self.entry.start
                and self._tour_due
                and self._age_s >= TOUR_AFTER_S
                and not self.play.hand.held
            ):
                self._open_tour()
        else:
            self.shell.update(elapsed_s, None, None)

    def _open(self, loader: Loader) -> None:
        """The scene is there, or it is not: then say why and go back to the menu."""
        self.loader = None
        if loader.stage is None and self.goes_on:
            self.goes_on, self.opening = False, Opening()
            self.host.tell("What was kept cannot be read.", loader.error, "warning")
            self.loader = self._load()
            return
        if loader.stage is None:
            self.host.open_menu(self.entry.name)
            self.host.tell(f"{self.entry.title} cannot be opened.", loader.error, "warning")
            return
        from game.app.scene.play import ScenePlay

        self.play = ScenePlay(self.host, self.shell, loader.stage, self.opening)

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
        return self.shell.wants_key(event) or self.play.action_of(event) is not None

    def handle(self, event: pygame.Event) -> None:
        play = self.play
        if play is None:
            for wish in self.shell.handle(event)[1]:
                if wish.name in WITHOUT_A_SCENE:
                    perform(wish.name, self.actions)
            return
        name = None
        if event.type == pygame.KEYDOWN and not self.shell.wants_key(event):
            name = play.action_of(event)
        if name is not None:
            play.act(name)
            return
        for wish in play.handle(event):
            self._fulfil(wish)

    def _fulfil(self, wish: Wish) -> None:
        take = self._wishes().get(wish.name)
        if take is not None:
            take(wish.value)
        else:
            self.host.perform(wish.name)

    # -- picture ------------------------------------------------------------------------------------

    def draw(self, surface: pygame.Surface) -> None:
        loader = self.loader
        if self.play is not None:
            self.play.draw(surface)
        elif loader is not None:
            self.shell.draw_loading(surface, loader.done, loader.total, loader.name, loader.seconds)
        else:
            surface.fill(self.host.look.theme.bg)
