"""Hierarchical grids in hash tables, beside testing every box against every other."""

from __future__ import annotations

from game.lab.studies.broadphase.count import METHOD_COLORS
from game.lab.studies.broadphase.workloads import hierarchy_study
from game.physics.broadphase import HierarchicalGrid, NaiveBroadPhase
from game.scenes.boxes import C06
from game.scenes.boxes.compared import ComparedScene
from game.scenes.boxes.figure import draw_levels
from game.scenes.boxes.model.hierarchical_grids import MOST_STACKED, HierarchicalGridModel
from game.scenes.boxes.numbers import grouped
from game.scenes.boxes.parameters import HierarchyParameters
from game.scenes.boxes.readouts import hierarchy_readouts
from game.scenes.boxes.stack_hand import StackHand
from game.scenes.boxes.view.hierarchical_grids import MOST_CELLS, HierarchicalGridView
from game.stage import Equation, Strip


class HierarchicalGridScene(ComparedScene):
    """Boxes of very unlike sizes: most are small, a few are many times larger. One uniform grid cannot serve
    both; here there is a grid for every size. A box stands on the level whose cells are just not smaller than
    itself, in the cell of its lower corner. No grid is stored: cells are found by hashing, a table for each
    level. So there is neither an edge nor a size to choose, and memory follows the boxes. The tilted stack
    shows the levels above each other, and beside each the chains of boxes in its buckets.

    Pairs on one level are found as in a uniform grid. Between two levels either the smaller boxes look up
    the few large cells around them, or the large boxes run over the small cells below. The naive method,
    every box against every other, does the same beside it and judges the answer.
    """

    name, task, title = C06.names
    study = hierarchy_study

    parameters_type = HierarchyParameters
    parameters: HierarchyParameters
    model_type = HierarchicalGridModel
    model: HierarchicalGridModel
    hand_type = StackHand
    view_type = HierarchicalGridView

    phases = (("hierarchical grids", HierarchicalGrid), ("naive pairs", NaiveBroadPhase))
    strips = (
        Strip("Pairs", "", ("pairs",)),
        Strip(
            "Update and all pairs",
            "s",
            ("hierarchical", "naive"),
            colors=(METHOD_COLORS["hierarchical"], METHOD_COLORS["naive"]),
        ),
        Strip("Box tests", "", ("box tests",)),
    )
    told = ComparedScene.told._replace(readouts=hierarchy_readouts)
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

    def why_idle(self, name: str) -> str:
        if name == "stack" and len(self.model.boxes) > MOST_STACKED:
            return f"Above {grouped(MOST_STACKED)} boxes the levels are not stacked."
        if name in ("cells", "lines") and self.model.stacked:
            return "The tilted stack has its own."
        if name == "cells" and len(self.model.boxes) > MOST_CELLS:
            return f"Above {grouped(MOST_CELLS)} boxes no cells are drawn."
        return super().why_idle(name)
