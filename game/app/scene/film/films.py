"""The films of a scene in play: asked for, made beside it, finished in the background, and told of."""

from __future__ import annotations

from collections.abc import Callable
from datetime import datetime
from pathlib import Path

import pygame

from game.app.film.video import VideoError
from game.app.scene.film.again import SLOW_S, FilmAgain
from game.app.scene.film.live import LiveFilm
from game.app.scene.film.strokes import FilmOfStrokes
from game.app.scene.film.writers import LONGEST_S, MISSING, Writer, has_mp4, make_writer
from game.app.scene.in_play import InPlay
from game.app.screens.host import Host
from game.app.stagehand.view import StageView
from game.folders import pictures_folder
from game.stage.replays.rerun import Rerun
from game.ui.widgets.list_row import ListRow

LAST_S = 10.0


class Films:
    """One film at a time."""

    def __init__(self, host: Host, record: InPlay, view: StageView) -> None:
        self._host, self._record, self._view = host, record, view
        self.live: LiveFilm | None = None
        self.again: FilmAgain | FilmOfStrokes | None = None
        self.finishing: Writer | None = None
        self._preparing = False
        self._wanted = record.stage.scene.film_wanted

    @property
    def busy(self) -> bool:
        """Whether a film is being made."""
        return bool(self.live or self.again or self.finishing or self._preparing)

    @property
    def words(self) -> str:
        """What is being made and how far it is; empty if nothing is."""
        if self.live is not None:
            return f"Filming {self.live.seconds:.1f} s · {self._host.keys.label('film')} ends it"
        if self.again is not None:
            return f"{self.again.label}, {100 * self.again.share:.0f} %"
        if self.finishing is not None:
            return f"Finishing the film, {100 * self.finishing.share:.0f} %"
        return "Film of the last seconds, 0 %" if self._preparing else ""

    def ask(self) -> None:
        """End the film that is being taken, or offer those that there can be."""
        if self.live is not None:
            self.stop()
        elif self.busy:
            self._host.tell("One film at a time.", self.words)
        else:
            self._host.cards.open_choices("Film", self._rows(), lambda value: self.begin(*value))

    def _rows(self) -> list[ListRow]:
        return [*self._scene_rows(), *self._any_rows()]

    def _scene_rows(self) -> list[ListRow]:
        """What the scene itself has to show."""
        if not self._record.stage.scene.highlights():
            return []
        kind = "mp4" if has_mp4() else "gif"
        about = "The last winning strokes, the highest run" if has_mp4() else MISSING
        return [ListRow("Film the deciding strokes", about, kind, value=("match", kind))]

    def _any_rows(self) -> list[ListRow]:
        """What can be filmed of every scene."""
        ends, least = f"{self._host.keys.label('film')} ends it", f"At most {LONGEST_S['gif']:.0f} s"
        if not has_mp4():
            return [
                ListRow(
                    "Film this", f"{least}, without sound; {ends}. {MISSING}", "gif", value=("this", "gif")
                ),
                ListRow("Film the last ten seconds", "Without sound", "gif", value=("last", "gif")),
            ]
        last = "Film the last ten seconds"
        return [
            ListRow("Film this", f"From now on, with sound; {ends}", "mp4", value=("this", "mp4")),
            ListRow(last, "With sound, beside what goes on", "mp4", value=("last", "mp4")),
            ListRow("Film this, small", f"{least}, without sound; {ends}", "gif", value=("this", "gif")),
            ListRow(f"{last}, small", "Without sound", "gif", value=("last", "gif")),
        ]

    def begin(self, what: str, kind: str) -> None:
        """Begin a film; what: "this" from now on, or "last" ten seconds; kind: "mp4" or "gif"."""
        if self.busy:
            self._host.tell("One film at a time.", self.words)
            return
        if what == "last":
            self._preparing = True
            self._record.errands.work(lambda: self._prepare(kind))
            return
        if what == "match":
            self._begin_match(kind)
            return
        try:
            writer = self._writer(kind)
        except VideoError as error:
            self._refuse(error)
            return
        self.live = LiveFilm(writer, self._sounding)
        self._host.tell("Filming", str(writer.path))

    def film_match(self) -> None:
        """The film of the deciding strokes at once; without PyAV one line says how to have it with sound."""
        kind = "mp4" if has_mp4() else "gif"
        if kind == "gif":
            self._host.tell("A film without sound.", MISSING, "warning")
        self.begin("match", kind)

    def _begin_match(self, kind: str) -> None:
        """The strokes that decided a match, one after the other."""
        stage = self._record.stage
        excerpts, writer = stage.scene.highlights(), None
        try:
            if not excerpts:
                raise VideoError("No stroke has decided anything yet.")
            writer = self._writer(kind)
            self.again = FilmOfStrokes(stage.scene_type, excerpts, writer, self._host.settings.theme)
        except VideoError as error:
            if writer is not None:
                writer.drop()
            self._refuse(error)
            return
        strokes = "stroke" if len(excerpts) == 1 else f"{len(excerpts)} strokes"
        self._host.tell(f"Filming the deciding {strokes}.", str(writer.path))

    @property
    def _sounding(self) -> bool:
        return self._record.stage.scene.is_heard()

    def _writer(self, kind: str) -> Writer:
        return make_writer(
            kind, free_path(self._record.stage.scene.name, kind), self._view.rect.size, self._sounding
        )

    def _prepare(self, kind: str) -> Callable[[], object]:
        """Build what the last seconds are gone through with; what is then to be done with it."""
        stage = self._record.stage
        steps = round(LAST_S * stage.speed / stage.dt)
        try:
            if stage.step_number == 0:
                raise VideoError("There is nothing yet: no step has been made.")
            rerun = Rerun(stage.kept_from(max(stage.step_number - steps, 0)))
            writer = self._writer(kind)
        except (VideoError, ValueError, ArithmeticError) as error:
            problem = error
            return lambda: self._refuse(problem)
        return lambda: self._begin_again(rerun, writer, steps)

    def _begin_again(self, rerun: Rerun, writer: Writer, steps: int) -> None:
        self._preparing = False
        stage, settings = self._record.stage, self._host.settings
        self.again = FilmAgain(rerun, writer, stage.speed, settings.theme, self._view.camera)
        seconds = self.again.count / writer.rate
        kept = rerun.kept.last - rerun.kept.first
        less = kept < min(steps, rerun.kept.last)
        about = "; no more of it is kept" if less else ""
        self._host.tell(f"Filming the last {seconds:.1f} s{about}.", str(writer.path))

    def stop(self) -> None:
        """End the film that is being taken."""
        if self.live is not None:
            live, self.live = self.live, None
            self._finish(live.writer)

    # -- time ---------------------------------------------------------------------------------------

    def update(self, elapsed_s: float) -> None:
        """Let time pass."""
        errands, stage = self._record.errands, self._record.stage
        if self.finishing is not None and not self._host.pictures.at_work(self.finishing.path):
            self.finishing = None
        if self.live is not None:
            still = stage.paused or errands.busy
            self.live.pass_time(elapsed_s, None if still else stage.scene.hearing())
            if self.live.finished:
                self._host.tell("The film is as long as it can be.")
                self.stop()
        if stage.scene.film_wanted and stage.scene.film_wanted != self._wanted:
            self.film_match()
        self._wanted = stage.scene.film_wanted
        if self.again is not None and not errands.busy:
            self._go_on(self.again)

    def _go_on(self, film: FilmAgain | FilmOfStrokes) -> None:
        """The next picture of the last seconds; in a thread where its steps take long."""
        if film.writer.full:
            return
        steps = self._record.stage.speed / film.writer.rate / film.dt
        slow = self._record.stage.last_step_s * steps > SLOW_S
        try:
            if slow and self._record.errands.in_background:
                self._record.errands.work(lambda: self._step(film))
            else:
                film.step()
                self._draw(film)
        except VideoError as error:
            self._give_up(film, str(error))

    def _step(self, film: FilmAgain | FilmOfStrokes) -> Callable[[], object]:
        film.step()
        return lambda: self._draw(film)

    def _draw(self, film: FilmAgain | FilmOfStrokes) -> None:
        """Draw a picture whose steps are made; the last one ends the film."""
        if film is not self.again:
            return
        if film.failed:
            self._give_up(film, "It cannot be gone through once more.")
            return
        film.draw()
        if film.finished:
            self.again = None
            if not film.same:
                self._host.tell("The film may differ from what was seen.", "Its digest does.", "warning")
            self._finish(film.writer)

    def see(self, surface: pygame.Surface, place: pygame.Rect) -> None:
        """The scene has been drawn into this part of the window."""
        if self.live is None:
            return
        try:
            self.live.see(surface, place)
        except VideoError as error:
            live, self.live = self.live, None
            live.writer.drop()
            self._refuse(error)

    # -- ends ---------------------------------------------------------------------------------------

    def _finish(self, writer: Writer) -> None:
        self.finishing = writer
        self._host.pictures.finish(writer.path, writer.finish)

    def _give_up(self, film: FilmAgain | FilmOfStrokes, why: str) -> None:
        self.again = None
        film.writer.drop()
        self._host.tell("No film.", why, "warning")

    def _refuse(self, error: Exception) -> None:
        self._preparing = False
        self._host.tell("No film.", str(error), "warning")

    def close(self) -> None:
        """The scene is left: what was filmed is finished, what was to be gone through is not."""
        self.stop()
        if self.again is not None:
            self._give_up(self.again, "The scene was left before it was done.")


def free_path(scene_name: str, kind: str) -> Path:
    """A name in the pictures folder that no film has yet."""
    folder, stamp = pictures_folder(), f"{datetime.now():%Y-%m-%d-%H%M%S}"
    path, number = folder / f"carom-{scene_name}-{stamp}.{kind}", 2
    while path.exists():
        path, number = folder / f"carom-{scene_name}-{stamp}-{number}.{kind}", number + 1
    return path
