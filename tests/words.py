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
PROSE = 4  # words that a string has at least if it is a sentence for a person
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


def literals(file: Path) -> Iterator[tuple[int, str]]:
    """Line and text of each string that is prose: help, captions, pages, messages.

    Docstrings are left out, and what has no four words. A value that is put in counts as a figure.
    """
    tree, left_out = ast.parse(file.read_text(encoding="utf-8")), set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Expr):
            left_out.add(id(node.value))
        elif isinstance(node, ast.JoinedStr):
            left_out |= {id(part) for part in ast.walk(node) if isinstance(part, ast.Constant)}
    for node in ast.walk(tree):
        text = ""
        if isinstance(node, ast.JoinedStr):
            parts = (part.value if isinstance(part, ast.Constant) else "1" for part in node.values)
            text = "".join(str(part) for part in parts)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in left_out:
            text = node.value
        if len(text.split()) >= PROSE and text.count("{") < PROSE:  # a sheet of styles is none
            yield node.lineno, text


def texts(data: object) -> Iterator[str]:
    """All strings of prose in what a level file holds."""
    if isinstance(data, str) and len(data.split()) >= PROSE:
        yield data
    elif isinstance(data, dict | list):
        for part in data.values() if isinstance(data, dict) else data:
            yield from texts(part)


def split(text: str) -> list[str]:
    """Sentences and clauses of a text in one line."""
    return ENDS.split(ABBREVIATED.sub(r"\1._", text))


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
            for sentence in split(paragraph):
                yield Sentence(file, line, sentence)
