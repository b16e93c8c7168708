"""What accuracy costs for a soft spring: stiffness as a share of each sweep, against compliance.

With a plain k the motion does not converge to that of any spring: smaller steps make it stiffer, until it is
rigid. With compliance it converges, with BDF2 to second order.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from game.lab.ranges import counts_between
from game.lab.studies.constraints import Run
from game.lab.study import Knob, Method, Setting, Study, Workload
from game.physics.constraints import LINKS, PositionBasedDynamics
from game.physics.effects import EffectSet
from game.physics.kernels import elementary

SPRING_S, SPRING_K, SPRING_START = 1.0, 100.0, 0.1  # s, N/m, m out of rest
SHARE_K = SPRING_K / (SPRING_K + 3600.0)  # k that is SPRING_K for 1 kg and one sweep of a step of 1/60 s
SPRINGS: dict[str, dict[str, Any]] = {
    "pbd": {"model": "pbd", "iterations": 4},
    "pbd-even": {"model": "pbd-even", "iterations": 4},
    "xpbd": {"model": "xpbd", "iterations": 1},
    "xpbd-bdf2": {"model": "xpbd", "iterations": 1, "scheme": "bdf2"},
}


def spring_trial(setting: Setting) -> Run:
    """A bead of 1 kg on a spring of 100 N/m, let go 10 cm from rest, for a second."""
    n = max(1, round(SPRING_S / setting.knob))
    settings = SPRINGS[setting.method] if setting.method in SPRINGS else dict(setting.scene)
    system = PositionBasedDynamics(
        [(0.0, 0.0), (1.0 + SPRING_START, 0.0)], [0.0, 1.0], [(0, 1)], SHARE_K, rest_lengths=[1.0],
        compliances=1.0 / SPRING_K, substeps=n, effects=EffectSet([LINKS]), **settings,
    )  # fmt: skip
    exact = SPRING_START * elementary.cos(math.sqrt(SPRING_K) * SPRING_S)
    return Run(
        system,
        SPRING_S,
        1,
        lambda s: abs(float(s.positions[1, 0]) - 1.0 - exact),
        n * int(settings["iterations"]),
    )


def spring_settings() -> list[Setting]:
    """40 to 10 000 steps for the second."""
    return [
        Setting(
            name, SPRING_S / n, {},
            {**SPRINGS[name],
             "step_length": min(max(SPRING_S / n, 1.0 / 2000.0), 0.1), "substeps": 1},
            10.0 + n,
        )
        for n in counts_between(40, 10_000, 22)
        for name in SPRINGS
    ]  # fmt: skip


def present_spring(parameters: Mapping[str, Any]) -> Setting:
    """Where a scene with these parameters stands: its model, scheme, iterations and substep."""
    settings = {
        "model": parameters["model"],
        "scheme": parameters["scheme"],
        "iterations": int(parameters["iterations"]),
    }
    h = float(parameters["step_length"]) / float(parameters["substeps"])
    names = (name for name, one in SPRINGS.items() if {"scheme": "euler", **one} == settings)
    return Setting(next(names, "present"), max(h, SPRING_S / 10_000), {}, settings)


spring_study = Study(
    name="c15",
    title="Soft springs: a bead on a spring",
    error="distance from the exact place after 1 s",
    error_unit="m",
    counter="projections of the spring",
    knob=Knob("step_length", "substep", "s"),
    methods=(
        Method("pbd", "k, 4 sweeps", None, "converges to a rigid link"),
        Method("pbd-even", "k′, 4 sweeps", None, "the same"),
        Method("xpbd", "compliance", 1.0, "backward Euler"),
        Method("xpbd-bdf2", "compliance, BDF2", 2.0),
    ),
    settings=spring_settings,
    trial=spring_trial,
    reference="0.1 m cos(10 t / s).",
    expectation=(
        "With k the error does not go away, whatever the step: there is no spring that it converges to. With "
        "compliance the order is 1, with BDF2 2."
    ),
    lesson=True,
    order_over="counter",
    present=present_spring,
    workload=Workload("a bead on a spring"),
)
