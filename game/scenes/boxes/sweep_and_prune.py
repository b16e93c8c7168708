"""Incremental sweep and prune on two axes, beside testing every box against every other."""

from __future__ import annotations

from game.lab.studies.broadphase.count import METHOD_COLORS
from game.lab.studies.broadphase.speed import sweep_study
from game.physics.broadphase import NaiveBroadPhase, SweepAndPrune
from game.scenes.boxes import C07
from game.scenes.boxes.compared import ComparedScene
from game.scenes.boxes.figure import draw_swap
from game.scenes.boxes.model.sweep_and_prune import MOST_TICKS, SweepAndPruneModel
from game.scenes.boxes.numbers import grouped
from game.scenes.boxes.parameters import SweepParameters
from game.scenes.boxes.readouts import sweep_readouts
from game.scenes.boxes.view.sweep_and_prune import SweepAndPruneView
from game.stage import Equation, Strip


class SweepAndPruneScene(ComparedScene):
    """The end points of all boxes are kept sorted on both axes. From one step to the next boxes move a
    little, so a few swaps of neighbours put them in order again. Only where a lower and an upper end swap can
    a pair begin or end. So the cost of a step follows the motion in it: boxes at rest cost one look at each
    end. In motion the swaps grow with the speed, and with the square of the number of boxes. Twice as many
    ends pass twice as many others. How many boxes overlap does not matter.

    At the edges of the world the sorted end points are shown, lower and upper ones, and marked where they
    changed places. The number of swaps is held against its mean for boxes that move in random directions.
    When all boxes leap, the swaps grow with the square of their number: then it is cheaper to sort again and
    sweep once, which is done unless it is switched off. The naive method does the same beside it.
    """

    name, task, title = C07.names
    study = sweep_study

    parameters_type = SweepParameters
    parameters: SweepParameters
    model_type = SweepAndPruneModel
    model: SweepAndPruneModel
    view_type = SweepAndPruneView

    phases = (("sweep and prune", SweepAndPrune), ("naive pairs", NaiveBroadPhase))
    strips = (
        Strip("Swaps in a step", "", ("swaps", "mean"), exact=("mean",)),
        Strip(
            "Update and all pairs",
            "s",
            ("sweep", "naive"),
            colors=(METHOD_COLORS["sweep"], METHOD_COLORS["naive"]),
        ),
        Strip("Pairs", "", ("pairs",)),
    )
    told = ComparedScene.told._replace(readouts=sweep_readouts)
    figure = staticmethod(draw_swap)
    equations = (
        Equation("Motion", r"x' = x + v \Delta t, \quad v' = -v", "explicit Euler; beyond the boundary"),
        Equation("Order", r"(x, \text{lower}) < (x, \text{upper})", "closed boxes: contact is overlap"),
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
        "Let all leap, and switch sorting again off: swaps and time show what was spared.",
        "Put all boxes on one line: on the other axis every hair's breadth is a swap.",
    )

    def why_idle(self, name: str) -> str:
        if name == "axes" and len(self.model.boxes) > MOST_TICKS:
            return f"Above {grouped(MOST_TICKS)} boxes the axes are not drawn."
        return super().why_idle(name)
