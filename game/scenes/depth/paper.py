"""The paper on penetration depth with rotation by the object norm (P32)."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from game.lab.studies.narrowphase.rotation import overlapping_pairs
from game.lab.timing import least_time
from game.physics.narrowphase.depth import ShapePair, preset
from game.scenes.depth.figure import (
    descent,
    draw_bound,
    draw_differences,
    draw_local,
    draw_norm,
    draw_two_ways,
)
from game.ui.widgets.paper import Comparison, Paper, Step

TOLERANCE = 1e-3  # m
ANGLES, STARTS = 721, 24  # of a whole turn, and beginnings of descents among them


def _combs() -> ShapePair:
    """Two combs askew, as in the scene's first level."""
    comb = preset("comb", 1.1)
    return ShapePair(comb, comb, (0.15, 0.3, math.radians(186.0)), (-0.1, -0.4, 0.0))


def _local_ends(pair: ShapePair) -> tuple[int, int]:
    """How many of STARTS descents over the angle end at the shortest motion of all, to a hundredth."""
    sigmas = pair.sigmas(np.linspace(-math.pi, math.pi, ANGLES))
    least = float(np.min(sigmas))
    begins = np.linspace(0, ANGLES - 1, STARTS).round().astype(int).tolist()
    return sum(float(sigmas[descent(sigmas, begin)]) < 1.01 * least for begin in begins), STARTS


def _measure() -> Iterator[Comparison]:
    pairs = overlapping_pairs()
    found = [pair.generalised(TOLERANCE) for pair in pairs]
    each = least_time(lambda: [pair.generalised(TOLERANCE) for pair in pairs], 1) / len(pairs)
    yield Comparison(
        "one query with rotation", "tens of ms, tens of thousands of triangles",
        f"{1e3 * each:.1f} ms, 1 to 6 parts in the plane",
    )  # fmt: skip
    ends = [_local_ends(pair) for pair in pairs]
    yield Comparison(
        f"shorter from neighbour to neighbour, from {STARTS} angles: ends at the shortest of all",
        "the shortest nearby",
        f"{sum(best for best, _ in ends)} of {sum(count for _, count in ends)}",
    )
    worst = max(one.sigma - one.certain for one in found)
    yield Comparison(
        "what is certain of the motion",
        "the shortest nearby",
        f"the shortest of all, to {1e3 * worst:.1f} mm",
    )
    slides = [pair.translational() for pair in pairs]
    alone = least_time(lambda: [pair.translational() for pair in pairs]) / len(pairs)
    yield Comparison("one query without rotation", "", f"{1e6 * alone:.0f} µs")
    saved = [100.0 * (1.0 - one.sigma / slide.sigma) for one, slide in zip(found, slides, strict=True)]
    yield Comparison(
        "shorter by rotation, ten pairs",
        "",
        f"{sum(saved) / len(saved):.0f} % on average, {max(saved):.0f} % at most",
    )
    combs = _combs()
    slide, turned = combs.translational(), combs.generalised(TOLERANCE)
    yield Comparison(
        "two combs askew", "", f"{slide.sigma:.3f} m without, {turned.sigma:.3f} m with rotation"
    )
    grid = combs.by_grid(31, 31)
    spent = least_time(lambda: combs.by_grid(31, 31), 1)
    yield Comparison(
        "the combs by brute force",
        "",
        f"{grid.sigma:.3f} m of {grid.evaluations} motions in {1e3 * spent:.0f} ms",
    )


OBJECT_NORM = Paper(
    problem=(
        "Two bodies overlap. How far apart must they be moved to be free of each other? With "
        "displacements alone the answer is often far too long: what is caught by a hair's breadth, and "
        "askew, seems to be stuck deep. With turns allowed, it must first be said how long a motion is "
        "that turns.",
    ),
    idea=(
        "Measure a motion by its object norm: the mean, over all points of the body, of the square of how "
        "far each goes. It depends on no origin and no units for angles, and has a closed form. The depth "
        "with rotation is then the shortest motion by this norm that parts the bodies.",
    ),
    steps=(
        Step(
            "About the centroid the displacement t and the turn part: the points' squares add to those of "
            "t, and of the turn times the radius of gyration k.",
            draw_norm,
            r"\sigma^2 = \abs{\v{t}}^2 + 4 k^2 \sin^2 (\theta / 2)",
        ),
        Step(
            "The authors begin with a motion that parts the bodies. They find what then touches, make "
            "contacts linear, and solve for the shortest motion within them. So they go on until nothing "
            "changes. Where that ends depends on where it begins (thick: for one angle, from two "
            "beginnings).",
            draw_local,
        ),
        Step(
            "In the plane there is but one angle, so we take all of them. For one angle the displacements "
            "that overlap are the Minkowski differences of the convex parts. The shortest one out of them "
            "leads to a foot on an edge or to a crossing of two.",
            draw_differences,
            r"B_j - A_i(\theta)",
        ),
        Step(
            "Over an interval of angles no point of A_i goes farther than ρ. The differences eroded by it "
            "are overlaps for every angle within. So they bound the depth from below, even where it jumps "
            "because A comes to fit into a gap.",
            draw_bound,
            r"\rho = 2 R_i \sin (w / 2)",
        ),
        Step(
            "Halve the intervals, leave out those whose bound is no shorter than what is found less the "
            "tolerance: what remains is the shortest motion of all.",
            draw_two_ways,
        ),
    ),
    showed=(
        "Rigid and articulated models of tens of thousands of triangles in space, a locally shortest "
        "motion in tens of milliseconds. It is used to plan motions, to animate with contacts, and to "
        "grasp.",
    ),
    measure=_measure,
    limits=(
        "Ours is the plane and shapes of a few convex parts; work grows with the pairs of parts and, for "
        "round ones, with their edges. A gap that fits at a single angle is found where edges come to be "
        "parallel. A shortest motion says where to go, not that the way there is free. In space an "
        "interval becomes a ball of rotations, and a search of all of them no longer answers in "
        "milliseconds.",
    ),
    after=(
        "The norm goes back to Kazerounian and Rastegar (1992). Zhang, Kim and Manocha (2007) first "
        "computed the depth with rotation by it. Later the contact space was sampled and learned "
        "beforehand, so that a query only looks up what is near.",
    ),
)
