"""What accuracy costs for linked particles: sweeps against substeps, two schemes, two solvers.

Stretch: a chain that hangs at rest should have its length. n sweeps divide its stretch by about n, n substeps
of one sweep by n²: (N - 1) (M + (N - 2) / 2) g h². Swing: sweeps do nothing for the motion, the step decides.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from game.lab.ranges import counts_between
from game.lab.study import Knob, Method, Outcome, Setting, Study, Workload
from game.physics.constraints import DAMPING, LINKS, PositionBasedDynamics, PositionState
from game.physics.fields import GRAVITY

FRAME = 1.0 / 60.0  # s
ABSURD = 10.0  # m of error beyond which a run counts as diverged
LINKS_HANGING, SETTLING_S = 20, 3.0
# five links of 0.2 m let go from horizontal: places (m) after 0.8 s, by Lagrange's equations in the angles
# (two integrators of order 8 and 5 that agree to 4e-14)
SWING_S = 0.8
SWING_END = (
    (-0.190965874450991, -0.0594309245693561), (-0.389138449232602, -0.0864055534718355),
    (-0.582905620171927, -0.135946278801312), (-0.76373204020427, -0.22139688335322),
    (-0.928429039428859, -0.334864493032881),
)  # fmt: skip


def copied(state: PositionState) -> PositionState:
    """A state of its own."""
    return PositionState(state.fields.copy(), state.torn.copy(), state.intact.copy(), state.hand.copy())


class Run:
    """A system that is stepped for so long from the same start."""

    def __init__(
        self,
        system: PositionBasedDynamics,
        dt: float,
        steps: int,
        error: Callable[[PositionBasedDynamics], float],
        projections: int,
    ) -> None:
        self.simulated_s = dt * steps
        self.system, self.dt, self.steps = system, dt, steps
        self.start = copied(system.state())
        self.error, self.projections = error, projections

    def reset(self) -> None:
        self.system.restore(self.start)

    def run(self) -> None:
        for _ in range(self.steps):
            self.system.step(self.dt)

    def outcome(self) -> Outcome:
        error = self.error(self.system)
        sane = math.isfinite(error) and error < ABSURD
        return Outcome(error, self.projections, "" if sane else "diverged")


# -- stretch of a hanging chain -------------------------------------------------------------------------

STRETCH: dict[str, Callable[[int], dict[str, Any]]] = {
    "iterations": lambda n: {"substeps": 1, "iterations": n},
    "over-relaxed": lambda n: {"substeps": 1, "iterations": n, "relaxation": 1.8},
    "both": lambda n: {"substeps": round(math.sqrt(n)), "iterations": round(math.sqrt(n))},
    "substeps": lambda n: {"substeps": n, "iterations": 1},
    "direct": lambda n: {"substeps": n, "iterations": 1, "solver": "direct"},
}


def hanging_chain(**settings: Any) -> PositionBasedDynamics:
    """20 links of 5 cm straight down from a pin."""
    n = LINKS_HANGING
    return PositionBasedDynamics(
        [(0.0, -i / n) for i in range(n + 1)],
        [0.0] + [1.0] * n,
        [(i, i + 1) for i in range(n)],
        order="natural",
        effects=GRAVITY | LINKS | DAMPING,
        damping=20.0,
        **settings,
    )


def stretch_trial(setting: Setting) -> Run:
    """The hanging chain until it is at rest."""
    if setting.method == "present":
        settings = dict(setting.others)
        chosen: dict[str, Any] = {name: int(settings[name]) for name in ("substeps", "iterations")}
        chosen["relaxation"] = float(settings["relaxation"])
        chosen["solver"] = str(setting.scene["solver"])
    else:
        chosen = STRETCH[setting.method](int(setting.knob))
    system = hanging_chain(**chosen)
    steps = round(SETTLING_S / FRAME)
    work = LINKS_HANGING * chosen["substeps"] * chosen["iterations"] * steps
    return Run(system, FRAME, steps, lambda s: abs(-s.positions[-1, 1] - 1.0), work)


def stretch_settings() -> list[Setting]:
    """All ways at the same work: n sweeps a frame, divided differently."""
    return [
        Setting(name, n, {}, _scene(STRETCH[name](n)), 10.0 + n)
        for n in counts_between(1, 200, 16)
        for name in STRETCH
        if name != "both" or math.isqrt(n) > 1
    ]


def _scene(settings: Mapping[str, Any]) -> dict[str, Any]:
    scene = dict(settings)
    scene["substeps"] = min(int(scene.get("substeps", 1)), 200)
    return scene


def present_stretch(parameters: Mapping[str, Any]) -> Setting:
    """Where a scene with these parameters stands."""
    others = {
        "substeps": float(parameters["substeps"]),
        "iterations": float(parameters["iterations"]),
        "relaxation": float(parameters["relaxation"]),
    }
    n = others["substeps"] * others["iterations"]
    present = {"solver": parameters["solver"], **others}
    for name, of_work in STRETCH.items():
        if {"solver": "gauss-seidel", "relaxation": 1.0, **of_work(round(n))} == present:
            return Setting(name, n, {}, {"solver": parameters["solver"]})
    return Setting("present", n, others, {"solver": parameters["solver"]})


# -- a swinging chain -----------------------------------------------------------------------------------

SWING: dict[str, tuple[str, str, bool]] = {
    "euler": ("euler", "gauss-seidel", True),
    "euler-sweeps": ("euler", "gauss-seidel", False),
    "bdf2": ("bdf2", "gauss-seidel", True),
    "bdf2-direct": ("bdf2", "direct", True),
}


def swing_trial(setting: Setting) -> Run:
    """Five links let go from horizontal."""
    n = int(setting.knob)
    scheme, solver, divide = SWING.get(setting.method, ("", "", True))
    substeps, iterations = (n, 1) if divide else (1, n)
    if setting.method == "present":
        scheme, solver = str(setting.scene["scheme"]), str(setting.scene["solver"])
        substeps, iterations = int(setting.scene["substeps"]), int(setting.scene["iterations"])
    system = PositionBasedDynamics(
        [(0.2 * i, 0.0) for i in range(6)], [0.0] + [1.0] * 5, [(i, i + 1) for i in range(5)],
        order="natural", scheme=scheme, solver=solver, substeps=substeps, iterations=iterations,
        effects=GRAVITY | LINKS,
    )  # fmt: skip
    steps = round(SWING_S / FRAME)

    def error(s: PositionBasedDynamics) -> float:
        off = s.positions[1:] - np.array(SWING_END)
        return math.sqrt(float((off * off).sum(axis=1).max()))

    return Run(system, FRAME, steps, error, 5 * n * steps)


def present_swing(parameters: Mapping[str, Any]) -> Setting:
    """Where a scene with these parameters stands."""
    scene = {name: parameters[name] for name in ("scheme", "solver", "substeps", "iterations")}
    work = float(scene["substeps"]) * float(scene["iterations"])
    for name, (scheme, solver, divide) in SWING.items():
        others = scene["iterations"] if divide else scene["substeps"]
        if (scheme, solver, 1) == (scene["scheme"], scene["solver"], others):
            return Setting(name, work, {}, scene)
    return Setting("present", work, {}, scene)


def swing_settings() -> list[Setting]:
    """One to 400 substeps (or sweeps) a frame."""
    return [
        Setting(
            name, n, {},
            {"scheme": SWING[name][0], "solver": SWING[name][1],
             "substeps": min(n, 200) if SWING[name][2] else 1,
             "iterations": 1 if SWING[name][2] else n},
            10.0 + n,
        )
        for n in counts_between(1, 400, 18)
        for name in SWING
    ]  # fmt: skip


swing_study = Study(
    name="c14-swing",
    title="Rigid links: a swinging chain",
    short="Swing",
    error="farthest particle from its exact place after 0.8 s",
    error_unit="m",
    counter="projections of a link",
    knob=Knob("substeps", "substeps or sweeps a frame", parts=True),
    methods=(
        Method("euler", "Euler, n substeps", 1.0),
        Method("euler-sweeps", "Euler, n sweeps", None, "sweeps do nothing for the motion"),
        Method("bdf2", "BDF2, n substeps", 2.0),
        Method("bdf2-direct", "BDF2, direct", 2.0),
    ),
    settings=swing_settings,
    trial=swing_trial,
    present=present_swing,
    workload=Workload("a swinging chain of five links"),
    reference="Lagrange's equations in the angles of five links.",
    expectation="Sweeps do not help; substeps are of first order, with BDF2 of second.",
    order_over="counter",
)

stretch_study = Study(
    name="c14",
    title="Rigid links: stretch of a hanging chain",
    short="Hanging",
    error="stretch of 20 links that should be 1 m long",
    error_unit="m",
    counter="projections of a link",
    knob=Knob("work", "sweeps a frame", parts=True),
    methods=(
        Method("iterations", "n iterations", 1.0),
        Method("over-relaxed", "over-relaxed", None, "each correction 1.8 times as far"),
        Method("both", "√n substeps, √n iterations", None),
        Method("substeps", "n substeps", 2.0),
        Method("direct", "direct", None, "all links of the chain at once: exact"),
    ),
    settings=stretch_settings,
    trial=stretch_trial,
    reference="a chain of rigid links hangs straight.",
    expectation="The same work: n iterations divide the stretch by n or so, n substeps by n squared.",
    order_over="counter",
    floor=1e-12,
    present=present_stretch,
    workload=Workload("a hanging chain of 20 links"),
    related=(swing_study,),
)
