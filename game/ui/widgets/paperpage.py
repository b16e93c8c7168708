"""The page of a paper: problem, idea and steps, what its authors showed, and ours beside it."""

from __future__ import annotations

from collections.abc import Sequence

from game.ui.look.look import Look
from game.ui.widgets.column import Column
from game.ui.widgets.paper import Comparison, Paper, PaperRow
from game.ui.widgets.sheetpage import Link, Section, SheetPage


class PaperPage(SheetPage):
    """The page as an overlay; ``show`` gives it what has been measured so far."""

    def __init__(self, look: Look, row: PaperRow, paper: Paper, links: Sequence[Link] = ()) -> None:
        super().__init__(look, links)
        self.row, self.paper = row, paper
        self.chip, self.title = row.number, row.title
        self.compared: tuple[Comparison, ...] = ()
        self.note = ""

    def show(self, compared: Sequence[Comparison], note: str) -> None:
        """What has been measured, and a word about what is still to come or has failed."""
        if (tuple(compared), note) != (self.compared, self.note):
            self.compared, self.note = tuple(compared), note
            self.refresh()

    def sections(self) -> tuple[Section, Section, Section]:
        return self._write_problem, self._write_steps, self._write_figures

    def _write_problem(self, column: Column) -> None:
        paper, row = self.paper, self.row
        column.paragraph(f"{row.authors}, {row.year}", color="text3")
        for title, paragraphs in (
            ("The problem", paper.problem),
            ("The idea", paper.idea),
            ("What the authors showed", paper.showed),
        ):
            self._part(column, title, paragraphs)

    def _write_steps(self, column: Column) -> None:
        column.head("Step by step")
        for i, step in enumerate(self.paper.steps):
            column.numbered(i + 1, step.words)
            if step.formula:
                column.formula(step.formula)
            if step.figure is not None:
                column.figure(step.figure)

    def _write_figures(self, column: Column) -> None:
        column.head("Measured here, now")
        for one in self.compared:
            column.comparison(one.what, one.theirs, one.ours)
        if self.note:
            column.paragraph(self.note, color="text3")
        column.space(8)
        self._part(column, "Limits", self.paper.limits)
        self._part(column, "What came after", self.paper.after)

    def _part(self, column: Column, title: str, paragraphs: Sequence[str]) -> None:
        column.head(title)
        for words in paragraphs:
            column.paragraph(words)
        column.space(8)
