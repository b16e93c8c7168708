"""The cards of the program: which screen answers what is asked, opened over the present one.

What few open in a run is imported as it is opened.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

from game.app.menu.screen import MenuScreen
from game.app.menu.welcome_card import WelcomeCard
from game.app.screens.choices import ChoiceCard
from game.app.screens.host import Host
from game.app.screens.keys_card import KeysCard
from game.app.screens.level_card import LevelCard
from game.app.screens.name_card import NameCard
from game.app.screens.paper_card import PaperCard
from game.app.screens.papers_card import PapersCard
from game.app.screens.question import Question
from game.app.screens.screen import Screen
from game.app.screens.settings_card import SettingsCard
from game.app.screens.stack import ScreenStack
from game.ui.look.layout import Layout
from game.ui.widgets.list_row import ListRow

if TYPE_CHECKING:
    import pygame

    from game.app.stagehand.teaching_draft import Draft
    from game.lab import Study
    from game.stage import Scene, Stage, StageEvent
    from game.stage.catalogue import Entry
    from game.ui.widgets.paper import PaperRow


class Program(Host, Protocol):
    """The host of these cards, and the pile that they lie on."""

    screens: ScreenStack

    def open_card(self, name: str, make: Callable[[], Screen]) -> None:
        """A screen over the present one; a message names one that cannot be made."""
        ...


class AppCards:
    """The `Cards` of a program."""

    def __init__(self, app: Program) -> None:
        self.app = app

    def open_welcome(self) -> None:
        """The card of the very first start, over the menu; it is not shown again."""
        self.app.welcome_due = False
        self.app.save_settings()  # once there is a file it is no first start any more
        self.app.open_card(WelcomeCard.called, lambda: WelcomeCard(self.app, self._show_category))

    def _show_category(self, category: str) -> None:
        """Where the menu lies below, go to a category."""
        for screen in self.app.screens:
            if isinstance(screen, MenuScreen):
                screen.show_category(category)

    def open_keys(self) -> None:
        """The card of all keys."""
        self.app.open_card(KeysCard.called, lambda: KeysCard(self.app))

    def open_settings(self) -> None:
        """The card of the settings; not over itself."""
        if not isinstance(self.app.screens.top, SettingsCard):
            self.app.open_card(SettingsCard.called, lambda: SettingsCard(self.app))

    def open_papers(self) -> None:
        """The list of the course's papers; not over itself."""
        if not isinstance(self.app.screens.top, PapersCard):
            self.app.open_card(PapersCard.called, lambda: PapersCard(self.app))

    def open_career(self) -> None:
        """The card of the career; not over itself."""
        from game.app.screens.career_card import CareerCard

        if not isinstance(self.app.screens.top, CareerCard):
            self.app.open_card(CareerCard.called, lambda: CareerCard(self.app))

    def open_statistics(self, person: str) -> None:
        """The card of what was counted of a person's strokes."""
        from game.app.screens.statistics_card import StatisticsCard

        self.app.open_card(StatisticsCard.called, lambda: StatisticsCard(self.app, person))

    def open_paper(self, row: PaperRow) -> None:
        """The page of a paper, which is measured while it is open."""
        self.app.open_card(PaperCard.called, lambda: PaperCard(self.app, row))

    def open_name(self, question: Question, taken: Callable[[str], object]) -> None:
        """A card that asks for a name; ``taken`` is called with what was typed."""
        self.app.open_card(NameCard.called, lambda: NameCard(self.app, question, taken))

    def open_choices(
        self, heading: str, rows: Sequence[ListRow], chosen: Callable[[Any], object], present: Any = None
    ) -> None:
        """A card with a list; ``chosen`` is called with the value of the row taken."""
        self.app.open_card(ChoiceCard.called, lambda: ChoiceCard(self.app, heading, rows, chosen, present))

    def open_levels(
        self, entry: Entry, chosen: Callable[[Path], object], present: Path | None = None
    ) -> None:
        """The card of a scene's levels, with pictures; ``chosen`` is called with the file of one."""
        self.app.open_card(LevelCard.called, lambda: LevelCard(self.app, entry, chosen, present))

    def open_help(self, scene_type: type[Scene], level: tuple[str, str] = ("", "")) -> None:
        """A scene's help page; ``level``: title and words of the level in play."""
        from game.app.scene.help_card import HelpCard

        self.app.open_card(HelpCard.called, lambda: HelpCard(self.app, scene_type, level))

    def open_teaching(self, draft: Draft, taken: Callable[[Draft], str]) -> None:
        """The card on which a teaching level is made; ``taken`` saves it, or says why it cannot."""
        from game.app.screens.teaching_card import TeachingCard

        self.app.open_card(TeachingCard.called, lambda: TeachingCard(self.app, draft, taken))

    def open_tour(
        self, layout: Callable[[], Layout], bar: Callable[[], Mapping[str, pygame.Rect]] | None
    ) -> None:
        """The tour of a window that is laid out so; ``bar``: the parts of a story's bar, if it has one."""
        from game.app.scene.tour import TourScreen

        self.app.open_card(TourScreen.called, lambda: TourScreen(self.app, layout, bar))

    def open_study(self, study: Study, stage: Stage, post: Callable[[StageEvent], object]) -> None:
        """What accuracy costs in a scene; ``post`` lets an event into it."""
        from game.app.scene.accuracy_card import AccuracyCard

        self.app.open_card(AccuracyCard.called, lambda: AccuracyCard(self.app, study, stage, post))
