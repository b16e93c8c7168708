"""What accuracy costs, over the scene: the study runs, its points can be clicked, its table saved."""

from __future__ import annotations

from collections.abc import Callable
from datetime import datetime
from typing import TYPE_CHECKING, ClassVar

import pygame

from game.app.scene.study_run import StudyRun, accuracy_data
from game.app.screens.host import Host
from game.app.screens.page_screen import PageScreen
from game.app.window.commands import Actions
from game.folders import user_folder
from game.stage import SetEffect, SetParameter, Stage, StageEvent
from game.ui.charts.accuracy import AccuracyPage
from game.ui.charts.accuracy_data import AccuracyData
from game.ui.widgets.tooltips import ToolTip
from game.ui.widgets.wishes import Wish

if TYPE_CHECKING:
    from game.lab import Study, StudyTable

REFRESH_S = 0.25  # s between looks at what has been measured


_tables: dict[str, StudyTable] = {}  # by study: what was measured is gone on with as long as the program runs
_latest: list[StudyRun] = []  # the run that was begun last, of any card: it may still be in its last repeat


class AccuracyCard(PageScreen):
    """Goes on with what was measured earlier; offers all studies of the scene."""

    called: ClassVar[str] = "What accuracy costs"

    page: AccuracyPage

    def __init__(self, host: Host, study: Study, stage: Stage, post: Callable[[StageEvent], object]):
        self._stage = stage
        self._post = post
        self._studies = study.family
        self._start(study)
        self._since_s = 0.0
        self._shown = -1
        self._tip = ToolTip(host.look)
        super().__init__(host, AccuracyPage(host.look, self._data()))

    def _start(self, study: Study) -> None:
        """Measure a study, once the run before it, of this card or of one that was closed, has stopped."""
        for before in _latest:
            before.stop()
        self.run = StudyRun(study, self._stage.scene.chosen(), _tables.get(study.name), *_latest)
        _tables[study.name], _latest[:] = self.run.table, [self.run]

    def _data(self) -> AccuracyData:
        study = self.run.study
        names = tuple(one.short or one.title for one in self._studies) if len(self._studies) > 1 else ()
        return accuracy_data(self.run, study.title)._replace(studies=names, study=self._studies.index(study))

    def _choose(self, number: int) -> None:
        """Show and measure another study."""
        if self._studies[number] is not self.run.study:
            self._start(self._studies[number])
            self._shown = -1
            self._refresh()

    def restyle(self) -> None:
        super().restyle()
        self._tip.place(self.host.look)

    def closed(self) -> None:
        self.run.stop()

    @property
    def actions(self) -> Actions:
        return {**super().actions, "accuracy": self.close}

    def update(self, elapsed_s: float) -> None:
        self._since_s += elapsed_s
        if self._since_s >= REFRESH_S:
            self._since_s = 0.0
            self._refresh()
        self._tip.update(elapsed_s, self.page.tip())
        super().update(elapsed_s)

    def _refresh(self) -> None:
        """Show what has come in since the last look."""
        state = (
            len(self.run.table)
            + (1_000_000 if self.run.present is not None else 0)
            + (not self.run.progress.running)
        )
        if state != self._shown:
            self._shown = state
            if self.run.failure is not None:
                kept = self.host.guard.keep(self.called, self.run.failure)
                self.run.error, self.run.failure = f"{self.run.error}. {kept.where}".rstrip(), None
            self.page.show(self._data())
        self.page.report(self.run.progress)

    def draw(self, surface: pygame.Surface) -> None:
        super().draw(surface)
        self._tip.draw(surface)

    def fulfil(self, wish: Wish) -> None:
        if wish.name == "stop":
            self.run.stop()
        elif wish.name == "save-csv":
            self._save_csv()
        elif wish.name == "save-picture":
            self._save_picture()
        elif wish.name == "study":
            self._choose(wish.value)
        elif wish.name == "point":
            self._set_scene(dict(wish.value))

    def _set_scene(self, parameters: dict[str, object]) -> None:
        """Set the scene's parameters and effects to those of a point, and go back to it."""
        scene = self._stage.scene
        declared, effects = scene.declared_parameters(), scene.effects.names
        for name, value in parameters.items():
            if name in declared:
                self._post(SetParameter(name, value))  # type: ignore[arg-type]
            elif name in effects:
                self._post(SetEffect(name, bool(value)))
        self.close()

    def _save_csv(self) -> None:
        from game.lab.report import write_csv

        folder = user_folder() / "reports"
        name = f"{self.run.study.name}-{datetime.now():%Y-%m-%d-%H%M%S}.csv"
        try:
            folder.mkdir(parents=True, exist_ok=True)
            write_csv(self.run.table, folder / name)
        except OSError as error:
            self.host.tell("Not saved.", str(error.strerror or error), "warning")
        else:
            self.host.tell("Table saved", str(folder / name))

    def _save_picture(self) -> None:
        try:
            self.host.pictures.save(self.page.picture(), self.run.study.name)
        except OSError as error:
            self.host.tell("Not saved.", str(error.strerror or error), "warning")
