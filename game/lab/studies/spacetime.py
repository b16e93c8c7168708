"""What accuracy costs for a distance that is asked on a budget: tests against the error of the answer."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import lru_cache
from typing import Any, NamedTuple

import numpy as np

from game.arrays import Floats
from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.lab.trials import computation
from game.physics.kernels import elementary
from game.physics.spacetime.exact import exact_distance
from game.physics.spacetime.motion import Laws
from game.physics.spacetime.refine import refine_many
from game.physics.spacetime.shapes import KINDS
from game.physics.spacetime.world import TimedBody, TimedWorld

BUDGETS = (1, 4, 16, 32, 64, 128, 256, 512, 1024, 2048)
POSES, NEAREST = 150, 0.05  # of a pair of kinds; m, no nearer than which errors are relative to the distance
TREES = "circle-trees"


class PosePairs(NamedTuple):
    """Two bodies at poses (q, 2, 4) and their exact distances (q,) m."""

    world: TimedWorld
    poses: Floats
    exact: Floats


def pose_pairs(first: str, second: str, seed: int = 5) -> PosePairs:
    """Two bodies of 1 m and 0.8 m at random poses, centres 0.5 to 2.6 m apart, none nearer than NEAREST."""
    chance = np.random.default_rng(seed)
    world = TimedWorld(
        [TimedBody(first, 1, 1.0, (0.0, 0.0)), TimedBody(second, 2, 0.8, (2.0, 0.0))],
        (3.0, 3.0), Laws(0.0, 0.0, 1.0, 3.0, 3.0),
    )  # fmt: skip
    poses, exact = np.zeros((POSES, 2, 4)), np.zeros(POSES)
    found = 0
    while found < POSES:
        far, heading, a, b = chance.uniform((0.5, 0.0, 0.0, 0.0), (2.6, math.tau, math.tau, math.tau))
        poses[found, 0] = 0.0, 0.0, elementary.cos(a), elementary.sin(a)
        poses[found, 1] = (
            far * elementary.cos(heading),
            far * elementary.sin(heading),
            elementary.cos(b),
            elementary.sin(b),
        )
        exact[found] = exact_distance(world.outlines, world.spans, 0, 1, poses[found])
        found += exact[found] >= NEAREST
    return PosePairs(world, poses, exact)


@lru_cache(maxsize=1)
def all_pairs() -> tuple[PosePairs, ...]:
    """All kinds against all."""
    return tuple(pose_pairs(a, b) for i, a in enumerate(KINDS) for b in KINDS[i:])


def answers(pairs: PosePairs, budget: int) -> Floats:
    """(q, 4): lower and upper bound, estimate (m), and tests of each query."""
    out = np.zeros((len(pairs.poses), 4))
    world = pairs.world
    refine_many(world.forest, pairs.poses, budget, world.left, world.gaps, out)
    return out


def relative_errors(pairs: PosePairs, found: Floats) -> Floats:
    """(q,): of the estimates, in shares of the exact distance."""
    return np.asarray(np.abs(found[:, 2] - pairs.exact) / pairs.exact)


def budget_trial(setting: Setting) -> Trial:
    """All pose pairs, each asked with the same budget of tests: the mean error in shares of the distance."""
    pairs = all_pairs()

    def judge(found: list[Floats]) -> Outcome:
        errors = [relative_errors(one, answer) for one, answer in zip(pairs, found, strict=True)]
        tests = int(sum(float(np.sum(answer[:, 3])) for answer in found))
        return Outcome(float(np.mean(np.concatenate(errors))), tests)

    queries = float(sum(len(one.poses) for one in pairs))
    return computation(queries, lambda: [answers(one, int(setting.knob)) for one in pairs], judge)


def _settings() -> list[Setting]:
    return [Setting(TREES, float(n), {}, {"budget": n}, float(min(n, 400))) for n in BUDGETS]


def _present(parameters: Mapping[str, Any]) -> Setting:
    return Setting(TREES, max(1.0, float(parameters["budget"])), {})


budget_study = Study(
    name="budget",
    title="A distance on a budget",
    error="mean error, of the distance",
    error_unit="",
    counter="tests",
    knob=Knob("budget", "tests a query", parts=True),
    methods=(Method(TREES, "circle trees", None),),
    settings=_settings,
    trial=budget_trial,
    reference="every edge against every edge.",
    expectation="The error falls slowly while circles are large, to rounding once all leaves are compared.",
    present=_present,
    workload=Workload(f"ten pairs of kinds at {POSES} random poses each, 0.05 m apart or more"),
    cost="CPU time for one query",
)
