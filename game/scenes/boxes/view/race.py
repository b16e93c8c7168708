"""How the race is drawn: the world, and a table with a row for each contestant."""

from __future__ import annotations

import math

import numpy as np

from game.lab.studies.broadphase.count import METHOD_COLORS
from game.physics.broadphase import BspTree, KineticSweep, SweepAndPrune
from game.scenes.boxes.level import HEIGHT, WIDTH
from game.scenes.boxes.model.arrays import BoxesState
from game.scenes.boxes.model.race import RaceModel
from game.scenes.boxes.numbers import bytes_text, grouped, short
from game.scenes.boxes.view.bounds_look import draw_bounds
from game.scenes.boxes.view.race_plot import ABOVE, area_below, crossover_words, draw_plot
from game.scenes.boxes.view.race_table import TABLE_RIGHT, Contestant, RaceTable
from game.scenes.boxes.view.world import BoxesView, draw_ground
from game.stage import Frame
from game.ui.canvas.canvas import Canvas

PHASES = (
    Contestant("naive", "Naive", METHOD_COLORS["naive"], "tests"),
    Contestant("uniform", "Uniform grid", METHOD_COLORS["uniform"], "tests"),
    Contestant("covering", "Grid, all cells covered", METHOD_COLORS["covering"], "tests"),
    Contestant("hierarchical", "Hierarchical grids", METHOD_COLORS["hierarchical"], "tests"),
    Contestant("sweep", "Sweep and prune", METHOD_COLORS["sweep"], "swaps"),
    Contestant("bsp", "BSP tree", METHOD_COLORS["bsp"], "tests"),
    Contestant("kinetic", "Kinetic sweep", METHOD_COLORS["kinetic"], "tests"),
)
MANAGERS = (
    Contestant("matrix", "Full matrix", "chalk", "begun"),
    Contestant("hash", "Hash table", "green", "begun"),
)


class RaceView(BoxesView):
    """The view of the race."""

    model: RaceModel

    def frame(self) -> Frame:
        return Frame(-0.1, -0.1, TABLE_RIGHT + 0.1, 12.9)

    def legend(self) -> list[tuple[str, str, str]]:
        """None: it would take half of the plot's width; the counts stand above the plot."""
        return []

    def draw(self, canvas: Canvas, before: BoxesState | None, alpha: float) -> None:
        draw_ground(canvas)
        self._write_counts(canvas)
        if self.model.parameters.cuts:
            self._draw_cuts(canvas)
        if self.model.parameters.bounds and self.model.kinetic is not None:
            draw_bounds(canvas, self.model.kinetic)
        self.draw_boxes(canvas, before, alpha)
        table = RaceTable(canvas)
        self._write_phases(table)
        table.space(20)
        self._write_managers(table)
        table.scale()
        table.space(26)
        table.words(crossover_words(self.model.curves))
        draw_plot(canvas, self.model, area_below(table.y))

    def _write_counts(self, canvas: Canvas) -> None:
        """How many boxes there are, how many of them overlap, and in how many pairs."""
        model = self.model
        words = (
            f"{grouped(len(model.boxes))} boxes, {grouped(model.overlapping())} overlap, "
            f"{grouped(len(model.pairs))} pairs"
        )
        at = (WIDTH, ABOVE.top)
        canvas.label(at, canvas.figure("counts", words), "vermilion", 11, "medium", "right", (0.0, -12.0))

    def _draw_cuts(self, canvas: Canvas) -> None:
        """The parts into which the BSP tree cuts the world."""
        tree = self.model.phases.get("bsp")
        if not isinstance(tree, BspTree):
            return
        world = np.array((0.0, 0.0, WIDTH, HEIGHT))
        parts = np.clip(tree.leaves()[:, :4], np.tile(world[:2], 2), np.tile(world[2:], 2))
        canvas.segments(parts[:, [0, 1]], parts[:, [2, 1]], "violet", 1.0)
        canvas.segments(parts[:, [2, 1]], parts[:, [2, 3]], "violet", 1.0)

    def _write_phases(self, table: RaceTable) -> None:
        """A row for each broad phase."""
        model = self.model
        table.head("Update and all pairs")
        fastest = min((model.watch.median(name) for name in model.phases), default=math.nan)
        for contestant in PHASES:
            phase = model.phases.get(contestant.name)
            if phase is None:
                table.row(contestant, math.nan, "left out", "", None, fastest)
                continue
            seconds = model.watch.median(contestant.name)
            work = model.swaps if isinstance(phase, SweepAndPrune) else phase.tests
            words = f"{short(work)} {contestant.work}"
            if isinstance(phase, BspTree):
                words += f", {short(model.tree_work.repairs)} anew"
            if isinstance(phase, KineticSweep):
                words += f", {short(phase.events)} events, {short(phase.false_pairs)} false"
            table.row(
                contestant, seconds, words, bytes_text(phase.memory()),
                model.agree[contestant.name] if len(model.phases) > 1 else None, fastest,
            )  # fmt: skip

    def _write_managers(self, table: RaceTable) -> None:
        """A row for each pair manager."""
        model = self.model
        table.head("Pairs begun and ended")
        times = [model.watch.median(contestant.name) for contestant in MANAGERS]
        fastest = min((time for time in times if math.isfinite(time)), default=math.nan)
        for contestant, seconds in zip(MANAGERS, times, strict=True):
            manager = model.managers[contestant.name]
            if manager is None:
                table.row(contestant, math.nan, "left out", "", None, fastest)
                continue
            table.row(
                contestant, seconds, f"{grouped(model.begun)} begun, {grouped(model.ended)} ended",
                bytes_text(manager.memory()), model.managers_agree(), fastest,
            )  # fmt: skip
