"""Levels and recordings of a scene in play: opened, watched, saved.

All of it is done behind the window, as a large file takes longer than a frame; what is broken in one is told
in a line, and the scene goes on with what it had.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from game.app.scene.variants import Variants
from game.app.screens.choices import Row
from game.app.stagehand import files
from game.app.stagehand.opening import Opening
from game.levels import Level, LevelError, load_level
from game.stage import ParameterError, Recording, RecordingError, Scene, Stage

if TYPE_CHECKING:
    from game.app.scene.play import ScenePlay

Act = Callable[[], object]
PROBLEMS = (LevelError, RecordingError, ParameterError)


class Shelf:
    """Files of one scene in play."""

    def __init__(self, play: ScenePlay) -> None:
        self._play = play

    @property
    def present(self) -> Path | None:
        """File of the level in play."""
        level = self._play.stage.level
        return level.path if level is not None else None

    def levels(self) -> list[Row]:
        """Rows of the gallery."""
        return files.level_rows(self._play.stage.scene_type)

    def saved(self) -> list[Row]:
        """Rows of what was saved."""
        return files.saved_rows(self._play.stage.scene_type.name)

    def open(self, path: Path) -> None:
        """Begin with a level, or watch a recording."""
        self._play.cancel()
        self._play.errands.work(lambda: self._read(Path(path)))

    def save(self) -> None:
        """Keep the present content as a level, and the session as a recording."""
        self._play.errands.work(self._write, kept=True)

    def _read(self, path: Path) -> Act:
        """Read and build what is in a file; what is then to be done with it."""
        play = self._play
        try:
            if path.suffix == ".json":
                recording = Recording.load(path)
                stage = self._begin(recording)
                return lambda: play.watch(stage, recording)
            scene_type = play.stage.scene_type
            level = load_level(path, scene_type.name, scene_type.content_type)
            scene = play.stage.scene_of(level)
            play.variants.prepare_level(level)
        except PROBLEMS as error:
            return self._refusal("Not opened.", str(error))
        return lambda: self._begin_level(level, scene)

    def _begin(self, recording: Recording) -> Stage:
        """A stage at the beginning of a recording, with all compiled that will be wanted on the way."""
        scene_type = self._play.stage.scene_type
        if recording.scene != scene_type.name:
            raise RecordingError(None, "scene", f"of {recording.scene}")
        stage = Opening(recording=recording).make_stage(scene_type)
        Variants(stage).prepare(stamped.event for stamped in recording.events)
        return stage

    def _begin_level(self, level: Level, scene: Scene) -> None:
        """Begin with a level that has been read and built."""
        try:
            self._play.stage.load_level(level, scene)
        except PROBLEMS as error:
            self._refusal("Not opened.", str(error))()
            return
        self._play.begin_anew()

    def _write(self) -> Act:
        """Write the scene as it stands; what is then to be told."""
        try:
            path = files.save_all(self._play.stage)
        except PROBLEMS as error:
            return self._refusal("Not saved.", str(error))
        return lambda: self._have_saved(path)

    def _have_saved(self, path: Path) -> None:
        self._play.offer_levels()
        self._play.app.tell("Saved", f"{path.stem} in {path.parent}")

    def _refusal(self, cause: str, why: str) -> Act:
        return lambda: self._play.app.tell(cause, why, "warning")
