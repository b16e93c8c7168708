"""Heads of level files: title and words for lists and search, read without the scene's code."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path
from typing import NamedTuple

from game.app.stagehand.stars import kept_stars
from game.files import read_text
from game.levels import MAX_BYTES, level_files, story_files, user_level_files

LESSON = "lesson-"  # how names of lessons begin
MOST_KEPT = 2_000  # heads of files
_TABLE = re.compile(r"^[ \t]*\[", re.MULTILINE)


class LevelHead(NamedTuple):
    """What a list shows of a level."""

    scene: str
    title: str
    about: str
    hard_case: str
    path: Path
    stars: str = ""  # that were won in it


def level_heads(scene_name: str) -> list[LevelHead]:
    """Heads of all levels of a scene in their order; what cannot be read is named by its file."""
    return list(_heads(scene_name))


def lessons_of(scene_name: str) -> list[LevelHead]:
    """Heads of a scene's own lessons, in their order."""
    return [head for head in level_heads(scene_name) if head.path.stem.startswith(LESSON)]


def next_lesson(lessons: list[LevelHead]) -> LevelHead:
    """The first lesson without a star; the first of all after the last. IndexError for none."""
    return next((head for head in lessons if not head.stars), lessons[0])


def story_heads(scene_name: str) -> list[LevelHead]:
    """Heads of a scene's stories, by the names of their files."""
    found = []
    for path in story_files(scene_name):
        fields = _fields(path)
        title = str(fields.get("title") or path.stem)
        found.append(LevelHead(scene_name, title, str(fields.get("about") or ""), "", path))
    return found


def _heads(scene_name: str) -> Iterator[LevelHead]:
    stars = kept_stars(scene_name)
    for path in [*level_files(scene_name), *user_level_files(scene_name)]:
        fields = _fields(path)
        title = str(fields.get("title") or path.stem.replace("-", " ").capitalize())
        hard_case = str(fields.get("hard_case") or "")
        won = stars[path.stem].words if path.stem in stars else ""
        yield LevelHead(scene_name, title, str(fields.get("about") or ""), hard_case, path, won)


def _fields(path: Path) -> dict[str, object]:
    """The fields of the file's head as it is now; the menu asks for all of them each time it is opened."""
    try:
        found = path.stat()
    except OSError:
        return {}
    return _read(path, found.st_mtime_ns, found.st_size)


@lru_cache(maxsize=MOST_KEPT)
def _read(path: Path, modified_ns: int, size: int) -> dict[str, object]:
    """The fields of the file's head, or none if it is broken: opening it will say why."""
    try:
        text = read_text(path, MAX_BYTES)
        return _head(text) or tomllib.loads(text)
    except (ValueError, RecursionError):
        return {}


def _head(text: str) -> dict[str, object]:
    """The fields before the first table; none if that cannot be told from the lines alone.

    What follows may be a hundred times as long, and a list of levels must not wait for it.
    """
    table = _TABLE.search(text)
    try:
        return tomllib.loads(text[: table.start()] if table else text)
    except (ValueError, RecursionError):
        return {}  # the bracket began no table: it stands within a text or a list of several lines
