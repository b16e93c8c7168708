"""Incremental sweep and prune on two axes, beside testing every box against every other."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from game.lab.studies.broadphase.speed import sweep_study
from game.physics.broadphase import NaiveBroadPhase, SweepAndPrune
from game.physics.broadphase.effects import MOTION
from game.physics.broadphase.workloads import expected_swaps
from game.scenes.boxes import C07, view
from game.scenes.boxes.compared import MOST_IN_MATRIX, ComparedScene, manager_for
from game.scenes.boxes.figure import draw_swap
from game.scenes.boxes.level import HEIGHT, WIDTH
from game.scenes.boxes.look import draw_names, named
from game.scenes.boxes.swap_story import (
    MOST_KEPT,
    draw_ends,
    draw_look,
    look_into,
    tell_look,
    tell_story,
    tell_swaps,
)
from game.stage import Equation, Frame, Param, Readout, Strip, Toggle

MOST_TICKS = 1_500  # boxes whose end points are drawn
NEAR, FAR, TICK = 0.06, 0.30, 0.15  # m, where the axes lie beside the world


class SweepAndPruneScene(ComparedScene):
    """The end points of all boxes are kept sorted on both axes. From one step to the next boxes move a
    little, so a few swaps of neighbours put them in order again; and only where a lower and an upper end
    swap can a pair begin or end. So the cost of a step follows the motion in it: boxes at rest cost one look
    at each end. In motion the swaps grow with the speed, and with the square of the number of boxes, since
    twice as many ends pass twice as many others. How many boxes overlap does not matter.

    At the edges of the world the sorted end points are shown, lower and upper ones, and marked where they
    changed places. The number of swaps is held against its mean for boxes that move in random directions.
    When all boxes leap, the swaps grow with the square of their number: then it is cheaper to sort anew and
    sweep once, which is done unless it is switched off. The naive way does the same beside it.
    """

    name, task, title = C07.names
    study = sweep_study

    resort = Toggle(
        True,
        group="Pairs",
        label="Sort anew when cheaper",
        help="a step with too many swaps is finished by sorting; if off, only one of above 4 million swaps",
    )
    count = Param(
        200, 1, 100_000, whole=True, log=True, group="Boxes", label="Number",
        help="boxes are added or removed while the others go on; their density stays",
    )  # fmt: skip
    speed = Param(
        0.25, 0.01, 100.0, log=True, unit="m/s", group="Boxes", help="of every box, in any direction"
    )
    axes = Toggle(
        True, group="Shown", label="Sorted axes", help="end points beside the world; amber: swapped"
    )

    parts = (("sweep and prune", SweepAndPrune), ("naive pairs", NaiveBroadPhase))
    strips = (
        Strip("Swaps in a step", "", ("swaps", "mean"), exact=("mean",)),
        Strip("Update and all pairs", "s", ("sweep", "naive")),
        Strip("Pairs", "", ("pairs",)),
    )
    figure = staticmethod(draw_swap)
    equations = (
        Equation("Motion", r"x' = x + v \Delta t, \quad v' = -v", "explicit Euler; beyond the boundary"),
        Equation("Order", r"(x, \text{lower}) < (x, \text{upper})", "closed boxes: touching overlaps"),
        Equation("Swaps", r"s = \sum_{i<j} \text{[} x_i > x_j \text{]}", "inversions of the order before"),
        Equation(
            "Their mean",
            r"2 n^2 \frac{8}{\pi^2} v \Delta t \left(\frac{1}{W} + \frac{1}{H}\right)",
            "n boxes at speed v in all directions, W × H",
        ),
        Equation("A leap of all", r"2 n (n - 1)", "swaps, mean"),
    )
    try_this = (
        "Draw the speed up: swaps grow with it, as the dashed mean says.",
        "Let a hundredth of the boxes leap: they alone cost more than all the others.",
        "Let all leap, and switch sorting anew off: swaps and time show what was spared.",
        "Put all boxes on one line: on the other axis every hair's breadth is a swap.",
    )

    # -- structures ---------------------------------------------------------------------------------

    def make_structures(self) -> None:
        self.sap = SweepAndPrune(manager_for(len(self.alive), self.manager), self.resort)
        self.swaps = 0  # in the last step
        self.swapped: tuple[NDArray[np.bool_], ...] = ()
        self.story: list[str] = []  # the last swaps in words, where boxes have letters
        self.fresh = 0  # of these, those of the last step
        self.make_naive()

    def structures(self) -> tuple[SweepAndPrune]:
        return (self.sap,)

    def shaping(self) -> tuple[str, ...]:
        return ("manager", "resort")

    def why_idle(self, name: str) -> str:
        if name == "axes" and len(self.ids) > MOST_TICKS:
            return f"Above {view.grouped(MOST_TICKS)} boxes the axes are not drawn."
        return super().why_idle(name)

    def add(self, lowers: Any, uppers: Any, velocities: Any) -> Any:
        rows = len(self.ids) + len(lowers)
        if self.sap.manager.greatest < rows - 1:
            if rows > MOST_IN_MATRIX:
                self.told.append(f"Above {MOST_IN_MATRIX} boxes the pairs are kept in a hash table.")
            self.sap.use_manager(manager_for(rows, self.manager))
        return super().add(lowers, uppers, velocities)

    def pair_up(self) -> None:
        shown = named(self) or (self.axes and len(self.ids) <= MOST_TICKS)
        pairs_before = self.pairs
        orders = [self.sap.end_points(axis)[1:] for axis in range(2)] if shown else []
        before = self.sap.swaps
        with self.watch.time("sweep"):
            self.update(self.sap)
            self.pairs = self.sap.pairs()
        events = self.sap.manager.take_events()
        self.begun, self.ended = len(events.begun), len(events.ended)
        self.swaps = self.sap.swaps - before
        self.swapped = tuple(
            (who != now) | (upper != upper_now)
            for (who, upper), (_, now, upper_now) in zip(
                orders, (self.sap.end_points(axis) for axis in range(len(orders))), strict=True
            )
        )
        if named(self):
            told = tell_swaps(self, orders, pairs_before)
            self.fresh = len(told)
            self.story = (self.story + told)[-MOST_KEPT:]
        self.compare()

    def mean_swaps(self) -> float:
        """Swaps to be expected in a step of isotropic motion at the boxes' mean speed."""
        if MOTION not in self.active or not len(self.ids):
            return 0.0
        speed = float(np.sqrt((self.velocities[self.ids] ** 2).sum(axis=1)).mean())
        return expected_swaps(len(self.ids), speed * self.step_length, (WIDTH, HEIGHT))

    # -- what is shown ------------------------------------------------------------------------------

    def frame(self) -> Frame:
        return Frame(-4.5, -0.8 if named(self) else -0.42, WIDTH + 0.1, HEIGHT + 0.1)

    def readouts(self) -> tuple[Readout, ...]:
        return (
            Readout("boxes", len(self.ids)),
            Readout("pairs", len(self.pairs)),
            Readout("swaps", self.swaps),
            Readout("mean", self.mean_swaps()),
            Readout("begun", self.begun),
            Readout("ended", self.ended),
            Readout("sweep", self.watch.median("sweep"), "s"),
            Readout("naive", self.watch.median("naive"), "s"),
            Readout("sorted anew", self.sap.resorts),
            Readout("answers differ", 0 if self.same else 1),
        )

    def legend(self) -> tuple[tuple[str, str, str], ...]:
        rows = self.legend_rows()
        if self.axes and len(self.ids) <= MOST_TICKS:
            moved = sum(int(mask.sum()) for mask in self.swapped)
            known = moved > 0 or self.swaps == 0  # a step that was gone back to has its number, not its marks
            rows += [
                ("line:chalk", "lower ends", ""),
                ("line:pink", "upper ends", ""),
                ("line:amber", "changed places", view.grouped(moved) if known else "–"),
            ]
        return tuple(rows)

    def draw(self, canvas: Any, alpha: float) -> None:
        view.draw_ground(canvas)
        view.draw_boxes(self, canvas, alpha)
        draw_names(self, canvas, alpha)
        seen = look_into(self, self.looked) if self.looked >= 0 else None
        if seen is not None:
            draw_look(self, canvas, alpha, seen)
        if self.axes and len(self.ids) <= MOST_TICKS:
            for axis in range(2):
                self._draw_axis(canvas, axis)
        column = view.Column(canvas, self, 4.6, -0.95 if named(self) else -0.75)
        if not named(self) or column.room_px > view.TALL:
            self.draw_comparison(column, "sweep", "Sweep and prune", "chalk")
            column.space(6)
        mean = self.mean_swaps()
        column.head("Swaps in this step", "both axes")
        top = max(self.swaps, mean, 1.0)
        column.bar("Made", view.grouped(self.swaps), self.swaps / top, "amber")
        column.bar("Mean for this speed", view.grouped(mean), mean / top, "text1", hollow=True)
        if not named(self):
            column.row("Sorted anew so far", view.grouped(self.sap.resorts))
            column.row("Pairs begun, ended", f"{view.grouped(self.begun)}, {view.grouped(self.ended)}")
        column.space(6)
        if seen is not None:
            tell_look(self, column, seen)
            column.space(6)
        if named(self):
            tell_story(column, self.story, self.fresh)

    def _draw_axis(self, canvas: Any, axis: int) -> None:
        """End points as ticks: lower ones towards the world, upper ones beyond; longer where they swapped."""
        values, who, upper = self.sap.end_points(axis)
        if named(self):
            draw_ends(canvas, axis, values, who, upper)
        swapped = (
            self.swapped[axis]
            if axis < len(self.swapped) and len(self.swapped[axis]) == len(values)
            else upper & False
        )
        limit = (WIDTH, HEIGHT)[axis]
        middle = -0.5 * (NEAR + FAR) - 0.04
        line = np.array([[0.0, middle], [limit, middle]])
        inks = np.where(upper, canvas.ink("pink"), canvas.ink("chalk"))
        inks = np.where(swapped, canvas.ink("amber"), inks).astype(np.uint32)
        ends = np.where(upper, middle - TICK, middle + TICK)
        inside = (values >= 0.0) & (values <= limit)
        tails = np.stack([values, np.full(len(values), middle)], axis=1)[inside]
        heads = np.stack([values, ends], axis=1)[inside]
        if axis == 1:
            line, tails, heads = line[:, ::-1], tails[:, ::-1], heads[:, ::-1]
        canvas.segments(tails, heads, inks[inside], 1.0, alpha=0.8)
        canvas.line(line[0], line[1], "line2", 1.0)
