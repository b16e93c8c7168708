"""Finding scenes and levels by a few letters, however they are spread over the words."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Sequence
from functools import lru_cache
from typing import NamedTuple, TypeVar

T = TypeVar("T")

LONGEST_QUERY = 60
MOST_KEPT = 8_000  # texts, or words; all levels of all scenes have some two thousand of each
_WORD = re.compile(r"[a-z0-9]+")


class Field(NamedTuple):
    """A text to search in and what a hit in it is worth."""

    text: str
    weight: float


class Words(NamedTuple):
    """A text as it is searched: plain, its words, the first letters of these."""

    text: str
    parts: tuple[str, ...]
    initials: str


def plain(text: str) -> str:
    """Lower case, without accents."""
    letters = text.casefold()
    if letters.isascii():
        return letters
    return "".join(one for one in unicodedata.normalize("NFKD", letters) if not unicodedata.combining(one))


@lru_cache(maxsize=MOST_KEPT)
def words_of(text: str) -> Words:
    """The words of a text, which is asked for again with every letter that is typed."""
    whole = plain(text)
    parts = tuple(_WORD.findall(whole))
    return Words(whole, parts, "".join(part[0] for part in parts))


def rank(query: str, candidates: Iterable[tuple[T, Sequence[Field]]]) -> list[T]:
    """The candidates that every word of the query is found in, the best first; ties keep their order."""
    words = _WORD.findall(plain(query[:LONGEST_QUERY]))
    if not words:
        return [candidate for candidate, _ in candidates]
    found: list[tuple[float, int, T]] = []
    for i, (candidate, fields) in enumerate(candidates):
        scores = [
            max((field.weight * score_word(word, field.text) for field in fields), default=0.0)
            for word in words
        ]
        if min(scores) > 0.0:
            found.append((-sum(scores), i, candidate))
    found.sort(key=lambda row: row[:2])
    return [candidate for _, _, candidate in found]


def score_word(word: str, text: str) -> float:
    """How well a word fits a text, 0 to 1: whole, begins a word, is inside one, first letters, scattered."""
    whole, parts, initials = words_of(text)
    if not word or not whole:
        return 0.0
    if word in parts:
        return 1.0 if parts[0] == word else 0.95
    if word in whole:
        if any(part.startswith(word) for part in parts):
            return 0.85 if parts[0].startswith(word) else 0.8
        return 0.6
    if len(word) < 2:
        return 0.0
    if _is_subsequence(word, initials):
        return 0.5
    return max((_scattered(word, part) for part in parts), default=0.0) if len(word) >= 3 else 0.0


def _is_subsequence(word: str, text: str) -> bool:
    letters = iter(text)
    return all(letter in letters for letter in word)


@lru_cache(maxsize=MOST_KEPT)
def _scattered(word: str, part: str) -> float:
    """Letters in order with gaps within one word ("fntn"), or one too many or swapped ("fountian")."""
    if len(part) < len(word) - 1:
        return 0.0
    if word[0] == part[0] and _is_subsequence(word, part):
        return 0.4 * len(word) / len(part)
    if len(word) >= 4 and len(part) <= len(word) + 1 and _distance_is_small(word, part):
        return 0.3
    return 0.0


def _distance_is_small(a: str, b: str) -> bool:
    """One letter added, left out, changed, or two neighbours swapped."""
    if len(a) > len(b):
        a, b = b, a
    i = next((i for i in range(len(a)) if a[i] != b[i]), len(a))
    if len(a) == len(b):
        swapped = a[i + 1 : i + 2] + a[i : i + 1] + a[i + 2 :]
        return a[i + 1 :] == b[i + 1 :] or swapped == b[i:]
    return a[i:] == b[i + 1 :]
