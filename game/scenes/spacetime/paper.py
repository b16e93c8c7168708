"""The paper on collision detection that can be interrupted (P02)."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from game.lab.studies.spacetime import PosePairs, answers, pose_pairs, relative_errors
from game.lab.timing import least_time
from game.physics.effects import EffectSet
from game.physics.spacetime.effects import SPACE_TIME, TIMED
from game.physics.spacetime.motion import Grip
from game.physics.spacetime.world import TimedWorld
from game.scenes.spacetime.figure import draw_bounds, draw_horns, draw_levels
from game.scenes.spacetime.level import DEFAULT
from game.scenes.spacetime.model import SpaceTimeModel
from game.scenes.spacetime.parameters import SpaceTimeParameters
from game.ui.canvas.pen import Pen
from game.ui.widgets.paper import Comparison, Paper, Step

BUDGETS_US = (1, 2, 5, 10, 20, 50, 100, 1000)
TESTS = tuple(round(2.0 ** (0.5 * k)) for k in range(25))  # 1 to 4096
SEED = 101  # not the study's poses, by which the estimate was chosen
STEPS, DT = 240, 1.0 / 240.0
HANDLESS = Grip(-1, 0.0, 0.0, 1.0)


def _cost_us(pairs: PosePairs, tests: int) -> float:
    """Mean CPU time (us) of a query with so many tests: the least of some runs."""
    return 1e6 * least_time(lambda: answers(pairs, tests)) / len(pairs.poses)


def _costs(pairs: PosePairs) -> list[tuple[int, float]]:
    """Budgets of tests, and what the dearest query of each may cost: tests times the time of one."""
    dearest = answers(pairs, TESTS[-1])
    each = _cost_us(pairs, TESTS[-1]) / max(float(np.mean(dearest[:, 3])), 1.0)
    return [(tests, tests * each) for tests in TESTS]


def _percent(value: float) -> str:
    """In words: what is rounding is 0."""
    return (
        "0 %"
        if value < 1e-6
        else "below 0.01 %"
        if value < 0.01
        else f"{value:.{2 if value < 10.0 else 0}f} %"
    )


def _errors(kinds: tuple[tuple[str, str], ...]) -> Iterator[Comparison]:
    """Error against the exact distance at budgets of time."""
    all_pairs = [(pairs, _costs(pairs)) for pairs in (pose_pairs(*kind, seed=SEED) for kind in kinds)]
    for budget in BUDGETS_US:
        errors = []
        for pairs, costs in all_pairs:
            tests = max((tests for tests, cost in costs if cost <= budget), default=0)
            errors.append(relative_errors(pairs, answers(pairs, tests)))
        found = 100.0 * np.concatenate(errors)
        shown = (np.mean(found), np.percentile(found, 95), np.max(found))
        yield Comparison(
            f"error of the distance at {budget} µs: mean, 19 in 20 within, worst", "",
            ", ".join(_percent(float(one)) for one in shown),
        )  # fmt: skip


def _world() -> TimedWorld:
    return SpaceTimeModel(DEFAULT, SpaceTimeParameters(), TIMED.known, 3).world


def _work(effects: EffectSet) -> tuple[float, float]:
    """Pairs due and tests a step of a dozen bodies over one second."""
    world, due, tests = _world(), 0, 0
    for _ in range(STEPS):
        world.step(DT, 4000, HANDLESS, effects)
        due, tests = due + world.due, tests + world.tests
    return due / STEPS, tests / STEPS


def _draw_queue(pen: Pen) -> None:
    """The soonest pairs of the queue after half a second, each with the time until which it needs no test."""
    world = _world()
    for _ in range(STEPS // 2):
        world.step(DT, 4000, HANDLESS, TIMED.known)
    queue = world.queue()
    soonest = queue[:12]
    most = max(soonest[-1][0], DT)
    for row, (ahead, i, j) in enumerate(soonest):
        y, due = 30.0 + 12.0 * row, ahead <= DT
        long = 190.0 * max(ahead, 0.0) / most
        pen.words(f"{i}, {j}", 62.0, y, "text2", "right", size=11)
        pen.line(((70.0, y), (72.0 + long, y)), "vermilion" if due else "chalk", 5.0)
    pen.words(f"{world.due} of {len(queue)} pairs are due in this step", 148.0, 12.0, "text2", size=11)
    pen.line(((70.0, 174.0), (262.0, 174.0)), "line2", 1.0)
    pen.words("now", 70.0, 188.0, "text2")
    pen.words(f"{1e3 * most:.0f} ms on", 262.0, 188.0, "text2", "right")


def _draw_budget(pen: Pen) -> None:
    """Two combs asked with few tests and with many: what their bounds leave open."""
    pairs = pose_pairs("comb", "comb", SEED)
    exact, line = {}, []
    for tests in TESTS:
        found = answers(pairs, tests)
        line.append((tests, float(np.mean(np.abs(relative_errors(pairs, found))))))
        exact[tests] = float(np.mean(found[:, 1] - found[:, 0]))
    pen.line(((44.0, 18.0), (44.0, 168.0), (280.0, 168.0)), "text3", 1.0)

    def place(tests: float, value: float, most: float) -> tuple[float, float]:
        return 44.0 + 62.0 * float(np.log10(tests)), 168.0 - 140.0 * min(value / most, 1.0)

    wide = max(exact.values())
    pen.line([place(tests, exact[tests], wide) for tests in TESTS], "chalk", 1.8)
    most = max(error for _, error in line)
    pen.line([place(tests, error, most) for tests, error in line], "amber", 1.8)
    pen.words("between the bounds", 284.0, 24.0, "chalk", "right")
    pen.words("error of the distance", 284.0, 41.0, "amber", "right")
    pen.words("1 test", 44.0, 184.0, "text2")
    pen.words(f"{TESTS[-1]}", 268.0, 184.0, "text2")


def _measure() -> Iterator[Comparison]:
    yield from _errors((("star", "star"), ("comb", "letter"), ("comb", "comb"), ("coast", "coast")))
    with_bounds, without = _work(TIMED.known), _work(TIMED.known.without(SPACE_TIME))
    yield Comparison("pairs due a step, of 66, with space-time bounds and without", "",
                     f"{with_bounds[0]:.3g} and {without[0]:.3g}")  # fmt: skip
    yield Comparison("tests a step, with space-time bounds and without", "",
                     f"{with_bounds[1]:.3g} and {without[1]:.3g}")  # fmt: skip
    pairs = pose_pairs("coast", "coast", SEED)
    exact = 1e6 * least_time(lambda: pairs.world.exact(0, 1), len(pairs.poses))
    tree = _cost_us(pairs, TESTS[-1])
    yield Comparison("two coast lines to the end, and every edge against every edge", "",
                     f"{tree:.3g} µs and {exact:.3g} µs")  # fmt: skip


INTERACTIVE = Paper(
    problem=(
        "A program that answers to a hand must draw the next picture in time. Exact collision detection "
        "takes as long as it takes: longest when much is close together, which is when one looks.",
    ),
    idea=(
        "Ask as late and as roughly as one can afford. Bounds on acceleration say until when two bodies "
        "cannot touch. From then on they are compared by levels of ever smaller spheres, and whatever is "
        "known when the time is up is the answer.",
    ),
    steps=(
        Step(
            "From place, velocity and a bound A of the acceleration each body has a region in space and time "
            "that it cannot leave. Before two of these meet, the two bodies need no test.",
            draw_horns,
            r"\abs{\v{d} + \v{v} t} = R_1 + R_2 + A t^2",
        ),
        Step(
            "Pairs wait in a queue by their next possible time of contact. An impact renews those of both.",
            _draw_queue,
        ),
        Step(
            "Each body has a tree: one circle about all of it, then ever smaller ones about its parts. Each "
            "level covers the whole body.",
            draw_levels,
        ),
        Step(
            "Two nodes bound the distance from below by their circles and, here, from above by discs within "
            "the bodies.",
            draw_bounds,
        ),
        Step(
            "All pairs are refined together, level by level. When the budget ends, circles that overlap "
            "count as contact, and bounds say how wrong that may be.",
            _draw_budget,
        ),
    ),
    showed=(
        "The article of 1996 works in space, with trees built along the medial axis. Detection on a budget "
        "was 10 to 100 times faster than an earlier algorithm. It kept nearly 10 frames a second on a "
        "workstation of the time. The accuracy was acceptable, and better than with earlier trees.",
    ),
    measure=_measure,
    limits=(
        "Ours is in the plane, and the trees are built by splitting the body, not along its medial axis. "
        "The bounds of different bodies are compared pair by pair, not by the faces of four-dimensional "
        "boxes. Steps count tests instead of time, so that they replay equal; the times above are tests "
        "times the mean time of one. The estimate is the middle of the bounds, and the upper one once "
        "leaves were compared. Errors are shares of the distance, of bodies at least 0.05 m apart and a "
        "metre in size. As long as circles overlap the answer is 0, and its error the whole distance.",
    ),
    after=(
        "Trees of spheres by better fits (Bradshaw and O'Sullivan 2004), of boxes (Gottschalk, Lin and "
        "Manocha 1996), responses for interrupted answers (Dingliana and O'Sullivan 2000), and bounds in "
        "time with an event queue for many spheres (Kim, Guibas and Shin 1998).",
    ),
)
