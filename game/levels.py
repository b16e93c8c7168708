"""Level files: read, check, write.

A level is a TOML file. Every value is checked by type and range, unknown keys are refused, and whatever is
wrong is answered by one LevelError: file, field, reason.

    scene = "c14"
    title = "A rope"
    about = "What is to be seen."
    hard_case = "C14.H3"          # only for those of the gallery
    seed = 7
    [parameters]                  # the scene's knobs
    iterations = 20
    [effects]
    off = ["gravity"]
    [content]                     # a msgspec.Struct type that the scene gives, or nothing

Field types of a content say what is allowed: ``Annotated[float, msgspec.Meta(gt=0)]``. NaN is never allowed,
infinity only in a field of type ``Unbounded``.
"""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path
from typing import Annotated, Any

import msgspec
import tomli_w

from game.files import FileProblem, read_text, write_text
from game.folders import data_folder, user_folder

MAX_BYTES = 1 << 20
MAX_DEPTH = 12
MAX_ITEMS = 100_000  # in one list or table

Unbounded = Annotated[float, msgspec.Meta(extra={"unbounded": True})]  # a number that may be infinite

_SCENE_NAME = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*")
_STRING_OR_COMMENT = re.compile(
    r'"""(?:[^\\]|\\.)*?"""|' r"'''.*?'''|" r'"(?:[^"\\\n]|\\.)*+"|' r"'[^'\n]*+'|#[^\n]*+", re.DOTALL
)
_LONG_KEY = re.compile(rf"(?<![\w-])(?:[\w-]++[ \t]*+\.[ \t]*+){{{MAX_DEPTH + 1}}}")
_MSGSPEC_PATH = re.compile(r" - at `(?:key in )?\$\.?([^`]*)`$")


class LevelError(ValueError):
    """What is wrong with a level: ``file``, ``field`` and ``reason``, in one line."""

    def __init__(self, file: Path | str | None, field: str, reason: str):
        self.file = str(file) if file else "level"
        self.field = field if len(field) <= 120 else field[:119] + "…"
        self.reason = reason
        super().__init__(
            _one_line(f"{self.file}: {self.field}: {reason}" if field else f"{self.file}: {reason}")
        )


class Level(msgspec.Struct, frozen=True, kw_only=True):
    """One level of a scene. ``content`` has the scene's own type; ``path`` is where it came from, if anywhere."""

    scene: str
    title: str = ""
    about: str = ""
    hard_case: str = ""
    seed: int = 0
    parameters: dict[str, float | bool | str] = {}
    effects_off: tuple[str, ...] = ()
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
    seed: Annotated[int, msgspec.Meta(ge=0, le=2**63 - 1)] = 0
    parameters: dict[str, float | bool | str] = {}
    effects: _Effects = msgspec.field(default_factory=_Effects)
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
    # the parser takes memory by the square of a dotted key's length, so it never sees a long one
    if _LONG_KEY.search(_STRING_OR_COMMENT.sub("k", text)):
        raise LevelError(path, "", f"a key has more than {MAX_DEPTH} dots")
    try:
        raw = tomllib.loads(text)
    except RecursionError:
        raise LevelError(path, "", "nested too deeply") from None
    except ValueError as error:
        raise LevelError(path, "", f"not TOML: {error}") from None
    _check_sizes(raw, path)
    file = _convert(raw, _File, path, "")
    if file.scene != scene_name:
        raise LevelError(path, "scene", f"is {file.scene!r}, but {scene_name!r} is wanted")
    for name, value in file.parameters.items():
        if isinstance(value, float) and not math.isfinite(value):
            raise LevelError(path, f"parameters.{name}", "a finite number is wanted")
    return Level(
        scene=file.scene,
        title=file.title,
        about=file.about,
        hard_case=file.hard_case,
        seed=file.seed,
        parameters=file.parameters,
        effects_off=tuple(file.effects.off),
        content=_content(file.content, content_type, path),
        path=path,
    )


def format_level(level: Level) -> str:
    """The text of a level's file; LevelError if its content cannot be read back (a number not finite)."""
    if level.content is not None:
        _check_numbers(level.content, type(level.content), level.path)
    document: dict[str, Any] = {"scene": level.scene}
    for key in ("title", "about", "hard_case", "seed"):
        if getattr(level, key):
            document[key] = getattr(level, key)
    if level.parameters:
        document["parameters"] = dict(level.parameters)
    if level.effects_off:
        document["effects"] = {"off": list(level.effects_off)}
    if level.content is not None:
        document["content"] = _without_none(msgspec.to_builtins(level.content))
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
        raise ValueError(f"scene name {scene_name!r}: letters a-z, digits and single hyphens are wanted")
    return _sorted_levels(data_folder("levels") / scene_name)


def user_level_files(scene_name: str) -> list[Path]:
    """Files of the levels that the user saved for a scene."""
    if not _SCENE_NAME.fullmatch(scene_name):
        raise ValueError(f"scene name {scene_name!r}: letters a-z, digits and single hyphens are wanted")
    return _sorted_levels(user_folder() / "levels" / scene_name)


def _sorted_levels(folder: Path) -> list[Path]:
    files = [path for path in folder.glob("*.toml") if not path.name.startswith(".")]
    return sorted(
        files, key=lambda path: (path.name != "default.toml", path.name.startswith("hard-"), path.name)
    )


