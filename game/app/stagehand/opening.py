"""How a scene is opened: with which level, parameters, effects and seed, or as a recording to be watched."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from game.levels import Level, level_files, load_level

if TYPE_CHECKING:
    from game.stage import Recording, Scene, Stage

NOTHING: Mapping[str, Any] = {}


class Opening(NamedTuple):
    """What is asked for; the rest is as the scene declares it."""

    level: Path | None = None
    parameters: Mapping[str, Any] = NOTHING
    effects_off: tuple[str, ...] = ()
    seed: int | None = None
    recording: Recording | None = None

    def make_stage(self, scene_type: type[Scene]) -> Stage:
        """The stage. Raises LevelError, ParameterError, RecordingError or ValueError, each with one line."""
        from game.stage import Stage, begin

        if self.recording is not None:
            return begin(self.recording, scene_type)
        return Stage(
            scene_type,
            level=read_level(scene_type, self.level),
            parameters=self.parameters,
            effects_off=self.effects_off,
            seed=self.seed,
        )


def read_level(scene_type: type[Scene], path: Path | None) -> Level | None:
    """The level in a file; without one the scene's default level, if it has any."""
    if path is None:
        path = next((file for file in level_files(scene_type.name) if file.stem == "default"), None)
    return None if path is None else load_level(path, scene_type.name, scene_type.content_type)
