"""The paper on semi-adjusting BSP trees (P01): cuts that stay where they are until moving them pays."""

from __future__ import annotations

import math
from collections.abc import Iterator
from time import thread_time

from game.physics.broadphase import BspTree
from game.physics.broadphase.bsp.tree import PRICE
from game.scenes.boxes.papers.figures import draw_cuts, draw_gathered, draw_leaves, draw_once, draw_repairs
from game.scenes.boxes.papers.measuring import (
    beside_others,
    differing_answers,
    in_words,
    mean_milliseconds,
    some_boxes,
    steps_of,
    travelling,
)
from game.ui.widgets.paper import Comparison, Paper, Step

STEPS, COUNT = 20, 2000
JOURNEY, WAYS = 160, (0.1, 0.5)  # steps that heaps travel, and sizes in each
MENDED = {"mended where it pays": PRICE, "mended at once": 0.0, "never cut anew": math.inf}


def _shares(tree: BspTree, count: int, steps: int) -> str:
    """What the tree has done since it was made, a step and box, and its tests."""
    work, share = tree.work, 100.0 / (count * steps)
    return f"{share * work.repairs:.3g} %; {share * work.moved:.3g} %; {tree.tests / count:.1f}"


def _work() -> Iterator[Comparison]:
    """What a tree of COUNT boxes has to do in a step."""
    for words, kind, way in (
        ("equal boxes, 2 % of a size a step", "equal", 0.02),
        ("all leap", "equal", 0.0),
    ):
        boxes, _ = some_boxes(kind, COUNT, way)
        tree = BspTree()
        list(steps_of(tree, boxes, way == 0.0, STEPS))
        yield Comparison(
            f"{words}: boxes put anew; in parts cut anew; tests for each box",
            "never the whole tree" if way == 0.0 else "",
            _shares(tree, COUNT, STEPS),
        )


def journey(tree: BspTree, way: float, anew: bool = False) -> Iterator[float]:
    """CPU time (s) of each step of heaps that go so many sizes; ``anew``: with a whole new tree in each."""
    at = travelling(COUNT, way)
    ids = tree.add_boxes(*at(0))
    tree.pairs()
    for step in range(1, JOURNEY + 1):
        low, high = at(step)
        begin = thread_time()
        if anew:
            tree = BspTree()
            tree.add_boxes(low, high)
        else:
            tree.update_boxes(ids, low, high)
        tree.pairs()
        yield thread_time() - begin


def _mending() -> Iterator[Comparison]:
    """The idea at work: heaps that travel, and a tree that is mended, by several prices, or made anew."""
    for way in WAYS:
        times = {}
        for words, price in MENDED.items():
            tree = BspTree(price)
            times[words] = mean_milliseconds(journey(tree, way), 0)
            if price == PRICE:
                done = _shares(tree, COUNT, JOURNEY)
        times["a new tree"] = mean_milliseconds(journey(BspTree(), way, True), 0)
        yield Comparison(
            f"{COUNT} boxes in heaps that go {way:g} sizes a step: boxes put anew; in parts cut anew; tests",
            "most of the tree stays",
            done,
        )
        mended = next(iter(MENDED))
        yield Comparison("the same: CPU time of a step", "mended where it pays", in_words(times, mended))
        yield Comparison(
            "a new tree takes so many times as long", "more than it saves",
            f"{times['a new tree'] / times[mended]:.2g}",
        )  # fmt: skip


def _measure() -> Iterator[Comparison]:
    differ, answers = differing_answers(BspTree)
    yield Comparison("answers that differ from the naive test, all workloads", "", f"{differ} of {answers}")
    yield from _work()
    yield from _mending()
    for words, kind, count, way in (
        ("equal boxes, 2 % of a size", "equal", 1000, 0.02),
        ("equal boxes, 2 % of a size", "equal", 10_000, 0.02),
        ("equal boxes, 2 % of a size", "equal", 100_000, 0.02),
        ("heavy-tailed sizes, 2 %", "power-law", 10_000, 0.02),
        ("all leap", "equal", 10_000, 0.0),
        ("all leap", "equal", 100_000, 0.0),
    ):
        yield Comparison(
            f"{words}, {count} boxes: CPU time of a step", "",
            in_words(beside_others("tree", kind, count, way), "tree"),
        )  # fmt: skip


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
        Step(
            "Leaves that have become too full are split, nearly empty ones that lie side by side merged.",
            draw_leaves,
        ),
        Step(
            "A node whose larger side holds more than its share owes, in each step, what is too much. When "
            "its debt exceeds the cost of cutting it anew, that is done.",
            draw_gathered,
            r"D \gets D + \max(0, n_+ - 0.65 n), \quad D > 2 n \log_2 n",
        ),
        Step(
            "Pairs are looked for in each leaf. One that shares several leaves is told only in the one that "
            "holds the lower corner of its overlap.",
            draw_once,
        ),
    ),
    showed=(
        "In scenes with thousands of moving things the tree need not be built anew as a whole, even where "
        "much moves. It keeps its balance and its height. The authors describe several ways to choose cuts "
        "and leave the measure of what pays to the user; the constants here are ours.",
    ),
    measure=_measure,
    limits=(
        "A box that crosses a cut is put in from the root, and all pairs are found anew in each step: the "
        "tree saves the building, not the search. How it stands beside methods that build anew "
        "what is cheap to build, each line tells with its figures.",
    ),
    after=(
        "Trees of boxes that are refitted and rotated (Kopta and others 2012) serve the same end and are "
        "what most engines use. P03, the kinetic sweep in this race, asks beforehand when a bound will be "
        "used up.",
    ),
)
