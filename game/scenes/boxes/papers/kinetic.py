"""The paper on velocity-aligned polytopes (P03): bounds that lie along the motion, and a sweep by events."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from game.physics.broadphase import KineticSweep, NaiveBroadPhase
from game.physics.broadphase.kinetic.kinetic_sweep import SLABS
from game.scenes.boxes.papers.figures import (
    draw_aligned_bounds,
    draw_candidates,
    draw_plain_bounds,
    draw_queue,
    draw_renewed,
)
from game.scenes.boxes.papers.measuring import (
    beside_others,
    differing_answers,
    in_words,
    some_boxes,
    steps_of,
)
from game.ui.widgets.paper import Comparison, Paper, Step

COUNT, STEPS, INSTANTS = 300, 12, 64
WAYS = (0.002, 0.005, 0.01, 0.05)  # sizes in a step


def _keys(pairs: np.ndarray) -> set[tuple[int, int]]:
    return {(a, b) for a, b in pairs.tolist()}


def _met_between() -> Comparison:
    """Pairs that meet between two steps: how many a test at the end sees, and how many are candidates."""
    boxes, _ = some_boxes("equal", COUNT, 2.0)
    sweep, naive = KineticSweep(16), NaiveBroadPhase()
    list(steps_of(sweep, boxes, False, STEPS))
    ids = naive.add_boxes(boxes.lowers, boxes.uppers)
    met: set[tuple[int, int]] = set()
    for instant in np.linspace(STEPS, STEPS + 1, INSTANTS + 1).tolist():
        shift = instant * boxes.velocities
        naive.update_boxes(ids, boxes.lowers + shift, boxes.uppers + shift)
        met |= _keys(naive.pairs())
    seen = len(met & _keys(naive.pairs()))
    foreseen = len(met & _keys(sweep.candidate_pairs()))
    return Comparison(
        f"two sizes a step: of {len(met)} pairs that meet within one, seen at its end; candidates before it",
        "all are found",
        f"{seen}; {foreseen}",
    )


def _false_pairs() -> Iterator[Comparison]:
    """False pairs and events, by the number of sides, for slow and fast boxes."""
    for words, way, steps in (("2 % of a size", 0.02, 60), ("three sizes", 3.0, 12)):
        boxes, _ = some_boxes("equal", 1000, way)
        false, events = [], []
        for slabs in SLABS:
            sweep = KineticSweep(slabs)
            each = [(sweep.false_pairs, sweep.events) for _ in steps_of(sweep, boxes, False, steps)]
            means = np.mean(each[steps // 2 :], axis=0) / 1000.0
            false.append(f"{means[0]:.2f}")
            events.append(f"{means[1]:.2g}")
        yield Comparison(
            f"{words} a step, {', '.join(map(str, SLABS))} sides: false pairs for each box (events)",
            "",
            f"{', '.join(false)} ({', '.join(events)})",
        )


def _longest_ways() -> Iterator[Comparison]:
    """Fast boxes on long thin ways: what the slab across the motion leaves of the candidates."""
    for way in (4.0, 16.0):
        boxes, _ = some_boxes("equal", COUNT, way)
        counts = {}
        for slabs in SLABS:
            sweep = KineticSweep(slabs)
            counts[slabs] = [sweep.candidates for _ in steps_of(sweep, boxes, False, STEPS)][-1]
        plain = counts[min(SLABS)]
        kept = ", ".join(f"{count}" for count in counts.values())
        yield Comparison(
            f"{way:g} sizes a step: candidates of {', '.join(map(str, SLABS))} sides",
            "slabs along the motion prune",
            f"{kept}: {100.0 * (1.0 - min(counts.values()) / plain):.0f} % fewer",
        )


def _slow_and_fast() -> Iterator[Comparison]:
    """How far boxes may go in a step for the kinetic sweep to take the least time of all."""
    first = []
    for way in WAYS:
        times = beside_others("kinetic", "equal", 10_000, way)
        if min(times, key=lambda name: times[name]) == "kinetic":
            first.append(way)
        yield Comparison(
            f"equal boxes, {100.0 * way:g} % of a size, 10000 boxes: CPU time of a step",
            "",
            in_words(times, "kinetic"),
        )
    yield Comparison(
        "of these ways, kinetic takes the least time at",
        "",
        ", ".join(f"{100.0 * way:g} %" for way in first) or "none",
    )


def _measure() -> Iterator[Comparison]:
    differ, answers = differing_answers(KineticSweep)
    yield Comparison("answers that differ from the naive test, all workloads", "", f"{differ} of {answers}")
    yield _met_between()
    yield from _false_pairs()
    yield from _longest_ways()
    yield from _slow_and_fast()
    for words, kind, count, way in (
        ("equal boxes, 0.2 % of a size", "equal", 100_000, 0.002),
        ("heavy-tailed sizes, 0.2 %", "power-law", 100_000, 0.002),
        ("all leap", "equal", 10_000, 0.0),
    ):
        yield Comparison(
            f"{words}, {count} boxes: CPU time of a step", "",
            in_words(beside_others("kinetic", kind, count, way), "kinetic"),
        )  # fmt: skip


KINETIC = Paper(
    problem=(
        "A test at the end of each step misses what meets and parts within it, and fast things do that. "
        "One must look at what they cover on their path. But a box about a long slanting path is mostly "
        "empty, and gives many pairs that never meet.",
    ),
    idea=(
        "Bound the way with slabs, of which one lies across the motion: it is as thin as the thing itself. "
        "Its direction is one of a few fixed ones, so that bounds remain easy to compare. And keep the order "
        "of the sweep: until a known moment nothing in it changes.",
    ),
    steps=(
        Step(
            "From where a box is and was, foresee where it will be: sides on straight ways, give or take a "
            "pad. What it covers lies between its first and its last place.",
            draw_plain_bounds,
            r"x_j(t) = x_j + (t - t_0) v_j \pm p",
        ),
        Step(
            "Of k / 2 directions take the one most nearly across the motion, and bound by its slab too.",
            draw_aligned_bounds,
            r"d = \arg \min_i \abs{\v{d}_i \cdot \v{v}}",
        ),
        Step(
            "A bound holds until motion has lengthened it by a size. When that will be stands in a queue of "
            "events; in the steps between, the box costs a comparison of its sides.",
            draw_queue,
            r"T = s / \max_j \abs{v_j}",
        ),
        Step(
            "What is used up, and what did not go on as foreseen, is bounded anew. It is taken out of the "
            "sorted order, merged in again and swept against its neighbours. The others stay as they are.",
            draw_renewed,
        ),
        Step(
            "Pairs of bounds that no slab parts are candidates until one of the two ends. In each step only "
            "candidates are tested, on the boxes themselves.",
            draw_candidates,
        ),
    ),
    showed=(
        "Collisions that a test at the end of frames misses are found, at interactive rates and without "
        "much loss of speed (2004). Later came a kinetic sweep of bounds in continuous motion (2006). With "
        "polytopes whose directions are chosen from coverings of the sphere the pruning saves more than it "
        "costs (2008).",
    ),
    measure=_measure,
    limits=(
        "Here a bound is kept over many steps, and pairs are those at the end of a step, as for all "
        "methods of the race. The farther boxes go in a step, the sooner bounds end; where all leap they end "
        "as soon as they begin. In the plane two axes and the one slab already bound a swept box tightly; in "
        "space more directions are needed, and gain more.",
    ),
    after=(
        "Fat boxes in trees, moved ahead of the motion, are the same thought in today's engines (Catto's "
        "Box2D); speculative margins use it for contacts.",
    ),
)
