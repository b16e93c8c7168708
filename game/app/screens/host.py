"""What a screen may ask of the program that shows it. The program is `game.app.application.App`."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

from game.app.compile.canvas_warming import CanvasWarming
from game.app.screens.question import Question
from game.app.stagehand.opening import Opening
from game.app.window.frames import FrameMeter
from game.app.window.guard import Failure, Guard
from game.app.window.keys import Keys
from game.app.window.pictures import PictureSaver
from game.app.window.settings import Settings
from game.stage.catalogue import Catalogue
from game.ui.look.layout import Layout
from game.ui.look.look import Look
from game.ui.sound import SoundPlayer
from game.ui.widgets.list_row import ListRow
from game.ui.widgets.toasts import Toasts

if TYPE_CHECKING:
    import pygame

    from game.app.stagehand.teaching_draft import Draft
    from game.lab import Study
    from game.stage import Scene, Stage, StageEvent
    from game.stage.catalogue import Entry
    from game.ui.widgets.paper import PaperRow


class Cards(Protocol):
    """Opens cards over the present screen; what is answered there goes to the function that is given."""

    def open_welcome(self) -> None:
        """The card of the very first start, over the menu."""
        ...

    def open_keys(self) -> None:
        """The card of all keys."""
        ...

    def open_settings(self) -> None:
        """The card of the settings."""
        ...

    def open_papers(self) -> None:
        """The list of the course's papers."""
        ...

    def open_career(self) -> None:
        """The card of the career."""
        ...

    def open_statistics(self, person: str) -> None:
        """The card of what was counted of a person's strokes."""
        ...

    def open_paper(self, row: PaperRow) -> None:
        """The page of a paper."""
        ...

    def open_name(self, question: Question, taken: Callable[[str], object]) -> None:
        """A card that asks for a name; ``taken`` is called with what was typed."""
        ...

    def open_choices(
        self, heading: str, rows: Sequence[ListRow], chosen: Callable[[Any], object], present: Any = None
    ) -> None:
        """A card with a list; ``chosen`` is called with the value of the row taken."""
        ...

    def open_levels(
        self, entry: Entry, chosen: Callable[[Path], object], present: Path | None = None
    ) -> None:
        """The card of a scene's levels, with pictures; ``chosen`` is called with the file of one."""
        ...

    def open_help(self, scene_type: type[Scene], level: tuple[str, str] = ("", "")) -> None:
        """A scene's help page; ``level``: title and words of the level in play."""
        ...

    def open_teaching(self, draft: Draft, taken: Callable[[Draft], str]) -> None:
        """The card on which a teaching level is made; ``taken`` saves it, or says why it cannot."""
        ...

    def open_tour(
        self, layout: Callable[[], Layout], bar: Callable[[], Mapping[str, pygame.Rect]] | None
    ) -> None:
        """The tour of a window that is laid out so; ``bar``: the parts of a story's bar, if it has one."""
        ...

    def open_study(self, study: Study, stage: Stage, post: Callable[[StageEvent], object]) -> None:
        """What accuracy costs in a scene; ``post`` lets an event into it."""
        ...


class Host(Protocol):
    """Lends appearance, keys, settings and services; opens screens, of which a screen knows no other."""

    catalogue: Catalogue
    settings: Settings
    folder: Path  # of the settings
    look: Look
    keys: Keys
    guard: Guard
    meter: FrameMeter
    sounds: SoundPlayer
    pictures: PictureSaver
    toasts: Toasts
    canvas_warming: CanvasWarming
    cards: Cards
    background: bool  # whether work may be done in the background
    tour_due: bool  # the next scene opened begins with the tour
    story_tour_due: bool  # the next story opened begins with that of stories
    welcome_due: bool  # the menu begins with the card of the very first start
    menu_category: str  # of the menu's card that was opened last: there its scene leads back to

    @property
    def size(self) -> tuple[int, int]:
        """The window's size, px."""
        ...

    @property
    def full_screen(self) -> bool:
        """Whether the window covers the whole screen."""
        ...

    # -- messages and settings

    def tell(self, cause: str, consequence: str = "", kind: str = "info") -> None:
        """A message that fades: kind is "info", "warning" or "marker"."""
        ...

    def tell_of(self, failure: Failure, consequence: str) -> None:
        """Something has failed: what was done about it, and where one can read why."""
        ...

    def perform(self, name: str) -> bool:
        """Do a command of `game.app.window.commands`, or of the screen on top; False if there is none."""
        ...

    def save_settings(self) -> None:
        """Keep the settings."""
        ...

    def restyle(self) -> None:
        """Lay all screens out again for another size, scale or theme."""
        ...

    def change_keys(self, changed: dict[str, str]) -> None:
        """Other keys from now on. ValueError, and nothing changed, if they clash."""
        ...

    def toggle_theme(self) -> None:
        """Dark or light."""
        ...

    def toggle_full_screen(self) -> None:
        """Window or whole screen."""
        ...

    # -- screens

    def pop(self) -> None:
        """Back to the screen below; from the last one out of the program."""
        ...

    def open_menu(self, focus: str = "") -> None:
        """The menu in place of everything, with that scene's card chosen."""
        ...

    def open_scene(self, name: str, level: Path | None = None, opening: Opening | None = None) -> None:
        """A scene in place of the menu or of another scene."""
        ...

    def open_clipboard(self) -> None:
        """Watch the run whose text lies in the clipboard."""
        ...

    def open_next_round(self) -> None:
        """The next match of the tournament at its table; the card of the career once that has ended."""
        ...
