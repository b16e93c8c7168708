"""What a widget asks for when it is pressed: a name, and a value where one belongs to it."""

from __future__ import annotations

from typing import Any, NamedTuple


class Wish(NamedTuple):
    """What the bar, the panel or a page wants done; the screen that shows it fulfils it.

    Without a value the names are the program's commands (pause, reset, step, step-back, screenshot, help,
    panel, accuracy, ...), and menu, defaults, close, stop, save-csv, save-picture. With a value: speed (-1,
    +1, or 0 for normal), level (path), refused (message), toast (message), study (number), point (parameters
    of a row of the study).
    """

    name: str
    value: Any = None
