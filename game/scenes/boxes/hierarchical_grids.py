"""Hierarchical grids in hash tables, beside testing every box against every other."""

from __future__ import annotations

import math
from typing import Any

import msgspec
import numpy as np

from game.lab.studies.broadphase.workloads import hierarchy_study
from game.physics.broadphase import HierarchicalGrid, NaiveBroadPhase
from game.physics.broadphase.hash_levels import TOP
from game.scenes.boxes import C06, view
from game.scenes.boxes.base import KIND_LABELS, KINDS, RATIO, SHARE
from game.scenes.boxes.compared import ComparedScene, manager_for
from game.scenes.boxes.figure import draw_levels
from game.scenes.boxes.levels_look import Look, draw_look, look_into, tell_look
from game.scenes.boxes.look import draw_names
from game.scenes.boxes.stack import MOST_BOXES, Sheet, draw_stack, sheet_at, sheets_of
from game.stage import Choice, Equation, Param, Pointer, Readout, Strip, Toggle
from game.ui.look.numerals import format_si
from game.ui.painters.boxes import BoxPainter

LEVEL_COLORS = ("violet", "pink", "yellow", "chalk")  # green is the naive way's
MOST_CELLS = 4_000
MOST_ROWS = 7  # levels listed
_cells = BoxPainter(tuple((color, 0.07, color, 0.4) for color in LEVEL_COLORS))


