"""Levels and recordings of a scene in play: opened, watched, saved.

All of it is done in the background, as a large file takes longer than a frame. What is wrong with one is said
in a line, and the scene goes on with what it had.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from game.app.scene.in_play import InPlay
from game.app.scene.variants import Variants
from game.app.screens.host import Host
from game.app.screens.question import Question
from game.app.stagehand import files
from game.app.stagehand.opening import Opening
from game.app.window import clipboard
from game.levels import Level, LevelError, level_files, load_level
from game.stage import (
    Action,
    ParameterError,
    Recording,
    RecordingError,
    Scene,
    SetParameter,
    Stage,
    StageEvent,
)
from game.ui.widgets.list_row import ListRow

if TYPE_CHECKING:
    from game.stage.records.excerpt import Excerpt

Act = Callable[[], object]
STORY_PREFIX = "story-"
MOST_LETTERS = 60  # of a title; a card of levels cuts longer ones
PROBLEMS = (LevelError, RecordingError, ParameterError)


class Shelf:
    """Files of one scene in play. ``opened`` and ``saved`` are called when one has been."""

    def __init__(self, record: InPlay, host: Host, opened: Act, saved: Act) -> None:
        self._record = record
        self._host = host
        self._opened = opened
        self._saved = saved
        self._copied: Excerpt | None = None  # what was copied last, if it was a part of the session

    @property
    def present(self) -> Path | None:
        """File of the level in play."""
        level = self._record.stage.level
        return level.path if level is not None else None

    def levels(self) -> list[ListRow]:
        """Rows of the gallery, its stories first."""
        scene_type = self._record.stage.scene_type
        return files.story_rows(scene_type) + files.level_rows(scene_type)

    def saved(self) -> list[ListRow]:
        """Rows of what was saved."""
        return files.saved_rows(self._record.stage.scene_type.name)

    def open(self, path: Path) -> None:
        """Begin with a level, or watch a recording or a story."""
        if path.name.startswith(STORY_PREFIX):
            self._host.open_scene(self._record.stage.scene_type.name, opening=Opening(story=Path(path)))
            return
        self._record.errands.work(lambda: self._read(Path(path)))

    def own_level(self, stem: str) -> Path | None:
        """File of a level of the scene by its name; None without one, or if it is the present one."""
        if not stem or self._record.watched or self._record.borrowed:
            return None
        files = level_files(self._record.stage.scene.name)
        return next((path for path in files if path.stem == stem and path != self.present), None)

    def level_of(self, event: StageEvent) -> Path | None:
        """The level that an event asks for: by another value of the level's parameter, or an action so named.

        None where it asks for none, or there is none with that value.
        """
        scene = self._record.stage.scene
        name = scene.level_parameter
        if not name:
            return None
        if isinstance(event, SetParameter) and event.name == name:
            value = event.value
        elif isinstance(event, Action):
            value = event.name
        else:
            return None
        for path in level_files(scene.name):
            try:
                level = load_level(path, scene.name, scene.content_type)
            except LevelError:  # opening it says why
                continue
            if level.parameters.get(name, scene.parameter(name).default) == value:
                return path
        return None

    def chosen(self) -> list[SetParameter]:
        """What a person has chosen otherwise than the level says, to be chosen again in another one."""
        scene = self._record.stage.scene
        return [
            SetParameter(name, value)
            for name, value in scene.values.items()
            if name != scene.level_parameter and value != scene.level_value(name)
        ]

    def ask_and_save(self) -> None:
        """Ask for a title, and save under it."""
        about = f"As a level and a recording; {self._host.keys.label('open')} opens them again"
        question = Question("Save", about, "Save", "", files.date_title(), MOST_LETTERS)
        self._host.cards.open_name(question, self.save)

    def save(self, title: str = "") -> None:
        """Keep the present content as a level, and the session as a recording; "": titled by the date."""
        self._record.errands.work(lambda: self._write(title), kept=True)

    def copy(self) -> None:
        """Put the last stroke (of a scene that gives such excerpts), or the session, into the clipboard as a
        text. Asked a second time in a row, it is the session.
        """
        self._record.errands.work(self._pack)

    def _pack(self) -> Act:
        """Make the text; what is then to be done with it."""
        from game.stage.records.run_text import text_of
        from game.stage.replaying import recording_of_excerpt

        stage = self._record.stage
        try:
            excerpt = stage.scene.excerpt()
            whole = excerpt is None or excerpt == self._copied
            if whole or excerpt is None:
                text = text_of(stage.recording)
            else:
                text = text_of(recording_of_excerpt(stage.scene_type, excerpt))
        except PROBLEMS as error:
            return self._refusal("Not copied.", str(error))
        self._copied = None if whole else excerpt
        what = "The session is copied" if whole or excerpt is None else f"The {excerpt.name} is copied"
        again = "" if whole else f" {self._host.keys.label('copy')} once more copies the whole session."
        return lambda: self._have_copied(text, what, f"{len(text)} letters.{again}")

    def _have_copied(self, text: str, what: str, more: str) -> None:
        why = clipboard.put(text)
        if why:
            self._host.tell("Not copied.", why, "warning")
        else:
            self._host.tell(f"{what} as text.", more)

    def _read(self, path: Path) -> Act:
        """Read and build what is in a file; what is then to be done with it."""
        record = self._record
        try:
            if path.suffix == ".json":
                recording = Recording.load(path)
                replay = self._stage_of(recording)
                return lambda: self._watch(replay, recording)
            scene_type = record.stage.scene_type
            level = load_level(path, scene_type.name, scene_type.content_type)
            scene = record.stage.scene_of(level)
            record.variants.prepare_level(level)
        except PROBLEMS as error:
            return self._refusal("Not opened.", str(error))
        return lambda: self._begin_level(level, scene)

    def _stage_of(self, recording: Recording) -> Stage:
        """A stage at the beginning of a recording, with all compiled that it needs on the way."""
        scene_type = self._record.stage.scene_type
        if recording.scene != scene_type.name:
            raise RecordingError(None, "scene", f"of {recording.scene}")
        stage = Opening(recording=recording).make_stage(scene_type)
        Variants(stage).prepare(stamped.event for stamped in recording.events)
        return stage

    def _watch(self, stage: Stage, recording: Recording) -> None:
        """Play a recording, from its beginning, before the user's eyes."""
        self._record.show(stage, recording)
        self._host.tell("Replaying", f"{recording.steps} steps as they were recorded")
        self._opened()

    def _begin_level(self, level: Level, scene: Scene) -> None:
        """Begin with a level that has been read and built."""
        try:
            self._record.stage.load_level(level, scene)
        except PROBLEMS as error:
            self._refusal("Not opened.", str(error))()
            return
        self._record.begin_level()
        self._opened()

    def _write(self, title: str) -> Act:
        """Write the scene as it stands; what is then to be said."""
        try:
            path = files.save_all(self._record.stage, title)
        except PROBLEMS as error:
            return self._refusal("Not saved.", str(error))
        return lambda: self._have_saved(path, title)

    def _have_saved(self, path: Path, title: str) -> None:
        self._saved()
        self._host.tell(
            "Saved", f"{title}: {path.stem} in {path.parent}" if title else f"{path.stem} in {path.parent}"
        )

    def _refusal(self, cause: str, why: str) -> Act:
        return lambda: self._host.tell(cause, why, "warning")
