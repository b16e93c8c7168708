"""Level files: read, check, write.

A level is a TOML file. Every value is checked by type and range, unknown keys are refused, and whatever is
wrong is answered by one LevelError: file, field, reason.

    scene = "c14"
    title = "A rope"
    about = "What is to be seen."
    hard_case = "C14.H3"          # only for those of the gallery
    pace = 0.0625                 # simulated seconds to a real one, in a window; 1 unless it is said
    seed = 7
    [parameters]                  # the scene's parameters
    iterations = 20
    [effects]
    off = ["gravity"]
    [teaching]                    # a task, locks and questions: see teaching.py
    task = "Find the restitution."
    [content]                     # a msgspec.Struct type that the scene gives, or nothing

Field types of a content say what is allowed: ``Annotated[float, msgspec.Meta(gt=0)]``. NaN is never allowed,
infinity only in a field of type ``Unbounded``.
"""

from __future__ import annotations

import math
import re
import tomllib
from pathlib import Path
from typing import Annotated, Any

import msgspec
import tomli_w

from game.files import FileProblem, read_text, write_text
from game.folders import data_folder, user_folder
from game.level_checks import (
    MAX_DEPTH,
    MAX_ITEMS,
    LevelError,
    Unbounded,
    check_numbers,
    check_sizes,
    check_strict,
    check_text,
    convert,
)
from game.teaching import Teaching, TeachingError

__all__ = [
    "MAX_BYTES",
    "MAX_DEPTH",
    "MAX_ITEMS",
    "Level",
    "LevelError",
    "Unbounded",
    "format_level",
    "level_files",
    "level_of",
    "load_level",
    "parse_level",
    "save_level",
    "story_files",
    "user_level_files",
]

MAX_BYTES = 1 << 20

_SCENE_NAME = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*")


class Level(msgspec.Struct, frozen=True, kw_only=True):
    """One level of a scene. ``content`` has the scene's own type, ``path`` is where it came from."""

    scene: str
    title: str = ""
    about: str = ""
    hard_case: str = ""
    pace: float = 1.0
    seed: int = 0
    parameters: dict[str, float | bool | str] = {}
    effects_off: tuple[str, ...] = ()
    teaching: Teaching | None = None
    content: Any = None
    path: Path | None = None


class _Effects(msgspec.Struct, forbid_unknown_fields=True):
    off: Annotated[list[str], msgspec.Meta(max_length=63)] = []


class _File(msgspec.Struct, forbid_unknown_fields=True):
    """A level as its file has it; the content is checked against the scene's type afterwards."""

    scene: Annotated[str, msgspec.Meta(max_length=40)]
    title: Annotated[str, msgspec.Meta(max_length=200)] = ""
    about: Annotated[str, msgspec.Meta(max_length=4000)] = ""
    hard_case: Annotated[str, msgspec.Meta(max_length=40)] = ""
    pace: Annotated[float, msgspec.Meta(ge=0.0625, le=4.0)] = 1.0
    seed: Annotated[int, msgspec.Meta(ge=0, le=2**63 - 1)] = 0
    parameters: dict[str, float | bool | str] = {}
    effects: _Effects = msgspec.field(default_factory=_Effects)
    teaching: Teaching | None = None
    content: dict[str, Any] | None = None


def load_level(path: Path | str, scene_name: str, content_type: type[msgspec.Struct] | None) -> Level:
    """The level in a file, for the scene of that name, its content as ``content_type``; LevelError."""
    path = Path(path)
    try:
        text = read_text(path, MAX_BYTES)
    except FileProblem as problem:
        raise LevelError(path, "", str(problem)) from None
    return parse_level(text, scene_name, content_type, path)


def parse_level(
    text: str, scene_name: str, content_type: type[msgspec.Struct] | None, path: Path | None = None
) -> Level:
    """The level that a text says; ``path`` is only named in a LevelError and kept."""
    check_text(text, path)
    try:
        raw = tomllib.loads(text)
    except RecursionError:
        raise LevelError(path, "", "nested too deeply") from None
    except ValueError as error:
        raise LevelError(path, "", f"not TOML: {error}") from None
    check_sizes(raw, path)
    return level_of(raw, scene_name, content_type, path)


