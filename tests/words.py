"""Sentences of docstrings, and the words in them that count."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

MOST_WORDS = 25  # of a sentence; a list after a colon counts by itself
CODE = re.compile(r"``[^`]*``|`[^`]*`")
SOURCE = re.compile(r"\([^()]*\b1[89]\d\d[^()]*\)|\([^()]*\b20[0-4]\d[^()]*\)")  # a work, by its year
ABBREVIATED = re.compile(r"\b(e\.g|i\.e|al|St|Proc|No|vol|pp|vs)\. ")
WORD = re.compile(r"(?<![\w.^*/=+])(?:[A-Za-z][a-z'’-]*[a-z]|[aA]|[A-Z]{3,})(?![\w(^*/=])")
APART = re.compile(r"^[ |=]|\S {3,}\S|^\w+\(.*\)$")  # of a table, a formula, code
SYMBOL = re.compile(r"(?<![\w'’-])[B-HJ-Zb-zα-ωΔ](?:_\w+)?(?![\w'’(])")
SYMBOLS = 5  # a sentence that names so many is a legend of formulas
ENDS = re.compile(r"(?<=[.!?:])\s+")


class Sentence(NamedTuple):
    """A sentence or clause of a docstring: its file, the line of the docstring, its text."""

    file: Path
    line: int
    text: str

    @property
    def words(self) -> int:
        """How many words it has, without code, formulas and works that it names; a legend has none."""
        if len(SYMBOL.findall(self.text)) >= SYMBOLS:
            return 0
        return len(WORD.findall(SOURCE.sub("", CODE.sub("", self.text))))


def docstrings(file: Path) -> Iterator[tuple[int, str]]:
    """Line and text of each docstring of a file."""
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
            text = ast.get_docstring(node)
            if text:
                yield node.body[0].lineno, text


def paragraphs(text: str) -> Iterator[str]:
    """Paragraphs of prose and items of lists, each in one line.

    Tables, formulas and code stand apart and are indented.
    """
    for paragraph in re.split(r"\n\s*\n|\n(?=- )", text):
        lines = [line for line in paragraph.split("\n") if not APART.search(line)]
        yield " ".join(" ".join(lines).split())


def sentences(file: Path) -> Iterator[Sentence]:
    """The sentences of a file's docstrings; a colon ends one too, as a list may follow it."""
    for line, text in docstrings(file):
        for paragraph in paragraphs(text):
            for sentence in ENDS.split(ABBREVIATED.sub(r"\1._", paragraph)):
                yield Sentence(file, line, sentence)
