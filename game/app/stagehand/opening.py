"""How a scene is opened: with which level, parameters, effects and seed, or as a recording to be watched."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import msgspec

from game.levels import Level, LevelError, level_files, load_level

if TYPE_CHECKING:
    from game.stage import Recording, Scene, Stage
    from game.stage.script.lines import Story

NOTHING: Mapping[str, Any] = {}


class Opening(NamedTuple):
    """What is asked for; the rest is as the scene declares it."""

    level: Path | None = None
    parameters: Mapping[str, Any] = NOTHING
    players: tuple[str, ...] = ()  # names of a game's players, in place of the level's
    cup: str = ""  # round of the cup that the match is
    effects_off: tuple[str, ...] = ()
    seed: int | None = None
    recording: Recording | None = None
    story: str | Path | None = None  # by its name or its file; "" is the scene's first one

    def make_stage(self, scene_type: type[Scene]) -> Stage:
        """The stage. Raises LevelError, ParameterError, RecordingError or ValueError, each with one line."""
        from game.stage import Stage, begin

        if self.recording is not None:
            return begin(self.recording, scene_type)
        story = self.read_story(scene_type)
        if story is not None:
            return Stage(scene_type, level=story.level)
        return Stage(
            scene_type,
            level=with_players(scene_type, read_level(scene_type, self.level), self.players, self.cup),
            parameters=self.parameters,
            effects_off=self.effects_off,
            seed=self.seed,
        )

    def read_story(self, scene_type: type[Scene]) -> Story | None:
        """The story that is asked for, if one is; LevelError."""
        from game.stage.story.reading import load_story, stories_of

        if self.story is None:
            return None
        if isinstance(self.story, Path):
            return load_story(self.story, scene_type)
        found = [one for one in stories_of(scene_type) if self.story in ("", one.name)]
        if not found:
            raise LevelError(None, "story", f"{scene_type.name} has none called {self.story!r}")
        return found[0]


def with_players(
    scene_type: type[Scene], level: Level | None, players: tuple[str, ...], cup: str = ""
) -> Level | None:
    """A level whose players have these names, in a round of a cup; the level itself without names. LevelError
    if it has none.
    """
    if not players:
        return level
    content_type: Any = scene_type.content_type
    content = level.content if level is not None and level.content is not None else content_type()
    if not hasattr(content, "players"):
        raise LevelError(None, "players", f"{scene_type.name} has none")
    named = msgspec.structs.replace(content, players=players, **({"cup": cup} if cup else {}))
    if level is None:
        return Level(scene=scene_type.name, content=named)
    return msgspec.structs.replace(level, content=named)


def read_level(scene_type: type[Scene], path: Path | None) -> Level | None:
    """The level in a file; without one the scene's default level, if it has any."""
    if path is None:
        path = next((file for file in level_files(scene_type.name) if file.stem == "default"), None)
    return None if path is None else load_level(path, scene_type.name, scene_type.content_type)
