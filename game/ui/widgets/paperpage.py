"""The page of a paper: problem, idea and steps, what its authors showed, and ours beside it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

import pygame

from game.ui.look.look import Look
from game.ui.widgets.column import Column
from game.ui.widgets.paper import Comparison, Paper, PaperRow, Step
from game.ui.widgets.sheetpage import Link, Section, SheetPage


class PaperPage(SheetPage):
    """The page as an overlay; ``show`` gives it what has been measured so far.

    Its blocks flow through columns as in a newspaper, cut where the highest column is least high. While
    something is still measured the cuts stay, so that nothing jumps under the eyes of a reader.
    """

    def __init__(self, look: Look, row: PaperRow, paper: Paper, links: Sequence[Link] = ()) -> None:
        super().__init__(look, links)
        self.row, self.paper = row, paper
        self.chip, self.title = row.number, row.title
        self.compared: tuple[Comparison, ...] = ()
        self.note = ""
        self._cuts: tuple[int, ...] = ()

    def place(self, window: pygame.Rect, look: Look) -> None:
        self._cuts = ()
        super().place(window, look)

    def show(self, compared: Sequence[Comparison], note: str) -> None:
        """What has been measured, and a word about what is still to come or has failed."""
        if (tuple(compared), note) != (self.compared, self.note):
            self.compared, self.note = tuple(compared), note
            self.refresh()

    def write(self, sheet: pygame.Surface | None) -> int:
        columns = self.even_columns(sheet)
        blocks = list(self._blocks())
        if not self._cuts or not self.note:
            heights = [_height(block, columns[0]) for block in blocks]
            self._cuts = cuts_of(heights, len(columns))
        for column, start, end in zip(columns, (0, *self._cuts), (*self._cuts, len(blocks)), strict=True):
            for block in blocks[start:end]:
                block(column)
        return max(column.y for column in columns) + self.look.px(16)

    def _blocks(self) -> Iterator[Section]:
        """What is never cut in two, in the order in which it is read."""
        paper = self.paper
        yield self._write_authors
        for title, paragraphs in (
            ("The problem", paper.problem),
            ("The idea", paper.idea),
            ("What the authors showed", paper.showed),
        ):
            yield from _part(title, paragraphs)
        for i, step in enumerate(paper.steps):
            yield partial(_write_step, i, step)
        yield from _part("Limits", paper.limits)
        yield from _part("What came after", paper.after)
        yield from self._measured()

    def _measured(self) -> Iterator[Section]:
        """Last of all, since it grows while it is read."""
        rows = [partial(_write_comparison, one) for one in self.compared]
        if self.note:
            rows.append(partial(_write_note, self.note))
        for i, write in enumerate(rows):
            yield partial(_write_headed, "Measured here, now", write) if i == 0 else write

    def _write_authors(self, column: Column) -> None:
        column.paragraph(f"{self.row.authors}, {self.row.year}", color="text3")


def cuts_of(heights: Sequence[int], columns: int) -> tuple[int, ...]:
    """First blocks of the columns after the first, so that the highest column is least high.

    heights: of the blocks, px. Of equal ways the earlier columns are filled.
    """
    least, most = max(heights, default=0), sum(heights)
    while least < most:
        middle = (least + most) // 2
        least, most = (least, middle) if len(_filled(heights, middle)) < columns else (middle + 1, most)
    cuts = _filled(heights, least)
    return (*cuts, *(len(heights) for _ in range(columns - 1 - len(cuts))))


def _filled(heights: Sequence[int], most: int) -> tuple[int, ...]:
    """Where columns end that hold at most so much, filled one after the other."""
    cuts, taken = [], 0
    for i, height in enumerate(heights):
        if taken + height > most and i > 0:
            cuts.append(i)
            taken = 0
        taken += height
    return tuple(cuts)


def _height(block: Section, like: Column) -> int:
    """How high a block is in a column as wide as another, px."""
    column = Column(like.look, None, 0, 0, like.width)
    block(column)
    return column.y


def _part(title: str, paragraphs: Sequence[str]) -> Iterator[Section]:
    """Paragraphs, the first below a heading."""
    for i, words in enumerate(paragraphs):
        write = partial(_write_words, words, i == len(paragraphs) - 1)
        yield partial(_write_headed, title, write) if i == 0 else write


def _write_headed(title: str, write: Section, column: Column) -> None:
    column.head(title)
    write(column)


def _write_words(words: str, last: bool, column: Column) -> None:
    column.paragraph(words)
    if last:
        column.space(8)


def _write_step(number: int, step: Step, column: Column) -> None:
    if number == 0:
        column.head("Step by step")
    column.numbered(number + 1, step.words)
    if step.formula:
        column.formula(step.formula)
    if step.figure is not None:
        column.figure(step.figure)


def _write_comparison(one: Comparison, column: Column) -> None:
    column.comparison(one.what, one.theirs, one.ours)


def _write_note(note: str, column: Column) -> None:
    column.paragraph(note, color="text3")
