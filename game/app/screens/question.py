"""What the card for a name asks."""

from __future__ import annotations

from typing import NamedTuple


class Question(NamedTuple):
    """What is asked: title of the card, words about it, the button's word, what is there before, what stands
    in the empty field, and the most letters."""

    heading: str
    about: str
    button: str
    text: str
    prompt: str
    longest: int
