"""Docstrings, comments, and what a person reads: short sentences, no phrases that must be read twice."""

from __future__ import annotations

import re
import tokenize
import tomllib
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

import game
from tests import words
from tests.words import MOST_WORDS, docstrings, sentences

ROOT = Path(game.__file__).resolve().parent
LEVELS = ROOT.parent / "levels"
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


@cache
def shown() -> tuple[tuple[str, str], ...]:
    """Place and text of everything that a person may read: strings of the package, files of levels."""
    strings = [
        (f"{file.relative_to(ROOT)}:{line}", text) for file in files() for line, text in words.literals(file)
    ]
    levels = [
        (f"levels/{file.relative_to(LEVELS)}", text)
        for file in sorted(LEVELS.rglob("*.toml"))
        for text in words.texts(tomllib.loads(file.read_text(encoding="utf-8")))
    ]
    return (*strings, *levels)


def test_what_a_person_reads_is_found():
    """Help of a parameter, a step of a paper's page, a caption of a story, a message with a number."""
    found = " | ".join(text for _, text in shown())
    for said in ("farther from a pin than the links reach", "Leaves that have become too full are split",
                 "There can be at most 1 bodies."):  # fmt: skip
        assert said in found
    assert any(place.startswith("levels/") for place, _ in shown())


def test_no_sentence_that_a_person_reads_is_longer():
    long = [
        f"{place} {one.words} words: {one.text}"
        for place, text in shown()
        for one in (words.Sentence(ROOT, 0, part) for part in words.split(text))
        if one.words > MOST_WORDS
    ]
    assert long == [], "\n".join(long)


@pytest.mark.parametrize("phrase", FORBIDDEN)
def test_no_phrase_that_a_person_must_read_twice(phrase):
    found = [
        f"{place} {match.group()}: {FORBIDDEN[phrase]}"
        for place, text in shown()
        for match in re.finditer(phrase, text)
    ]
    assert found == [], "\n".join(found)


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
