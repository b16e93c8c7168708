"""Strokes that are counted for ever, in one file of the user's folder: strokes.json, format 2.
Format 1, without cushions, is read.

Written whole or not at all. A file that cannot be understood is kept beside as strokes.broken.json; one of a
later version is left as it is.
"""

from __future__ import annotations

from pathlib import Path

import msgspec

from game.billiards.career.strokes import StrokeFact
from game.files import FileProblem, put_aside, read_text, write_text
from game.folders import user_folder

FILE_NAME = "strokes.json"
FORMAT = 2
LARGEST_BYTES = 64 << 20
MOST = 100_000  # strokes of each person; of more the oldest are given up

Strokes = dict[str, list[StrokeFact]]  # by the person's name


class _File(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    format: int
    strokes: Strokes


class _Format(msgspec.Struct, frozen=True):
    format: int


class LaterStrokesError(ValueError):
    """A file that a later Carom has written."""


def strokes_path() -> Path:
    """The file."""
    return user_folder() / FILE_NAME


def read_strokes() -> Strokes:
    """All strokes. ValueError, in one line, if they cannot be understood, or are of a later format."""
    path = strokes_path()
    if not path.exists():
        return {}
    try:
        text = read_text(path, LARGEST_BYTES)
        version = msgspec.json.decode(text, type=_Format).format
        if version > FORMAT:
            raise LaterStrokesError(
                f"{FILE_NAME}: is of format {version}; this Carom reads formats up to {FORMAT}"
            )
        return msgspec.json.decode(text, type=_File).strokes
    except LaterStrokesError:
        raise
    except (ValueError, msgspec.DecodeError, RecursionError) as error:
        raise ValueError(f"{FILE_NAME}: {' '.join(str(error).replace('`', '').split())}"[:400]) from None


def keep_stroke(person: str, fact: StrokeFact) -> str:
    """Add a stroke of a person. What there is to complain of, in a line."""
    complaint = ""
    try:
        strokes = read_strokes()
    except LaterStrokesError as error:
        return f"{error}; nothing is written over it"
    except ValueError as error:
        strokes, complaint = {}, f"{error}{put_aside(strokes_path())}"
    strokes[person] = [*strokes.get(person, []), fact][-MOST:]
    try:
        write_text(strokes_path(), msgspec.json.encode(_File(FORMAT, strokes)).decode() + "\n")
    except FileProblem as error:
        return f"{FILE_NAME}: {error}"
    return complaint
