"""Files as they should not be: cut off, garbled, of the wrong kind, with numbers that are none."""

from __future__ import annotations

import re
from random import Random

NUMBERS = (
    "nan",
    "inf",
    "-inf",
    "-1",
    "0",
    "1e308",
    "-1e308",
    "1e-320",
    "1e-170",
    "9" * 30,
    '"1"',
    "true",
    "[]",
    "{}",
)
WHOLE = (
    "",
    "\n\n",
    "\x00\x01\x02",
    "scene",
    "[[[[",
    "a = " + "[" * 5000,
    "{" * 5000,
    "null",
    '{"a": 1}',
    "scene = 3",
    'scene = "c04"\ncontent = 1',
    "\ufeff# only a comment",
)
_NUMBER = re.compile(r"(?<![\w.])-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?(?![\w.])")


def spoil(text: str, hand: Random) -> str:
    """A text, spoilt in one of many ways; now and then it is as good as before."""
    kind = hand.randrange(7)
    if kind == 0:
        return hand.choice(WHOLE)
    if kind == 1:
        return text[: hand.randrange(len(text) + 1)]
    if kind == 2:
        return _swap_number(text, hand)
    if kind == 3:
        at = hand.randrange(len(text) + 1)
        return text[:at] + chr(hand.randrange(1, 0x2FF)) + text[at + 1 :]
    lines = text.splitlines(keepends=True)
    if not lines:
        return text
    at = hand.randrange(len(lines))
    if kind == 4:
        del lines[at]
    elif kind == 5:
        lines.insert(at, lines[hand.randrange(len(lines))])
    else:
        lines[at] = lines[at].replace("=", hand.choice(("==", ":", "= unknown", "= [", "")), 1)
    return "".join(lines)


def _swap_number(text: str, hand: Random) -> str:
    """The text with one of its numbers replaced by another, or by none."""
    places = list(_NUMBER.finditer(text))
    if not places:
        return text
    place = hand.choice(places)
    return text[: place.start()] + hand.choice(NUMBERS) + text[place.end() :]
