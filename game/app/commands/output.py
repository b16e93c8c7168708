"""Files that commands write: whole or not at all, and refused before a long run, not after it."""

from __future__ import annotations

import json
import math
import os
import re
import sys
import tempfile
from pathlib import Path
from typing import Any

from game import files
from game.app.window.mistake import MistakeError

STANDARD_OUTPUT = "-"
_NOT_ASCII = re.compile("[^\\n -~]")


def check_writable(word: str | None, option: str) -> None:
    """MistakeError if a file of that name could not be written."""
    if word is None or word == STANDARD_OUTPUT:
        return
    path = Path(word)
    try:
        if os.path.basename(word) in ("", ".", "..") or path.is_dir():  # noqa: PTH119  Path drops a last slash
            raise MistakeError(f"{option} {word}: expected a file name, this is a folder")
        if not path.parent.is_dir():
            raise MistakeError(f"{option} {word}: there is no folder {path.parent}")
        with tempfile.TemporaryFile(dir=path.parent):
            pass
    except OSError as error:
        raise MistakeError(f"{option} {word}: {error.strerror or error}") from None


def write_text(text: str, word: str, option: str) -> None:
    """Write a text file by way of a temporary one in the same folder; ``-`` is standard output."""
    if word == STANDARD_OUTPUT:
        sys.stdout.write(text)
        return
    try:
        files.write_text(Path(word), text)
    except files.FileProblem as problem:
        raise MistakeError(f"{option} {word}: {problem}") from None


def write_json(content: Any, word: str, option: str = "--json") -> None:
    """Write strict JSON: what is not finite is null."""
    plain = word == STANDARD_OUTPUT and not _is_unicode(sys.stdout.encoding)
    text = json.dumps(_finite(content), indent=2, ensure_ascii=plain, allow_nan=False)
    text = _NOT_ASCII.sub(_escaped_unless_printable, text)
    write_text(text + "\n", word, option)


def _is_unicode(encoding: str | None) -> bool:
    return (encoding or "").lower().replace("-", "").replace("_", "").startswith("utf")


def _escaped_unless_printable(found: re.Match[str]) -> str:
    """A character of a JSON text as it is, or as JSON writes it in ASCII: such stand in its strings alone."""
    return found[0] if found[0].isprintable() else json.dumps(found[0])[1:-1]


def _finite(content: Any) -> Any:
    """The same with null for each number that JSON has no word for."""
    if isinstance(content, float):
        return content if math.isfinite(content) else None
    if isinstance(content, dict):
        return {str(key): _finite(value) for key, value in content.items()}
    if isinstance(content, (list, tuple)):
        return [_finite(value) for value in content]
    return content
