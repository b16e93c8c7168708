"""What reaching costs: error against iterations and time, by seven methods and four kinds of target.

Reachable targets: linear convergence of the gradients, nearly quadratic of damped least squares. The dead
point: a straight chain with its target on its axis, where every gradient is zero. Full reach: only 1 / k,
as the chain gets straight. Out of reach: the error that is left goes to the distance missing.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import cache
from typing import Any

import numpy as np

from game.arrays import Floats
from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload
from game.physics.animation import IK_METHODS, Solutions, Solver, chain_skeleton
from game.physics.kernels import elementwise

BONES, TARGETS = 10, 40
PER_TARGET = "CPU time for one target"
TIGHT = 1e-13  # m: as good as exact
LABELS = {
    "gradient": "gradient, fixed step",
    "buss": "gradient, Buss step",
    "armijo": "gradient, Armijo",
    "damped": "damped least squares",
    "ccd": "CCD",
    "fabrik": "FABRIK",
    "damped-fixed": "fixed damping",
}
LONGEST = {"gradient": 2_000, "buss": 2_000, "armijo": 2_000, "damped": 300, "ccd": 2_000, "fabrik": 2_000,
           "damped-fixed": 300}  # fmt: skip
THREE = (1.0, 0.8, 0.6)  # m, links of the chain of the single targets
SINGLE = {
    "dead point": ((0.0, 0.0, 0.0), (1.0, 0.0), 0.0),
    "full reach": ((0.9, -0.7, 0.5), (2.4, 0.0), 0.0),
    "out of reach": ((0.3, 0.4, 0.5), (3.0, 2.0), math.sqrt(13.0) - 2.4),
}  # start (rad), target (m), error that must be left (m)
THRASHING = 0.01  # m more than must be left, after so many iterations that it is no beginning any more
ENOUGH = 100
COPIES = 20  # of a single target in one run, so that beginning a run costs next to nothing


@cache
def reachable() -> tuple[Floats, Floats]:
    """A bent chain of total length 1 m, and targets (m, 2) within 0.9 m of its root."""
    rng = np.random.default_rng(11)
    start = rng.uniform(-0.5, 0.5, BONES)
    radii, angles = 0.9 * np.sqrt(rng.random(TARGETS)), rng.uniform(-math.pi, math.pi, TARGETS)
    return start, np.column_stack([radii * elementwise.cos(angles), radii * elementwise.sin(angles)])


class Run:
    """A chain solved for some targets with so many iterations at most."""

    def __init__(
        self, lengths: Floats, start: Floats, targets: Floats, setting: Setting, left: float
    ) -> None:
        self.solver = Solver(chain_skeleton(lengths, start), 0, len(lengths) - 1)
        self.targets, self.left = targets, left
        self.method, self.most = setting.method, int(setting.knob)
        self.simulated_s = float(len(targets))  # so that times are those of one target
        self.found: Solutions | None = None

    def reset(self) -> None:
        """The pose stays as it is."""

    def run(self) -> None:
        best = self.method not in ("gradient", "damped-fixed")
        self.found = self.solver.solve_each(self.targets, self.method, TIGHT, self.most, keep_best=best)

    def outcome(self) -> Outcome:
        assert self.found is not None
        error = abs(float(np.median(self.found.errors)) - self.left)
        thrashes = self.method == "damped-fixed" and self.most >= ENOUGH and error > THRASHING
        return Outcome(error, int(np.median(self.found.placings)), "thrashes" if thrashes else "")


def counts(method: str, longer: int) -> list[int]:
    """Iterations of a method, spread evenly in the logarithm; the slow ones begin late if made longer."""
    first = 50 * longer if longer > 1 and LONGEST[method] > 1_000 else 1
    return sorted({round(k) for k in np.geomspace(first, longer * LONGEST[method], 14).tolist()})


def settings_of(methods: tuple[str, ...], longer: int = 1) -> list[Setting]:
    """All numbers of iterations of the methods, up to so many times more than usual."""
    return [
        Setting(name, k, {}, _scene(name, k), 5.0 + k)
        for name in methods
        for k in counts(name, longer)
    ]  # fmt: skip


def _scene(method: str, iterations: int) -> dict[str, Any]:
    """The scene's parameters at a point."""
    fixed = method == "damped-fixed"
    return {
        "method": "damped" if fixed else method,
        "iterations": min(iterations, 300),
        "adaptive": not fixed,
    }


def reaching_trial(setting: Setting) -> Run:
    """The targets that can be reached; the median of their errors."""
    start, targets = reachable()
    return Run(np.full(BONES, 1.0 / BONES), start, targets, setting, 0.0)


def single_trial(kind: str, setting: Setting) -> Run:
    """One hard target for three links."""
    start, target, left = SINGLE[kind]
    return Run(np.array(THREE), np.array(start), np.tile(target, (COPIES, 1)), setting, left)


def present_reaching(parameters: Mapping[str, Any]) -> Setting:
    """Where a scene with these parameters stands."""
    method = str(parameters["method"])
    if method == "damped" and not parameters["adaptive"]:
        method = "damped-fixed"
    return Setting(method, float(parameters["iterations"]))


def single_study(
    kind: str, name: str, orders: Mapping[str, float], expectation: str, longer: int = 1
) -> Study:
    """The study of one hard target."""
    return Study(
        name=name,
        title=f"Inverse kinematics: {kind}",
        error="distance from the target, less what must be left",
        error_unit="m",
        counter="placings of the chain",
        knob=Knob("iterations", "iterations", parts=True),
        methods=tuple(Method(method, LABELS[method], orders.get(method)) for method in IK_METHODS),
        settings=lambda: settings_of(IK_METHODS, longer),
        trial=lambda setting: single_trial(kind, setting),
        reference="the reach of the chain and the distance of the target.",
        expectation=expectation,
        order_over="counter",
        floor=1e-11,
        present=present_reaching,
        workload=Workload("a chain of three links"),
        short=kind.capitalize(),
        cost=PER_TARGET,
    )


dead_point_study = single_study(
    "dead point", "c03-dead-point", {},
    "At first nothing moves: all gradients are zero. The kick comes at once, then it converges as ever.",
)  # fmt: skip
full_reach_study = single_study(
    "full reach", "c03-full-reach", dict.fromkeys(("gradient", "buss", "armijo", "ccd"), 1.0),
    "Only 1 / k for gradients and CCD, as the chain gets straight; damped least squares halves each time.",
    longer=10,
)  # fmt: skip
out_of_reach_study = single_study(
    "out of reach", "c03-out-of-reach", {},
    "All come to the distance that is missing, but for fixed damping, which thrashes.",
)  # fmt: skip

reaching_study = Study(
    name="c03",
    title="Inverse kinematics: targets that can be reached",
    error="median distance from 40 targets, chain of 1 m",
    error_unit="m",
    counter="placings of the chain",
    knob=Knob("iterations", "iterations", parts=True),
    methods=tuple(Method(method, LABELS[method]) for method in IK_METHODS),
    settings=lambda: settings_of(IK_METHODS),
    trial=reaching_trial,
    reference="a target within the reach is met exactly.",
    expectation=(
        "Buss's step is about ten times cheaper than the fixed one. Damped least squares and FABRIK need a "
        "few iterations."
    ),
    order_over="counter",
    floor=1e-12,
    present=present_reaching,
    workload=Workload("a chain of 1 m and 40 targets"),
    short="Within reach",
    cost=PER_TARGET,
    related=(dead_point_study, full_reach_study, out_of_reach_study),
)