def _content(raw: dict[str, Any] | None, content_type: type[msgspec.Struct] | None, path: Path | None) -> Any:
    """The content in the scene's type, or None if the file has none."""
    if raw is None:
        return None
    if content_type is None:
        raise LevelError(path, "content", "this scene has none")
    _check_strict(content_type)
    content = _convert(raw, content_type, path, "content")
    _check_numbers(content, content_type, path)
    return content


def _convert(raw: Any, target: Any, path: Path | None, field: str) -> Any:
    """``msgspec.convert`` with its complaint taken apart into field and reason."""
    try:
        return msgspec.convert(raw, target)
    except msgspec.ValidationError as error:
        message = str(error)
        found = _MSGSPEC_PATH.search(message)
        where = ".".join(part for part in (field, found.group(1) if found else "") if part)
        reason = message[: found.start()] if found else message
        unknown = re.match(r"Object contains unknown field `(.*)`$", reason)
        if unknown:
            raise LevelError(
                path, ".".join(p for p in (where, unknown.group(1)) if p), "unknown key"
            ) from None
        missing = re.match(r"Object missing required field `(.*)`$", reason)
        if missing:
            raise LevelError(path, ".".join(p for p in (where, missing.group(1)) if p), "missing") from None
        raise LevelError(
            path, where.replace(".[", "["), reason[0].lower() + reason[1:].replace("`", "")
        ) from None
    except (OverflowError, ValueError) as error:
        raise LevelError(path, field, str(error)) from None


def _check_sizes(raw: Any, path: Path | None) -> None:
    """Refuse absurd nesting and lengths, without recursion."""
    waiting: list[tuple[Any, str, int]] = [(raw, "", 0)]
    while waiting:
        value, field, depth = waiting.pop()
        if depth > MAX_DEPTH:
            raise LevelError(path, field, f"nested deeper than {MAX_DEPTH}")
        if not isinstance(value, (dict, list)):
            continue
        if len(value) > MAX_ITEMS:
            raise LevelError(path, field, f"more than {MAX_ITEMS} items")
        pairs = value.items() if isinstance(value, dict) else enumerate(value)
        for key, item in pairs:
            if isinstance(item, (dict, list)):
                waiting.append((item, _below(field, key), depth + 1))


def _below(field: str, key: str | int) -> str:
    if isinstance(key, int):
        return f"{field}[{key}]"
    return f"{field}.{key}" if field else key


@lru_cache(maxsize=None)
def _check_strict(content_type: type) -> None:
    """TypeError if a Struct within a content type would pass over unknown keys: a slip of the programmer."""
    for part in _structs(msgspec.inspect.type_info(content_type)):
        if not part.forbid_unknown_fields:
            raise TypeError(f"{part.cls.__name__}: a level's content needs forbid_unknown_fields=True")


def _structs(info: Any) -> Iterator[Any]:
    """All Struct types within a type, each once."""
    waiting, seen = [info], set()
    while waiting:
        part = waiting.pop()
        if isinstance(part, msgspec.inspect.StructType):
            if part.cls in seen:
                continue
            seen.add(part.cls)
            yield part
            waiting += [field.type for field in part.fields]
        else:
            waiting += _parts(part)


def _parts(info: Any) -> list[Any]:
    """Types that a container, union or annotated type is made of."""
    found = [
        getattr(info, name) for name in ("type", "item_type", "key_type", "value_type") if hasattr(info, name)
    ]
    found += getattr(info, "types", ()) or ()
    found += getattr(info, "item_types", ()) or ()
    return [part for part in found if isinstance(part, msgspec.inspect.Type)]


def _check_numbers(content: Any, content_type: Any, path: Path | None) -> None:
    """LevelError for a NaN anywhere, and for an infinity where the field is not ``Unbounded``."""
    waiting: list[tuple[Any, Any, str]] = [(content, msgspec.inspect.type_info(content_type), "content")]
    while waiting:
        value, info, field = waiting.pop()
        if isinstance(value, float):
            if math.isnan(value):
                raise LevelError(path, field, "NaN is no number")
            if math.isinf(value) and not _allows_infinity(info):
                raise LevelError(path, field, "a finite number is wanted")
        elif isinstance(value, msgspec.Struct):
            known = msgspec.inspect.type_info(type(value))
            for part in getattr(known, "fields", ()):
                waiting.append((getattr(value, part.name), part.type, _below(field, part.encode_name)))
        elif isinstance(value, dict):
            waiting += [(item, info, _below(field, str(key))) for key, item in value.items()]
        elif isinstance(value, (list, tuple)):
            waiting += [(item, info, _below(field, index)) for index, item in enumerate(value)]


def _allows_infinity(info: Any) -> bool:
    """True if ``Unbounded`` is among the types that a field is made of."""
    if isinstance(info, msgspec.inspect.Metadata) and (info.extra or {}).get("unbounded"):
        return True
    return any(
        _allows_infinity(part) for part in _parts(info) if not isinstance(part, msgspec.inspect.StructType)
    )


def _without_none(value: Any) -> Any:
    """TOML has no null: a key without a value is left out."""
    if isinstance(value, dict):
        return {key: _without_none(item) for key, item in value.items() if item is not None}
    if isinstance(value, list):
        return [_without_none(item) for item in value]
    return value


def _one_line(text: str) -> str:
    """The text in one line of printable characters, cut if very long."""
    line = "".join(letter if letter.isprintable() else " " for letter in text)
    return line if len(line) <= 500 else line[:499] + "…"
