"""The careers of this machine in one file of the user's folder: career.json, format 3.

Format 1 had no prizes and no measured hand, format 2 no newcomers' cup; both are read as well.

It is written whole or not at all. A file that cannot be understood is kept beside as career.broken.json, and
one line says so. One of a later version is left as it is, and nothing is written over it.
"""

from __future__ import annotations

from pathlib import Path

import msgspec

from game.billiards.career.career import Career
from game.files import FileProblem, put_aside, read_text, write_text
from game.folders import user_folder

FILE_NAME = "career.json"
FORMAT = 3
LARGEST_BYTES = 32 << 20


class _File(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    format: int
    career: Career


class _Format(msgspec.Struct, frozen=True):
    """Of a file of any version, the only thing that is read first."""

    format: int


class LaterCareerError(ValueError):
    """A file that a later Carom has written."""


def career_path() -> Path:
    """The file."""
    return user_folder() / FILE_NAME


def read_career() -> Career:
    """The careers; an empty one if there is no file. ValueError, in one line, if it cannot be understood, and
    as LaterCareerError if it is of a later version.
    """
    path = career_path()
    if not path.exists():
        return Career()
    try:
        text = read_text(path, LARGEST_BYTES)
        version = msgspec.json.decode(text, type=_Format).format
        if version > FORMAT:
            raise LaterCareerError(f"is of format {version}; this Carom reads format {FORMAT}")
        if version < 1:
            raise ValueError(f"is of format {version}, which there never was")
        career = msgspec.json.decode(text, type=_File).career
        career.check()
    except LaterCareerError as error:
        raise LaterCareerError(f"{FILE_NAME}: {error}") from None
    except (ValueError, msgspec.DecodeError, RecursionError) as error:
        raise ValueError(f"{FILE_NAME}: {' '.join(str(error).replace('`', '').split())}"[:400]) from None
    return career


def load_career() -> tuple[Career, str]:
    """The careers, and what there is to complain of in a line. A damaged file is put aside."""
    try:
        return read_career(), ""
    except LaterCareerError as error:
        return Career(), f"{error}; nothing is written over it"
    except ValueError as error:
        return Career(), f"{error}{put_aside(career_path())}"


def keep_career(career: Career) -> str:
    """Write the careers. What there is to complain of, in a line."""
    complaint = ""
    try:
        read_career()
    except LaterCareerError as error:
        return f"{error}; nothing is written over it"
    except ValueError as error:
        complaint = f"{error}{put_aside(career_path())}"
    try:
        text = msgspec.json.format(msgspec.json.encode(_File(FORMAT, career)), indent=1)
        write_text(career_path(), text.decode("utf-8") + "\n")
    except FileProblem as error:
        return f"{FILE_NAME}: {error}"
    return complaint
