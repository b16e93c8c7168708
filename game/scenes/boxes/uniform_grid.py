"""A uniform grid finds the pairs; a full matrix and a hash table keep them, side by side."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.lab.studies.broadphase.workloads import cell_size_study
from game.physics.broadphase import CoveringGrid, HashedPairs, MatrixPairs, PairEvents, UniformGrid
from game.physics.broadphase.effects import BOUNDARY, HASHED_PAIRS, MATRIX_PAIRS, MOTION
from game.scenes.boxes import C05, view
from game.scenes.boxes.base import BoxesScene
from game.scenes.boxes.figure import draw_cells
from game.scenes.boxes.grid_look import Look, draw_look, look_into, mark_matrix, mark_table, tell_look
from game.scenes.boxes.level import HEIGHT, WIDTH
from game.scenes.boxes.look import draw_names
from game.stage import Choice, Equation, Param, Readout, Strip, Toggle

MOST_IN_MATRIX = 4096  # boxes; the matrix takes 32 MB then, and four times as much at twice as many
MOST_CELLS = 1 << 20
MATRIX_PICTURE = 128  # blocks across
TURNS = ("first", "second")  # in which a manager is told the pairs
FEW_IDS = 64  # the matrix is drawn with a block for each place, the table in one row
HASH_ROWS, HASH_COLUMNS = 16, 64


class UniformGridScene(BoxesScene):
    """Boxes with random velocities move by explicit Euler and turn back at the boundary. A uniform grid,
    a dense matrix of cells without any hashing, finds all pairs that overlap in every step; boxes are
    added, removed and updated in it as they come, go and move.

    Two pair managers are told the pairs, and say which ones began and which ended. One looks a pair up in a
    full matrix over all boxes, the other in a hash table. Their answers are compared in every step, their
    times and their memory are shown side by side. The matrix asks for one look and for memory that grows
    with the square of the boxes; above 4096 boxes it is left out here.

    In the textbook's grid every box stands in all cells that it covers; here it may also stand in the cell
    of its lower corner alone, and look further for its partners.
    """

    name, task, title = C05.names
    effects = MOTION | BOUNDARY | MATRIX_PAIRS | HASHED_PAIRS
    study = cell_size_study

    cell = Param(
        2.0, 0.25, 32.0, log=True, group="Grid", label="Cell size",
        help="edge of a cell over the size of most boxes",
    )  # fmt: skip
    storage = Choice(
        "corner",
        ("corner", "covered"),
        labels=("One cell", "All covered"),
        group="Grid",
        label="A box stands in",
        help="the cell of its lower corner, or every cell that it covers",
    )
    heat = Toggle(True, group="Shown", label="Cell load", help="cells shaded by the boxes in them")

    parts = (
        ("uniform grid", lambda: UniformGrid((0.0, 0.0), (1.0, 1.0), 0.5)),
        ("covered cells", lambda: CoveringGrid((0.0, 0.0), (1.0, 1.0), 0.5)),
    )
    strips = (
        Strip("Pairs", "", ("pairs",)),
        Strip("Pair managers", "s", ("matrix", "hash")),
        Strip("Grid", "s", ("grid",)),
    )
    figure = staticmethod(draw_cells)
    equations = (
        Equation("Motion", r"x' = x + v \Delta t", "explicit Euler"),
        Equation("Boundary", r"v' = -v", "beyond it and on the way out"),
        Equation("Cell", r"i = \floor\left(\frac{x - x_0}{c}\right)", "Ericson 2005, 7.1"),
        Equation("Entries of a box", r"\left(1 + \frac{s}{c}\right)^2", "all covered cells, mean"),
        Equation("Place of a pair", r"k = \frac{i(2n - i - 1)}{2} + j - i - 1", "triangular matrix"),
        Equation(
            "Mean pairs",
            r"\frac{n(n-1)}{2} p_W p_H, \quad p_W = \frac{2 s L - s^2}{L^2}, \quad L = W - s",
            "boxes of side s, uniform in W × H; p_H as p_W",
        ),
    )
    try_this = (
        "Draw the cell size from 0.25 to 32: the time of the grid goes through a minimum.",
        "Choose all covered cells at a small cell size: entries grow with the square of size over cell.",
        "Raise the number to 4000 and watch the memory of the matrix; the hash table hardly grows.",
        "Put all boxes on one line, or cluster them: the load of a few cells, and the time, go up.",
    )

    # -- structures ---------------------------------------------------------------------------------

    def make_structures(self) -> None:
        cell = max(self.cell * self.size, math.sqrt(WIDTH * HEIGHT / MOST_CELLS))
        kind = UniformGrid if self.storage == "corner" else CoveringGrid
        self.grid = kind((0.0, 0.0), (WIDTH, HEIGHT), min(cell, WIDTH))
        self.hashed = HashedPairs()
        self.answers: list[PairEvents] = []  # of the managers, in the last step
        self.matrix: MatrixPairs | None = None
        self._fit_matrix(len(self.alive))

    def _fit_matrix(self, rows: int) -> None:
        """A matrix with room for the ids there are, while there are not too many; its pairs are kept."""
        if rows > MOST_IN_MATRIX:
            if self.matrix is not None:
                self.told.append(f"Above {MOST_IN_MATRIX} boxes the full matrix is left out.")
            self.matrix = None
        elif self.matrix is None or self.matrix.capacity < rows:
            old, self.matrix = self.matrix, MatrixPairs(max(1 << (rows - 1).bit_length(), 256))
            if old is not None:
                self.matrix.set_pairs(old.pairs())
                self.matrix.take_events()

    def structures(self) -> tuple[UniformGrid]:
        return (self.grid,)

    def pair_up(self) -> None:
        with self.watch.time("grid"):
            self.update(self.grid)
            self.pairs = self.grid.pairs()
        self._fit_matrix(len(self.alive))
        self.answers = []
        managers = (("matrix", MATRIX_PAIRS, self.matrix), ("hash", HASHED_PAIRS, self.hashed))
        # in turn, as the first one finds the pairs in no cache and the second one does
        for name, effect, manager in managers if self.steps % 2 else managers[::-1]:
            if manager is None or effect not in self.active:
                self._forget_times(name)
                continue
            with self.watch.time(f"{name}, {TURNS[len(self.answers)]}"):
                manager.set_pairs(self.pairs)
                self.answers.append(manager.take_events())
        self.begun, self.ended = (len(events) for events in self.answers[0]) if self.answers else (0, 0)

    def manager_s(self, name: str) -> float:
        """What a manager ("matrix", "hash") takes in a step, s: the mean over both turns; NaN if unknown."""
        medians = [self.watch.median(f"{name}, {turn}") for turn in TURNS]
        known = [seconds for seconds in medians if math.isfinite(seconds)]
        return sum(known) / len(known) if known else math.nan

    def _forget_times(self, *names: str) -> None:
        for name in names:
            for turn in TURNS:
                self.watch.forget(f"{name}, {turn}")

    @property
    def compared(self) -> bool:
        """Whether both managers kept the pairs in the last step, so that there is something to compare."""
        return len(self.answers) == 2

    @property
    def same(self) -> bool:
        """Whether the managers' answers of the last step agree.

        They are compared when that is asked for, so that it is not counted as the cost of a manager.
        """
        return not self.compared or all(np.array_equal(*both) for both in zip(*self.answers, strict=True))

    def effects_changed(self) -> None:
        """A manager that was off learns the pairs that there are; who is told first is another one now."""
        self._forget_times("matrix", "hash")
        for manager in (self.matrix, self.hashed):
            if manager is not None:
                manager.set_pairs(self.pairs)
                manager.take_events()

    def parameter_changed(self, name: str) -> None:
        super().parameter_changed(name)
        if name in ("cell", "storage"):
            counts = self.begun, self.ended
            self.begin_anew()
            self.begun, self.ended = counts

    # -- what is shown ------------------------------------------------------------------------------

    def readouts(self) -> tuple[Readout, ...]:
        return (
            Readout("boxes", len(self.ids)),
            Readout("pairs", len(self.pairs)),
            Readout("begun", self.begun),
            Readout("ended", self.ended),
            Readout("grid", self.watch.median("grid"), "s"),
            Readout("matrix", self.manager_s("matrix"), "s"),
            Readout("hash", self.manager_s("hash"), "s"),
            Readout("box tests", self.grid.tests),
            Readout("answers differ", 0 if self.same else 1),
        )

    def legend(self) -> tuple[tuple[str, str, str], ...]:
        rows = [
            ("box:vermilion", "overlapping", view.grouped(self.overlapping())),
            ("box:ghost", "boxes", view.grouped(len(self.ids))),
            ("line:vermilion", "pairs", view.grouped(len(self.pairs))),
        ]
        if self.heat:
            full = self._full()
            rows.append(("scale:stage:chalk", "Boxes in a cell", f"0 {full:.3g}"))
        return tuple(rows)

    def _full(self) -> float:
        """Load that is shaded fully: three times that of a cell if boxes were spread evenly, at least 3."""
        even = len(self.ids) / (self.grid.columns * self.grid.rows)
        if isinstance(self.grid, CoveringGrid):
            even *= (1.0 + self.size / self.grid.cell) ** 2
        return max(3.0 * math.ceil(even), 3.0)

    def draw(self, canvas: Any, alpha: float) -> None:
        if self.heat:
            view.draw_loads(canvas, self.grid.loads(), self.grid.cell, self._full())
        view.draw_ground(canvas)
        view.draw_boxes(self, canvas, alpha)
        draw_names(self, canvas, alpha)
        seen = look_into(self, self.looked) if self.looked >= 0 else None
        if seen is not None:
            draw_look(self, canvas, alpha, seen)
        self._draw_managers(canvas, seen)

    @property
    def keeps_matrix(self) -> bool:
        """Whether the full matrix keeps the pairs."""
        return self.matrix is not None and MATRIX_PAIRS in self.active

    @property
    def keeps_table(self) -> bool:
        """Whether the hash table keeps the pairs."""
        return HASHED_PAIRS in self.active

    def _draw_managers(self, canvas: Any, seen: Look | None) -> None:
        """Matrix and hash table as they are filled, and what each costs."""
        column = view.Column(canvas, self)
        if seen is None or column.room_px > view.TALL:
            self._draw_times(column)
        self._draw_matrix(column, canvas, seen)
        self._draw_table(column, canvas, seen)
        if seen is not None:
            tell_look(self, column, seen)

    def _draw_times(self, column: view.Column) -> None:
        """What each manager takes, and whether they agree."""
        times = [self.manager_s(name) for name in ("matrix", "hash")]
        longest = max((time for time in times if math.isfinite(time)), default=1.0)
        same = "same answers" if self.same else "answers differ"
        column.head("Pair managers", same if self.compared else "not compared")
        for words, manager, time, color in (
            ("Full matrix", self.matrix if MATRIX_PAIRS in self.active else None, times[0], "chalk"),
            ("Hash table", self.hashed if HASHED_PAIRS in self.active else None, times[1], "green"),
        ):
            pairs = "left out"
            if manager is not None:
                pairs = f"{view.grouped(len(manager))} {'pair' if len(manager) == 1 else 'pairs'}"
            column.bar(
                f"{words}, {pairs}", view.seconds_text(time), time / longest if time > 0.0 else 0.0, color
            )
        column.space(8)

    def _draw_matrix(self, column: view.Column, canvas: Any, seen: Look | None) -> None:
        """Which places of the matrix hold a pair, in blocks."""
        if self.matrix is None or not self.keeps_matrix:
            size = 4.0 * len(self.alive) * (len(self.alive) - 1) / 2
            column.head("Full matrix", f"would take {view.bytes_text(size)}")
            return
        n = max(len(self.alive), 2)
        blocks = min(MATRIX_PICTURE, n)
        high = blocks if n <= FEW_IDS else blocks // 2
        filled = np.zeros((high, blocks))
        if len(self.pairs):
            rows = (high - 1) - self.pairs[:, 0] * high // n
            np.add.at(filled, (rows, self.pairs[:, 1] * blocks // n), 1.0)
        beyond = _beyond(*filled.shape)
        colors = view.shades(
            canvas, np.where(filled > 0, 0.35 + 0.65 * filled / max(filled.max(), 1), 0.0), "chalk", "inset"
        )
        colors[beyond & (filled == 0)] = canvas.ink("stage")
        column.head("Full matrix", view.bytes_text(self.matrix.memory()))
        frame = column.picture(colors, 92)
        if seen is not None:
            mark_matrix(canvas, seen, n, frame)

    def _draw_table(self, column: view.Column, canvas: Any, seen: Look | None) -> None:
        """Which places of the hash table are taken, in blocks."""
        if not self.keeps_table:
            return
        taken = self.hashed.table.where > 0
        blocks = min(HASH_ROWS * HASH_COLUMNS, len(taken))
        columns = min(HASH_COLUMNS, blocks)
        filled = taken.reshape(blocks, -1).mean(axis=1).reshape(-1, columns)
        column.head(
            "Hash table", f"{view.bytes_text(self.hashed.memory())}, {self.hashed.probes():.2f} looks"
        )
        frame = column.picture(view.shades(canvas, filled, "green", "inset"), 56 if blocks > FEW_IDS else 28)
        if seen is not None:
            mark_table(canvas, self.hashed, seen, filled.shape, frame)


@lru_cache(maxsize=4)
def _beyond(rows: int, columns: int) -> NDArray[np.bool_]:
    """Which blocks of the picture of the matrix hold nothing: those below its diagonal."""
    row, place = np.indices((rows, columns))
    return place / columns < 1.0 - (row + 1) / rows