class HierarchicalGridScene(ComparedScene):
    """Boxes of very unlike sizes: most are small, a few are many times larger. One uniform grid cannot
    serve both; here there is a grid for every size. A box stands on the level whose cells are just not
    smaller than itself, in the cell of its lower corner. No grid is stored: cells are found by hashing, a
    table for each level, so there is neither an edge nor a size to choose, and memory follows the boxes. The
    tilted stack shows the levels above each other, and beside each the chains of boxes in its buckets.

    Pairs on one level are found as in a uniform grid. Between two levels either the smaller boxes look up
    the few large cells around them, or the large boxes run over the small cells below. The naive way, every
    box against every other, does the same beside it and judges the answer.
    """

    name, task, title = C06.names
    study = hierarchy_study

    step_ratio = Choice(
        "2",
        ("2", "4", "8", "16"),
        labels=("2", "4", "8", "16"),
        group="Levels",
        label="Cells from level to level",
        help="how many times larger the cells of the next level are",
    )
    workload = Choice(
        "heavy-tail",
        KINDS,
        labels=KIND_LABELS,
        group="Boxes",
        rebuild=True,
        help="how boxes are made",
    )
    ratio = Param(
        RATIO, 1.0, 1000.0, log=True, group="Boxes", label="Large to small", rebuild=True,
        help="size of the largest boxes of the heavy tail over that of the small ones",
    )  # fmt: skip
    share = Param(
        SHARE,
        0.0,
        0.5,
        group="Boxes",
        label="Share of large ones",
        rebuild=True,
        help="where there are two sizes",
    )
    cells = Toggle(
        True, group="Shown", label="Cells", help="cells that hold boxes, in the colour of their level"
    )

    stack = Toggle(
        False,
        group="Shown",
        label="Tilted stack",
        help="level upon level, each with its hash table beside it",
    )

    parts = (("hierarchical grids", HierarchicalGrid), ("naive pairs", NaiveBroadPhase))
    strips = (
        Strip("Pairs", "", ("pairs",)),
        Strip("Update and all pairs", "s", ("hierarchical", "naive")),
        Strip("Box tests", "", ("box tests",)),
    )
    figure = staticmethod(draw_levels)
    equations = (
        Equation("Motion", r"x' = x + v \Delta t, \quad v' = -v", "explicit Euler; beyond the boundary"),
        Equation("Level", r"2^{k-1} < s \le 2^k", "k from the exponent of the size s"),
        Equation(
            "Cell",
            r"i = \floor\left(\frac{x}{2^k}\right), \quad j = \floor\left(\frac{y}{2^k}\right)",
            "Ericson 2005, 7.2",
        ),
        Equation("Bucket", r"h = (i + P j) \text{ mod } m", "rows stay together; P near 0.618 m"),
        Equation("Naive", r"\frac{n(n-1)}{2}", "tests"),
    )
    try_this = (
        "Draw large to small from 1 to 1000: levels appear, and the tests hardly change.",
        "Choose the heavy tail: each level up holds half as many boxes. Then switch the tilted stack on.",
        "Open the ten boxes and point at a small one: it looks up a few cells on every coarser level.",
        "Set the share of large ones to a half: one grid for the large ones would make fewer tests.",
        "Let cells grow by 16 from level to level: fewer levels, more tests in each.",
        "Open the hard case of boxes that grow: they pass from level to level, and no pair is lost.",
    )

    # -- structures ---------------------------------------------------------------------------------

    def make_structures(self) -> None:
        self.grid = HierarchicalGrid(int(self.step_ratio))
        self.keeper = manager_for(len(self.alive), self.manager)
        self.make_naive()
        self.sheet_held: Sheet | None = None  # of the stack, where the pointer is
        self.sheet_grasped: Sheet | None = None  # and where something was taken

    def structures(self) -> tuple[HierarchicalGrid]:
        return (self.grid,)

    def shaping(self) -> tuple[str, ...]:
        return ("manager", "step_ratio")

    @property
    def stacked(self) -> bool:
        """Whether the levels are shown as a stack."""
        return bool(self.stack) and len(self.ids) <= MOST_BOXES

    def sheets(self) -> list[Sheet]:
        """The sheets of the stack as it is now."""
        present = [level for level, _ in self.grid.levels()]
        return sheets_of(present, lambda level: LEVEL_COLORS[self._color(present, level)])

    def pointer(self, event: Pointer) -> None:
        """In a stack, a place on a sheet is a place in the world, and boxes of its level are meant."""
        if self.stacked and event.kind != "cancel":
            sheet = sheet_at(self.sheets(), event.x, event.y)
            if sheet is not None:
                self.sheet_held = sheet
            elif event.kind == "down" or (self.held < 0 and self.anchor is None and not self.erasing):
                self.pointed = None
                return
            if (self.held >= 0 or self.anchor is not None) and self.sheet_grasped is not None:
                self.sheet_held = self.sheet_grasped
            if event.kind == "down":
                self.sheet_grasped = self.sheet_held
            if self.sheet_held is None:
                return
            x, y = self.sheet_held.back(event.x, event.y)
            event = msgspec.structs.replace(event, x=x, y=y)
        super().pointer(event)

    def box_at(self, at: tuple[float, float]) -> int:
        """As ever; in a stack the topmost box of the level whose sheet is pointed at."""
        found = super().box_at(at)
        return self._on_level(at, found)

    @property
    def looked(self) -> int:
        """As ever; in a stack of the boxes below the pointer the topmost one of that level."""
        found = super().looked
        if found in (-1, self.held, self.chosen) or self.pointed is None:
            return found
        return self._on_level(self.pointed, found)

    def _on_level(self, at: tuple[float, float], found: int) -> int:
        """The topmost box at a place, m, on the level of the sheet pointed at; -1 if there is none."""
        if not self.stacked or self.sheet_held is None or found < 0:
            return found
        within = ((self.lowers <= at) & (at <= self.uppers)).all(axis=1) & (self.alive == 1)
        mine = [i for i in np.flatnonzero(within).tolist() if self.grid.level(i) == self.sheet_held.level]
        return mine[-1] if mine else -1

    def why_idle(self, name: str) -> str:
        if name == "stack" and len(self.ids) > MOST_BOXES:
            return f"Above {view.grouped(MOST_BOXES)} boxes the levels are not stacked."
        if name in ("cells", "lines") and self.stacked:
            return "The tilted stack has its own."
        if name == "cells" and len(self.ids) > MOST_CELLS:
            return f"Above {view.grouped(MOST_CELLS)} boxes no cells are drawn."
        return super().why_idle(name)

    def pair_up(self) -> None:
        with self.watch.time("hierarchical"):
            self.update(self.grid)
            self.pairs = self.grid.pairs()
        if self.keeper.greatest < len(self.alive) - 1:
            self.keeper = manager_for(len(self.alive), self.manager)
        with self.watch.time("keeper"):
            self.keeper.set_pairs(self.pairs)
            events = self.keeper.take_events()
        self.begun, self.ended = len(events.begun), len(events.ended)
        self.compare()

    # -- what is shown ------------------------------------------------------------------------------

    def readouts(self) -> tuple[Readout, ...]:
        return (
            Readout("boxes", len(self.ids)),
            Readout("pairs", len(self.pairs)),
            Readout("begun", self.begun),
            Readout("ended", self.ended),
            Readout("hierarchical", self.watch.median("hierarchical"), "s"),
            Readout("naive", self.watch.median("naive"), "s"),
            Readout("pair manager", self.watch.median("keeper"), "s"),
            Readout("box tests", self.grid.tests),
            Readout("answers differ", 0 if self.same else 1),
        )

    def legend(self) -> tuple[tuple[str, str, str], ...]:
        return tuple(self.legend_rows())

    def draw(self, canvas: Any, alpha: float) -> None:
        levels, corners = self.grid.cells()
        counts = np.bincount(levels[levels >= 0], minlength=1)
        present = np.flatnonzero(counts)
        seen = look_into(self, self.looked) if self.looked >= 0 else None
        if self.stacked:
            draw_stack(self, canvas, alpha, self.sheets(), seen)
        else:
            self._draw_world(canvas, alpha, levels, corners, present, seen)
        column = view.Column(canvas, self, 5.75)
        if seen is None or column.room_px > view.TALL:
            words = f"Hierarchical, {view.grouped(self.grid.tests)} tests"
            self.draw_comparison(column, "hierarchical", words, "chalk")
            column.space(6)
        self._draw_levels(column, canvas, counts, present)
        if seen is not None:
            column.space(6)
            tell_look(self, column, seen)

    def _draw_world(
        self, canvas: Any, alpha: float, levels: Any, corners: Any, present: Any, seen: Look | None
    ) -> None:
        """The world from above, cells of all levels upon each other."""
        if self.cells and len(self.ids) <= MOST_CELLS:
            self._draw_cells(canvas, levels, corners, present)
        view.draw_ground(canvas)
        view.draw_boxes(self, canvas, alpha)
        draw_names(self, canvas, alpha)
        if seen is not None:
            draw_look(self, canvas, alpha, seen)

    def _draw_cells(self, canvas: Any, levels: Any, corners: Any, present: Any) -> None:
        """The cells that hold boxes, coarse ones first; the level that is one cell has no outline."""
        for level in present[::-1].tolist():
            if level == TOP:
                continue
            lower = np.unique(corners[levels == level], axis=0)
            kinds = np.full(len(lower), self._color(present, level), dtype=np.uint8)
            _cells.paint(canvas, lower, lower + self.grid.cell_size(level), kinds)

    @staticmethod
    def _color(present: Any, level: int) -> int:
        return int(np.searchsorted(present, level)) % len(LEVEL_COLORS)

    def _draw_levels(self, column: view.Column, canvas: Any, counts: Any, present: Any) -> None:
        """A row for each level that holds boxes, from the finest: size of its cells, boxes in them."""
        column.head("Levels", "boxes")
        most = max(int(counts.max(initial=1)), 1)
        for level in present[:MOST_ROWS].tolist():
            size = self.grid.cell_size(level)
            words = f"Cells of {format_si(size, 'm')}" if math.isfinite(size) else "One cell for the rest"
            length = math.log1p(int(counts[level])) / math.log1p(most)
            column.bar(
                words, view.grouped(int(counts[level])), length, LEVEL_COLORS[self._color(present, level)]
            )
        if len(present) > MOST_ROWS:
            column.row(f"and {len(present) - MOST_ROWS} levels more", "")
