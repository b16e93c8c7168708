"""Heads of level files: title and words for lists and search, read without the scene's code."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from game.files import read_text
from game.levels import MAX_BYTES, level_files, user_level_files


class LevelHead(NamedTuple):
    """What a list shows of a level."""

    scene: str
    title: str
    about: str
    hard_case: str
    path: Path


def level_heads(scene_name: str) -> list[LevelHead]:
    """Heads of all levels of a scene in their order; what cannot be read is named by its file."""
    return list(_heads(scene_name))


def _heads(scene_name: str) -> Iterator[LevelHead]:
    for path in [*level_files(scene_name), *user_level_files(scene_name)]:
        fields = _read(path)
        title = str(fields.get("title") or path.stem.replace("-", " ").capitalize())
        hard_case = str(fields.get("hard_case") or "")
        yield LevelHead(scene_name, title, str(fields.get("about") or ""), hard_case, path)


def _read(path: Path) -> dict[str, object]:
    """The file's fields, or none if it is broken: opening it will say why."""
    try:
        return tomllib.loads(read_text(path, MAX_BYTES))
    except (ValueError, RecursionError):
        return {}
