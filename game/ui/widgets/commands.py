"""What a widget asks for when it is pressed: a name, and a value where one belongs to it."""

from __future__ import annotations

from typing import Any, NamedTuple


class Command(NamedTuple):
    """One wish. Names used: back, reset, step, step-back, play, speed (-1, +1 or 0 for "normal"), picture,
    help, panel, accuracy, defaults, level (path), refused (message), close, stop, save-csv, save-picture,
    point (a row of the study), toast (message)."""

    name: str
    value: Any = None
