"""What was practised, set by set, in one file of the user's folder: practice.json.

Format 1: {"format": 1, "sets": [{"key", "title", "when", "made", "tried", "of"}, ...]}, the oldest first. A
file that cannot be understood is kept beside as practice.broken.json. One of a later version is left as it
is, and nothing is written over it.
"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, NamedTuple

import msgspec

from game.files import FileProblem, put_aside, read_text, write_text
from game.folders import user_folder

FILE_NAME = "practice.json"
FORMAT = 1
LARGEST_BYTES = 8 << 20
MOST_SETS = 20_000

Count = Annotated[int, msgspec.Meta(ge=0, le=10**6)]


class Practised(NamedTuple):
    """How a set stands: made of tried so far, out of ``of`` in all (0: no end).

    key: equal for what can be compared, such as one drill; title: for people.
    """

    key: str
    title: str
    made: int
    tried: int
    of: int


class PracticeSet(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A set as it is kept: `Practised`, and when it was begun (ISO 8601, local time)."""

    key: Annotated[str, msgspec.Meta(min_length=1, max_length=100)]
    title: Annotated[str, msgspec.Meta(max_length=200)]
    when: Annotated[str, msgspec.Meta(pattern=r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d{1,6})?$")]
    made: Count
    tried: Annotated[int, msgspec.Meta(ge=1, le=10**6)]
    of: Count

    @property
    def share(self) -> float:
        """Made of tried."""
        return self.made / self.tried


class _File(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    format: int
    sets: Annotated[list[PracticeSet], msgspec.Meta(max_length=MOST_SETS)] = []


class _Format(msgspec.Struct, frozen=True):
    """Of a file of any version, the only thing that is read first."""

    format: int


class LaterFormatError(ValueError):
    """A file that a later Carom has written."""


def history_path() -> Path:
    """The file."""
    return user_folder() / FILE_NAME


def read_history() -> tuple[PracticeSet, ...]:
    """All sets; none if there is no file. ValueError, in one line, if it cannot be understood, and as
    LaterFormatError if it is of a later version.
    """
    path = history_path()
    if not path.exists():
        return ()
    try:
        text = read_text(path, LARGEST_BYTES)
        version = msgspec.json.decode(text, type=_Format).format
        if version > FORMAT:
            raise LaterFormatError(f"is of format {version}; this Carom reads format {FORMAT}")
        if version != FORMAT:
            raise ValueError(f"is of format {version}, which there never was")
        sets = msgspec.json.decode(text, type=_File).sets
        for one in sets:
            if one.made > one.tried or (one.of and one.tried > one.of):
                raise ValueError(f"a set of {one.when} says {one.made} of {one.tried} of {one.of}")
    except LaterFormatError as error:
        raise LaterFormatError(f"{FILE_NAME}: {error}") from None
    except (ValueError, msgspec.DecodeError, RecursionError) as error:
        raise ValueError(f"{FILE_NAME}: {' '.join(str(error).replace('`', '').split())}"[:400]) from None
    return tuple(sets)


def keep_set(one: PracticeSet) -> str:
    """Keep a set, in place of the one of the same key and beginning if there is such. What there is to
    complain of, in a line.
    """
    complaint = ""
    try:
        sets = list(read_history())
    except LaterFormatError as error:
        return f"{error}; nothing is written over it"
    except ValueError as error:
        sets, complaint = [], f"{error}{put_aside(history_path())}"
    places = [k for k, other in enumerate(sets) if (other.key, other.when) == (one.key, one.when)]
    if places:
        sets[places[-1]] = one
    else:
        sets.append(one)
    try:
        text = msgspec.json.format(msgspec.json.encode(_File(FORMAT, sets[-MOST_SETS:])), indent=1)
        write_text(history_path(), text.decode("utf-8") + "\n")
    except FileProblem as error:
        return f"{FILE_NAME}: {error}"
    return complaint
