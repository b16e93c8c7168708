"""What a level file may say: its text before it is parsed, its sizes, types, ranges and numbers.

Whatever is wrong is answered by one LevelError: file, field, reason, in one line.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Annotated, Any

import msgspec

MAX_DEPTH = 12
MAX_ITEMS = 100_000  # in one list or table

Unbounded = Annotated[float, msgspec.Meta(extra={"unbounded": True})]  # a number that may be infinite

_PATH = re.compile(r" - at `(?:key in )?\$\.?([^`]*)`$")
_STRING_OR_COMMENT = re.compile(
    r'"""(?:[^\\]|\\.)*?"""|' r"'''.*?'''|" r'"(?:[^"\\\n]|\\.)*+"|' r"'[^'\n]*+'|#[^\n]*+", re.DOTALL
)
_LONG_KEY = re.compile(rf"(?<![\w-])(?:[\w-]++[ \t]*+\.[ \t]*+){{{MAX_DEPTH + 1}}}")


class LevelError(ValueError):
    """What is wrong with a level: ``file``, ``field`` and ``reason``, in one line."""

    def __init__(self, file: Path | str | None, field: str, reason: str):
        self.file = str(file) if file else "level"
        shown = self.file if len(self.file) <= 250 else "…" + self.file[-249:]
        self.field = field if len(field) <= 120 else field[:119] + "…"
        self.reason = reason
        super().__init__(_one_line(f"{shown}: {self.field}: {reason}" if field else f"{shown}: {reason}"))


def check_text(text: str, path: Path | None) -> None:
    """Refuse a key of very many parts: the parser would take memory by the square of their number."""
    if _LONG_KEY.search(_STRING_OR_COMMENT.sub("k", text)):
        raise LevelError(path, "", f"a key has more than {MAX_DEPTH} dots")


def convert(raw: Any, target: Any, path: Path | None, field: str) -> Any:
    """``msgspec.convert`` with its complaint taken apart into field and reason."""
    try:
        return msgspec.convert(raw, target)
    except msgspec.ValidationError as error:
        message = str(error)
        found = _PATH.search(message)
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


def check_sizes(raw: Any, path: Path | None) -> None:
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


@cache
def check_strict(content_type: type) -> None:
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


def check_numbers(content: Any, content_type: Any, path: Path | None) -> None:
    """LevelError for a NaN anywhere, and for an infinity where the field is not ``Unbounded``."""
    if _all_finite(content):
        return
    waiting: list[tuple[Any, Any, str]] = [(content, msgspec.inspect.type_info(content_type), "content")]
    while waiting:
        value, info, field = waiting.pop()
        if isinstance(value, float):
            if math.isnan(value):
                raise LevelError(path, field, "NaN is no number")
            if math.isinf(value) and not _allows_infinity(info):
                raise LevelError(path, field, "expected a finite number")
        elif isinstance(value, msgspec.Struct):
            known = _type_info(type(value))
            waiting += [
                (getattr(value, part.name), part.type, _below(field, part.encode_name))
                for part in getattr(known, "fields", ())
            ]
        elif isinstance(value, dict):
            waiting += [(item, info, _below(field, str(key))) for key, item in value.items()]
        elif isinstance(value, (list, tuple)):
            waiting += [(item, info, _below(field, index)) for index, item in enumerate(value)]


def _all_finite(content: Any) -> bool:
    """True if no number in a content is NaN or infinite: ten times cheaper than to look with its types."""
    waiting = [content]
    while waiting:
        value = waiting.pop()
        if isinstance(value, (list, tuple)):
            waiting += value
        elif isinstance(value, float):
            if not math.isfinite(value):
                return False
        elif isinstance(value, msgspec.Struct):
            waiting += msgspec.structs.astuple(value)
        elif isinstance(value, dict):
            waiting += value.values()
    return True


@cache
def _type_info(content_type: type) -> Any:
    return msgspec.inspect.type_info(content_type)


def _allows_infinity(info: Any) -> bool:
    """True if ``Unbounded`` is among the types that a field is made of."""
    if isinstance(info, msgspec.inspect.Metadata) and (info.extra or {}).get("unbounded"):
        return True
    return any(
        _allows_infinity(part) for part in _parts(info) if not isinstance(part, msgspec.inspect.StructType)
    )


def _one_line(text: str) -> str:
    """The text in one line of printable characters, cut if very long."""
    line = "".join(letter if letter.isprintable() else " " for letter in text)
    return line if len(line) <= 500 else line[:499] + "…"