def level_of(
    raw: dict[str, Any], scene_name: str, content_type: type[msgspec.Struct] | None, path: Path | None
) -> Level:
    """The level that a parsed document of checked sizes says; LevelError."""
    file = convert(raw, _File, path, "")
    if file.scene != scene_name:
        raise LevelError(path, "scene", f"expected {scene_name!r}, not {file.scene!r}")
    for name, value in file.parameters.items():
        if isinstance(value, float) and not math.isfinite(value):
            raise LevelError(path, f"parameters.{name}", "expected a finite number")
    if file.teaching is not None:
        try:
            file.teaching.check()
        except TeachingError as error:
            raise LevelError(path, f"teaching.{error.field}", error.reason) from None
    return Level(
        scene=file.scene,
        title=file.title,
        about=file.about,
        hard_case=file.hard_case,
        pace=file.pace,
        seed=file.seed,
        parameters=file.parameters,
        effects_off=tuple(file.effects.off),
        teaching=file.teaching,
        content=_content(file.content, content_type, path),
        path=path,
    )


def format_level(level: Level) -> str:
    """The text of a level's file; LevelError if its content cannot be read back (a number not finite)."""
    if level.content is not None:
        check_numbers(level.content, type(level.content), level.path)
    document: dict[str, Any] = {"scene": level.scene}
    for key in ("title", "about", "hard_case", "seed"):
        if getattr(level, key):
            document[key] = getattr(level, key)
    if level.pace != 1.0:
        document["pace"] = level.pace
    if level.parameters:
        document["parameters"] = dict(level.parameters)
    if level.effects_off:
        document["effects"] = {"off": list(level.effects_off)}
    if level.teaching is not None:
        document["teaching"] = _without_none(_said(level.teaching))
    if level.content is not None:
        document["content"] = _without_none(msgspec.to_builtins(level.content, enc_hook=_plain))
    return tomli_w.dumps(document)


def save_level(level: Level, path: Path | str) -> None:
    """Write a level's file, whole or not at all; LevelError, and then the old file is as it was."""
    path = Path(path)
    text = format_level(level)
    if len(text.encode("utf-8")) > MAX_BYTES:
        raise LevelError(path, "", f"would be longer than {MAX_BYTES} bytes")
    parse_level(text, level.scene, type(level.content) if level.content is not None else None, path)
    try:
        write_text(path, text)
    except FileProblem as problem:
        raise LevelError(path, "", f"not written: {problem}") from None


def level_files(scene_name: str) -> list[Path]:
    """Files of a scene's own levels: ``default.toml``, then the others, then the hard cases, each by name."""
    if not _SCENE_NAME.fullmatch(scene_name):
        raise ValueError(f"scene name {scene_name!r}: expected letters a-z, digits and single hyphens")
    return _sorted_levels(data_folder("levels") / scene_name)


def user_level_files(scene_name: str) -> list[Path]:
    """Files of the levels that the user saved for a scene."""
    if not _SCENE_NAME.fullmatch(scene_name):
        raise ValueError(f"scene name {scene_name!r}: expected letters a-z, digits and single hyphens")
    return _sorted_levels(user_folder() / "levels" / scene_name)


def story_files(scene_name: str) -> list[Path]:
    """Files of a scene's own stories, which lie beside its levels, by name."""
    if not _SCENE_NAME.fullmatch(scene_name):
        raise ValueError(f"scene name {scene_name!r}: expected letters a-z, digits and single hyphens")
    return sorted((data_folder("levels") / scene_name).glob("story-*.toml"))


def _sorted_levels(folder: Path) -> list[Path]:
    """Levels alone: hidden files and stories are none."""
    files = [path for path in folder.glob("*.toml") if not path.name.startswith((".", "story-"))]
    return sorted(
        files, key=lambda path: (path.name != "default.toml", path.name.startswith("hard-"), path.name)
    )


def _content(raw: dict[str, Any] | None, content_type: type[msgspec.Struct] | None, path: Path | None) -> Any:
    """The content in the scene's type, or None if the file has none."""
    if raw is None:
        return None
    if content_type is None:
        raise LevelError(path, "content", "this scene has none")
    check_strict(content_type)
    content = convert(raw, content_type, path, "content")
    check_numbers(content, content_type, path)
    return content


def _said(teaching: Teaching) -> dict[str, Any]:
    """The section without lists that are empty."""
    return {name: value for name, value in msgspec.to_builtins(teaching).items() if value}


def _plain(value: Any) -> Any:
    """An array or a number of an array in Python's own types; NotImplementedError for anything else."""
    if hasattr(value, "tolist"):
        return value.tolist()
    raise NotImplementedError(f"{type(value).__name__} cannot be written to a level file")


def _without_none(value: Any) -> Any:
    """TOML has no null: a key without a value is left out."""
    if isinstance(value, dict):
        return {key: _without_none(item) for key, item in value.items() if item is not None}
    if isinstance(value, list):
        return [_without_none(item) for item in value]
    return value
