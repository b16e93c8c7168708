"""Words for a terminal, whatever they were taken from and whatever the terminal can show.

Names and titles come from files that others made. Escape sequences in them would colour the terminal, move
its cursor, or turn the order of letters about; none of those is a printable character.
"""

from __future__ import annotations

import codecs
import sys

PLAIN = {
    "−": "-", "–": "-", "—": "-", "×": "x", "·": "*", "…": "...", "°": " deg", "µ": "u", "μ": "u", "±": "+-",
    "²": "^2", "³": "^3", "½": "1/2", "≤": "<=", "≥": ">=", "→": "->", "’": "'", "█": "#",
    "\N{NARROW NO-BREAK SPACE}": " ", "\N{THIN SPACE}": " ", "\N{NO-BREAK SPACE}": " ",
}  # fmt: skip
REPLACEMENT = "\N{REPLACEMENT CHARACTER}"
_ERRORS = "carom-plain"


def printable(text: str) -> str:
    """The text in one line without control characters (C0, C1, directions) and halves of characters."""
    return "".join(one if one.isprintable() or one in PLAIN else REPLACEMENT for one in text)


def say(text: str = "", end: str = "\n", flush: bool = False) -> None:
    """Print one line on the standard output, without what is not printable in it."""
    print(printable(text), end=end, flush=flush)


def speak_what_is_understood() -> None:
    """Let the standard output write what its encoding lacks in plainer words, instead of raising an error."""
    codecs.register_error(_ERRORS, _plainer)
    if sys.stdout is not None and hasattr(sys.stdout, "reconfigure"):
        sys.stdout.reconfigure(errors=_ERRORS)


def _plainer(error: UnicodeError) -> tuple[str, int]:
    """The error handler: plain words for the first letter that cannot be written, or a question mark."""
    if not isinstance(error, UnicodeEncodeError):
        raise error
    letter = error.object[error.start]
    plain = PLAIN.get(letter, "?")
    return plain, error.start + 1
