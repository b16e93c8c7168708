"""Docstrings and comments: short sentences, and no phrases that must be read twice."""

from __future__ import annotations

import re
import tokenize
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

import game
from tests import words
from tests.words import MOST_WORDS, docstrings, sentences

ROOT = Path(game.__file__).resolve().parent
FORBIDDEN = {
    r"\b(is|are) told of\b": "say what it receives",
    r"\b[Nn]obody\b": "no body, no particle, no player: name the thing",
    r"(?<!let )\bgo(es)? by\b(?! way of)": "depends on, follows, is proportional to",
    r"\b[Aa]ll that (is|are)\b": "everything, or name it",
    r"\b[Ww]ho(m?ever)\b|# [Ww]ho\b": "name the caller, the thread, the player",
    r"\b([Aa]t one|[Aa]t the|[Aa]|[Tt]he|[Ee]ach|[Nn]o) doors?\b": "entry, or where it comes in",
    r"\b([Mm]akes?|[Hh]as|[Hh]ave|[Nn]o|[Ww]ithout|[Tt]wice the) room\b": "space, capacity",
    r"\b[Rr]oom (for|to|ran)\b|\(room,|, room\)": "space, capacity",
}  # fmt: skip


def files() -> list[Path]:
    """Every file of the package."""
    return sorted(ROOT.rglob("*.py"))


@cache
def said(file: Path) -> tuple[tuple[int, str], ...]:
    """Line and text of each docstring and each comment."""
    return tuple(_said(file))


def _said(file: Path) -> Iterator[tuple[int, str]]:
    for line, text in docstrings(file):
        yield line, " ".join(text.split())
    with file.open("rb") as source:
        for token in tokenize.tokenize(source.readline):
            if token.type == tokenize.COMMENT:
                yield token.start[0], token.string


def test_no_sentence_is_longer_than_can_be_read_at_once():
    long = [
        f"{one.file.relative_to(ROOT)}:{one.line} {one.words} words: {one.text}"
        for file in files()
        for one in sentences(file)
        if one.words > MOST_WORDS
    ]
    assert long == [], "\n".join(long)


@pytest.mark.parametrize("phrase", FORBIDDEN)
def test_no_phrase_that_must_be_read_twice(phrase):
    found = [
        f"{file.relative_to(ROOT)}:{line} {match.group()}: {FORBIDDEN[phrase]}"
        for file in files()
        for line, text in said(file)
        for match in re.finditer(phrase, text)
    ]
    assert found == [], "\n".join(found)


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("One two three.", [3]),
        ("One two. Three four five.", [2, 3]),
        ("Sources: one, two; three.", [1, 3]),
        ("A rod (Stronge 2000, a long title of a book) turns.", [3]),
        ("Takes ``one two three`` and `four five`.", [2]),
        ("Where d depth, r way, m slots, h step and n normal stand.", [0]),
        ("It ends if\n- one rests, or\n- two part.", [3, 3, 2]),
        ("It is\n\n    indented = text, that is no prose\n\nand goes on.", [2, 0, 3]),
    ],
)
def test_words_are_counted_without_code_formulas_and_works(text, count, tmp_path):
    file = tmp_path / "made.py"
    file.write_text(f'"""{text}"""\n', encoding="utf-8")
    assert [one.words for one in words.sentences(file)] == count
