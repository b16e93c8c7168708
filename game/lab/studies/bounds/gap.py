"""What it costs to prove with bounding volumes that two curves are apart.

Upright boxes stay half as broad when they are half as long, boxes on a curve a quarter as broad. So the tests
grow with 1/g for the former and with 1/sqrt(g) for the latter. Twice the tests prove half the gap, or a
quarter of it.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from game.arrays import Floats
from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.lab.trials import computation
from game.physics.bounds import BoundingTree, Query, build_tree
from game.physics.kernels import elementary, elementwise

GAPS = tuple(np.geomspace(0.02, 2e-4, 12).tolist())
SEGMENTS = 1024  # of each arc
ARC_DEGREES = tuple(60.0 * elementary.pow(2.0, 0.25 * i) for i in range(4))
TREES: dict[str, tuple[str, str]] = {
    "aabb": ("aabb", "search"),
    "obb": ("obb", "search"),
    "obb-exact": ("obb", "exact"),
    "capsule": ("capsule", "search"),
}


def arc(radius: float, degrees: float) -> Floats:
    """A part of a circle about the origin, m."""
    angle = np.radians(17.0 + degrees * np.arange(SEGMENTS + 1) / SEGMENTS)
    return radius * np.column_stack((elementwise.cos(angle), elementwise.sin(angle)))


@lru_cache(maxsize=32)
def inner_tree(kind: str, fit: str, degrees: float) -> BoundingTree:
    """The tree over the inner arc."""
    return build_tree(arc(1.0, degrees), kind, 1, fit=fit)


def gap_trial(setting: Setting) -> Trial:
    """Two arcs about one centre, a gap apart: queries prove that they do not meet, for arcs of four lengths.

    Halving makes volumes of few lengths only; over an octave of lengths its steps even out.
    """
    kind, fit = TREES[setting.method]
    queries = [
        Query(inner_tree(kind, fit, degrees), build_tree(arc(1.0 + setting.knob, degrees), kind, 1, fit=fit))
        for degrees in ARC_DEGREES
    ]

    def work() -> None:
        for query in queries:
            query.run((0.0, 0.0))

    def judge(_: None) -> Outcome:
        met = sum(query.leaves_met for query in queries)
        tests = sum(query.volume_tests + query.segment_tests for query in queries)
        return Outcome(setting.knob, tests, "leaves overlap: not by volumes alone" if met else "")

    return computation(float(len(ARC_DEGREES)), work, judge)


def gap_settings() -> list[Setting]:
    """Every gap with every tree."""
    return [
        Setting(name, gap, {}, {"volume": TREES[name][0], "fit": TREES[name][1]}, 1.0 / gap)
        for gap in GAPS
        for name in TREES
    ]


gap_study = Study(
    name="bounds-gap",
    title="Bounding volumes: tests to prove a gap",
    error="gap between two arcs that is proven",
    error_unit="m",
    counter="tests of volumes and segments",
    knob=Knob("gap", "gap", "m"),
    methods=(
        Method("aabb", "axis-aligned boxes", 1.0),
        Method("obb", "boxes, by degrees", None, "loses its order where a box is thinner than its own error"),
        Method("obb-exact", "boxes, exact", 2.0),
        Method("capsule", "capsules", None, "by degrees, too"),
    ),
    settings=gap_settings,
    trial=gap_trial,
    reference="arcs of 1024 segments about one centre, 1 m off, 60 to 101 degrees long.",
    expectation=(
        "Twice the tests prove half the gap with axis-aligned boxes, a quarter of it with exact ones. "
        "Boxes by degrees lose that where they are thinner than half a degree of their length."
    ),
    order_over="counter",
    workload=Workload("two arcs about one centre"),
    no_place="No mark: measured on two arcs about one centre; your scene has outlines of its own.",
    cost="CPU time for one query",
    short="Gap",
)
