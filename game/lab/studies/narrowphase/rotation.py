"""What the depth with rotation costs: branch and bound against its tolerance, a grid against its spacing.

Branch and bound narrows the angle to its tolerance where the curve has a corner and to its root where it is
smooth. So angles grow at most like the root of 1 / tolerance. A grid of three axes takes the cube.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import lru_cache
from typing import Any

import numpy as np

from game.lab.study import Knob, Method, Outcome, Setting, Study, Trial, Workload
from game.lab.trials import computation
from game.physics.narrowphase.depth import Escape, ShapePair, preset

TOLERANCES = (1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 1e-4, 1e-5)
GRIDS = (7, 11, 17, 25, 37)
FINEST = 1e-7  # m, tolerance of the reference
BOUND, SLIDE, GRID = "branch-and-bound", "translation", "grid"
KINDS = (("L", "comb"), ("star", "L"), ("bar", "slot"), ("comb", "slot"), ("square", "triangle"))


@lru_cache(maxsize=1)
def overlapping_pairs() -> tuple[ShapePair, ...]:
    """Two of each kind, that overlap."""
    random = np.random.default_rng(32)
    pairs = []
    for first, second in KINDS * 2:
        x, y, turn = random.uniform(-0.3, 0.3, 3).tolist()
        pairs.append(ShapePair(preset(first), preset(second), (x, y + 0.4, 3.0 * turn), (0.0, 0.0, 0.0)))
    return tuple(pairs)


@lru_cache(maxsize=1)
def _reference() -> tuple[float, ...]:
    """Sigma of each pair (m)."""
    return tuple(pair.generalised(FINEST).sigma for pair in overlapping_pairs())


def depth_trial(setting: Setting) -> Trial:
    """One query a pair: by how much the motions found are too long, root mean square; motions tried."""
    side = int(setting.others.get("places", 0.0))

    def query(pair: ShapePair) -> Escape:
        if setting.method == GRID:
            return pair.by_grid(side, side)
        return pair.translational() if setting.method == SLIDE else pair.generalised(setting.knob)

    def judge(found: list[Escape]) -> Outcome:
        errors = [one.sigma - exact for one, exact in zip(found, _reference(), strict=True)]
        error = math.sqrt(sum(e * e for e in errors) / len(errors))
        return Outcome(error, sum(one.evaluations for one in found))

    return computation(float(2 * len(KINDS)), lambda: [query(pair) for pair in overlapping_pairs()], judge)


def _settings() -> list[Setting]:
    return [
        Setting(SLIDE, 1.0),
        *(
            Setting(BOUND, tolerance, {}, {"tolerance": tolerance}, 1.0 / tolerance)
            for tolerance in TOLERANCES
        ),
        *(
            Setting(GRID, 2.0 / (side - 1), {"places": float(side)}, {"grid": side}, side * side * side)
            for side in GRIDS
        ),
    ]


def _present(parameters: Mapping[str, Any]) -> Setting:
    return Setting(BOUND, float(parameters["tolerance"]), {})


depth_study = Study(
    name="depth-with-rotation",
    title="Depth with rotation",
    error="excess of the motion found, root mean square",
    error_unit="m",
    counter="motions tried",
    knob=Knob("tolerance", "tolerance, or spacing of the grid", "m"),
    methods=(
        Method(SLIDE, "translation only", None),
        Method(BOUND, "branch and bound", 1.0),
        Method(GRID, "grid in x, y, angle", 1.0),
    ),
    settings=_settings,
    trial=depth_trial,
    reference="Branch and bound to 0.1 µm.",
    expectation="What turning saves no displacement finds; a grid pays for each digit with a thousand times "
    "the motions, branch and bound with a few times.",
    cost="CPU time for one query",
    present=_present,
    workload=Workload("ten pairs of shapes that overlap; a query of each"),
)
