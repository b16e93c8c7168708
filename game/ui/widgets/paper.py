"""What is declared about a scientific paper: a row in the list of papers, and its page once it is done."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from importlib import import_module
from typing import Any, NamedTuple

from game.definition import DefinitionError

Figure = Callable[[Any], None]  # draws with a ui.canvas.pen.Pen in a help figure's frame


class Step(NamedTuple):
    """A step of the method: words, and what shows it."""

    words: str
    figure: Figure | None = None
    formula: str = ""


class Comparison(NamedTuple):
    """A figure of the authors and ours; ``theirs`` is "" where they give none."""

    what: str
    theirs: str
    ours: str


class Paper(NamedTuple):
    """The page of a paper, in our words.

    measure: gives what the page compares, one after the other, measured when it is opened, each in a second
    or so and without a screen. It runs in a thread of its own.
    """

    problem: tuple[str, ...]
    idea: tuple[str, ...]
    steps: tuple[Step, ...]
    showed: tuple[str, ...]
    measure: Callable[[], Iterator[Comparison]]
    limits: tuple[str, ...]
    after: tuple[str, ...]


class PaperRow(NamedTuple):
    """A paper in the list of all: what it is called, and where it is done.

    scene: name of the scene that shows it, "" as long as none does. level: name of the level that shows the
    authors' own example, or "". page: module and name of its Paper, as "module:NAME".
    """

    number: str
    title: str
    authors: str
    year: int
    scene: str = ""
    level: str = ""
    page: str = ""

    @property
    def done(self) -> bool:
        """Whether it can be seen and read here."""
        return bool(self.scene and self.page)

    def load(self) -> Paper:
        """Import its page; DefinitionError if there is none of that name."""
        module, _, name = self.page.partition(":")
        paper = getattr(import_module(module), name, None)
        if not isinstance(paper, Paper):
            raise DefinitionError(f"{self.number}: no page {self.page!r}")
        return paper
