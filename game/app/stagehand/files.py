"""What a person keeps of a scene: its present content as a level, and the session as a recording."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

import msgspec

from game.app.stagehand.level_index import level_heads, story_heads
from game.folders import user_folder
from game.levels import Level, save_level
from game.teaching import Teaching
from game.ui.widgets.list_row import ListRow

if TYPE_CHECKING:
    from game.stage import Scene, Stage


def recordings_folder() -> Path:
    """Where recordings are kept."""
    return user_folder() / "recordings"


def present_level(stage: Stage, title: str) -> Level:
    """The scene as it is now: the parameters that are not at their defaults, effects, seed, content."""
    scene = stage.scene
    changed = {
        name: scene.values[name]
        for name, parameter in scene.declared_parameters().items()
        if scene.values[name] != parameter.default
    }
    return Level(
        scene=scene.name,
        title=title,
        seed=scene.level.seed if scene.level is not None else 0,
        parameters=changed,
        effects_off=tuple(effect.name for effect in scene.effects if effect not in scene.active),
        teaching=stage.level.teaching if stage.level is not None else None,
        content=scene.save_content(),
    )


def with_teaching(level: Level, teaching: Teaching) -> Level:
    """The same level with another task."""
    return msgspec.structs.replace(level, teaching=teaching)


def date_title() -> str:
    """The title of what is saved now without one."""
    return f"Saved {datetime.now():%d %b %Y, %H:%M}"


def save_all(stage: Stage, title: str = "") -> Path:
    """Write level and recording; the level's path. Raises LevelError or RecordingError with one line."""
    now = datetime.now()
    name = f"saved-{now:%Y-%m-%d-%H%M%S}"
    folder = user_folder() / "levels" / stage.scene.name
    path, number = folder / f"{name}.toml", 2
    while path.exists():
        path, number = folder / f"{name}-{number}.toml", number + 1
    save_level(present_level(stage, title or stage.scene.level_title or date_title()), path)
    stage.recording.save(recordings_folder() / f"{stage.scene.name}-{path.stem}.json")
    return path


def level_rows(scene_type: type[Scene]) -> list[ListRow]:
    """The scene's levels and the user's own, to choose from."""
    return [
        ListRow(
            head.title,
            head.about,
            "hard case" if head.hard_case else head.stars,
            bool(head.hard_case),
            head.path,
        )
        for head in level_heads(scene_type.name)
    ]


def story_rows(scene_type: type[Scene]) -> list[ListRow]:
    """The scene's stories, to choose from."""
    return [
        ListRow(head.title, head.about, "story", False, head.path) for head in story_heads(scene_type.name)
    ]


def saved_rows(scene_name: str) -> list[ListRow]:
    """What the user has saved of a scene, the newest first: levels and recordings."""
    heads = [head for head in level_heads(scene_name) if user_folder() in head.path.parents]
    levels = [ListRow(head.title, head.path.name, "level", False, head.path) for head in heads]
    titles = {f"{scene_name}-{head.path.stem}": head.title for head in heads}
    recordings = [
        ListRow(
            titles.get(path.stem, path.stem.removeprefix(f"{scene_name}-")),
            path.name,
            "recording",
            False,
            path,
        )
        for path in recordings_folder().glob(f"{scene_name}-*.json")
    ]
    return sorted(levels + recordings, key=lambda row: row.value.name.rpartition("saved-")[2], reverse=True)
