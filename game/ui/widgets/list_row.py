"""A row of a list to choose from, in a card or in a drop-down."""

from __future__ import annotations

from typing import Any, NamedTuple


class ListRow(NamedTuple):
    """One choice: title, words about it, a short id at the right, an amber mark for a hard case."""

    title: str
    about: str = ""
    chip: str = ""
    marked: bool = False
    value: Any = None
