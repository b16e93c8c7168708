"""The paper on semi-adjusting BSP trees (P01): cuts that stay where they are until moving them pays."""

from __future__ import annotations

from collections.abc import Iterator

from game.physics.broadphase import BspTree
from game.scenes.boxes.papers.figures import draw_cuts, draw_gathered, draw_repairs
from game.scenes.boxes.papers.measuring import beside_others, differing_answers, some_boxes, steps_of
from game.ui.widgets.paper import Comparison, Paper, Step

STEPS = 20


def _work() -> Iterator[Comparison]:
    """What a tree of 2000 boxes has to do in a step."""
    for words, kind, way in (
        ("equal boxes, 2 % of a size a step", "equal", 0.02),
        ("five heaps, the same", "clustered", 0.02),
        ("all leap", "equal", 0.0),
    ):
        boxes, _ = some_boxes(kind, 2000, way)
        tree = BspTree()
        steps = steps_of(tree, boxes, way == 0.0, STEPS)
        next(steps)
        before = tree.work
        list(steps)
        share = 100.0 / (2000.0 * (STEPS - 1))
        anew, cut = (share * (b - a) for a, b in zip(before[::3], tree.work[::3], strict=True))
        yield Comparison(
            f"{words}: boxes put anew; in parts cut anew; tests for each box",
            "never the whole tree" if way == 0.0 else "",
            f"{anew:.3g} %; {cut:.3g} %; {tree.tests / 2000.0:.1f}",
        )


def _measure() -> Iterator[Comparison]:
    differ, answers = differing_answers(BspTree)
    yield Comparison("answers that differ from the naive test, all workloads", "", f"{differ} of {answers}")
    yield from _work()
    for words, kind, way in (
        ("equal boxes, 2 % of a size", "equal", 0.02),
        ("heavy-tailed sizes, 2 %", "power-law", 0.02),
        ("all leap", "equal", 0.0),
    ):
        for count in (1000, 10_000):
            yield Comparison(
                f"{words}, {count} boxes: CPU time of a step", "", beside_others("tree", kind, count, way)
            )


BSP = Paper(
    problem=(
        "Among thousands of things in motion, find those that may touch. A tree of cuts finds them fast, "
        "but things move and the tree ages: to build it anew in each step costs more than it saves, and not "
        "to do so makes it worse and worse.",
    ),
    idea=(
        "Keep the tree, and mend it only where mending pays. What stays between the cuts about it costs "
        "a comparison. A part that has become uneven is noted; it is cut anew when what it has cost exceeds "
        "what the cutting would.",
    ),
    steps=(
        Step(
            "Cut the plane along x or y, through the middle of the boxes, until few are left in each part. A "
            "box is listed in every leaf into which it reaches.",
            draw_cuts,
        ),
        Step(
            "Each side of a box knows between which cuts it lies. As long as it stays there nothing is to be "
            "done; a box that crosses a cut is taken out and put in anew.",
            draw_repairs,
            r"c_- \le x < c_+",
        ),
        Step("Leaves that have become too full are split, nearly empty ones that lie side by side merged."),
        Step(
            "A node whose larger side holds more than its share owes, in each step, what is too much. When "
            "its debt exceeds the cost of cutting it anew, that is done.",
            draw_gathered,
            r"D \gets D + \max(0, n_+ - 0.65 n), \quad D > 2 n \log_2 n",
        ),
        Step(
            "Pairs are looked for in each leaf. One that shares several leaves is told only in the one that "
            "holds the lower corner of its overlap."
        ),
    ),
    showed=(
        "In scenes with thousands of moving things the tree need not be built anew as a whole even where "
        "much moves, and keeps its balance and its height. The authors describe several ways to choose "
        "cuts and leave the measure of what pays to the user; the constants here are ours.",
    ),
    measure=_measure,
    limits=(
        "It wins where sizes and densities are unlike, and comes near the best on a line of ten thousand "
        "boxes. Equal boxes in an even crowd are a grid's: the tree takes several times as long. Where all "
        "leap it has to put every box anew, and falls back the farthest.",
    ),
    after=(
        "Trees of boxes that are refitted and rotated (Kopta and others 2012) serve the same end and are "
        "what most engines use. P03, the kinetic sweep in this race, asks beforehand when a bound will be "
        "used up.",
    ),
)
